// unisize in WebAssembly without a page, in Node: both broad phases, scalar and with vectors. See .ci/browser.
//
//   node node.mjs check                     contacts of all scenes, as `compare` checks them (build --check)
//   node node.mjs golden                    hashes of all events (build --check)
//   node node.mjs times [steps [bodies]]    milliseconds per step (build)

import { readFileSync } from "node:fs";

const BUILDS = ["scalar", "simd"];
const ENGINES = ["rapier2d-027", "rapier3d-027", "rapier2d-036", "rapier3d-036"];
const [part, ...options] = process.argv.slice(2);
await { check, golden, times }[part](...options);

async function loadChecks(build, engine) {
  const folder = new URL(`check/${build}-${engine}/`, import.meta.url);
  const checks = await import(new URL("engine.js", folder));
  await checks.default({ module_or_path: readFileSync(new URL("engine_bg.wasm", folder)) });
  return checks;
}

/** Both broad phases have the same pairs in each step, and narrow phases find the same contacts and intersections among them. */
async function check(bodies = 200, steps = 60) {
  for (const build of BUILDS) {
    for (const engine of ENGINES) {
      const checks = await loadChecks(build, engine);
      const scenes = checks.scenes();
      for (const scene of scenes) {
        const difference = checks.first_difference(scene, Number(bodies), Number(steps));
        if (difference !== undefined) throw new Error(`${build}, ${engine}, ${scene}: ${difference}`);
      }
      console.log(`${build}, ${engine}: no difference in ${steps} steps of ${scenes.length} scenes`);
    }
  }
}

/** Prints the hash of each scene, which must be the same in both builds. */
async function golden() {
  for (const engine of ENGINES) {
    const [scalar, simd] = await Promise.all(BUILDS.map((build) => loadChecks(build, engine)));
    for (const scene of scalar.scenes()) {
      const hashes = [scalar, simd].map((checks) => checks.golden(scene));
      if (hashes[0] !== hashes[1]) throw new Error(`${engine}, ${scene}: ${hashes.join(" without vectors, with them ")}`);
      console.log(engine, scene, hashes[0]);
    }
  }
}

async function times(steps = 120, bodies = 2000) {
  const page = await import(new URL("site/engine.js", import.meta.url));
  const scenes = ["ropes", "hopper", "crowd", "gas", "mixed-1.5", "columns"];
  const widths = [10, 6, 7, 7, 13, 7, 8, 7, 6, 14];
  const row = (cells) => console.log(cells.map((cell, index) => String(cell).padStart(widths[index])).join(" "));
  row(["scene", "space", "Rapier", "build", "Rapier's own", "broad", "unisize", "broad", "ratio", "contacts"]);
  for (const build of BUILDS) {
    for (const version of ["027", "036"]) {
      for (const scene of scenes) {
        for (const space of ["2d", "3d"]) {
          const engine = await page.loadEngine(build, page.engineName({ space, version }), readFileSync);
          const sides = page.buildSides(engine, { scene, bodies: Number(bodies), seed: 1 });
          row([scene, space, version, build, ...clock(page, sides, Number(steps))]);
          for (const side of Object.values(sides)) side.free();
        }
      }
    }
  }
}

/** Means over all steps except the first, in which the code is compiled. */
function clock(page, sides, steps) {
  const warm = Math.min(10, Math.floor(steps / 4));
  const means = { rapier: { step: 0, broad: 0 }, unisize: { step: 0, broad: 0 } };
  for (let step = 0; step < steps; step += 1) {
    for (const [name, taken] of Object.entries(page.stepInTurns(sides, step))) {
      for (const part of step < warm ? [] : ["step", "broad"]) means[name][part] += taken[part] / (steps - warm);
    }
  }
  const { rapier, unisize } = means;
  const ms = [rapier.step, rapier.broad, unisize.step, unisize.broad].map((time) => time.toFixed(3));
  return [...ms, (rapier.step / unisize.step).toFixed(2), `${sides.rapier.contacts()} ${sides.unisize.contacts()}`];
}
