//! The processes, and the messages between them.

use anyhow::{Context, Result};
use mpi::datatype::{Partition, PartitionMut};
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, CommunicatorCollectives, Equivalence};
use serde::{Serialize, de::DeserializeOwned};

/// Types that processes can send to each other, in the format of postcard.
pub trait Sent: Serialize + DeserializeOwned {}
impl<T: Serialize + DeserializeOwned> Sent for T {}

/// The processes that mpirun has started. All of them must call the same methods in the same order.
pub struct World(SimpleCommunicator);

impl World {
    /// Starts MPI, and runs a job on each process. If one fails or panics, all end with an exit code other than 0.
    ///
    /// # Errors
    /// If MPI runs already.
    pub fn run<T>(job: impl FnOnce(&Self) -> Result<T>) -> Result<T> {
        // A panic must not unwind: MPI would be finalized, and wait for the other processes.
        std::panic::set_hook(Box::new(|panic| {
            eprintln!("{panic}");
            std::process::exit(101);
        }));
        let universe = mpi::initialize().context("MPI does not start")?;
        let world = Self(universe.world());
        Ok(job(&world).unwrap_or_else(|error| {
            eprintln!("process {}: {error:#}", world.rank());
            world.0.abort(1)
        }))
    }

    /// The number of this process, from 0 on.
    pub fn rank(&self) -> usize {
        self.0.rank() as usize
    }

    /// The number of processes.
    pub fn size(&self) -> usize {
        self.0.size() as usize
    }

    /// Waits for all processes.
    pub fn barrier(&self) {
        self.0.barrier();
    }

    /// Collects a value of each process, on all of them.
    pub fn each<T: Equivalence + Clone + Default>(&self, own: T) -> Vec<T> {
        let mut each = vec![T::default(); self.size()];
        self.0.all_gather_into(&own, &mut each[..]);
        each
    }

    /// Concatenates the lists of all processes, on each of them.
    ///
    /// # Errors
    /// As of [`exchange`](Self::exchange).
    pub fn gather<T: Clone + Sent>(&self, own: Vec<T>) -> Result<Vec<T>> {
        let mut all = Vec::new();
        self.exchange(&vec![own; self.size()], &mut all)?;
        Ok(all)
    }

    /// Sends `lists[p]` to process p, and appends the lists sent to this process, in the order of the senders. Returns the number of bytes
    /// sent to other processes.
    ///
    /// # Errors
    /// If a process would send or receive 2³¹ bytes at once, which MPI cannot count. The others wait until the run is ended.
    pub fn exchange<T: Sent>(&self, lists: &[Vec<T>], received: &mut Vec<T>) -> Result<u64> {
        // Both buffers have a byte of memory at least: the pointer of an empty vector is 1, which is Open MPI's MPI_IN_PLACE.
        let (mut bytes, mut sizes) = (Vec::with_capacity(1), Vec::new());
        for list in lists {
            let start = bytes.len();
            if !list.is_empty() {
                bytes = postcard::to_extend(list, bytes)?;
            }
            sizes.push(bytes.len() - start);
        }
        let mut sizes_in = vec![0; sizes.len()];
        self.0.all_to_all_into(&sizes[..], &mut sizes_in[..]);
        let ([counts, starts], [counts_in, starts_in]) = (counted(&sizes)?, counted(&sizes_in)?);
        let mut bytes_in = vec![0_u8; sizes_in.iter().sum::<usize>() + 1];
        self.0.all_to_all_varcount_into(
            &Partition::new(&bytes[..], &counts[..], &starts[..]),
            &mut PartitionMut::new(&mut bytes_in[..], &counts_in[..], &starts_in[..]),
        );
        let mut rest = &bytes_in[..];
        for _ in sizes_in.iter().filter(|&&size| size > 0) {
            let (mut list, next) = postcard::take_from_bytes(rest).context("damaged message")?;
            received.append(&mut list);
            rest = next;
        }
        Ok((bytes.len() - sizes[self.rank()]) as u64)
    }
}

/// The sizes of lists in bytes, and where they start, in MPI's type.
fn counted(sizes: &[usize]) -> Result<[Vec<i32>; 2]> {
    let total = i32::try_from(sizes.iter().sum::<usize>());
    total.context("2 GB are too many for a message: use more processes")?;
    let counts = sizes.iter().map(|&size| size as i32);
    let starts = counts.clone().scan(0, |end, count| {
        *end += count;
        Some(*end - count)
    });
    Ok([counts.clone().collect(), starts.collect()])
}
