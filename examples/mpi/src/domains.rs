//! The bodies of one process, its copies of others, and the pairs among them.

use crate::{Sent, World, bisection::Bisection};
use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};
use std::time::Instant;
use unisize::{Aabb, BruteForce, GridSweep, InvalidInput, PairFinder, Real};

/// Regions are cut by so many centres a process. With fewer, loads differ by more: by some 2 % at the last cut.
const SAMPLES: usize = 2048;

/// Boxes up to so many times as long as the median are the unisize class. With more, one long box makes all processes send more; with
/// less, fewer boxes have all their partners on their own process.
const CLASS: f64 = 4.0;

/// What is dealt to processes: a box, its number, and what travels with it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(bound = "[R; D]: Sent, T: Sent")]
pub struct Body<R, const D: usize, T = ()> {
    /// Its number, the same wherever it is. No two bodies have one number.
    pub number: u64,
    /// Its box.
    pub aabb: Aabb<R, D>,
    /// What else it is.
    pub rest: T,
}

/// What the last frame has cost this process.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub struct Stats {
    /// Milliseconds of everything but the sweep: agreeing, handing over, copying, waiting for others.
    pub exchange_ms: f64,
    /// Milliseconds of finding pairs.
    pub sweep_ms: f64,
    /// Bytes of bodies that it sent to others.
    pub bytes: u64,
    /// Bodies that it received for good.
    pub migrated: usize,
    /// Bodies that it has a copy of.
    pub copies: usize,
    /// Whether regions were cut anew.
    pub bisected: bool,
}

/// The bodies that a process owns, and the pairs it finds, on the threads of the current Rayon pool. All processes must call the same
/// methods in the same order.
pub struct Domains<'a, R, const D: usize, T = ()> {
    /// All processes.
    pub world: &'a World,
    bisection: Bisection<D>,
    /// What of space is this process's own.
    region: Aabb<f64, D>,
    /// What a side of the unisize class is at most.
    class: f64,
    /// By how much loads may differ before regions are cut anew; nothing until they have been cut.
    tolerated: Option<usize>,
    /// The bodies of this process, which the caller moves, then the copies of others. Numbers must stay.
    pub bodies: Vec<Body<R, D, T>>,
    /// How many of the bodies are its own.
    pub own: usize,
    boxes: Vec<Aabb<R, D>>,
    /// The pairs of indices of `bodies`: all those of each own body of the unisize class, and others.
    pub pairs: Vec<[u32; 2]>,
    kernel: GridSweep<R, D>,
    /// What the last frame has cost.
    pub stats: Stats,
}

