//! A stampede over many processes: the same bits as the herd of one process.

use crate::domains::sorted;
use crate::{Body, Domains, sum};
use anyhow::Result;
use mpi::topology::SimpleCommunicator;
use mpi::traits::Communicator;
use unisize::Aabb;
use unisize_scenes::Stampede;

/// An animal: its neighbourhood, and with it its place, its velocity, and the speed that it would like to run at, in metres and seconds.
pub type Animal = Body<f32, 2, ([f32; 2], [f32; 2], f32)>;

impl Animal {
    /// The animals of a herd, numbered from 0 on.
    pub fn all(herd: &Stampede) -> impl Iterator<Item = Self> {
        let moving = herd.places().iter().zip(herd.velocities());
        let animal = |(((&at, &velocity), &pace), number)| Self {
            number,
            aabb: Aabb::new(at, at).loosened(Stampede::NEIGHBOURHOOD),
            rest: (at, velocity, pace),
        };
        moving.zip(herd.paces()).zip(0..).map(animal)
    }
}

/// A hash of all that these animals are, in any order: the hash of a herd is the sum of those of its parts.
pub fn hash(animals: &[Animal]) -> u64 {
    let hash = |&Animal { number, aabb, rest }: &Animal| {
        let (place, velocity, pace) = rest;
        let pairs = [aabb.mins, aabb.maxs, place, velocity, [pace; 2]];
        // FNV-1a, word by word, and then its high bits into the low ones.
        let hash = pairs.as_flattened().iter().fold(!number, |hash, word| {
            (hash ^ u64::from(word.to_bits())).wrapping_mul(0x0000_0100_0000_01B3)
        });
        (hash ^ hash >> 32).wrapping_mul(0x9E37_79B9_7F4A_7C15)
    };
    animals.iter().map(hash).fold(0, u64::wrapping_add)
}

/// The part of a herd that one process owns. All processes must call the same methods in the same order.
pub struct Herd<'a> {
    world: &'a SimpleCommunicator,
    /// The animals.
    pub domains: Domains<'a, f32, 2, ([f32; 2], [f32; 2], f32)>,
    /// Animals in the whole herd.
    pub count: usize,
    /// Steps since the start.
    pub step: u64,
}

impl<'a> Herd<'a> {
    /// A herd of `count`, after so many steps, of which these animals are on this process.
    pub fn new(world: &'a SimpleCommunicator, count: usize, step: u64, own: Vec<Animal>) -> Self {
        let domains = Domains::new(world, own);
        Self {
            world,
            domains,
            count,
            step,
        }
    }

    /// A herd at its start. Every process makes the whole herd, and keeps its share.
    pub fn at_start(world: &'a SimpleCommunicator, count: usize) -> Self {
        let all = Stampede::new(count, 7);
        let share = Animal::all(&all).skip(world.rank() as usize);
        let share = share.step_by(world.size() as usize).collect();
        Self::new(world, count, 0, share)
    }

    /// The hash of the whole herd, on every process.
    pub fn hash(&self) -> u64 {
        sum(self.world, hash(self.domains.own()))
    }

    /// Moves on by a step.
    ///
    /// Rounding depends on the order in which an animal's pushes are added up. Here that is the order of its neighbours' numbers, which
    /// no process changes; and each process has all neighbours of its own animals, for all are of the unisize class. So the bits are those
    /// of [`Stampede::advance`] with sorted pairs. Copies move as well, without all their neighbours, and are forgotten.
    ///
    /// # Errors
    /// Those of [`Domains::find_pairs`].
    pub fn advance(&mut self) -> Result<()> {
        self.domains.find_pairs()?;
        let Domains {
            bodies, own, pairs, ..
        } = &mut self.domains;
        let mut order: Vec<usize> = (0..bodies.len()).collect();
        // They come in a few sorted runs, which this merges.
        order.sort_by_key(|&i| bodies[i].number);
        let mut rank = vec![0; bodies.len()];
        order.iter().zip(0..).for_each(|(&i, at)| rank[i] = at);
        let is_due = |pair: &&[u32; 2]| pair.iter().any(|&i| (i as usize) < *own);
        let pairs = pairs.iter().filter(is_due);
        let ranked = |pair: &[u32; 2]| sorted(pair.map(|i| rank[i as usize]));
        let mut pairs: Vec<_> = pairs.map(ranked).collect();
        pairs.sort_unstable();
        let mut part = Stampede::part(self.count, order.iter().map(|&i| bodies[i].rest));
        part.advance(pairs);
        for (moved, &i) in Animal::all(&part).zip(&order) {
            let number = bodies[i].number;
            bodies[i] = Animal { number, ..moved };
        }
        self.step += 1;
        Ok(())
    }
}
