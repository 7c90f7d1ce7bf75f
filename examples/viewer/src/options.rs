//! The command line.

use crate::choice::Choice;
use crate::setup::{KernelName, RAPIERS_MARGIN, Setup};
use crate::stage::Scene;
use clap::Parser;
use clap::builder::RangedU64ValueParser;
use std::path::PathBuf;

/// Shows the worlds of unisize's examples live, in a window
#[derive(Clone, Debug, Parser)]
#[command(name = "viewer")]
pub(crate) struct Options {
    /// The scene to start with
    #[arg(long, value_enum, default_value = "rope3d")]
    pub(crate) scene: Scene,
    /// About how many bodies [default: what runs in about real time]
    #[arg(long, value_name = "N", value_parser = between(1, 1_000_000))]
    bodies: Option<usize>,
    /// The broad phase that finds the pairs
    #[arg(long, value_enum, default_value = "unisize")]
    broad_phase: Choice,
    /// Give the other broad phase the same colliders, and time both
    #[arg(long)]
    both: bool,
    /// The kernel of unisize
    #[arg(long, value_enum, default_value = "grid-sweep")]
    kernel: KernelName,
    /// How far a collider may move before its box is renewed, in units of length
    #[arg(long, value_name = "LENGTH", default_value_t = RAPIERS_MARGIN, value_parser = margin)]
    margin: f32,
    /// Draw the pairs
    #[arg(long)]
    pub(crate) pairs: bool,
    /// Draw the strips of the grid
    #[arg(long)]
    pub(crate) strips: bool,
    /// Start paused
    #[arg(long)]
    pub(crate) paused: bool,
    /// Write a picture of the window and exit
    #[arg(long, value_name = "FILE.png", value_parser = png)]
    pub(crate) screenshot: Option<PathBuf>,
    /// After how many steps the picture is taken
    #[arg(long, value_name = "STEPS", default_value_t = 120, requires = "screenshot", value_parser = between(0, 1_000_000))]
    pub(crate) after: usize,
    /// Width and height of the window, in pixels
    #[arg(long, num_args = 2, value_names = ["WIDTH", "HEIGHT"], default_values_t = [1280, 800], value_parser = between(480, 8192))]
    size: Vec<usize>,
}

impl Options {
    pub(crate) fn setup(&self) -> Setup {
        Setup {
            choice: self.broad_phase,
            times_both: self.both,
            kernel: self.kernel,
            margin: self.margin,
        }
    }

    pub(crate) fn bodies(&self) -> usize {
        self.bodies.unwrap_or(self.scene.bodies())
    }

    pub(crate) fn size(&self) -> [u32; 2] {
        // Two values below 2^13, or the default.
        [self.size[0] as u32, self.size[1] as u32]
    }
}

fn between(low: u64, high: u64) -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(low..=high)
}

fn margin(text: &str) -> Result<f32, String> {
    match text.parse() {
        Ok(margin) if (0.0..=10.0).contains(&margin) => Ok(margin),
        _ => Err("must be a number from 0 to 10".to_owned()),
    }
}

fn png(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    let is_png = path.extension().is_some_and(|extension| extension == "png");
    is_png
        .then_some(path)
        .ok_or_else(|| "must end in .png".to_owned())
}

#[cfg(test)]
mod tests {
    use super::Options;
    use clap::{CommandFactory, Parser};

    #[test]
    fn the_switches_are_sound() {
        Options::command().debug_assert();
    }

    #[test]
    fn what_is_wrong_is_refused() {
        for wrong in [
            &["--scene", "pool"][..],
            &["--bodies", "0"],
            &["--margin=-1"],
            &["--margin=NaN"],
            &["--screenshot", "picture.jpg"],
            &["--after", "3"],
            &["--size", "100", "100"],
        ] {
            let line = ["viewer"].iter().chain(wrong);
            assert!(Options::try_parse_from(line).is_err(), "{wrong:?}");
        }
        let line = ["viewer", "--screenshot", "x.png", "--after", "3"];
        assert_eq!(Options::try_parse_from(line).unwrap().after, 3);
    }
}
