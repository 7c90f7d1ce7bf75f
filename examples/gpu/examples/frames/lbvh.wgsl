// A linear bounding volume hierarchy (Karras 2012, "Maximizing Parallelism in the Construction of BVHs, Octrees, and k-d Trees"), and the
// pairs of boxes by a search from each leaf. `lbvh.rs` puts before it what depends on the number of axes.

const GROUP = 256u;
// Items of a group in the sort.
const BLOCK = 2048u;
const LEAF = 0x80000000u;
// Pairs that a group keeps until it appends them.
const STAGE = 1024u;
// The words of a node: the bounds of both children (lower sides inverted, so that every union is a maximum), the children, how many
// children are known, and the last leaf. No bound is 0.
const WORDS = 4u * D + 4u;

struct Params {
  boxes: u32,
  pair_capacity: u32,
  shift: u32,
  blocks: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> boxes: array<u32>;
// The number of pairs; then the bounds of all boxes, as those of a node.
@group(0) @binding(2) var<storage, read_write> state: array<atomic<u32>>;
// Codes and boxes.
@group(0) @binding(3) var<storage, read> items: array<vec2<u32>>;
@group(0) @binding(4) var<storage, read_write> sorted: array<vec2<u32>>;
@group(0) @binding(5) var<storage, read_write> counts: array<u32>;
@group(0) @binding(6) var<storage, read_write> nodes: array<atomic<u32>>;
@group(0) @binding(7) var<storage, read> tree: array<vec4<u32>>;
// Twice the parent, plus 1 for its right child: of each node, then of each leaf.
@group(0) @binding(8) var<storage, read_write> parents: array<u32>;
@group(0) @binding(9) var<storage, read_write> pairs: array<vec2<u32>>;

// A side of a box as an integer that compares as the number does; inverted if it is a lower one.
fn side(i: u32, k: u32) -> u32 {
  let bits = boxes[2u * D * i + k];
  let key = select(select(bits | LEAF, ~bits, bits > LEAF), LEAF, bits == LEAF);
  return select(key, ~key, k < D);
}

fn number(key: u32) -> f32 { return bitcast<f32>(select(~key, key ^ LEAF, key >= LEAF)); }

var<workgroup> widest: array<atomic<u32>, 2u * D>;

@compute @workgroup_size(GROUP)
fn extent(
  @builtin(global_invocation_id) thread: vec3<u32>,
  @builtin(local_invocation_index) t: u32,
  @builtin(num_workgroups) groups: vec3<u32>,
) {
  var bounds: array<u32, 2u * D>;
  for (var i = thread.x; i < params.boxes; i += GROUP * groups.x) {
    for (var k = 0u; k < 2u * D; k++) { bounds[k] = max(bounds[k], side(i, k)); }
  }
  for (var k = 0u; k < 2u * D; k++) { atomicMax(&widest[k], bounds[k]); }
  workgroupBarrier();
  if t < 2u * D { atomicMax(&state[1u + t], atomicLoad(&widest[t])); }
}

// The Morton codes of the centres.
@compute @workgroup_size(GROUP)
fn encode(@builtin(global_invocation_id) thread: vec3<u32>) {
  let i = thread.x;
  if i >= params.boxes { return; }
  let bits = 32u / D;
  var code = 0u;
  for (var k = 0u; k < D; k++) {
    let low = number(~atomicLoad(&state[1u + k]));
    let high = number(atomicLoad(&state[1u + D + k]));
    let centre = 0.5 * number(~side(i, k)) + 0.5 * number(side(i, D + k));
    let cells = f32(1u << bits);
    let cell = u32(clamp((centre - low) / (high - low) * cells, 0.0, cells - 1.0));
    for (var b = 0u; b < bits; b++) { code |= ((cell >> b) & 1u) << (D * b + k); }
  }
  sorted[i] = vec2<u32>(code, i);
}

// ---- A stable sort by eight bits of the code.

fn digit_of(item: vec2<u32>) -> u32 { return (item.x >> params.shift) & 255u; }

var<workgroup> tally: array<atomic<u32>, GROUP>;

@compute @workgroup_size(GROUP)
fn count(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) t: u32) {
  for (var i = group.x * BLOCK + t; i < min((group.x + 1u) * BLOCK, params.boxes); i += GROUP) {
    atomicAdd(&tally[digit_of(items[i])], 1u);
  }
  workgroupBarrier();
  counts[t * params.blocks + group.x] = atomicLoad(&tally[t]);
}

