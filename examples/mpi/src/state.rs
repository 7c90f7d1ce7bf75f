//! A herd on disk: a folder for a step, and in it a file for each process, in the format of postcard.
//!
//! A folder has another name until every process has written its part to the disk, so whatever dies, a folder without `.partial` is whole.
//! All processes must see the same disk.

use crate::{Animal, Herd, sum};
use anyhow::{Context, Result, ensure};
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, CommunicatorCollectives};
use std::ffi::OsStr;
use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};

/// What each part says of the whole: step, animals, parts, and hash.
type About = (u64, usize, usize, u64);

/// Writes the herd below `folder`, then removes the other states there. Every process must call it.
///
/// # Errors
/// What the disk says, on one process only: end the run.
pub fn write(world: &SimpleCommunicator, herd: &Herd, folder: &Path) -> Result<()> {
    let about: About = (herd.step, herd.count, world.size() as usize, herd.hash());
    // What has the same name holds the same herd.
    let whole = folder.join(format!("step-{:08}-{:016x}", herd.step, about.3));
    let partial = whole.with_extension("partial");
    fs::create_dir_all(&partial).with_context(|| format!("cannot make {}", partial.display()))?;
    let mut file = File::create(part_of(&partial, world.rank() as usize))?;
    file.write_all(&postcard::to_stdvec(&(about, herd.domains.own()))?)?;
    file.sync_all()?;
    world.barrier();
    if world.rank() == 0 {
        if !whole.exists() {
            fs::rename(&partial, &whole)?;
        }
        File::open(folder)?.sync_all()?;
        for other in states(folder)?.iter().filter(|&state| *state != whole) {
            fs::remove_dir_all(other)?;
        }
    }
    world.barrier();
    Ok(())
}

/// Reads the latest state below `folder`, each process some of its parts, however many there are. Every process must call it.
///
/// # Errors
/// If there is no state, or it is damaged or lacks a part.
pub fn read<'a>(world: &'a SimpleCommunicator, folder: &Path) -> Result<Herd<'a>> {
    let states = states(folder).with_context(|| format!("cannot read {}", folder.display()))?;
    let whole = states.iter().rfind(|state| state.extension().is_none());
    let whole = whole.with_context(|| format!("there is no state in {}", folder.display()))?;
    let damaged = || format!("{} is damaged", whole.display());
    let part = |number| -> Result<(About, Vec<Animal>)> {
        let file = part_of(whole, number);
        let bytes = fs::read(&file).with_context(|| format!("cannot read {}", file.display()))?;
        postcard::from_bytes(&bytes).with_context(damaged)
    };
    // With more processes than parts, some have none of their own to learn this from.
    let (about, _) = part(0)?;
    let (step, count, parts, hash) = about;
    let mut own = Vec::new();
    for number in (world.rank() as usize..parts).step_by(world.size() as usize) {
        let (of, mut animals) = part(number)?;
        ensure!(of == about, damaged());
        own.append(&mut animals);
    }
    let read = sum(world, own.len() as u64);
    let herd = Herd::new(world, count, step, own);
    ensure!(herd.hash() == hash && read == count as u64, damaged());
    Ok(herd)
}

fn part_of(state: &Path, number: usize) -> PathBuf {
    state.join(format!("part-{number:05}.postcard"))
}

/// The folders of states, whole or not, the latest last.
fn states(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder)?.map(|entry| Ok(entry?.path()));
    let mut states = entries.collect::<std::io::Result<Vec<_>>>()?;
    let is_step = |name: &OsStr| name.to_string_lossy().starts_with("step-");
    states.retain(|state| state.file_name().is_some_and(is_step));
    states.sort();
    Ok(states)
}
