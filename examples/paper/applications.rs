//! The applications that the paper names: herds, kinematic chains, and particles.

mod chains;
mod stampede;

use crate::page::Page;
use anyhow::Result;

pub(crate) fn run(page: &Page, quick: bool) -> Result<()> {
    stampede::run(page, quick)?;
    chains::run(page, quick)
}
