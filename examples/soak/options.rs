//! The command line.

use clap::{Parser, ValueEnum};

/// Makes very many updates of a world in which everything changes, and sees that memory does not grow.
///
/// After every so many updates the broad phase checks itself, and its pairs are compared with its events. Ends with 1
/// if more than half as much memory again is held after the first tenth of the updates than during it.
#[derive(Clone, Debug, Parser)]
#[command(name = "soak")]
pub(super) struct Options {
    /// How many updates to make
    #[arg(long, value_name = "N", default_value_t = 1_000_000, value_parser = clap::value_parser!(u64).range(10..))]
    pub(super) updates: u64,
    /// How many colliders there are at most
    #[arg(long, value_name = "N", default_value_t = 500, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub(super) colliders: u32,
    /// The seed of everything that happens
    #[arg(long, value_name = "N", default_value_t = 7)]
    pub(super) seed: u64,
    /// In how many dimensions
    #[arg(long, value_enum, default_value = "both")]
    dim: Dim,
    /// Check after every so many updates
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
