//! The command line.

use super::Show;
use super::choice::Choice;
use clap::builder::RangedU64ValueParser;
use clap::{CommandFactory, FromArgMatches, Parser};
use std::path::PathBuf;

/// The switches of every example that shows a world.
#[derive(Clone, Debug, Parser)]
pub(crate) struct Options {
    /// About how many bodies
    #[arg(long, value_name = "N", value_parser = between(1, 10_000_000))]
    bodies: Option<usize>,
    /// How many steps to simulate, 60 per second
    #[arg(long, value_name = "N", value_parser = between(1, 1_000_000))]
    steps: Option<usize>,
    /// The broad phase that finds the pairs
    #[arg(long, value_enum, default_value = "unisize")]
    pub(crate) broad_phase: Choice,
    /// Compare the pairs with those of Rapier's own broad phase after every step; exits with 1 if they differ
    #[arg(long)]
    pub(crate) verify_pairs: bool,
    /// Draw nothing, which is the default without --out
    #[arg(long, conflicts_with = "out")]
    no_render: bool,
    /// Draw a film: a looping animation if the name ends in .gif, numbered frames if it ends in .png
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    /// Width and height of the film, in pixels
    #[arg(long, num_args = 2, value_names = ["WIDTH", "HEIGHT"], default_values_t = [640, 360], value_parser = between(1, 8192))]
    size: Vec<usize>,
}

impl Options {
    /// Reads the command line, and exits if it is invalid.
    pub(crate) fn read<S: Show>() -> Self {
        let bodies = format!("About how many bodies [default: {}]", S::BODIES);
        let steps = format!(
            "How many steps to simulate, 60 per second [default: {}]",
            S::STEPS
        );
        let command = Self::command()
            .name(S::NAME)
            .about(S::ABOUT)
            .mut_arg("bodies", |arg| arg.help(bodies))
            .mut_arg("steps", |arg| arg.help(steps));
        Self::from_arg_matches(&command.get_matches()).unwrap_or_else(|error| error.exit())
    }

    pub(crate) fn bodies<S: Show>(&self) -> usize {
        self.bodies.unwrap_or(S::BODIES)
    }

    pub(crate) fn steps<S: Show>(&self) -> usize {
        self.steps.unwrap_or(S::STEPS)
    }

    pub(crate) fn size(&self) -> [usize; 2] {
        // Two values, or the default.
        [self.size[0], self.size[1]]
    }
}

fn between(low: u64, high: u64) -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(low..=high)
}