impl<'a, R: Real, const D: usize, T: Copy + Sent> Domains<'a, R, D, T>
where
    [R; D]: Sent,
{
    /// With these bodies on this process: any, for they are dealt when pairs are first searched for.
    pub fn new(world: &'a World, bodies: Vec<Body<R, D, T>>) -> Self {
        Self {
            world,
            bisection: Bisection::Leaf(0, everywhere()),
            region: everywhere(),
            class: 0.0,
            tolerated: None,
            own: bodies.len(),
            bodies,
            boxes: Vec::new(),
            pairs: Vec::new(),
            kernel: GridSweep::default(),
            stats: Stats::default(),
        }
    }

    /// The bodies of this process.
    pub fn own(&self) -> &[Body<R, D, T>] {
        &self.bodies[..self.own]
    }

    /// Whether a box is of the unisize class: not much longer than most.
    pub fn is_unisize(&self, aabb: &Aabb<R, D>) -> bool {
        longest_side(aabb) <= self.class
    }

    /// The numbers of the pairs that this process reports, smaller first. Over all processes, each overlapping pair is reported once.
    ///
    /// A pair is reported by the process in whose region the corner max(mins) of the two lies, axis by axis. Proof: both boxes contain
    /// this point (`mins <= max(mins) <= maxs`, compared and not computed), so both reach the region of its owner; and a process has each
    /// body that reaches its region, once, as its own or as a copy. Regions partition space, so no other process owns the point.
    pub fn reported(&self) -> impl Iterator<Item = [u64; 2]> {
        let is_mine = |[a, b]: &[u32; 2]| {
            let [a, b] = [a, b].map(|&i| &self.boxes[i as usize].mins);
            let corner = std::array::from_fn(|k| if a[k] < b[k] { b[k] } else { a[k] }.to_f64());
            contains(&self.region, &Aabb::new(corner, corner))
        };
        let number = |i: u32| self.bodies[i as usize].number;
        let mine = self.pairs.iter().filter(move |pair| is_mine(pair));
        mine.map(move |pair| sorted(pair.map(number)))
    }

    /// Finds the pairs of this frame. Regions are cut the first time, and when loads have come to differ by a fifth of their mean.
    ///
    /// # Errors
    /// [`InvalidInput`], the same on every process, if a box has a NaN or is inverted: it names the body with the smallest number. Any
    /// other error is of one process only, and the rest wait for it: end the run.
    pub fn find_pairs(&mut self) -> Result<()> {
        let began = Instant::now();
        self.stats = Stats::default();
        self.pairs.clear();
        self.bodies.truncate(self.own);
        self.check()?;
        let (mean, spread) = self.loads();
        if self.tolerated.is_none_or(|most| spread > most) {
            self.bisect(mean)?;
        }
        self.deal()?;
        if self.stats.bisected {
            // Where bodies coincide no cut helps, and another one is not tried in every frame.
            self.tolerated = Some((mean / 5).max(2 * self.loads().1));
        }
        self.boxes.clear();
        self.boxes.extend(self.bodies.iter().map(|body| body.aabb));
        let exchanged = began.elapsed();
        let found = self.kernel.find_pairs(&self.boxes, &mut self.pairs);
        found.context("a process has too many boxes: use more processes")?;
        self.stats.exchange_ms = 1e3 * exchanged.as_secs_f64();
        self.stats.sweep_ms = 1e3 * (began.elapsed() - exchanged).as_secs_f64();
        Ok(())
    }

    /// Tells all processes of the invalid body with the smallest number.
    fn check(&self) -> Result<()> {
        let invalid = self.own().iter().filter(|body| !body.aabb.is_valid());
        let mine = invalid.min_by_key(|body| body.number).copied();
        if self.world.each(mine.is_some()).contains(&true) {
            let mut all = self.world.gather(Vec::from_iter(mine))?;
            all.sort_unstable_by_key(|body| body.number);
            let refused = BruteForce.find_pairs(&[all[0].aabb], &mut Vec::new());
            refused.map_err(|error| InvalidInput::new(all[0].number as usize, error.reason))?;
        }
        Ok(())
    }

    /// The mean number of bodies of a process, and the difference between the most and the least.
    pub fn loads(&self) -> (usize, usize) {
        let mut loads = self.world.each(self.own);
        loads.sort_unstable();
        let mean = loads.iter().sum::<usize>() / loads.len();
        (mean, loads[loads.len() - 1] - loads[0])
    }

    /// Cuts regions anew, by a sample of all bodies that every process is given.
    fn bisect(&mut self, mean: usize) -> Result<()> {
        let stride = mean.div_ceil(SAMPLES).max(1);
        // Any one of each `stride`, so that a pattern in the order of bodies is not seen.
        let any = |(i, chunk): (usize, &[Body<R, D, T>])| {
            chunk[i.wrapping_mul(0x9E37_79B9) / 8 % chunk.len()].aabb
        };
        let sample = self.own().chunks(stride).enumerate().map(any).collect();
        let sample = self.world.gather(sample)?;
        let mut sides: Vec<_> = sample.iter().map(longest_side).collect();
        sides.sort_unstable_by(f64::total_cmp);
        // Finite, whatever the boxes are: infinity less infinity would be nowhere.
        self.class = (CLASS * sides.get(sides.len() / 2).unwrap_or(&0.0)).min(f64::MAX);
        let finite = |x: f64| x.clamp(f64::MIN, f64::MAX);
        let centres = sample.iter().map(|aabb| centre(aabb).mins.map(finite));
        let mut centres: Vec<_> = centres.collect();
        let (processes, me) = (0..self.world.size(), self.world.rank());
        self.bisection = Bisection::new(&mut centres, processes, everywhere());
        self.bisection.reach(&everywhere(), &mut |process, region| {
            if process == me {
                self.region = *region;
            }
        });
        self.stats.bisected = true;
        Ok(())
    }

    /// Sends each own body to all processes whose region its box reaches, loosened by the longest side of the unisize class: those near a
    /// border to who is behind it, longer ones to all they reach, and what has left the region to its new owner. That is where its centre
    /// lies, and the loosened box contains the centre. All others have copies.
    ///
    /// So a process has all partners of its own bodies of the class. Proof: let `b` overlap such a body `a`. Then `b.mins <= a.maxs`, and
    /// rounding is monotone, so `b.mins - longest <= a.maxs - longest`, which is not above the centre of `a`: if `longest` is
    /// less than the true side, by half a unit in its last place, then the side has so many units that its half makes up for it. The
    /// same holds above. So `b`, loosened, contains the centre, which is in the region.
    fn deal(&mut self) -> Result<()> {
        let sides = self.bodies.iter().map(|body| longest_side(&body.aabb));
        let own = sides.filter(|&side| side <= self.class).fold(0.0, f64::max);
        let longest = self.world.each(own).into_iter().fold(0.0, f64::max);
        let mut lists = vec![Vec::new(); self.world.size()];
        self.bodies.retain(|body| {
            let aabb = widened(&body.aabb).loosened(longest);
            let stays = contains(&self.region, &aabb);
            if !stays {
                self.bisection
                    .reach(&aabb, &mut |process, _| lists[process].push(*body));
            }
            stays
        });
        let mut near = std::mem::take(&mut lists[self.world.rank()]);
        let kept = near.len();
        self.stats.bytes = self.world.exchange(&lists, &mut near)?;
        let is_own = |body: &&Body<R, D, T>| contains(&self.region, &centre(&body.aabb));
        self.stats.migrated = near[kept..].iter().filter(is_own).count();
        let (own, copies): (Vec<&_>, Vec<&_>) = near.iter().partition(is_own);
        self.bodies.extend(own);
        self.own = self.bodies.len();
        self.stats.copies = copies.len();
        self.bodies.extend(copies);
        Ok(())
    }
}

