//! An exact and fast broad phase for boxes of about the same size, as a drop-in replacement for [Rapier](https://rapier.rs)'s.
//!
//! Many scenes consist of many boxes of about the same size: ropes, cables, grains, crowds, herds. For such boxes, sorting and sweeping is
//! faster than maintaining a tree. The method began with Capannini and Larsson, *Output Sensitive Collision Detection for Unisize Boxes*.
//! `unisize` extends it to boxes of any sizes. Its time grows about linearly with boxes and pairs, in two dimensions and in three.
//!
//! # In Rapier
//!
//! One line of your program changes, and no contact is lost.
//!
//! Rapier **0.36.1**, patched by the program `open-rapier` of the same repository, with the feature `rapier2d-036`,
//! `rapier3d-036`, `rapier2d-f64-036` or `rapier3d-f64-036`:
//!
//! ```diff
//! -let mut broad_phase = DefaultBroadPhase::new();
//! +let mut broad_phase = DefaultBroadPhase::custom(unisize::rapier3d_036::UnisizeBroadPhase::new());
//! ```
//!
//! Rapier **0.27**, the last version whose pipelines take any broad phase, with the feature `rapier2d-027`, `rapier3d-027`,
//! `rapier2d-f64-027` or `rapier3d-f64-027`:
//!
//! ```diff
//! -let mut broad_phase = DefaultBroadPhase::new();
//! +let mut broad_phase = unisize::rapier3d_027::UnisizeBroadPhase::new();
//! ```
//!
//! A program that drives Rapier 0.36's collision detection itself needs no patched copy: `UnisizeBroadPhase::update` has the
//! arguments of Rapier's own.
//!
//! # Without an engine
//!
//! The kernels need no feature and no engine. A [`PairFinder`] takes boxes and returns the pairs that overlap:
//!
//! ```
//! use unisize::{Aabb, GridSweep, PairFinder};
//!
//! // Two unit cubes that touch in a corner, and one apart.
//! let cube = |x: f32, y: f32, z: f32| Aabb::new([x, y, z], [x + 1.0, y + 1.0, z + 1.0]);
//! let boxes = [cube(0.0, 0.0, 0.0), cube(9.0, 9.0, 9.0), cube(1.0, 1.0, 1.0)];
//!
//! let mut finder = GridSweep::default(); // Keep it: it reuses its memory.
//! let mut pairs = Vec::new();
//! finder.find_pairs(&boxes, &mut pairs)?;
//! assert_eq!(pairs, [[0, 2]]);
//! # Ok::<(), unisize::InvalidInput>(())
//! ```
//!
//! # Kernels
//!
//! | kernel | time | use it |
//! |---|---|---|
//! | [`GridSweep`] | O(n + pairs) for boxes of about one size, O((n + pairs) log n) for most others | always |
//! | [`RankSweep`] | O(n log n + pairs) for boxes of one size in 2D | to study the paper |
//! | [`BruteForce`] | O(n²) | as the oracle of a test |
//!
//! All kernels return the same set of pairs for every input. Boxes are closed, and compared without a tolerance
//! ([`Aabb::intersects`]). Kernels are generic over `f32` and `f64` and over two and three dimensions. None panics on any input: a NaN or
//! an inverted box is an [`InvalidInput`] error.

#![cfg_attr(docsrs, feature(doc_cfg))]
// A part of the kernels serves the broad phases only.
#![cfg_attr(not(feature = "_adapter"), allow(dead_code))]

mod aabb;
mod bit_set;
mod brute_force;
mod bucket_sort;
mod clock;
mod counting_sort;
mod grid_sweep;
mod invalid_input;
mod lanes;
#[cfg(feature = "_adapter")]
mod pair_filter;
mod pair_finder;
#[cfg(feature = "_adapter")]
mod pair_tracker;
mod parallel;
#[cfg(feature = "_adapter")]
mod proxy_table;
mod radix_sort;
mod rank_sweep;
mod real;
#[cfg(feature = "_adapter")]
mod settings;
#[cfg(feature = "_adapter")]
mod slot_set;
#[cfg(feature = "_adapter")]
mod stats;
mod tuning;
#[cfg(feature = "_adapter")]
mod volume;

