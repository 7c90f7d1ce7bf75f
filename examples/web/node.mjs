// What a step takes in WebAssembly without a page: both broad phases in turns, scalar and with vectors, in Node.
//
//   node examples/web/node.mjs [steps] [bodies]
//
// Needs `site`, which `build` makes. In Rapier 0.27, worlds that are equal to the last bit have as many contacts; later on, and in 0.36,
// which may find the first contact of a pair a step sooner on unisize, the numbers are near each other. If not, it fails.

import { readFileSync } from "node:fs";

const SCENES = ["ropes", "hopper", "crowd", "gas", "mixed-1.5", "stacks"];
const [steps, bodies] = [Number(process.argv[2] ?? 120), Number(process.argv[3] ?? 2000)];
/** The first steps compile, and are not counted. */
const WARM = Math.min(10, Math.floor(steps / 4));

const site = new URL("site/", import.meta.url);
const { buildSides, distanceApart, loadEngine, stepInTurns } = await import(new URL("engine.js", site));

const columns = [["scene", 10], ["space", 6], ["Rapier", 7], ["build", 7], ["Rapier's own", 13], ["broad", 7], ["unisize", 8], ["broad", 7], ["ratio", 6], ["contacts", 14], ["equal until", 12]];
const row = (cells) => console.log(cells.map((cell, index) => String(cell).padStart(columns[index][1])).join(" "));
row(columns.map(([name]) => name));

for (const build of ["scalar", "simd"]) {
  for (const version of ["027", "036"]) {
    const engine = await loadEngine(build, version, readFileSync);
    for (const scene of SCENES) {
      for (const space of ["2d", "3d"]) {
        row([scene, space, version, build, ...run(engine, { scene, space, version, bodies, seed: 1 })]);
      }
    }
  }
}

function run(engine, setup) {
  const sides = buildSides(engine, setup);
  const sums = { rapier: { step: 0, broad: 0 }, unisize: { step: 0, broad: 0 } };
  let equalUntil = 0;
  for (let step = 0; step < steps; step += 1) {
    const times = stepInTurns(sides, step);
    if (step >= WARM) {
      for (const [name, taken] of Object.entries(times)) {
        sums[name].step += taken.step / (steps - WARM);
        sums[name].broad += taken.broad / (steps - WARM);
      }
    }
    const contacts = [sides.rapier.contacts(), sides.unisize.contacts()];
    if (equalUntil === step && distanceApart(sides) === 0) equalUntil = step + 1;
    const isEqual = equalUntil === step + 1 && setup.version === "027";
    if (isEqual ? contacts[0] !== contacts[1] : 1.5 * Math.min(...contacts) + 20 < Math.max(...contacts)) {
      throw new Error(`${JSON.stringify(setup)}: ${contacts.join(" and ")} contacts after step ${step + 1}`);
    }
  }
  const contacts = `${sides.rapier.contacts()} ${sides.unisize.contacts()}`;
  for (const side of Object.values(sides)) side.free();
  const { rapier, unisize } = sums;
  const times = [rapier.step, rapier.broad, unisize.step, unisize.broad].map((ms) => ms.toFixed(3));
  return [...times, (rapier.step / unisize.step).toFixed(2), contacts, equalUntil];
}
