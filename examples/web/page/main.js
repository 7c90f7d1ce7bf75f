// The page: builds the two worlds, steps them in turns, and shows the time of each.

import { bestBuild, buildSides, distanceApart, engineName, loadEngine, stepInTurns } from "./engine.js";
import { drawChart } from "./chart.js";

/** The scenes: default number of bodies, and description; where it starts later than another one, the name of that and the step. */
const SCENES = {
  ropes: [2000, "chains of capsules fall over obstacles and tangle"],
  hopper: [2000, "grains are poured through a funnel"],
  crowd: [4000, "walkers, each on its way to a goal"],
  "falling-balls": [2000, "balls fall into a walled box"],
  gas: [5000, "elastic balls without gravity"],
  ships: [3000, "three drifting bodies of very many colliders"],
  chains: [2000, "slanting chains of capsules, held at both ends"],
  "mixed-1.5": [2000, "balls and cubes of sizes 1 to 1.5 fall into a heap"],
  settled: [2000, "a heap of balls and cubes, 600 steps after they began to fall", "mixed-1.5", 600],
  columns: [3000, "columns of boxes, a twentieth of a box apart"],
  sleeping: [5000, "sleeping boxes, and a few balls that move"],
};

/**
 * Times are means over a window of steps. The slowest steps are left out, because the browser did something else, and so are the first ones,
 * in which the browser compiles functions on the time of the world that first calls them.
 */
const WINDOW = 120;
const LEAST = 20;
const WARMING = 30;
const COUNTED = 0.9;

/**
 * Worlds run at 60 steps per second or less: in each frame at least one step, and no new one after this many milliseconds. Up to the step
 * at which the scene starts, they run as fast as they can.
 */
const STEPS_PER_MS = 60 / 1000;
const BUDGET = 12;
const FAST_BUDGET = 50;

/** A picture is slow above this many milliseconds. After this many slow ones in a row, the resolution is reduced. */
const SLOW = 50;
const PATIENCE = 5;

/** The interval in milliseconds at which the numbers are written and the worlds compared. */
const INTERVAL = 250;

const NAMES = ["rapier", "unisize"];
const byId = (id) => document.getElementById(id);
const form = byId("setup");
const integer = new Intl.NumberFormat("en");

/** The parameters in the address of the page: fields of the form, or a scene to film. */
const asked = new URLSearchParams(location.search);

const engines = {};
let drawing;
let views = [];
let sides = {};
let times = { rapier: [], unisize: [] };
let steps = 0;
let firstStep = 0;
let equalUntil = 0;
let isRunning = true;
let isBroken = false;
let mustDraw = false;

function say(sentence) {
  byId("trouble").textContent = sentence;
  byId("trouble").hidden = false;
}

function fail(sentence) {
  isBroken = true;
  say(sentence);
}

/** Calls a function that may panic in WebAssembly. After a panic, no world can be used. */
function guarded(action) {
  if (isBroken) return;
  try {
    action();
  } catch (error) {
    console.warn(error);
    fail(`The simulation has stopped: ${error.message ?? error}. Reload the page to start again.`);
  }
}

function setup() {
  const value = (name) => form.elements[name].value;
  const bodies = Math.min(Math.max(Math.round(value("bodies")), 20), 20000);
  const seed = Number(value("seed")) >>> 0;
  return { scene: value("scene"), space: value("space"), version: value("version"), bodies, seed };
}

async function restart() {
  const wanted = setup();
  const engine = engineName(wanted);
  if (!(await load(engine))) return;
  const [, text, scene = wanted.scene, start = 0] = SCENES[wanted.scene];
  guarded(() => {
    for (const side of Object.values(sides)) side.free();
    form.elements.bodies.value = wanted.bodies;
    sides = buildSides(engines[engine], { ...wanted, scene });
    times = { rapier: [], unisize: [] };
    steps = 0;
    firstStep = start;
    equalUntil = 0;
    byId("title").textContent = `${integer.format(wanted.bodies)} bodies in ${wanted.space.toUpperCase()}, Rapier 0.${wanted.version.slice(1)}: ${text}`;
    const camera = views.length > 0 && new drawing.Camera(sides.unisize.bounds(), wanted.space === "2d");
    for (const view of views) view.begin(camera);
    history.replaceState(null, "", `?${new URLSearchParams(wanted)}`);
    mustDraw = true;
    writeNumbers();
  });
}

