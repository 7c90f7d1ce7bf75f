// Finds the overlapping pairs of boxes. `dim2.wgsl` or `dim3.wgsl` goes before it.
//
// Only integers decide which pairs overlap and where boxes are entered, because a GPU may flush subnormals, ignore infinities and fuse
// operations. Floats choose grids, on which only the speed depends.

// Size classes, finest first. The last one accepts boxes of every size.
const CLASSES = 4u;
const GROUP = 256u;
const PAIR_GROUP = 128u;
// A dispatch of more groups than a dimension may have is that many wide.
const WIDTH = 32768u;
const SAMPLES = 256u;
const SCANNED = 2048u;
// Pairs that a group keeps until it appends them.
const STAGE = 1024u;
// A thread that finds more rows in a range, or more entries in a row, leaves them to a whole group.
const LONG_RANGE = 16u;
const LONG_ROW = 256u;
const LANES = 16u;
// Places saturate at this number of quanta, so that an i32 can hold the sum of three.
const FARTHEST = 536870912;
// The greatest finite number, as a key.
const LARGEST = 0x7f7fffff;
const NO_CELL = 0xffffffffu;
// Words of `state`.
const LEVEL = 0u;
const INVALID = 1u;
const FOUND = 2u; // And its high word.
const LONG = 4u;
const WIDEST = 5u; // One for each axis.
const LEFT = 8u; // How many boxes each class was offered.

struct Params {
  boxes: u32,
  // How many boxes and pairs there is memory for, and cells in the tables of all classes.
  box_capacity: u32,
  pair_capacity: u32,
  cell_capacity: u32,
  // Whether the grids of the last frame are kept.
  keeps_grids: u32,
  // Groups that share each box whose work is long.
  shares: u32,
}

// A place on an axis is floor(x / 2^exponent), saturated. Its cell is (place - origin, clamped to 0..=extent) * multiplier >> shift.
// Both are monotone in x.
struct Grid {
  exponent: I,
  origin: I,
  extent: I,
  multiplier: U,
  shift: U,
  dims: U,
  // The most that the places of a member's two sides differ.
  reach: I,
  // The first cell, and how many there are.
  first: u32,
  cells: u32,
  // A bit for each class in which members of this class look for partners.
  partners: u32,
}

struct Grids {
  grids: array<Grid, CLASSES>,
  cells: u32,
}

struct Entry {
  mins: I,
  maxs: I,
  id: u32,
}

// Some buffers have two names: no kernel writes one that it reads by the other.
@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> boxes: array<i32>;
@group(0) @binding(2) var<storage, read_write> plan: Grids;
@group(0) @binding(3) var<storage, read_write> state: array<atomic<u32>>;
@group(0) @binding(4) var<storage, read_write> counts: array<atomic<u32>>;
@group(0) @binding(5) var<storage, read> starts: array<u32>;
@group(0) @binding(6) var<storage, read_write> slots: array<vec2<u32>>;
@group(0) @binding(7) var<storage, read_write> lists: array<u32>;
@group(0) @binding(8) var<storage, read_write> sums: array<u32>;
@group(0) @binding(9) var<storage, read_write> sorted_entries: array<vec4<i32>>;
@group(0) @binding(10) var<storage, read_write> sorted_ids: array<u32>;
@group(0) @binding(11) var<storage, read_write> pairs: array<vec2<u32>>;
@group(0) @binding(12) var<storage, read_write> long_entries: array<u32>;
@group(0) @binding(13) var<storage, read_write> long_groups: array<atomic<u32>>;
@group(0) @binding(14) var<storage, read> planned: Grids;
@group(0) @binding(15) var<storage, read> entries: array<vec4<i32>>;
@group(0) @binding(16) var<storage, read> ids: array<u32>;
@group(0) @binding(17) var<storage, read_write> counted: array<u32>;

fn group_index(group: vec3<u32>) -> u32 { return group.y * WIDTH + group.x; }

