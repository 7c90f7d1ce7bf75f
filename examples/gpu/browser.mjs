// The shaders of this package in Chromium's WebGPU, against brute force: examples/gpu/browser says how.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { join } from "node:path";

const here = import.meta.dirname;
const { chromium } = createRequire(join(here, "../web/package.json"))("playwright-core");
const shader = (name) => readFileSync(join(here, "src/shaders", `${name}.wgsl`), "utf8");
const ARGUMENTS = ["--no-sandbox", "--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader", "--enable-unsafe-swiftshader"];

/** In the browser: the host part of `src/sweep.rs`. Returns for each list of boxes what differs from brute force. */
async function check({ sources, lists }) {
  const adapter = await navigator.gpu?.requestAdapter();
  if (!adapter) return "no adapter";
  const device = await adapter.requestDevice();
  const errors = [];
  device.onuncapturederror = ({ error }) => errors.push(error.message);
  const { STORAGE, UNIFORM, COPY_SRC, COPY_DST, INDIRECT, MAP_READ } = GPUBufferUsage;
  const bindings = (axes) => {
    const ids = axes === 2;
    return {
      choose: [0, 1, 2, 3, 7],
      assign: [0, 1, 2, 3, 4, 6, 7],
      sum_counts: [2, 3, 4, 8],
      scan_counts: [2, 4, 8],
      scatter: ids ? [0, 1, 5, 6, 9, 10] : [0, 1, 5, 6, 9],
      find: ids ? [0, 3, 5, 11, 12, 13, 14, 15, 16] : [0, 3, 5, 11, 12, 13, 14, 15],
      find_long: ids ? [0, 3, 5, 11, 12, 14, 15, 16] : [0, 3, 5, 11, 12, 14, 15],
      finish: [0, 3, 17],
    };
  };
  const results = [];
  for (const { name, axes, sides } of lists) {
    const count = sides.length / (2 * axes);
    const capacity = Math.max(count, 1);
    const module = device.createShaderModule({ code: sources[axes] });
    const pairCapacity = 1 << 20;
    const cells = 2 * capacity + 2047;
    const buffer = (words, usage = 0, content) => {
      const made = device.createBuffer({ size: 4 * words, usage: STORAGE | COPY_DST | COPY_SRC | usage });
      if (content) device.queue.writeBuffer(made, 0, content);
      return made;
    };
    const state = new Uint32Array(16);
    state[1] = 0xffffffff;
    state[8] = count;
    const plan = buffer(132);
    const starts = buffer(cells + 1);
    const entries = buffer(8 * capacity);
    const ids = buffer(capacity);
    const params = buffer(8, UNIFORM, new Uint32Array([count, capacity, pairCapacity, cells, 0, 1, 0, 0]));
    const boxes = buffer(sides.length || 1, 0, new Float32Array(sides));
    const buffers = [params, boxes, plan, buffer(16, 0, state), starts, starts, buffer(2 * capacity), buffer(2 * capacity)];
    buffers.push(buffer(Math.ceil((cells + 1) / 2048)), entries, ids, buffer(2 * pairCapacity), buffer(capacity));
    buffers.push(buffer(3, INDIRECT, new Uint32Array([0, 1, 1])), plan, entries, ids, buffer(7));
    const encoder = device.createCommandEncoder();
    const run = (kernel, groups) => {
      const pipeline = device.createComputePipeline({ layout: "auto", compute: { module, entryPoint: kernel } });
      const bound = bindings(axes)[kernel].map((binding) => ({ binding, resource: { buffer: buffers[binding] } }));
      const pass = encoder.beginComputePass();
      pass.setPipeline(pipeline);
      pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries: bound }));
      if (kernel === "find_long") pass.dispatchWorkgroupsIndirect(buffers[13], 0);
      else pass.dispatchWorkgroups(groups);
      pass.end();
    };
    for (let level = 0; level < 4; level++) {
      run("choose", 1);
      run("assign", Math.ceil(capacity / 256));
    }
    run("sum_counts", Math.ceil((cells + 1) / 2048));
    run("scan_counts", Math.ceil((cells + 1) / 2048));
    run("scatter", Math.ceil(capacity / 256));
    run("find", Math.ceil(capacity / 128));
    run("find_long");
    run("finish", 1);
    const copies = [buffers[17], buffers[11]].map((from) => {
      const copy = device.createBuffer({ size: from.size, usage: MAP_READ | COPY_DST });
      encoder.copyBufferToBuffer(from, 0, copy, 0, from.size);
      return copy;
    });
    device.queue.submit([encoder.finish()]);
    await Promise.all(copies.map((copy) => copy.mapAsync(GPUMapMode.READ)));
    const [words, pairs] = copies.map((copy) => new Uint32Array(copy.getMappedRange()));
    const found = [];
    for (let i = 0; i < words[3]; i++) found.push(pairs[2 * i] * count + pairs[2 * i + 1]);
    const rounded = new Float32Array(sides);
    const expected = [];
    for (let a = 0; a < count; a++) {
      for (let b = a + 1; b < count; b++) {
        let overlap = true;
        for (let k = 0; k < axes; k++) {
          const [i, j] = [2 * axes * a + k, 2 * axes * b + k];
          overlap &&= rounded[i] <= rounded[j + axes] && rounded[j] <= rounded[i + axes];
        }
        if (overlap) expected.push(a * count + b);
      }
    }
    found.sort((a, b) => a - b);
    const same = found.length === expected.length && found.every((pair, i) => pair === expected[i]);
    results.push({ name, found: words[4], expected: expected.length, invalid: words[6], same });
    for (const each of [...new Set([...buffers, ...copies])]) each.destroy();
  }
  return { adapter: `${adapter.info.vendor} ${adapter.info.architecture}`, errors, results };
}

