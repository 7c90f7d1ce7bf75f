//! The command line.

use std::path::PathBuf;

use clap::Parser;

/// Opens Rapier 0.36.1 for other broad phases than its own.
///
/// Copies the sources of rapier2d, rapier3d, rapier2d-f64 and rapier3d-f64 that a project uses, as Cargo has fetched them, gives
/// the copies a trait `CustomBroadPhase` and a constructor `BroadPhaseBvh::custom`, and prints the lines by which the project
/// takes the copies. A copy that this program has made before is made anew.
#[derive(Parser)]
#[command(version)]
pub(crate) struct Options {
    /// The folder for the copies, each in a folder with the name of its package
    #[arg(long, value_name = "DIR")]
    pub(crate) out: PathBuf,

    /// The manifest of the project that uses Rapier
    #[arg(long, value_name = "PATH", default_value = "Cargo.toml")]
    pub(crate) manifest_path: PathBuf,

    /// Write the lines into the manifest of the workspace, instead of printing them
    #[arg(long)]
    pub(crate) write: bool,

    /// Write nothing, and fail if a copy is not exactly as it would be made
    #[arg(long, conflicts_with = "write")]
    pub(crate) check: bool,

    /// For tests: have `BroadPhaseBvh::new()` and `default()` ask `BROAD_PHASE_FACTORY`
    #[arg(long)]
    pub(crate) factory: bool,
}
