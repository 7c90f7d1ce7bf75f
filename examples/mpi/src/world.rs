//! Lists from each process to each, and what all have in common: all that is sent, but for the loads.

use anyhow::{Context, Result, bail};
use mpi::collective::SystemOperation;
use mpi::datatype::{Partition, PartitionMut};
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, CommunicatorCollectives, Equivalence};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Sends `lists[p]` to process p, appends what was sent to this one, in the order of the senders, and returns the number of bytes that
/// went to others. Every process must call it.
///
/// # Errors
/// If a process would send or receive 2³¹ bytes at once, which MPI cannot count. The others wait until somebody ends the run.
pub fn exchange<T: Serialize + DeserializeOwned>(
    world: &SimpleCommunicator,
    lists: &[Vec<T>],
    received: &mut Vec<T>,
) -> Result<u64> {
    // The pointer of a vector without memory is 1, which Open MPI takes for MPI_IN_PLACE: so there is a byte more.
    let (mut bytes, mut counts) = (Vec::with_capacity(1), Vec::new());
    for list in lists {
        let start = bytes.len();
        if !list.is_empty() {
            bytes = postcard::to_extend(list, bytes)?;
        }
        counts.push(i32::try_from(bytes.len() - start)?);
    }
    let mut counts_in = vec![0; counts.len()];
    world.all_to_all_into(&counts[..], &mut counts_in[..]);
    let starts = [starts(&counts), starts(&counts_in)];
    let [Some(starts), Some(starts_in)] = starts else {
        bail!("2 GB are too many for a message: use more processes");
    };
    let total: usize = counts_in.iter().map(|&count| count as usize).sum();
    let mut bytes_in = vec![0_u8; total + 1];
    world.all_to_all_varcount_into(
        &Partition::new(&bytes[..], &counts[..], &starts[..]),
        &mut PartitionMut::new(&mut bytes_in[..], &counts_in[..], &starts_in[..]),
    );
    let mut rest = &bytes_in[..];
    for _ in counts_in.iter().filter(|&&count| count > 0) {
        let (mut list, others) = postcard::take_from_bytes(rest).context("a message is damaged")?;
        received.append(&mut list);
        rest = others;
    }
    Ok(bytes.len() as u64 - counts[world.rank() as usize] as u64)
}

/// Where each list begins, if MPI can count so far.
fn starts(counts: &[i32]) -> Option<Vec<i32>> {
    let mut end = 0_i32;
    let starts = counts.iter().map(|&count| {
        end = end.checked_add(count)?;
        Some(end - count)
    });
    starts.collect()
}

/// The lists of all processes, one after the other, on each of them.
///
/// # Errors
/// Those of [`exchange`].
pub fn gather<T: Clone + Serialize + DeserializeOwned>(
    world: &SimpleCommunicator,
    own: Vec<T>,
) -> Result<Vec<T>> {
    let mut all = Vec::new();
    exchange(world, &vec![own; world.size() as usize], &mut all)?;
    Ok(all)
}

/// The greatest of a number of each process.
pub fn greatest<T: Equivalence + Default>(world: &SimpleCommunicator, own: T) -> T {
    let mut greatest = T::default();
    world.all_reduce_into(&own, &mut greatest, SystemOperation::max());
    greatest
}

/// The sum of a number of each process, modulo 2⁶⁴.
pub fn sum(world: &SimpleCommunicator, own: u64) -> u64 {
    let mut sum = 0;
    world.all_reduce_into(&own, &mut sum, SystemOperation::sum());
    sum
}
