// Loads the worlds in WebAssembly: the build with vectors if the browser supports them, otherwise the one without.

/** A module with one function that uses a vector: `i8x16.popcnt(i8x16.splat(0))`. */
const WITH_VECTORS = Uint8Array.of(
  ...[0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11],
);

/** The build for this browser: `simd` or `scalar`. */
export function bestBuild() {
  return WebAssembly.validate(WITH_VECTORS) ? "simd" : "scalar";
}

/** The name of an engine: `rapier3d-036` and the like. */
export function engineName({ space, version }) {
  return `rapier${space}-${version}`;
}

/** Loads an engine in a build. In Node, `read` reads a file. */
export async function loadEngine(build, name, read = () => undefined) {
  const engine = await import(`./${build}-${name}/engine.js`);
  await engine.default({ module_or_path: read(new URL(`${build}-${name}/engine_bg.wasm`, import.meta.url)) });
  return engine;
}

/** Builds a scene on both broad phases: `{ rapier, unisize }`. */
export function buildSides(engine, { scene, bodies, seed }) {
  const side = (withUnisize) => new engine.Side(withUnisize, scene, bodies, seed);
  return { rapier: side(false), unisize: side(true) };
}

/** Steps both worlds, in an order that alternates from step to step. Returns the milliseconds of each step, and of its broad phase. */
export function stepInTurns(sides, turn) {
  const times = {};
  for (const name of turn % 2 === 0 ? ["rapier", "unisize"] : ["unisize", "rapier"]) {
    const start = performance.now();
    const broad = sides[name].step();
    times[name] = { step: performance.now() - start, broad };
  }
  return times;
}

/** The greatest difference between coordinates of the two worlds: 0 if they are equal bit for bit. */
export function distanceApart(sides) {
  const [a, b] = [sides.rapier.positions(), sides.unisize.positions()];
  if (a.length !== b.length) return Infinity;
  let most = 0;
  for (let index = 0; index < a.length; index += 1) most = Math.max(most, Math.abs(a[index] - b[index]));
  return most;
}
