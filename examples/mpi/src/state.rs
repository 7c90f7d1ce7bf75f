//! A herd on disk: a folder for a step, in it a file for each process, in the format of postcard, and `herd.json`, which says what they are.
//!
//! A folder has another name until every process has written its part to the disk, so whatever dies, a folder without `.partial` is whole.
//! All processes must see the same disk.

use crate::{Animal, Herd, sum};
use anyhow::{Context, Result, ensure};
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, CommunicatorCollectives};
use serde::{Deserialize, Serialize};
use std::ffi::OsStr;
use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};

/// What the parts of a state are of.
#[derive(Serialize, Deserialize)]
struct About {
    step: u64,
    animals: usize,
    parts: usize,
    hash: u64,
}

/// Writes the herd below `folder`, then removes the other states there. Every process must call it.
///
/// # Errors
/// What the disk says, on one process only: end the run.
pub fn write(world: &SimpleCommunicator, herd: &Herd, folder: &Path) -> Result<()> {
    let about = About {
        step: herd.step,
        animals: herd.count,
        parts: world.size() as usize,
        hash: herd.hash(),
    };
    // What has the same name holds the same herd.
    let whole = folder.join(format!("step-{:08}-{:016x}", about.step, about.hash));
    let partial = whole.with_extension("partial");
    fs::create_dir_all(&partial).with_context(|| format!("cannot make {}", partial.display()))?;
    let part = postcard::to_stdvec(herd.domains.own())?;
    write_to_disk(&partial.join(part_name(world.rank() as usize)), &part)?;
    world.barrier();
    if world.rank() == 0 {
        write_to_disk(&partial.join("herd.json"), &serde_json::to_vec(&about)?)?;
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
    let mut whole = states(folder)?
        .into_iter()
        .filter(|state| state.extension().is_none());
    let state = whole.next_back();
    let state = state.with_context(|| format!("there is no state in {}", folder.display()))?;
    let damaged = || format!("{} is damaged", state.display());
    let about: About = serde_json::from_slice(&read_file(&state.join("herd.json"))?)?;
    let mut own: Vec<Animal> = Vec::new();
    for part in (world.rank() as usize..about.parts).step_by(world.size() as usize) {
        let part = read_file(&state.join(part_name(part)))?;
        own.append(&mut postcard::from_bytes(&part).with_context(damaged)?);
    }
    let count = sum(world, own.len() as u64);
    let herd = Herd::new(world, about.animals, about.step, own);
    ensure!(
        herd.hash() == about.hash && count == about.animals as u64,
        damaged()
    );
    Ok(herd)
}

fn part_name(part: usize) -> String {
    format!("part-{part:05}.postcard")
}

/// The folders of states, whole or not, the latest last.
fn states(folder: &Path) -> Result<Vec<PathBuf>> {
    let entries =
        fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))?;
    let mut states = entries
        .map(|entry| Ok(entry?.path()))
        .collect::<Result<Vec<_>>>()?;
    let is_step = |name: &OsStr| name.to_string_lossy().starts_with("step-");
    states.retain(|state| state.file_name().is_some_and(is_step));
    states.sort();
    Ok(states)
}

fn read_file(file: &Path) -> Result<Vec<u8>> {
    fs::read(file).with_context(|| format!("cannot read {}", file.display()))
}

fn write_to_disk(file: &Path, bytes: &[u8]) -> Result<()> {
    let write = || {
        let mut file = File::create(file)?;
        file.write_all(bytes)?;
        file.sync_all()
    };
    write().with_context(|| format!("cannot write {}", file.display()))
}
