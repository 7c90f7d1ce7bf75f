//! The share of a whole Rapier step that the broad phase takes: falling balls, with Rapier's own and with unisize.
//!
//! ```text
//! cargo bench --features rapier2d-027,rapier3d-027,parallel --bench share
//! ```
//!
//! Prints a Markdown table. Balls fall, land and begin to settle; all steps count.
//!
//! The pipelines of Rapier 0.36 take unisize on an opened copy only: `opened/compare` measures both times there.

mod common;

#[path = "share"]
mod dim2 {
    use unisize::rapier2d_027 as ours;
    use unisize_scenes::dim2 as scenes;

    mod dimension;
    pub(crate) use dimension::print;
}

#[path = "share"]
mod dim3 {
    use unisize::rapier3d_027 as ours;
    use unisize_scenes::dim3 as scenes;

    mod dimension;
    pub(crate) use dimension::print;
}

/// Numbers of balls.
const COUNTS: [usize; 2] = [8_000, 20_000];

/// The number of balls in a smoke test.
const SMALL_COUNT: usize = 100;

/// Two simulated seconds.
const STEPS: u32 = 120;

fn main() {
    common::set_threads();
    println!("| dimension | balls | broad phase | ms of a step | of which it takes | part |");
    println!("|---|---|---|---|---|---|");
    let counts = if common::is_smoke_test() {
        &[SMALL_COUNT][..]
    } else {
        &COUNTS
    };
    for &count in counts {
        dim2::print(count);
        dim3::print(count);
    }
}
