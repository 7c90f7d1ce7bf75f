//! The options that all studies have in common.

use clap::builder::RangedU64ValueParser;
use clap::{Args, ValueEnum};
use std::ops::Range;
use std::path::PathBuf;
use unisize_scenes::SceneKind;

/// What every study can be told.
#[derive(Args, Clone, Debug)]
pub(crate) struct Common {
    /// In how many dimensions
    #[arg(long, value_enum, default_value = "both")]
    dimension: Dimension,
    /// How many steps of each simulation at most
    #[arg(long, value_name = "N", value_parser = at_least_one())]
    pub(crate) steps: Option<usize>,
    /// From how many starts, or how often, each case is run
    #[arg(long, value_name = "N", value_parser = at_least_one())]
    seeds: Option<usize>,
    /// The first seed
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) seed: u32,
    /// Little of everything, for a check of some seconds; its figures are rough
    #[arg(long)]
    pub(crate) quick: bool,
    /// Write what was found to this file as well, a line of JSON for each row
    #[arg(long, value_name = "FILE")]
    pub(crate) json: Option<PathBuf>,
    /// Draw the charts of studies that have some into this folder
    #[arg(long, value_name = "FOLDER")]
    pub(crate) chart: Option<PathBuf>,
}

impl Common {
    pub(crate) fn dims(&self) -> &'static [u8] {
        match self.dimension {
            Dimension::Two => &[2],
            Dimension::Three => &[3],
            Dimension::Both => &[2, 3],
        }
    }

    /// The number that was asked for, or one of these: of a quick run, and of a full one.
    pub(crate) fn seeds(&self, quick: usize, full: usize) -> Range<u64> {
        let first = u64::from(self.seed);
        first..first + self.seeds.unwrap_or(self.usual(quick, full)) as u64
    }

    /// Those of these scenes that were asked for by name, or all of them.
    pub(crate) fn scenes(&self, all: &[SceneKind], names: &[String]) -> Vec<SceneKind> {
        let is_meant =
            |kind: &SceneKind| names.is_empty() || names.iter().any(|n| n == kind.name());
        all.iter().copied().filter(is_meant).collect()
    }

    /// One of these: for a quick run, and for a full one.
    pub(crate) fn usual<T>(&self, quick: T, full: T) -> T {
        if self.quick { quick } else { full }
    }
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Dimension {
    #[value(name = "2")]
    Two,
    #[value(name = "3")]
    Three,
    Both,
}

/// Of numbers.
pub(crate) fn at_least_one() -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(1..=10_000_000)
}

#[cfg(test)]
mod tests {
    use super::Common;
    use clap::{Args, Command, FromArgMatches};

    #[test]
    fn what_is_asked_for_goes_first() {
        let parse = |line: &str| {
            let command = Common::augment_args(Command::new("study"));
            let line = ["study"].into_iter().chain(line.split_whitespace());
            let matches = command.try_get_matches_from(line)?;
            Common::from_arg_matches(&matches)
        };
        let full = parse("").unwrap();
        assert_eq!((full.dims(), full.seeds(2, 20)), (&[2, 3][..], 1..21));
        let quick = parse("--quick --seed 7 --dimension 3").unwrap();
        assert_eq!((quick.dims(), quick.seeds(2, 20)), (&[3][..], 7..9));
        assert_eq!(parse("--quick --seeds 3").unwrap().seeds(2, 20), 1..4);
        for wrong in ["--seeds 0", "--steps 0", "--dimension 4"] {
            assert!(parse(wrong).is_err(), "{wrong}");
        }
    }
}