/// All of space.
fn everywhere<const D: usize>() -> Aabb<f64, D> {
    Aabb::new([f64::NEG_INFINITY; D], [f64::INFINITY; D])
}

/// Whether all points of a box are in a region, which does not contain its finite `maxs`.
fn contains<const D: usize>(region: &Aabb<f64, D>, aabb: &Aabb<f64, D>) -> bool {
    (0..D).all(|k| {
        let end = region.maxs[k];
        region.mins[k] <= aabb.mins[k] && (aabb.maxs[k] < end || end == f64::INFINITY)
    })
}

/// The same box in `f64`, exactly.
fn widened<R: Real, const D: usize>(aabb: &Aabb<R, D>) -> Aabb<f64, D> {
    Aabb::new(aabb.mins.map(R::to_f64), aabb.maxs.map(R::to_f64))
}

/// The centre, rounded, a point of the box: 0 from one infinity to the other. It decides who owns a body.
fn centre<R: Real, const D: usize>(aabb: &Aabb<R, D>) -> Aabb<f64, D> {
    let centre = std::array::from_fn(|k| {
        let middle = f64::midpoint(aabb.mins[k].to_f64(), aabb.maxs[k].to_f64());
        if middle.is_nan() { 0.0 } else { middle }
    });
    Aabb::new(centre, centre)
}

/// The longest side: infinite or NaN if a side is at infinity.
fn longest_side<R: Real, const D: usize>(aabb: &Aabb<R, D>) -> f64 {
    let sides = (0..D).map(|k| aabb.maxs[k].to_f64() - aabb.mins[k].to_f64());
    sides.max_by(f64::total_cmp).unwrap_or(0.0)
}

/// A pair, smaller first.
pub fn sorted<T: Ord>([a, b]: [T; 2]) -> [T; 2] {
    if a <= b { [a, b] } else { [b, a] }
}
