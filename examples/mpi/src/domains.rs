//! The bodies of one process, its copies of others, and the pairs among them.

use crate::{Sent, World, bisection::Bisection};
use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};
use std::time::Instant;
use unisize::{Aabb, BruteForce, GridSweep, InvalidInput, PairFinder, Real};

/// The number of centres per process in the sample that regions are cut by. With 2048, loads differ by some 2 % at the last cut; with fewer,
/// by more.
const SAMPLES: usize = 2048;

/// The unisize class has the boxes up to this many times as long as the median. If larger, one long box makes all processes send more. If
/// smaller, fewer boxes have all of their partners on their own process.
const CLASS: f64 = 4.0;

/// A box with its number and its payload, which the processes send to each other.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(bound = "[R; D]: Sent, T: Sent")]
pub struct Body<R, const D: usize, T = ()> {
    /// Its number, which no other body has, and which is the same on all processes.
    pub number: u64,
    /// Its box.
    pub aabb: Aabb<R, D>,
    /// Data of the caller's.
    pub payload: T,
}

/// The cost of the last frame on this process.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub struct Stats {
    /// Milliseconds of everything but the sweep, which includes waiting for other processes.
    pub exchange_ms: f64,
    /// Milliseconds of finding pairs.
    pub sweep_ms: f64,
    /// Bytes of bodies sent to other processes.
    pub bytes: u64,
    /// Received bodies that this process now owns.
    pub migrated: usize,
    /// Copies of bodies of other processes.
    pub copies: usize,
    /// Whether the regions were cut again.
    pub bisected: bool,
}

/// The bodies that a process owns, and the pairs that it finds on as many threads as the current Rayon pool has. All processes must call the same
/// methods in the same order.
pub struct Domains<'a, R, const D: usize, T = ()> {
    /// All processes.
    pub world: &'a World,
    bisection: Bisection<D>,
    /// The region of this process.
    region: Aabb<f64, D>,
    /// The longest side in the unisize class.
    class: f64,
    /// The difference between loads above which the regions are cut again. `None` before the first cut.
    tolerated: Option<usize>,
    /// The bodies of this process, which the caller may move, and then the copies. Numbers must not change.
    pub bodies: Vec<Body<R, D, T>>,
    /// The number of bodies of this process.
    pub own: usize,
    boxes: Vec<Aabb<R, D>>,
    /// Pairs of indices of `bodies`: all pairs of each own body of the unisize class, and other pairs.
    pub pairs: Vec<[u32; 2]>,
    kernel: GridSweep<R, D>,
    /// The cost of the last frame.
    pub stats: Stats,
}

impl<'a, R: Real, const D: usize, T: Copy + Sent> Domains<'a, R, D, T>
where
    [R; D]: Sent,
{
    /// Starts with any bodies on this process. The first search sends them to the processes of their regions.
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

    /// Whether a box belongs to the unisize class: it is not much longer than most.
    pub fn is_unisize(&self, aabb: &Aabb<R, D>) -> bool {
        longest_side(aabb) <= self.class
    }

    /// The pairs that this process reports, as numbers of bodies, the smaller one first. Exactly one process reports each overlapping pair.
    ///
    /// The owner of the point max(mins) of both boxes, axis by axis, reports the pair. Proof: both boxes contain this point
    /// (`mins <= max(mins) <= maxs`, without rounding), so both reach the region of its owner. A process has each body that reaches its
    /// region once, as its own or as a copy. Regions partition space, so no other process owns the point.
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

    /// Finds the pairs of this frame. Cuts the regions in the first frame, and when loads differ by a fifth of their mean.
    ///
    /// # Errors
    /// [`InvalidInput`], the same on every process, if a box has a NaN or is inverted: it has the smallest number of such a body. Any other
    /// error occurs on one process only, while the others wait for it: end the run.
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
        self.distribute()?;
        if self.stats.bisected {
            // If bodies coincide, no cut evens out the loads. So do not cut again in every frame.
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

    /// Returns the same error on all processes: that of the invalid body with the smallest number.
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

    /// The mean number of bodies per process, and the difference between the largest and the smallest number.
    pub fn loads(&self) -> (usize, usize) {
        let mut loads = self.world.each(self.own);
        loads.sort_unstable();
        let mean = loads.iter().sum::<usize>() / loads.len();
        (mean, loads[loads.len() - 1] - loads[0])
    }

    /// Cuts the regions by a sample of all bodies, which every process receives.
    fn bisect(&mut self, mean: usize) -> Result<()> {
        let stride = mean.div_ceil(SAMPLES).max(1);
        // A pseudorandom one of each `stride` bodies, so that a pattern in their order does not matter.
        let any = |(i, chunk): (usize, &[Body<R, D, T>])| {
            chunk[i.wrapping_mul(0x9E37_79B9) / 8 % chunk.len()].aabb
        };
        let sample = self.own().chunks(stride).enumerate().map(any).collect();
        let sample = self.world.gather(sample)?;
        let mut sides: Vec<_> = sample.iter().map(longest_side).collect();
        sides.sort_unstable_by(f64::total_cmp);
        // Finite for any boxes: an infinite box loosened by infinity has no centre.
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

    /// Sends each own body to all processes whose region its box reaches, loosened by the longest side of the unisize class. The process
    /// whose region has the centre becomes the owner (the loosened box contains the centre); the others receive copies.
    ///
    /// So a process has all partners of its own bodies of the class. Proof: let `b` overlap such a body `a`. Then `b.mins <= a.maxs`.
    /// Rounding is monotone, so `b.mins - longest <= a.maxs - longest`, which is not above the centre of `a`: rounding may make `longest`
    /// shorter than the true side by half a unit in the last place, which is less than half of the side. The same holds above. So the
    /// loosened `b` contains the centre, which is in the region.
    fn distribute(&mut self) -> Result<()> {
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

/// Whether all points of a box are in a region. Finite `maxs` do not belong to the region.
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

/// The rounded centre, which is a point of the box, and decides which process owns a body. 0 between two infinities.
fn centre<R: Real, const D: usize>(aabb: &Aabb<R, D>) -> Aabb<f64, D> {
    let centre = std::array::from_fn(|k| {
        let middle = f64::midpoint(aabb.mins[k].to_f64(), aabb.maxs[k].to_f64());
        if middle.is_nan() { 0.0 } else { middle }
    });
    Aabb::new(centre, centre)
}

/// The length of the longest side: infinite or NaN if a bound is infinite.
fn longest_side<R: Real, const D: usize>(aabb: &Aabb<R, D>) -> f64 {
    let sides = (0..D).map(|k| aabb.maxs[k].to_f64() - aabb.mins[k].to_f64());
    sides.max_by(f64::total_cmp).unwrap_or(0.0)
}

/// The pair with the smaller one first.
pub fn sorted<T: Ord>([a, b]: [T; 2]) -> [T; 2] {
    if a <= b { [a, b] } else { [b, a] }
}