function stepBoth() {
  const taken = stepInTurns(sides, steps);
  steps += 1;
  for (const name of steps > firstStep + WARMING ? NAMES : []) {
    times[name].push(taken[name]);
    if (times[name].length > 1000) times[name].splice(0, 500);
  }
  if (equalUntil === steps - 1 && distanceApart(sides) === 0) equalUntil = steps;
  mustDraw = true;
}

function draw() {
  const { boxes, pairs, search } = form.elements;
  const overlays = { boxes: boxes.checked, pairs: pairs.checked, search: search.checked };
  for (const view of views) {
    if (mustDraw) view.update(sides[view.name], overlays);
    view.render();
  }
  mustDraw = false;
}

/** The mean of the last steps, once there are enough. */
function mean(name, part) {
  const recent = times[name].slice(-WINDOW).sort((a, b) => a.step - b.step);
  if (recent.length < LEAST) return undefined;
  const counted = recent.slice(0, Math.ceil(recent.length * COUNTED));
  return counted.reduce((sum, sample) => sum + sample[part], 0) / counted.length;
}

const milliseconds = (ms) => (ms === undefined ? "…" : ms.toFixed(ms < 9.995 ? 2 : 1));

/** Writes the numbers. */
function writeNumbers() {
  const write = (part, name, text) => (document.querySelector(`[data-${part}=${name}]`).textContent = text);
  for (const name of NAMES) {
    write("time", name, `${milliseconds(mean(name, "step"))} ms per step`);
    write("step", name, milliseconds(mean(name, "step")));
    write("broad", name, milliseconds(mean(name, "broad")));
    write("pairs", name, integer.format(sides[name].pairs()));
    write("contacts", name, integer.format(sides[name].contacts()));
  }
  const ratio = mean("rapier", "step") / mean("unisize", "step");
  byId("ratio").textContent = ratio > 0 ? `${ratio.toFixed(2)}×` : "…";
  const waiting = steps < firstStep ? `until step ${integer.format(firstStep)}, the bodies come to rest` : "measuring";
  byId("verdict").textContent = ratio > 0 ? "as fast with unisize, by whole steps" : waiting;
  byId("agreement").textContent = agreement();
  byId("searches").textContent = searches();
  drawChart(byId("chart"), times);
}

function searches() {
  const [runs, updates] = sides.unisize.searches().map((count) => integer.format(count));
  return `So far ${runs} searches for all pairs in ${updates} updates.`;
}

function agreement() {
  const count = `${integer.format(sides.unisize.bodies())} bodies, step ${integer.format(steps)}. `;
  if (equalUntil === steps) return `${count}Both worlds are equal to the last bit.`;
  const contacts = NAMES.map((name) => sides[name].contacts());
  const same = contacts[0] === contacts[1] ? "as many contacts" : "about as many contacts";
  return (
    `${count}Both worlds were equal to the last bit up to step ${integer.format(equalUntil)}, and have ${same} now. ` +
    "Both broad phases find every contact, but they report pairs in different orders. The solver works in that order, and rounding depends on it."
  );
}

let before = 0;
let due = 0;
let told = 0;
let drawn = 0;
let stepTime = 0;
let drawTime = 0;
let slowInARow = 0;

/** Measures the last picture: the time from frame to frame, without the steps. */
function clockPicture(now) {
  drawTime = now - drawn - stepTime;
  document.body.dataset.drawing = drawTime.toFixed(1);
  slowInARow = drawTime > SLOW ? slowInARow + 1 : 0;
  if (slowInARow < PATIENCE) return;
  slowInARow = 0;
  for (const view of views) view.coarsen();
}

