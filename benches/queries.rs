//! What a query costs when a step has one: the kept tree brought up to date, and its quality once it has aged.
//!
//! ```text
//! cargo bench --features rapier2d-027,rapier3d-027 --bench queries
//! ```
//!
//! Prints a Markdown table. Balls fly about in a container, all of them or a part, and there is one ray in every step.
//! *First ray* is the time of that ray, with all that it takes to bring the tree up to date, at the beginning and at the end.
//! *Further ray* is the mean time of rays through the tree as it is at the end, *new tree* that of the same rays through one
//! that is just built. Rapier's own broad phase keeps its tree up to date in every update, so its rays are all further ones.

mod common;

#[path = "queries"]
mod dim2 {
    use rapier2d as rapier;
    use unisize::rapier2d_027 as ours;

    mod dimension;
    pub(crate) use dimension::print;
}

#[path = "queries"]
mod dim3 {
    use rapier3d as rapier;
    use unisize::rapier3d_027 as ours;

    mod dimension;
    pub(crate) use dimension::print;
}

/// Balls, and one in how many moves.
const CASES: [(usize, usize); 5] = [
    (10_000, 1),
    (10_000, 10),
    (10_000, 100),
    (1_000, 1),
    (10, 1),
];

/// Steps, after which a tree is old.
const STEPS: usize = 10_000;

/// The steps of a smoke test.
const FEW_STEPS: usize = 20;

fn main() {
    common::set_threads();
    println!(
        "| dimension | balls | of which move | µs of the first ray, mean of steps 1 to 100 | of the last 100 | further ray | new tree | ratio | default's ray |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    let steps = if common::is_smoke_test() {
        FEW_STEPS
    } else {
        STEPS
    };
    for (count, one_in) in CASES {
        dim2::print(count, one_in, steps);
        dim3::print(count, one_in, steps);
    }
}