// An integer that compares as the number does, from its bits; both zeros have the same one.
fn key(bits: I) -> I {
  let magnitude = bits & I(0x7fffffff);
  let ordered = select(bits, -1 - magnitude, bits < I(0));
  return select(ordered, I(0), magnitude == I(0));
}

fn bits_of(key: I) -> I { return select(key, (-1 - key) | I(i32(0x80000000u)), key < I(0)); }

fn is_valid(mins: I, maxs: I) -> bool {
  let infinity = I(0x7f800000);
  let are_numbers = all((mins & I(0x7fffffff)) <= infinity) && all((maxs & I(0x7fffffff)) <= infinity);
  return are_numbers && all(key(mins) <= key(maxs));
}

// floor(x / 2^exponent), saturated, for exponents from -149 to 100.
fn place(key: I, exponent: I) -> I {
  let bits = bits_of(key);
  let biased = (bits >> U(23u)) & I(255);
  let mantissa = (bits & I(0x7fffff)) | select(I(0x800000), I(0), biased == I(0));
  let is_negative = bits < I(0);
  let signed = select(mantissa, -mantissa, is_negative);
  let shift = max(biased, I(1)) - I(150) - exponent;
  let up = signed << U(clamp(shift, I(0), I(5)));
  let down = signed >> U(clamp(-shift, I(0), I(31)));
  let shifted = select(down, up, shift >= I(0));
  return select(shifted, select(I(FARTHEST), I(-FARTHEST), is_negative), shift > I(5));
}

fn cell_of(grid: Grid, place: I) -> U {
  let offset = U(clamp(place - grid.origin, I(0), grid.extent));
  return (offset * grid.multiplier) >> grid.shift;
}

// ---- The grid of one class, by a sample of the boxes that finer classes have left.

var<workgroup> sampled: array<I, SAMPLES>;
// The least key of the sample, the ends of its middle seven eighths, and the greatest.
var<workgroup> quantiles: array<array<i32, D>, 4>;
var<workgroup> widest: array<atomic<u32>, 3>;
var<workgroup> best: atomic<u32>;

fn exponent_of(x: F) -> I { return ((bitcast<I>(x) >> U(23u)) & I(255)) - I(127); }

fn sides_for(least: F, extent: F, cells: f32) -> F {
  var sides = least;
  for (var i = 0; i < 4; i++) {
    let excess = product(max(extent / sides, F(1.0))) / cells;
    if excess > 1.0 { sides *= pow(excess, 1.0 / f32(D)); }
  }
  return clamp(sides, F(1.0), F(4194304.0));
}

