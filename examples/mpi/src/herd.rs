//! A stampede over many processes: the same bits as the herd of one process.

use crate::{Body, Domains, World, sorted};
use anyhow::Result;
use siphasher::sip::SipHasher;
use std::hash::{Hash, Hasher};
use unisize::Aabb;
use unisize_scenes::Stampede;

/// An animal: its neighbourhood, its place, its velocity, and the speed that it would like to run at, in metres and seconds.
pub type Animal = Body<f32, 2, ([f32; 2], [f32; 2], f32)>;

impl Animal {
    /// The animals of a herd, numbered from 0 on.
    pub fn all(herd: &Stampede) -> impl Iterator<Item = Self> {
        let moving = herd.places().iter().zip(herd.velocities());
        let animal = |(number, ((&place, &velocity), &pace))| Self {
            number,
            aabb: Aabb::new(place, place).loosened(Stampede::NEIGHBOURHOOD),
            rest: (place, velocity, pace),
        };
        (0..).zip(moving.zip(herd.paces())).map(animal)
    }
}

/// The part of a herd that one process owns. All processes must call the same methods in the same order.
pub struct Herd<'a> {
    /// The animals.
    pub domains: Domains<'a, f32, 2, ([f32; 2], [f32; 2], f32)>,
    /// Animals in the whole herd.
    pub count: usize,
    /// Steps since the start.
    pub step: u64,
}

impl<'a> Herd<'a> {
    /// A herd of `count` at its start. Every process makes the whole herd, and keeps its share.
    pub fn at_start(world: &'a World, count: usize) -> Self {
        let all = Stampede::new(count, 7);
        let share = Animal::all(&all).skip(world.rank()).step_by(world.size());
        let (domains, step) = (Domains::new(world, share.collect()), 0);
        Self {
            domains,
            count,
            step,
        }
    }

    /// A hash of the step and of all animals of the whole herd, the same on every process: the sum over the animals.
    pub fn hash(&self) -> u64 {
        let hash = |&Animal { number, aabb, rest }: &Animal| {
            let (place, velocity, pace) = rest;
            let pairs = [aabb.mins, aabb.maxs, place, velocity, [pace; 2]];
            let mut hasher = SipHasher::new();
            (self.step, self.count, number).hash(&mut hasher);
            pairs.map(|pair| pair.map(f32::to_bits)).hash(&mut hasher);
            hasher.finish()
        };
        let own = self.domains.own().iter().map(hash);
        let parts = self.domains.world.each(own.fold(0, u64::wrapping_add));
        parts.into_iter().fold(0, u64::wrapping_add)
    }

    /// Moves on by a step.
    ///
    /// Rounding depends on the order in which an animal's pushes are added up. Here that is the order of its neighbours' numbers, which
    /// no process changes; and each process has all neighbours of its own animals, for all are of the unisize class. So the bits are those
    /// of [`Stampede::advance`] with sorted pairs. Copies move as well, without all their neighbours, and are forgotten.
    /// Errors are those of [`Domains::find_pairs`].
    pub fn advance(&mut self) -> Result<()> {
        self.domains.find_pairs()?;
        let bodies = &mut self.domains.bodies;
        let mut order: Vec<usize> = (0..bodies.len()).collect();
        // They come in a few sorted runs, which this merges.
        order.sort_by_key(|&i| bodies[i].number);
        let mut rank = vec![0; bodies.len()];
        order.iter().zip(0..).for_each(|(&i, at)| rank[i] = at);
        let ranked = |pair: &[u32; 2]| sorted(pair.map(|i| rank[i as usize]));
        let mut pairs: Vec<_> = self.domains.pairs.iter().map(ranked).collect();
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
