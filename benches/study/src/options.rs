//! The options that all studies have in common.

use clap::Args;
use clap::builder::RangedU64ValueParser;
use std::ops::Range;
use std::path::PathBuf;
use unisize_report::progress_bar;

/// What every study can be told.
#[derive(Args, Clone, Debug)]
pub(crate) struct Common {
    /// In how many dimensions
    #[arg(long, default_value = "both", value_parser = ["2", "3", "both"])]
    dimension: String,
    /// How many steps of each simulation at most
    #[arg(long, value_name = "N", value_parser = at_least_one())]
    pub(crate) steps: Option<usize>,
    /// From how many starts, or how often, each case is run
    #[arg(long, value_name = "N", value_parser = at_least_one())]
    seeds: Option<usize>,
    /// Little of everything, for a check of some seconds; its figures are rough
    #[arg(long)]
    pub(crate) quick: bool,
    /// Append what is found to this file as well, a line of JSON for each row
    #[arg(long, value_name = "FILE")]
    pub(crate) json: Option<PathBuf>,
}

impl Common {
    pub(crate) fn dims(&self) -> &'static [u8] {
        match &*self.dimension {
            "2" => &[2],
            "3" => &[3],
            _ => &[2, 3],
        }
    }

    /// Seeds from 1 on: as many as were asked for, or else as a quick run has, or a full one.
    pub(crate) fn seeds(&self, usual: [usize; 2]) -> Range<u64> {
        1..1 + self.seeds.unwrap_or(self.usual(usual)) as u64
    }

    /// What a function returns for each dimension and each of these cases, with a progress bar.
    pub(crate) fn each<C, T>(
        &self,
        cases: &[C],
        name: impl Fn(&C) -> &'static str,
        mut of: impl FnMut(u8, &C) -> T,
    ) -> Vec<T> {
        let bar = progress_bar((cases.len() * self.dims().len()) as u64);
        let mut all = Vec::new();
        for &dim in self.dims() {
            for case in cases {
                bar.set_message(format!("{} {dim}D", name(case)));
                all.push(of(dim, case));
                bar.inc(1);
            }
        }
        bar.finish_and_clear();
        all
    }

    /// What a quick run has, or a full one.
    pub(crate) fn usual<T>(&self, [quick, full]: [T; 2]) -> T {
        if self.quick { quick } else { full }
    }
}

fn at_least_one() -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(1..=10_000_000)
}