@compute @workgroup_size(GROUP)
fn choose(@builtin(local_invocation_index) t: u32) {
  if params.keeps_grids != 0u {
    if t == 0u { atomicAdd(&state[LEVEL], 1u); }
    return;
  }
  let level = atomicLoad(&state[LEVEL]);
  let n = atomicLoad(&state[LEFT + level]);
  let samples = min(n, SAMPLES);
  var mins = I(0);
  var maxs = I(0);
  if t < samples {
    let stride = n / samples;
    // A random one of each stretch, so that no period in the order of the boxes hides some of them.
    var i = stride * t + (n % samples) * t / samples + ((t * 747796405u + 2891336453u) >> 16u) % stride;
    if level > 0u { i = lists[(level & 1u) * params.box_capacity + i]; }
    let bits_of_mins = box_mins(i);
    let bits_of_maxs = box_maxs(i);
    if is_valid(bits_of_mins, bits_of_maxs) {
      mins = key(bits_of_mins);
      maxs = key(bits_of_maxs);
    }
  }
  let start = clamp(mins, I(-1 - LARGEST), I(LARGEST));
  sampled[t] = start;
  workgroupBarrier();

  var rank = U(0u);
  for (var j = 0u; j < samples; j++) {
    let other = sampled[j];
    rank += select(U(0u), U(1u), select(other < start, other <= start, j < t));
  }
  if t < samples {
    let margin = samples / 16u;
    for (var k = 0u; k < D; k++) {
      if rank[k] == 0u { quantiles[0][k] = start[k]; }
      if rank[k] == margin { quantiles[1][k] = start[k]; }
      if rank[k] == samples - 1u - margin { quantiles[2][k] = start[k]; }
      if rank[k] == samples - 1u { quantiles[3][k] = start[k]; }
    }
  }
  workgroupBarrier();

  // Where most boxes are, without a few that are far away. Quarters, lest something overflows.
  let inner = bitcast<F>(bits_of(vector(quantiles[1]))) * 0.25;
  let outer = bitcast<F>(bits_of(vector(quantiles[2]))) * 0.25;
  let beyond = (outer - inner) * 0.5;
  let low = max(bitcast<F>(bits_of(vector(quantiles[0]))) * 0.25, inner - beyond);
  let high = min(bitcast<F>(bits_of(vector(quantiles[3]))) * 0.25, outer + beyond);
  let fringe = (high - low) / 128.0;
  // So many quanta that the range has at most 2^21 of them, and the places in it are less than 2^28.
  let by_range = exponent_of(high - low + 2.0 * fringe) + I(3 - 21);
  let by_place = exponent_of(max(abs(low - fringe), abs(high + fringe))) + I(3 - 28);
  var grid: Grid;
  grid.exponent = clamp(max(by_range, by_place), I(-149), I(100));
  grid.origin = place(key(bitcast<I>((low - fringe) * 4.0)), grid.exponent);
  let end = place(key(bitcast<I>((high + fringe) * 4.0)), grid.exponent);
  grid.extent = clamp(end - grid.origin, I(0), I(4194303));

  let size = clamp(place(maxs, grid.exponent) - place(mins, grid.exponent), I(0), I(FARTHEST));
  sampled[t] = size;
  for (var k = 0u; k < D; k++) { atomicMax(&widest[k], u32(size[k])); }
  workgroupBarrier();

  // Each thread proposes a class: boxes no larger than its own box, or than this and three more; the first, boxes of all sizes.
  var limit = size;
  if t % 2u == 1u {
    limit = max(max(limit, sampled[(t + 64u) % GROUP]), max(sampled[(t + 128u) % GROUP], sampled[(t + 192u) % GROUP]));
  }
  if t == 0u {
    for (var k = 0u; k < D; k++) { limit[k] = i32(atomicLoad(&widest[k])); }
  }
  grid.reach = min(limit + limit / 8 + 2, I(FARTHEST));
  var members = 0u;
  for (var j = 0u; j < samples; j++) {
    members += select(0u, 1u, all(sampled[j] <= grid.reach));
  }

  if level > 0u {
    grid.first = plan.grids[level - 1u].first + plan.grids[level - 1u].cells;
  }
  let room = f32(params.cell_capacity - grid.first - 1u - 16u * (CLASSES - 1u - level));
  let share = f32(members) / f32(max(samples, 1u));
  let reach = F(grid.reach);
  let extent = F(grid.extent) + 1.0;
  let cells = min(share * f32(n) + 64.0, room);
  var sides = sides_for(reach, extent, cells);
  // The work of a member: the rows that it visits, and the entries in them.
  let spans = 1.0 + 2.0 * reach / sides;
  let rows = product(spans) / spans.x;
  let visited = share * f32(n) * product(min((2.0 * reach + sides) / extent, F(1.0)));
  var cost = f32(members) * (4.0 * rows + visited);
  if members < samples {
    // Each member looks for partners in the coarser classes, and those that are left are more work.
    cost += 16.0 * f32(members) + 64.0 * f32(samples - members);
  }
  if t < max(samples, 1u) {
    // Positive floats compare as their bits do.
    let bits = bitcast<u32>(clamp(cost, 0.0, 3e38));
    atomicMax(&best, ~((bits & ~255u) | t));
  }
  workgroupBarrier();

  if t == select(~atomicLoad(&best) & 255u, 0u, level == CLASSES - 1u) {
    for (var i = 0; i < 64; i++) {
      let whole = clamp(U(sides), U(1u), U(4194304u));
      grid.shift = firstLeadingBit(whole) + 9u;
      grid.multiplier = clamp(U(exp2(F(grid.shift)) / sides), U(1u), U(1023u));
      grid.dims = ((U(grid.extent) * grid.multiplier) >> grid.shift) + 1u;
      let product_of_dims = product(F(grid.dims));
      if product_of_dims <= 1.5 * cells && product_of_dims * 1.001 <= room { break; }
      sides = min(sides * 1.5, F(4194304.0));
    }
    grid.cells = cell_index(grid.dims - 1u, grid.dims) + 1u;
    plan.grids[level] = grid;
    plan.cells = grid.first + grid.cells;
    atomicStore(&state[LEVEL], level + 1u);
  }
}

