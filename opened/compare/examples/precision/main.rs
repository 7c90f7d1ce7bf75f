//! How many pairs are left, by the axes along which the intervals of two shapes must meet.
//!
//! ```text
//! cargo run --release --package compare-opened --example precision
//! ```
//!
//! Each scene is stepped on Rapier's own broad phase. In the second half of the run it is asked, of each pair that its narrow
//! phase holds, whether the shapes' intervals, loosened by half the prediction distance, meet along all axes of a set. What no
//! test leaves out, its narrow phase has to look at in every step. Prints a Markdown table.

use unisize_scenes::SceneKind;

mod volume;

/// The scenes, and about how many bodies each has.
const SCENES: [(SceneKind, usize); 14] = [
    (SceneKind::FallingBalls, 2000),
    (SceneKind::Gas, 4000),
    (SceneKind::Net, 1000),
    (SceneKind::Hopper, 1000),
    (SceneKind::Ropes, 1000),
    (SceneKind::Chains, 2000),
    (SceneKind::Pyramids, 1000),
    (SceneKind::Stacks, 1000),
    (SceneKind::MixedOneAndAHalf, 2000),
    (SceneKind::MixedFour, 1000),
    (SceneKind::Bullets, 500),
    (SceneKind::Churn, 1000),
    (SceneKind::Shapes, 1000),
    (SceneKind::Soft, 500),
];

const STEPS: usize = 150;

/// What is counted: pairs with a contact, and pairs that a test does not tell apart.
#[derive(Default)]
struct Counts {
    contacts: usize,
    pairs: [usize; TESTS.len()],
}

/// Of each test the name, in the order in which [`Counts`] has them.
const TESTS: [&str; 9] = [
    "with margins",
    "boxes",
    "corners",
    "edges",
    "both",
    "centres",
    "own axes",
    "own axes, nearest points",
    "distance",
];

#[path = "."]
mod dim2 {
    use unisize_scenes::dim2_0_36 as scenes;

    mod dimension;
    pub(super) use dimension::count;
}

#[path = "."]
mod dim3 {
    use unisize_scenes::dim3_0_36 as scenes;

    mod dimension;
    pub(super) use dimension::count;
}

fn main() {
    for (dim, count) in [
        (2, dim2::count as fn(SceneKind, usize) -> Counts),
        (3, dim3::count),
    ] {
        println!(
            "## Of 100 pairs, {dim}D\n\n| scene | {} | contact |",
            TESTS.join(" | ")
        );
        println!("|---|{}", "---:|".repeat(TESTS.len() + 1));
        for (kind, bodies) in SCENES {
            let Counts { contacts, pairs } = count(kind, bodies);
            let share = |count: usize| format!("{:.0}", 100.0 * count as f64 / pairs[0] as f64);
            let shares = pairs.map(share).join(" | ");
            println!("| {} | {shares} | {} |", kind.name(), share(contacts));
        }
        println!();
    }
}
