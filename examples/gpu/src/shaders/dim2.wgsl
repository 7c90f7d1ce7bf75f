// Two dimensions: what depends on their number.

alias F = vec2<f32>;
alias I = vec2<i32>;
alias U = vec2<u32>;
const D = 2u;

fn box_mins(i: u32) -> I { return I(boxes[4u * i], boxes[4u * i + 1u]); }
fn box_maxs(i: u32) -> I { return I(boxes[4u * i + 2u], boxes[4u * i + 3u]); }
fn read_entry(p: u32) -> Entry {
  let sides = entries[p];
  return Entry(sides.xy, sides.zw, ids[p]);
}
fn write_entry(p: u32, entry: Entry) {
  sorted_entries[p] = vec4<i32>(entry.mins, entry.maxs);
  sorted_ids[p] = entry.id;
}

// The number of a cell in its table. Cells along the first axis follow each other: they are a row.
fn cell_index(cell: U, dims: U) -> u32 { return cell.y * dims.x + cell.x; }
fn row_count(low: U, high: U) -> u32 { return high.y - low.y + 1u; }
fn row_start(low: U, high: U, row: u32) -> U { return U(low.x, low.y + row); }

// The lowest cell of a range, with the rows before the layer of `own` left out.
fn from_own(low: U, own: U) -> U { return U(low.x, own.y); }

// Where the row of `own` starts in a range.
fn row_of(low: U, own: U) -> U { return U(low.x, own.y); }
fn vector(a: array<i32, D>) -> I { return I(a[0], a[1]); }
fn product(x: F) -> f32 { return x.x * x.y; }