// ---- The cells of the boxes of one class; the others are left to the next.

var<workgroup> group_count: atomic<u32>;
var<workgroup> group_base: u32;

@compute @workgroup_size(GROUP)
fn assign(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) t: u32) {
  let i = group_index(group) * GROUP + t;
  let level = atomicLoad(&state[LEVEL]) - 1u;
  var id = i;
  var is_left = false;
  var rank = 0u;
  if i < atomicLoad(&state[LEFT + level]) {
    if level > 0u { id = lists[(level & 1u) * params.box_capacity + i]; }
    let mins = box_mins(id);
    let maxs = box_maxs(id);
    if is_valid(mins, maxs) {
      let grid = plan.grids[level];
      let start = place(key(mins), grid.exponent);
      let size = place(key(maxs), grid.exponent) - start;
      is_left = any(size > grid.reach);
      if is_left && level == CLASSES - 1u {
        is_left = false;
        for (var k = 0u; k < D; k++) { atomicMax(&state[WIDEST + k], u32(size[k])); }
      }
      if is_left {
        rank = atomicAdd(&group_count, 1u);
      } else {
        let cell = grid.first + cell_index(cell_of(grid, start), grid.dims);
        slots[id] = vec2<u32>(cell, atomicAdd(&counts[cell], 1u));
      }
    } else {
      atomicMin(&state[INVALID], id);
      slots[id] = vec2<u32>(NO_CELL, 0u);
    }
  }
  workgroupBarrier();
  if t == 0u { group_base = atomicAdd(&state[LEFT + level + 1u], atomicLoad(&group_count)); }
  workgroupBarrier();
  if is_left { lists[((level + 1u) & 1u) * params.box_capacity + group_base + rank] = id; }
}

// ---- Where the entries of each cell start.

var<workgroup> group_sum: atomic<u32>;
var<workgroup> scanned: array<u32, SCANNED>;
var<workgroup> thread_sums: array<u32, GROUP>;

@compute @workgroup_size(GROUP)
fn sum_counts(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) t: u32) {
  let block = group_index(group);
  if block == 0u && t == 0u { choose_partners(); }
  var sum = 0u;
  for (var i = t; i < SCANNED; i += GROUP) {
    let cell = block * SCANNED + i;
    if cell < plan.cells { sum += atomicLoad(&counts[cell]); }
  }
  atomicAdd(&group_sum, sum);
  workgroupBarrier();
  if t == 0u { sums[block] = atomicLoad(&group_sum); }
}

// For each two classes, decides once whose members look for partners in the grid of the other: those with less work, by an estimate.
fn choose_partners() {
  for (var k = 0u; k < D; k++) {
    let widest_member = i32(atomicLoad(&state[WIDEST + k]));
    plan.grids[CLASSES - 1u].reach[k] = max(plan.grids[CLASSES - 1u].reach[k], widest_member);
  }
  for (var a = 0u; a < CLASSES; a++) { plan.grids[a].partners = 1u << a; }
  for (var b = 1u; b < CLASSES; b++) {
    for (var a = 0u; a < b; a++) {
      if class_count(a) == 0.0 || class_count(b) == 0.0 { continue; }
      if lookup_cost(a, b) <= lookup_cost(b, a) {
        plan.grids[a].partners |= 1u << b;
      } else {
        plan.grids[b].partners |= 1u << a;
      }
    }
  }
}

fn class_count(a: u32) -> f32 {
  return f32(atomicLoad(&state[LEFT + a]) - atomicLoad(&state[LEFT + a + 1u]));
}