function frame(now) {
  requestAnimationFrame(frame);
  if (isBroken) return;
  guarded(() => {
    // After a slow picture, frames without one follow, so that the page stays responsive.
    if (before === drawn && drawn > 0) clockPicture(now);
    due = isRunning ? Math.min(due + (now - before) * STEPS_PER_MS, 3) : 0;
    before = now;
    const start = performance.now();
    while (isRunning && steps < firstStep && performance.now() - start < FAST_BUDGET) stepBoth();
    // Below 1, because the interval of a screen with 60 frames per second varies.
    while (due >= 0.9 && performance.now() - start < BUDGET) {
      stepBoth();
      due -= 1;
    }
    stepTime = performance.now() - start;
    if (drawTime < SLOW || now - drawn > 2 * drawTime) {
      draw();
      drawn = now;
    }
    if (now - told > INTERVAL) {
      told = now;
      writeNumbers();
    }
  });
}

function run(wanted) {
  isRunning = wanted;
  byId("pause").textContent = wanted ? "Pause" : "Continue";
}

function oneStep() {
  run(false);
  guarded(() => {
    stepBoth();
    writeNumbers();
  });
}

/** Fills the form, with the values in the address of the page where there are any. */
function fillForm() {
  const { scene, bodies } = form.elements;
  for (const [name, [, text]] of Object.entries(SCENES)) scene.add(new Option(`${name}: ${text}`, name));
  if (asked.has("film")) asked.set("scene", asked.get("film"));
  for (const field of ["scene", "space", "version", "seed"]) {
    const initial = form.elements[field].value;
    form.elements[field].value = asked.get(field) ?? initial;
    form.elements[field].value ||= initial;
  }
  bodies.value = Number(asked.get("bodies")) || SCENES[scene.value][0];
}

function listen() {
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    restart();
  });
  form.addEventListener("change", ({ target }) => {
    if (target.type === "checkbox") {
      byId("legend").hidden = !form.elements.pairs.checked;
      byId("search").hidden = !form.elements.search.checked;
      mustDraw = true;
      return;
    }
    if (target.name === "scene") form.elements.bodies.value = SCENES[target.value][0];
    if (form.reportValidity()) restart();
  });
  byId("pause").addEventListener("click", () => run(!isRunning));
  byId("step").addEventListener("click", oneStep);
  document.addEventListener("keydown", (event) => {
    // A key in a field or on a button is for that.
    if (event.target.closest("form") || event.ctrlKey || event.metaKey || event.altKey) return;
    const action = { " ": () => run(!isRunning), n: oneStep, r: restart }[event.key.toLowerCase()];
    if (action === undefined) return;
    event.preventDefault();
    action();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    for (const view of views) view.recolor();
  });
}

async function loadViews() {
  try {
    drawing = await import("./view.js");
    views = NAMES.map((name) => new drawing.View(byId(name), name));
  } catch (error) {
    console.warn(error);
    byId("views").hidden = true;
    say("This browser has no WebGL, so the worlds are simulated but not drawn. The numbers are below.");
  }
}

/** Loads an engine, unless it is loaded. Returns whether it is now. */
async function load(name) {
  try {
    const build = bestBuild();
    engines[name] ??= await loadEngine(build, name);
    byId("build").textContent = `WebAssembly ${build === "simd" ? "with" : "without"} vectors.`;
    return true;
  } catch (error) {
    console.warn(error);
    fail(`The simulation could not be loaded: ${error.message}. Has the page been built, and is it served over HTTP?`);
    return false;
  }
}

async function start() {
  if (typeof WebAssembly === "undefined") {
    fail("This page needs WebAssembly, which this browser does not support. All major browsers have supported it since 2017.");
    return;
  }
  await loadViews();
  fillForm();
  listen();
  await restart();
  if (asked.has("film")) {
    // The recorder calls this function for each picture. It returns the milliseconds of the picture.
    document.body.classList.add("film");
    window.film = (count) => {
      for (let step = 0; step < count; step += 1) stepBoth();
      const start = performance.now();
      draw();
      for (const view of views) view.finish();
      const taken = performance.now() - start;
      writeNumbers();
      return taken;
    };
  } else {
    requestAnimationFrame(frame);
  }
}

start();
