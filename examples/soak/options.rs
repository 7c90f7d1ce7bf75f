//! The command line.

use clap::{Parser, ValueEnum};

/// Makes very many updates of a world in which everything changes, and checks that memory does not grow.
///
/// At intervals the broad phase checks itself, and its pairs are compared with its events. Exits with 1 if memory
/// later peaks at more than one and a half times its peak in the first tenth of the updates.
#[derive(Clone, Debug, Parser)]
#[command(name = "soak")]
pub(super) struct Options {
    /// How many updates to make
    #[arg(long, value_name = "N", default_value_t = 1_000_000, value_parser = clap::value_parser!(u64).range(10..))]
    pub(super) updates: u64,
    /// The greatest number of colliders
    #[arg(long, value_name = "N", default_value_t = 500, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub(super) colliders: u32,
    /// The seed of everything that happens
    #[arg(long, value_name = "N", default_value_t = 7)]
    pub(super) seed: u64,
    /// In how many dimensions
    #[arg(long, value_enum, default_value = "both")]
    dim: Dim,
    /// The number of updates between two checks
    #[arg(long, value_name = "N", default_value_t = 1_000, value_parser = clap::value_parser!(u64).range(1..))]
    pub(super) check_every: u64,
}

impl Options {
    pub(super) fn dims(&self) -> &'static [u8] {
        match self.dim {
            Dim::Two => &[2],
            Dim::Three => &[3],
            Dim::Both => &[2, 3],
        }
    }
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Dim {
    #[value(name = "2")]
    Two,
    #[value(name = "3")]
    Three,
    Both,
}