fn lookup_cost(a: u32, b: u32) -> f32 {
  let grid = plan.grids[b];
  let scale = exp2(F(clamp(plan.grids[a].exponent - grid.exponent, I(-60), I(60))));
  let size = F(plan.grids[a].reach) * scale;
  let extent = F(grid.extent) + 1.0;
  let sides = extent / F(grid.dims);
  let spans = min(1.0 + (size + F(grid.reach)) / sides, F(grid.dims));
  let rows = product(spans) / spans.x;
  return class_count(a) * (4.0 * rows + class_count(b) * product(spans / F(grid.dims)));
}

@compute @workgroup_size(GROUP)
fn scan_counts(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) t: u32) {
  let block = group_index(group);
  var before = 0u;
  for (var i = t; i < block; i += GROUP) {
    before += sums[i];
  }
  atomicAdd(&group_sum, before);
  for (var i = t; i < SCANNED; i += GROUP) {
    let cell = block * SCANNED + i;
    scanned[i] = 0u;
    if cell < plan.cells { scanned[i] = atomicLoad(&counts[cell]); }
  }
  workgroupBarrier();
  let each = SCANNED / GROUP;
  var sum = 0u;
  for (var i = 0u; i < each; i++) { sum += scanned[t * each + i]; }
  thread_sums[t] = sum;
  workgroupBarrier();
  for (var step = 1u; step < GROUP; step *= 2u) {
    var earlier = 0u;
    if t >= step { earlier = thread_sums[t - step]; }
    workgroupBarrier();
    thread_sums[t] += earlier;
    workgroupBarrier();
  }
  var start = atomicLoad(&group_sum) + thread_sums[t] - sum;
  for (var i = 0u; i < each; i++) {
    let count = scanned[t * each + i];
    scanned[t * each + i] = start;
    start += count;
  }
  workgroupBarrier();
  // The cell past the last one is where all entries end.
  for (var i = t; i < SCANNED; i += GROUP) {
    let cell = block * SCANNED + i;
    if cell <= plan.cells { atomicStore(&counts[cell], scanned[i]); }
  }
}

@compute @workgroup_size(GROUP)
fn scatter(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) t: u32) {
  let id = group_index(group) * GROUP + t;
  if id >= params.boxes { return; }
  let slot = slots[id];
  if slot.x != NO_CELL {
    write_entry(starts[slot.x] + slot.y, Entry(key(box_mins(id)), key(box_maxs(id)), id));
  }
}

// ---- The pairs.

var<workgroup> staged: atomic<u32>;
var<workgroup> handed_out: atomic<u32>;
var<workgroup> stage: array<vec2<u32>, STAGE>;

var<private> seeker: Entry;
var<private> found: u32;
// Where this thread writes its pairs, if the group finds more than it can keep.
var<private> cursor: u32;
var<private> is_writing: bool;

fn report(other: u32) {
  let pair = vec2<u32>(min(seeker.id, other), max(seeker.id, other));
  if is_writing {
    if cursor < params.pair_capacity { pairs[cursor] = pair; }
    cursor += 1u;
  } else {
    let at = atomicAdd(&staged, 1u);
    if at < STAGE { stage[at] = pair; }
    found += 1u;
  }
}

