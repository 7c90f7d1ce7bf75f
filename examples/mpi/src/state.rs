//! A herd on disk: one file, of which each process writes its part, in the format of postcard. All processes must see the same disk.
//!
//! The file has another name until all of it is on the disk, and only then replaces the state before: whatever dies, a state is whole.

use crate::{Animal, Domains, Herd, World};
use anyhow::{Context, Result, ensure};
use fs_err::{self as fs, File, OpenOptions};
use std::io::{BufReader, Read, Seek, SeekFrom, Write};
use std::path::Path;

/// What a state begins with: step, animals, hash, and the number of bytes of each part that follows.
type About = (u64, usize, u64, Vec<u64>);

/// Writes the herd. Every process must call it.
///
/// # Errors
/// What the disk says, on one process only: end the run.
pub fn write(herd: &Herd, path: &Path) -> Result<()> {
    let (world, partial) = (herd.domains.world, path.with_extension("partial"));
    let me = world.rank();
    let part = postcard::to_stdvec(herd.domains.own())?;
    let sizes = world.each(part.len() as u64);
    let before: u64 = sizes[..me].iter().sum();
    let about = postcard::to_stdvec(&(herd.step, herd.count, herd.hash(), sizes))?;
    if me == 0 {
        File::create(&partial)?.write_all(&about)?;
    }
    world.barrier();
    let mut file = OpenOptions::new().write(true).open(&partial)?;
    file.seek(SeekFrom::Start(about.len() as u64 + before))?;
    file.write_all(&part)?;
    file.sync_all()?;
    world.barrier();
    if me == 0 {
        fs::rename(&partial, path)?;
    }
    Ok(())
}

/// Reads a herd, each process some of the parts, however many there are. Every process must call it.
///
/// # Errors
/// If there is no state, or it is damaged.
pub fn read<'a>(world: &'a World, path: &Path) -> Result<Herd<'a>> {
    let damaged = || format!("{} is damaged", path.display());
    let mut file = BufReader::new(File::open(path)?);
    let read = postcard::from_io((&mut file, &mut []));
    let (about, _): (About, _) = read.with_context(damaged)?;
    let mut start = postcard::to_stdvec(&about)?.len() as u64;
    let (step, count, hash, sizes) = about;
    let mut own = Vec::new();
    for (part, size) in sizes.iter().enumerate() {
        if part % world.size() == world.rank() {
            let mut bytes = Vec::new();
            file.seek(SeekFrom::Start(start)).with_context(damaged)?;
            file.by_ref().take(*size).read_to_end(&mut bytes)?;
            let animals: Vec<Animal> = postcard::from_bytes(&bytes).with_context(damaged)?;
            own.extend(animals);
        }
        start = start.saturating_add(*size);
    }
    let mut herd = Herd::at_start(world, 0);
    herd.domains = Domains::new(world, own);
    (herd.count, herd.step) = (count, step);
    ensure!(herd.hash() == hash, damaged());
    Ok(herd)
}