// Never compiled. The formatter does not look into macros; these lines lead it to the sources of the flavours.
#[cfg(any())]
mod adapter;
#[cfg(any())]
#[path = "adapter"]
mod versions {
    mod rapier_027;
    mod rapier_036;
    #[path = "rapier_036/seam.rs"]
    mod seam;
}

/// Declares a module with the broad phase for each flavour of one version of Rapier. All modules include the same source, which names the
/// engine `rapier`.
#[cfg(feature = "_adapter")]
macro_rules! flavours {
    ($version:literal; $(
        $feature:literal $title:literal: $name:ident, ::$engine:ident, $doc:literal $(, seam in $opened:ident)?;
    )*) => { $(
        #[cfg(feature = $feature)]
        #[path = "."]
        pub mod $name {
            #![doc = concat!("The broad phase for ", $title, ".\n\n", include_str!($doc))]

            use ::$engine as rapier;

            #[path = "adapter/mod.rs"]
            mod adapter;

            #[path = $version]
            mod version;

            $(
                #[cfg($opened)]
                #[path = "adapter/rapier_036/seam.rs"]
                mod seam;
            )?

            pub use crate::{pair_filter::PairFilter, stats::Stats};
            pub use adapter::{Difference, Measured, Settings, Trial, TrialReport, UnisizeBroadPhase};
        }
    )* };
}

#[cfg(feature = "_adapter")]
flavours! { "adapter/rapier_027/mod.rs";
    "rapier2d-027" "rapier2d 0.27": rapier2d_027, ::rapier2d, "adapter/rapier_027/dim2.md";
    "rapier2d-f64-027" "rapier2d-f64 0.27": rapier2d_f64_027, ::rapier2d_f64, "adapter/rapier_027/module.md";
    "rapier3d-027" "rapier3d 0.27": rapier3d_027, ::rapier3d, "adapter/rapier_027/dim3.md";
    "rapier3d-f64-027" "rapier3d-f64 0.27": rapier3d_f64_027, ::rapier3d_f64, "adapter/rapier_027/module.md";
}

#[cfg(feature = "_adapter")]
flavours! { "adapter/rapier_036/mod.rs";
    "rapier2d-036" "rapier2d 0.36":
        rapier2d_036, ::rapier2d_036, "adapter/rapier_036/module.md", seam in opened_rapier2d;
    "rapier2d-f64-036" "rapier2d-f64 0.36":
        rapier2d_f64_036, ::rapier2d_f64_036, "adapter/rapier_036/module.md", seam in opened_rapier2d_f64;
    "rapier3d-036" "rapier3d 0.36":
        rapier3d_036, ::rapier3d_036, "adapter/rapier_036/module.md", seam in opened_rapier3d;
    "rapier3d-f64-036" "rapier3d-f64 0.36":
        rapier3d_f64_036, ::rapier3d_f64_036, "adapter/rapier_036/module.md", seam in opened_rapier3d_f64;
}

pub use aabb::Aabb;
pub use brute_force::BruteForce;
pub use grid_sweep::GridSweep;
pub use invalid_input::{InvalidInput, InvalidInputReason};
pub use pair_finder::PairFinder;
pub use rank_sweep::RankSweep;
pub use real::Real;
#[cfg(feature = "_adapter")]
pub use {pair_filter::PairFilter, settings::Settings, stats::Stats};

/// The example of the README, compiled and run.
#[cfg(all(doctest, feature = "rapier3d-027"))]
#[doc = include_str!("../README.md")]
struct Readme;

/// The examples of the guide.
#[cfg(all(doctest, feature = "rapier3d-027", feature = "rapier3d-036"))]
#[doc = include_str!("../docs/guide.md")]
struct Guide;