// Finds the partners of entry `p`, as one of so many threads that share it. One thread alone leaves long rows and ranges out, and returns
// whether there were any; several take only these.
//
// Let A look for B in a grid. If they overlap, place(A.mins) <= place(B.maxs) <= place(B.mins) + reach and place(B.mins) <= place(A.maxs), so
// the cell of B is in the range. In a class of its own, A takes only the entries after its own, so that one of each pair finds the other.
fn search(p: u32, thread: u32, threads: u32) -> bool {
  var is_long = false;
  var own_class = 0u;
  for (var b = 1u; b < CLASSES; b++) {
    if p >= starts[planned.grids[b].first] { own_class = b; }
  }
  for (var b = 0u; b < CLASSES; b++) {
    let grid = planned.grids[b];
    let is_own = b == own_class;
    if ((planned.grids[own_class].partners >> b) & 1u) == 0u { continue; }
    let start = place(seeker.mins, grid.exponent);
    let own = cell_of(grid, start);
    var low = cell_of(grid, start - grid.reach);
    let high = cell_of(grid, place(seeker.maxs, grid.exponent));
    if is_own { low = from_own(low, own); }
    let own_row = cell_index(row_of(low, own), grid.dims);
    let rows = row_count(low, high);
    let is_wide = rows > LONG_RANGE;
    if is_wide && threads == 1u { is_long = true; continue; }
    let lanes = select(threads, LANES, is_wide);
    for (var row = thread / lanes; row < rows; row += threads / lanes) {
      let cell = cell_index(row_start(low, high, row), grid.dims);
      var first = starts[grid.first + cell];
      let end = starts[grid.first + cell + high.x - low.x + 1u];
      if is_own && cell < own_row { continue; }
      if is_own && cell == own_row { first = p + 1u; }
      let is_crowded = end - first > LONG_ROW;
      if is_crowded && threads == 1u { is_long = true; continue; }
      if threads > 1u && !is_crowded && !is_wide { continue; }
      for (var j = first + thread % lanes; j < end; j += lanes) {
        let other = read_entry(j);
        if all(seeker.mins <= other.maxs) && all(other.mins <= seeker.maxs) { report(other.id); }
      }
    }
  }
  return is_long;
}

// Appends what the group has found, by one step of the counter. More than it keeps is found once more, and written at once.
fn append(t: u32, size: u32, p: u32, thread: u32, threads: u32) {
  workgroupBarrier();
  if t == 0u {
    let total = atomicLoad(&staged);
    group_base = atomicAdd(&state[FOUND], total);
    if group_base + total < group_base { atomicAdd(&state[FOUND + 1u], 1u); }
  }
  workgroupBarrier();
  let total = atomicLoad(&staged);
  if total <= STAGE {
    for (var i = t; i < total; i += size) {
      if group_base + i < params.pair_capacity { pairs[group_base + i] = stage[i]; }
    }
  } else if found > 0u {
    cursor = group_base + atomicAdd(&handed_out, found);
    is_writing = true;
    search(p, thread, threads);
  }
}

@compute @workgroup_size(PAIR_GROUP)
fn find(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) t: u32) {
  let p = group_index(group) * PAIR_GROUP + t;
  if p < starts[planned.cells] {
    seeker = read_entry(p);
    if search(p, 0u, 1u) {
      let at = atomicAdd(&state[LONG], 1u);
      long_entries[at] = p;
      atomicMax(&long_groups[0], min(at + 1u, WIDTH));
      atomicMax(&long_groups[1], at / WIDTH + 1u);
    }
  }
  append(t, PAIR_GROUP, p, 0u, 1u);
}

@compute @workgroup_size(GROUP)
fn find_long(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) t: u32) {
  let thread = group.z * GROUP + t;
  let threads = params.shares * GROUP;
  var p = 0u;
  if group_index(group) < atomicLoad(&state[LONG]) {
    p = long_entries[group_index(group)];
    seeker = read_entry(p);
    search(p, thread, threads);
  }
  append(t, GROUP, p, thread, threads);
}

// What others read: groups of 64 pairs to dispatch, pairs in the buffer, pairs found (64 bits), and the first invalid box.
@compute @workgroup_size(1)
fn finish() {
  let low = atomicLoad(&state[FOUND]);
  let high = atomicLoad(&state[FOUND + 1u]);
  let invalid = atomicLoad(&state[INVALID]);
  var held = select(min(low, params.pair_capacity), params.pair_capacity, high > 0u);
  if invalid != NO_CELL { held = 0u; }
  let groups = (held + 63u) / 64u;
  counted[0] = min(groups, WIDTH);
  counted[1] = (groups + WIDTH - 1u) / WIDTH;
  counted[2] = 1u;
  counted[3] = held;
  counted[4] = low;
  counted[5] = high;
  counted[6] = invalid;
}