/** Numbers from a seed, in 0..1. */
function random(seed) {
  return () => {
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    return seed / 2 ** 32;
  };
}

const lists = [];
for (const axes of [2, 3]) {
  const add = (name, count, extent, side) => {
    const next = random(lists.length + 1);
    const sides = [];
    for (let i = 0; i < count; i++) {
      const mins = Array.from({ length: axes }, () => extent * next());
      sides.push(...mins, ...mins.map((x, k) => Math.fround(x) + side(next, k, i)));
    }
    lists.push({ name: `${name}, ${axes}D`, axes, sides });
  };
  const unit = () => 1;
  add("one box", 1, 1, unit);
  add("uniform", 10_000, (10_000 / 0.3) ** (1 / axes), unit);
  add("uniform at 1e7", 2_000, 1e7, unit);
  add("all in one place", 1_200, 0, unit);
  add("sizes from 1 to 1,000", 3_000, 3e3, (next) => 1000 ** next());
  add("some huge", 5_000, 5e2, (next, k, i) => (i % 500 ? 1 : 200));
  add("walls", 3_000, 2e2, (next, k, i) => (i % 8 === 0 && k === i % axes ? 200 : 0.5));
  // Subnormal numbers, which a GPU may take for 0.
  add("subnormal", 300, 1e-41, (next) => 1e-43 * Math.floor(3 * next()));
}

const server = createServer((request, response) => response.end("<!doctype html><title>WebGPU</title>"));
await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: ARGUMENTS });
try {
  const page = await browser.newPage();
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  const sources = Object.fromEntries([2, 3].map((axes) => [axes, `${shader(`dim${axes}`)}\n${shader("sweep")}`]));
  const answer = await page.evaluate(check, { sources, lists });
  assert.notEqual(answer, "no adapter", "Chromium has no adapter for WebGPU");
  assert.deepEqual(answer.errors, []);
  for (const { name, found, expected, invalid, same } of answer.results) {
    console.log(`${name}: ${found} pairs`);
    assert.ok(same && found === expected && invalid === 0xffffffff, `${name}: brute force finds ${expected}`);
  }
  console.log(`${answer.results.length} lists of boxes are equal to brute force, on ${answer.adapter}`);
} finally {
  await browser.close();
  server.close();
}
