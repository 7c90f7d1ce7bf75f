//! What part of a whole step of Rapier the broad phase takes: falling balls, with Rapier's own and with this one.
//!
//! ```text
//! cargo bench --features rapier2d,rapier3d,parallel --bench share
//! ```
//!
//! A table in Markdown. Balls fall, land and are about to come to rest; all steps count.

mod common;

#[path = "share"]
mod dim2 {
    use unisize::rapier2d as ours;
    use unisize_scenes::dim2 as scenes;

    mod dimension;
    pub(crate) use dimension::print;
}

#[path = "share"]
mod dim3 {
    use unisize::rapier3d as ours;
    use unisize_scenes::dim3 as scenes;

    mod dimension;
    pub(crate) use dimension::print;
}

/// The numbers of balls.
const COUNTS: [usize; 2] = [8_000, 20_000];

/// That of a smoke test.
const SMALL_COUNT: usize = 100;

/// Two seconds.
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
