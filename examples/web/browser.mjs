// Tests the page in a headless Chromium, or records a film of it: see .ci/browser.

import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright-core";

const here = import.meta.dirname;
const BROWSER = ["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run"];
BROWSER.push("--disable-background-networking", "--disable-component-update", "--disable-sync");
const STEPS = 60;
/** The steps after which the scene `settled` starts. */
const SETTLED = 600;
const BODIES = 240;
/** Timeout in milliseconds. The machine may be slow, and draws on its processor. */
const PATIENCE = 120_000;

const server = spawn("python3", ["-u", "-m", "http.server", "0", "--bind", "127.0.0.1", "--directory", join(here, "site")]);
server.stderr.resume();
const address = await new Promise((resolve) => {
  let said = "";
  server.stdout.on("data", (text) => {
    said += text;
    const port = /port (\d+)/.exec(said);
    if (port) resolve(`http://127.0.0.1:${port[1]}/`);
  });
});

/** Opens the page in a new profile, runs an action on it, and checks that there is no error in its console, unless one is expected. */
async function withPage(options, action) {
  const { args = [], query = "", prepare = () => {}, mayFail = false, ...context } = options;
  const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: [...BROWSER, ...args] });
  try {
    const page = await browser.newPage({ viewport: { width: 900, height: 1000 }, ...context });
    page.setDefaultTimeout(PATIENCE);
    const errors = [];
    page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
    page.on("pageerror", (error) => errors.push(error.message));
    await prepare(page);
    await page.goto(`${address}?${query}`);
    await action(page);
    assert.ok(mayFail || errors.length === 0, `in the console: ${errors}`);
  } finally {
    await browser.close();
  }
}

/** Reads the numbers of the page. */
const readNumbers = (page) =>
  page.evaluate(() => {
    const number = (text) => Number(text.replaceAll(",", ""));
    const both = (part) => ["rapier", "unisize"].map((name) => number(document.querySelector(`[data-${part}=${name}]`).textContent));
    const agreement = document.querySelector("#agreement").textContent;
    return {
      steps: number(/step ([\d,]+)/.exec(agreement)?.[1] ?? "-1"),
      isEqual: agreement.includes("are equal to the last bit"),
      trouble: document.querySelector("#trouble").textContent,
      ...Object.fromEntries(["contacts", "pairs", "step", "broad"].map((part) => [part, both(part)])),
    };
  });

async function afterSteps(page, steps) {
  for (const start = Date.now(); Date.now() - start < PATIENCE; await page.waitForTimeout(50)) {
    const found = await readNumbers(page);
    if (found.steps >= steps || found.trouble !== "") return found;
  }
  throw new Error(`fewer than ${steps} steps in ${PATIENCE} ms`);
}

/** Tests every scene on all engines. */
async function scenes() {
  await withPage({ query: `bodies=${BODIES}` }, async (page) => {
    await afterSteps(page, 1);
    const names = await page.locator("[name=scene] option").evaluateAll((options) => options.map(({ value }) => value));
    assert.equal(names.length, 11);
    for (const scene of names) {
      for (const space of ["2d", "3d"]) {
        for (const version of ["027", "036"]) {
          await page.selectOption("[name=scene]", scene);
          await page.selectOption("[name=space]", space);
          await page.selectOption("[name=version]", version);
          await page.fill("[name=bodies]", String(BODIES));
          await page.click("[type=submit]");
          const found = await afterSteps(page, scene === "settled" ? SETTLED + STEPS : STEPS);
          const name = `${scene} ${space} ${version}`;
          assert.equal(found.trouble, "", name);
          const [rapier, unisize] = found.contacts;
          if (found.isEqual && version === "027") assert.equal(rapier, unisize, name);
          assert.ok(Math.abs(rapier - unisize) <= 10 + 0.1 * Math.max(rapier, unisize), `${name}: ${rapier} and ${unisize} contacts`);
          assert.ok(found.pairs[1] >= unisize && found.pairs[0] >= rapier, name);
          for (const side of [0, 1]) assert.ok(found.broad[side] <= found.step[side] && found.step[side] > 0, name);
          console.log(`${name}: ${found.steps} steps, ${rapier} and ${unisize} contacts${found.isEqual ? ", equal to the last bit" : ""}`);
        }
      }
    }
  });
}

/** Tests buttons, keys, boxes, pairs and fat boxes. */
async function switches() {
  await withPage({ query: "scene=hopper&bodies=300" }, async (page) => {
    await afterSteps(page, 40);
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.name), "scene", "the form is reached by keyboard");
    await page.click("#pause");
    await page.waitForTimeout(600);
    const { steps } = await readNumbers(page);
    await page.waitForTimeout(600);
    assert.equal((await readNumbers(page)).steps, steps, "paused");
    await page.click("#step");
    assert.equal((await readNumbers(page)).steps, steps + 1, "one step");
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press("n");
    assert.equal((await readNumbers(page)).steps, steps + 2, "one step by a key");
    const shots = [await page.locator("#unisize").screenshot()];
    for (const overlay of ["boxes", "pairs", "search"]) {
      await page.focus(`[name=${overlay}]`);
      await page.keyboard.press("Space");
      await page.waitForTimeout(500);
      shots.push(await page.locator("#unisize").screenshot());
      assert.notDeepEqual(shots.at(-1), shots.at(-2), `${overlay} are drawn`);
    }
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press("r");
    assert.equal((await readNumbers(page)).steps, 0, "again");
    await page.keyboard.press("Space");
    await afterSteps(page, 5);
  });
  await withPage({ query: "scene=gas&bodies=20000" }, async (page) => {
    await afterSteps(page, 12);
    const start = Date.now();
    await page.click("#pause");
    console.log(`20,000 bodies: the page pauses ${Date.now() - start} ms after the click`);
  });
}

