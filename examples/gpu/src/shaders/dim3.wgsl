// Three dimensions: what depends on their number.

alias F = vec3<f32>;
alias I = vec3<i32>;
alias U = vec3<u32>;
const D = 3u;

fn box_mins(i: u32) -> I { return I(boxes[6u * i], boxes[6u * i + 1u], boxes[6u * i + 2u]); }
fn box_maxs(i: u32) -> I { return I(boxes[6u * i + 3u], boxes[6u * i + 4u], boxes[6u * i + 5u]); }
fn read_entry(p: u32) -> Entry {
  let low = entries[2u * p];
  return Entry(low.xyz, entries[2u * p + 1u].xyz, u32(low.w));
}
fn write_entry(p: u32, entry: Entry) {
  sorted_entries[2u * p] = vec4<i32>(entry.mins, i32(entry.id));
  sorted_entries[2u * p + 1u] = vec4<i32>(entry.maxs, 0);
}

// The number of a cell in its table. Cells along the first axis follow each other: they are a row.
fn cell_index(cell: U, dims: U) -> u32 { return (cell.z * dims.y + cell.y) * dims.x + cell.x; }
fn row_count(low: U, high: U) -> u32 { return (high.y - low.y + 1u) * (high.z - low.z + 1u); }

fn row_start(low: U, high: U, row: u32) -> U {
  let width = high.y - low.y + 1u;
  return U(low.x, low.y + row % width, low.z + row / width);
}

// The lowest cell of a range, with the rows before the layer of `own` left out.
fn from_own(low: U, own: U) -> U { return U(low.x, low.y, own.z); }

// Where the row of `own` starts in a range.
fn row_of(low: U, own: U) -> U { return U(low.x, own.y, own.z); }
fn vector(a: array<i32, D>) -> I { return I(a[0], a[1], a[2]); }
fn product(x: F) -> f32 { return x.x * x.y * x.z; }
