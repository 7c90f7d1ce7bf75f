//! The command line of the small examples.

use clap::Parser;

/// Simulates, and prints how long the search for pairs takes.
#[derive(Clone, Copy, Debug, Parser)]
pub(crate) struct Options {
    /// About how many bodies [default: the scene's own]
    #[arg(long, value_name = "N")]
    pub(crate) bodies: Option<usize>,
    /// How many steps to simulate, 60 a second
    #[arg(long, value_name = "N", default_value_t = 300)]
    pub(crate) steps: usize,
    /// Compare the pairs with another method's after every step; exits with 1 if they differ
    #[arg(long)]
    pub(crate) verify_pairs: bool,
}