var<workgroup> sums: array<u32, GROUP>;

// The sum of `x` over this thread and those before it.
fn sum_to(t: u32, x: u32) -> u32 {
  sums[t] = x;
  workgroupBarrier();
  for (var step = 1u; step < GROUP; step *= 2u) {
    var earlier = 0u;
    if t >= step { earlier = sums[t - step]; }
    workgroupBarrier();
    sums[t] += earlier;
    workgroupBarrier();
  }
  return sums[t];
}

// One group for each digit.
@compute @workgroup_size(GROUP)
fn scan(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) t: u32) {
  var before = 0u;
  for (var first = 0u; first < params.blocks; first += GROUP) {
    let at = group.x * params.blocks + first + t;
    var here = 0u;
    if first + t < params.blocks { here = counts[at]; }
    let sum = sum_to(t, here);
    if first + t < params.blocks { counts[at] = before + sum - here; }
    before += sums[GROUP - 1u];
    workgroupBarrier();
  }
  if t == 0u { counts[GROUP * params.blocks + group.x] = before; }
}

var<workgroup> offsets: array<u32, GROUP>;
// For each digit, which threads have it.
var<workgroup> masks: array<array<atomic<u32>, GROUP>, GROUP / 32u>;

@compute @workgroup_size(GROUP)
fn scatter(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) t: u32) {
  let total = counts[GROUP * params.blocks + t];
  offsets[t] = sum_to(t, total) - total + counts[t * params.blocks + group.x];
  workgroupBarrier();
  for (var round = 0u; round < BLOCK / GROUP; round++) {
    let i = group.x * BLOCK + round * GROUP + t;
    let item = items[min(i, params.boxes - 1u)];
    let digit = digit_of(item);
    if i < params.boxes { atomicOr(&masks[t / 32u][digit], 1u << (t % 32u)); }
    workgroupBarrier();
    var at = offsets[digit] + countOneBits(atomicLoad(&masks[t / 32u][digit]) & ((1u << (t % 32u)) - 1u));
    for (var w = 0u; w < t / 32u; w++) { at += countOneBits(atomicLoad(&masks[w][digit])); }
    if i < params.boxes { sorted[at] = item; }
    workgroupBarrier();
    for (var w = 0u; w < GROUP / 32u; w++) { offsets[t] += countOneBits(atomicExchange(&masks[w][t], 0u)); }
    workgroupBarrier();
  }
}

// ---- The tree.

// How many bits leaves `i` and `j` share from the highest on; of equal codes, their places count.
fn shared_bits(i: i32, j: i32) -> i32 {
  if j < 0 || j >= i32(params.boxes) { return -1; }
  let differing = items[i].x ^ items[j].x;
  if differing == 0u { return 32 + i32(countLeadingZeros(u32(i ^ j))); }
  return i32(countLeadingZeros(differing));
}

// The children of each inner node, as sections 3 and 4 of the paper find them.
@compute @workgroup_size(GROUP)
fn link(@builtin(global_invocation_id) thread: vec3<u32>) {
  let i = i32(thread.x);
  if thread.x + 1u >= params.boxes { return; }
  let step = select(-1, 1, shared_bits(i, i + 1) > shared_bits(i, i - 1));
  let outside = shared_bits(i, i - step);
  var bound = 2;
  while shared_bits(i, i + bound * step) > outside { bound *= 2; }
  var length = 0;
  for (var half = bound / 2; half > 0; half /= 2) {
    if shared_bits(i, i + (length + half) * step) > outside { length += half; }
  }
  let inside = shared_bits(i, i + length * step);
  var before = 0;
  var part = length;
  while part > 1 {
    part = (part + 1) / 2;
    if shared_bits(i, i + (before + part) * step) > inside { before += part; }
  }
  let split = u32(i + before * step + min(step, 0));
  let first = u32(min(i, i + length * step));
  let last = u32(max(i, i + length * step));
  let is_leaf = vec2<bool>(first == split, last == split + 1u);
  for (var k = 0u; k < 2u; k++) {
    let child = split + k;
    parents[select(child, params.boxes + child, is_leaf[k])] = 2u * thread.x + k;
    atomicStore(&nodes[WORDS * thread.x + 4u * D + k], select(child, child | LEAF, is_leaf[k]));
  }
  atomicStore(&nodes[WORDS * thread.x + 4u * D + 3u], last);
}