/** Measures pictures of 10,000 bodies, in both views together. */
async function drawing() {
  for (const [scene, space] of [["gas", "3d"], ["gas", "2d"], ["ropes", "3d"], ["columns", "3d"]]) {
    await withPage({ query: `film=${scene}&space=${space}&bodies=10000` }, async (page) => {
      await page.waitForFunction(() => window.film);
      const taken = await page.evaluate(() => Array.from({ length: 21 }, () => window.film(1)).sort((a, b) => a - b));
      console.log(`10,000 bodies, ${scene} ${space}: a picture takes ${taken[10].toFixed(0)} ms, at most ${taken[20].toFixed(0)}`);
    });
  }
}

/** Tests the messages on the page: missing features of the browser, and failures. */
async function troubles() {
  const sentence = async (name, options, pattern, action = () => {}) => {
    await withPage({ query: "bodies=100", mayFail: true, ...options }, async (page) => {
      await action(page);
      await page.waitForFunction(() => !document.querySelector("#trouble").hidden);
      const { trouble } = await readNumbers(page);
      assert.match(trouble, pattern, name);
      console.log(`${name}: ${trouble}`);
      // Without WebGL, the worlds are still simulated.
      if (name === "no WebGL") await page.waitForFunction(() => /step [2-9]\d/.test(document.querySelector("#agreement").textContent));
    });
  };
  await sentence("no WebGL", { args: ["--disable-3d-apis"] }, /WebGL/);
  await sentence("no WebAssembly", { prepare: (page) => page.addInitScript(() => delete window.WebAssembly) }, /WebAssembly/);
  const withoutFile = (page) => page.route("**/*.wasm", (route) => route.abort());
  await sentence("no file", { prepare: withoutFile }, /could not be loaded/);
  await sentence("a panic", {}, /index out of bounds/, async (page) => {
    await afterSteps(page, 2);
    await page.evaluate(async () => {
      const { Side } = await import("./simd-rapier3d-036/engine.js");
      Side.prototype.step = function () {
        this.batch_shape(1_000_000);
      };
    });
  });
  const withoutVectors = (page) => page.addInitScript(() => (WebAssembly.validate = () => false));
  await withPage({ query: "bodies=100", prepare: withoutVectors }, async (page) => {
    await afterSteps(page, 20);
    assert.match(await page.textContent("#build"), /without vectors/);
  });
}

/** Takes screenshots. */
async function pictures() {
  const folder = join(here, "pictures");
  mkdirSync(folder, { recursive: true });
  const shown = [[400, 800, "ropes", "3d"], [900, 1000, "hopper", "3d"], [1600, 1000, "mixed-1.5", "2d"]];
  for (const colorScheme of ["light", "dark"]) {
    for (const [width, height, scene, space] of shown) {
      const query = `scene=${scene}&space=${space}&bodies=1000`;
      await withPage({ query, colorScheme, viewport: { width, height } }, async (page) => {
        await afterSteps(page, 150);
        await page.screenshot({ path: join(folder, `${width}-${colorScheme}.png`), fullPage: true });
        const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
        assert.ok(overflow <= 0, `${width} pixels are too narrow by ${overflow}`);
        if (width === 900) {
          await page.check("[name=pairs]");
          await page.check("[name=boxes]");
          await page.waitForTimeout(1500);
          await page.screenshot({ path: join(folder, `overlays-${colorScheme}.png`), fullPage: true });
        }
        if (width === 1600) {
          await page.check("[name=search]");
          await page.waitForTimeout(1500);
          await page.screenshot({ path: join(folder, `search-${colorScheme}.png`), fullPage: true });
        }
      });
    }
  }
}

/** Records a film in which the worlds move in real time: grains poured through a funnel, then a settled pile. */
async function film() {
  const [rate, stepsPerFrame] = [10, 6];
  let count = 0;
  const frames = mkdtempSync(join(tmpdir(), "film-"));
  const output = join(here, "../../docs/media/side-by-side.gif");
  for (const [scene, firstStep, seconds] of [["hopper", 0, 6], ["settled", SETTLED + STEPS, 3]]) {
    const query = `film=${scene}&space=3d&version=036&bodies=2000`;
    await withPage({ query, colorScheme: "dark", viewport: { width: 800, height: 450 } }, async (page) => {
      await page.waitForFunction(() => window.film);
      await page.evaluate((steps) => window.film(steps), firstStep);
      for (let frame = 0; frame < seconds * rate; frame += 1) {
        await page.evaluate((steps) => window.film(steps), stepsPerFrame);
        await page.screenshot({ path: join(frames, `${String(count).padStart(4, "0")}.png`) });
        count += 1;
      }
    });
  }
  const palette = "split[a][b];[a]palettegen=max_colors=64[p];[b][p]paletteuse=dither=none:diff_mode=rectangle";
  const input = ["-framerate", rate, "-i", join(frames, "%04d.png")];
  const made = spawnSync("ffmpeg", ["-y", "-loglevel", "error", ...input, "-filter_complex", palette, output].map(String), { stdio: "inherit" });
  assert.equal(made.status, 0);
  rmSync(frames, { recursive: true });
  console.log(`written: ${output}`);
}

try {
  if (process.argv.includes("--film")) {
    await film();
  } else {
    const only = process.argv[2];
    for (const part of [scenes, switches, drawing, troubles, pictures]) {
      if (only === undefined || only === part.name) await part();
    }
    console.log("the page passed");
  }
} finally {
  server.kill();
}
