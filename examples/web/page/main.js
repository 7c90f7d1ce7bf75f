// The page: builds the two worlds, steps them by turns, and shows how long each takes.

import { bestBuild, buildSides, distanceApart, loadEngine, stepInTurns } from "./engine.js";
import { drawChart } from "./chart.js";

/** The scenes: how many bodies they begin with, and what happens. */
const SCENES = {
  ropes: [2000, "chains of capsules fall over obstacles and tangle"],
  hopper: [2000, "grains are poured through a funnel"],
  crowd: [4000, "walkers, each on its way to a goal"],
  "falling-balls": [2000, "balls fall into a walled box"],
  gas: [5000, "elastic balls without gravity"],
  ships: [3000, "three drifting bodies of very many colliders"],
  chains: [2000, "slanting chains of capsules, held at both ends"],
  "mixed-1.5": [2000, "balls and cubes of sizes 1 to 1.5 fall into a heap"],
  columns: [3000, "columns of boxes, a twentieth of a box apart"],
  sleeping: [5000, "sleeping boxes, and a few balls that move"],
};

/**
 * Times are means of so many steps. The slowest are left out: the browser did something else. So are the first, in which the browser
 * compiles, on the account of whichever world comes first to a function that both need.
 */
const WINDOW = 120;
const LEAST = 20;
const WARMING = 30;
const COUNTED = 0.9;

/** Worlds run at 60 steps a second, or slower: in each frame at least one step, and no more than fit into this many milliseconds. */
const STEPS_PER_MS = 60 / 1000;
const BUDGET = 12;

/** Pictures that take more milliseconds than this are slow; after so many in a row they get coarser. */
const SLOW = 50;
const PATIENCE = 5;

/** The numbers are written, and the worlds compared, at these intervals of milliseconds. */
const INTERVAL = 250;

const NAMES = ["rapier", "unisize"];
const byId = (id) => document.getElementById(id);
const form = byId("setup");
const integer = new Intl.NumberFormat("en");

/** What the address of the page asks for: fields of the form, or a scene that is filmed. */
const asked = new URLSearchParams(location.search);

const engines = {};
let drawing;
let views = [];
let sides = {};
let times = { rapier: [], unisize: [] };
let steps = 0;
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

/** Runs something that may panic in WebAssembly. After that, no world can be used any more. */
function guarded(action) {
  if (isBroken) return;
  try {
    action();
  } catch (error) {
    console.warn(error);
    fail(`The simulation has stopped: ${error.message ?? error}. Reload the page to begin again.`);
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
  if (!(await load(wanted.version))) return;
  guarded(() => {
    for (const side of Object.values(sides)) side.free();
    form.elements.bodies.value = wanted.bodies;
    sides = buildSides(engines[wanted.version], wanted);
    times = { rapier: [], unisize: [] };
    steps = 0;
    equalUntil = 0;
    const camera = views.length > 0 && new drawing.Camera(sides.unisize.bounds(), wanted.space === "2d");
    for (const view of views) view.begin(camera);
    history.replaceState(null, "", `?${new URLSearchParams(wanted)}`);
    mustDraw = true;
    tell();
  });
}

function stepBoth() {
  const taken = stepInTurns(sides, steps);
  steps += 1;
  for (const name of steps > WARMING ? NAMES : []) {
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

/** The mean of the last steps, or nothing before there are enough. */
function mean(name, part) {
  const recent = times[name].slice(-WINDOW).sort((a, b) => a.step - b.step);
  if (recent.length < LEAST) return undefined;
  const counted = recent.slice(0, Math.ceil(recent.length * COUNTED));
  return counted.reduce((sum, sample) => sum + sample[part], 0) / counted.length;
}

const milliseconds = (ms) => (ms === undefined ? "…" : ms.toFixed(ms < 9.995 ? 2 : 1));

/** Writes the numbers. */
function tell() {
  const write = (part, name, text) => (document.querySelector(`[data-${part}=${name}]`).textContent = text);
  for (const name of NAMES) {
    write("time", name, `${milliseconds(mean(name, "step"))} ms a step`);
    write("step", name, milliseconds(mean(name, "step")));
    write("broad", name, milliseconds(mean(name, "broad")));
    write("pairs", name, integer.format(sides[name].pairs()));
    write("contacts", name, integer.format(sides[name].contacts()));
  }
  const ratio = mean("rapier", "step") / mean("unisize", "step");
  byId("ratio").textContent = ratio > 0 ? `${ratio.toFixed(2)}×` : "…";
  byId("verdict").textContent = ratio > 0 ? "as fast with unisize, by whole steps" : "measuring";
  byId("agreement").textContent = agreement();
  byId("searches").textContent = searches();
  drawChart(byId("chart"), times);
}

function searches() {
  const [ahead, runs, updates] = sides.unisize.searches().map((count) => integer.format(count));
  return `So far ${runs} searches for all pairs in ${updates} updates, the last one ${ahead} moves ahead.`;
}

function agreement() {
  const count = `${integer.format(sides.unisize.bodies())} bodies, step ${integer.format(steps)}. `;
  if (equalUntil === steps) return `${count}Both worlds are equal to the last bit.`;
  const contacts = NAMES.map((name) => sides[name].contacts());
  const same = contacts[0] === contacts[1] ? "as many contacts" : "about as many contacts";
  return (
    `${count}Both worlds were equal to the last bit up to step ${integer.format(equalUntil)}, and have ${same} now. ` +
    "Both broad phases find every contact, but report pairs in different orders, in which the solver then works, and rounding depends on that."
  );
}

let before = 0;
let due = 0;
let told = 0;
let drawn = 0;
let stepTime = 0;
let drawTime = 0;
let slowInARow = 0;

/** Takes down how long the last picture took: from frame to frame, less the steps. */
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
    // Pictures that take long are drawn in every other stretch of time, so that the page answers in between.
    if (before === drawn && drawn > 0) clockPicture(now);
    due = isRunning ? Math.min(due + (now - before) * STEPS_PER_MS, 3) : 0;
    before = now;
    const start = performance.now();
    // Not quite 1: a screen that shows 60 frames a second does so with a tolerance.
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
      tell();
    }
  });
}

function run(wanted) {
  isRunning = wanted;
  byId("pause").textContent = wanted ? "Pause" : "Go on";
}

function oneStep() {
  run(false);
  guarded(() => {
    stepBoth();
    tell();
  });
}

/** Fills the form, from the address of the page where it says something. */
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
    // Whoever is in a field or on a button means that.
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
    say("This browser has no WebGL, so the worlds are not drawn. They are simulated all the same; the numbers are below.");
  }
}

/** Loads the worlds of a version of Rapier, unless they are there. Returns whether they are. */
async function load(version) {
  try {
    const build = bestBuild();
    engines[version] ??= await loadEngine(build, version);
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
    fail("This page simulates in WebAssembly, which this browser does not have. Any browser since 2017 has it.");
    return;
  }
  await loadViews();
  fillForm();
  listen();
  await restart();
  if (asked.has("film")) {
    // Whoever records it says when it goes on, and is told the milliseconds of the picture.
    document.body.classList.add("film");
    window.film = (count) => {
      for (let step = 0; step < count; step += 1) stepBoth();
      const start = performance.now();
      draw();
      for (const view of views) view.finish();
      const taken = performance.now() - start;
      tell();
      return taken;
    };
  } else {
    requestAnimationFrame(frame);
  }
}

start();