// The bounds, upwards from each leaf. Of the two threads that come to a node, the second one goes on.
@compute @workgroup_size(GROUP)
fn bound(@builtin(global_invocation_id) thread: vec3<u32>) {
  if thread.x >= params.boxes { return; }
  let id = items[thread.x].y;
  var bounds: array<u32, 2u * D>;
  for (var k = 0u; k < 2u * D; k++) { bounds[k] = side(id, k); }
  var child = params.boxes + thread.x;
  while child != 0u {
    let link = parents[child];
    child = link / 2u;
    let at = WORDS * child + 2u * D * (link & 1u);
    for (var k = 0u; k < 2u * D; k++) { atomicStore(&nodes[at + k], bounds[k]); }
    if atomicAdd(&nodes[WORDS * child + 4u * D + 2u], 1u) == 0u { return; }
    let sibling = WORDS * child + 2u * D * (1u - (link & 1u));
    for (var k = 0u; k < 2u * D; k++) {
      var other = 0u;
      // Atomic operations have no order between addresses, so that a bound may come after its count.
      while other == 0u { other = atomicLoad(&nodes[sibling + k]); }
      bounds[k] = max(bounds[k], other);
    }
  }
}

// ---- The pairs.

var<workgroup> staged: atomic<u32>;
var<workgroup> base: u32;
var<workgroup> stage: array<vec2<u32>, STAGE>;

fn report(id: u32, leaf: u32) {
  let other = items[leaf & ~LEAF].y;
  let pair = vec2<u32>(min(id, other), max(id, other));
  let at = atomicAdd(&staged, 1u);
  if at < STAGE { stage[at] = pair; } else { write(atomicAdd(&state[0], 1u), pair); }
}

fn write(at: u32, pair: vec2<u32>) {
  if at < params.pair_capacity { pairs[at] = pair; }
}

// Each leaf looks for those after it.
@compute @workgroup_size(GROUP)
fn find(@builtin(global_invocation_id) thread: vec3<u32>, @builtin(local_invocation_index) t: u32) {
  let p = thread.x;
  if p < params.boxes {
    let link = parents[params.boxes + p];
    let parent = node(link / 2u);
    let mins = ~select(parent.left_mins, parent.right_mins, (link & 1u) == 1u);
    let maxs = select(parent.left_maxs, parent.right_maxs, (link & 1u) == 1u);
    let id = items[p].y;
    // One for each bit of a code, and of a place below 2^23.
    var stack: array<u32, 55>;
    var depth = 0u;
    var at = 0u;
    loop {
      let node = node(at);
      let left = node.links.x;
      let right = node.links.y;
      var goes_left = (left & ~LEAF) > p && all(mins <= node.left_maxs) && all(~node.left_mins <= maxs);
      var goes_right = node.links.w > p && all(mins <= node.right_maxs) && all(~node.right_mins <= maxs);
      if goes_left && left >= LEAF { report(id, left); goes_left = false; }
      if goes_right && right >= LEAF { report(id, right); goes_right = false; }
      if goes_left && goes_right { stack[depth] = right; depth += 1u; }
      if goes_left { at = left; continue; }
      if goes_right { at = right; continue; }
      if depth == 0u { break; }
      depth -= 1u;
      at = stack[depth];
    }
  }
  workgroupBarrier();
  let total = min(atomicLoad(&staged), STAGE);
  if t == 0u { base = atomicAdd(&state[0], total); }
  workgroupBarrier();
  for (var i = t; i < total; i += GROUP) { write(base + i, stage[i]); }
}
