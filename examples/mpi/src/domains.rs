//! The bodies of one process, its copies of others, and the pairs among them.

use crate::{Bisection, exchange, gather, greatest};
use anyhow::{Context, Result};
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, CommunicatorCollectives};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::time::Instant;
use unisize::{Aabb, BruteForce, GridSweep, InvalidInput, PairFinder, Real};

/// Regions are cut by so many centres a process. With fewer, loads differ by more: by some 2 % at the last cut.
const SAMPLES: u64 = 2048;

/// Boxes up to so many times as long as the median are the unisize class. With more, one long box makes all processes send more; with
/// less, fewer boxes have all their partners on their own process.
const CLASS: f64 = 4.0;

/// What is dealt to processes: a box, its number, and what travels with it, in the format of postcard.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(bound(
    serialize = "R: Serialize, T: Serialize",
    deserialize = "R: Real + Deserialize<'de>, T: Deserialize<'de>"
))]
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
    /// Bodies that it owns.
    pub own: usize,
    /// Bodies that it received for good.
    pub migrated: usize,
    /// Bodies that it received a copy of.
    pub copies: usize,
    /// Whether regions were cut anew.
    pub bisected: bool,
}

/// The bodies that a process owns, and the pairs it finds, on the threads of the current Rayon pool. All processes must call the same
/// methods in the same order.
pub struct Domains<'a, R, const D: usize, T = ()> {
    world: &'a SimpleCommunicator,
    bisection: Bisection,
    region: Aabb<f64, D>,
    /// What a side of the unisize class is at most.
    class: f64,
    /// By how much loads may differ before regions are cut anew; none if they have not been cut yet.
    tolerated: Option<u64>,
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

impl<'a, R, const D: usize, T> Domains<'a, R, D, T>
where
    R: Real + Serialize + DeserializeOwned,
    T: Copy + Serialize + DeserializeOwned,
{
    /// With these bodies on this process: any, for they are dealt when pairs are first searched for.
    pub fn new(world: &'a SimpleCommunicator, bodies: Vec<Body<R, D, T>>) -> Self {
        Self {
            world,
            bisection: Bisection::Leaf(0),
            region: Aabb::new([0.0; D], [0.0; D]),
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
        longest_side(&widened(aabb)) <= self.class
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
        let loads = self.loads();
        if self.tolerated.is_none_or(|most| spread(&loads) > most) {
            self.bisect(loads.iter().sum())?;
            self.migrate()?;
            // Where bodies coincide no cut helps, and another one is not tried in every frame.
            let dealt = spread(&self.loads());
            let mean = loads.iter().sum::<u64>() / loads.len() as u64;
            self.tolerated = Some((mean / 5).max(2 * dealt));
        } else {
            self.migrate()?;
        }
        self.copy_borders()?;
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
        if greatest(self.world, u64::from(mine.is_some())) == 0 {
            return Ok(());
        }
        let all = gather(self.world, Vec::from_iter(mine))?;
        if let Some(first) = all.iter().min_by_key(|body| body.number) {
            let refused = BruteForce.find_pairs(&[first.aabb], &mut Vec::new());
            refused.map_err(|error| InvalidInput::new(first.number as usize, error.reason))?;
        }
        Ok(())
    }

    /// The number of bodies of each process.
    fn loads(&self) -> Vec<u64> {
        let (own, mut loads) = (self.own as u64, vec![0; self.world.size() as usize]);
        self.world.all_gather_into(&own, &mut loads[..]);
        loads
    }

    /// Cuts regions anew, by a sample of all `total` boxes that every process is given.
    fn bisect(&mut self, total: u64) -> Result<()> {
        let processes = self.world.size() as usize;
        let stride = total.div_ceil(SAMPLES * processes as u64).max(1) as usize;
        // Any one of each `stride`, so that a pattern in the order of bodies is not seen.
        let any = |(i, chunk): (usize, &[Body<R, D, T>])| {
            widened(&chunk[i.wrapping_mul(0x9E37_79B9) / 8 % chunk.len()].aabb)
        };
        let sample = self.own().chunks(stride).enumerate().map(any).collect();
        let sample = gather(self.world, sample)?;
        let mut centres: Vec<_> = sample.iter().map(centre).collect();
        let mut sides: Vec<_> = sample.iter().map(longest_side).collect();
        sides.sort_unstable_by(f64::total_cmp);
        // Finite, whatever the boxes are: infinity less infinity would be nowhere.
        self.class = (CLASS * sides.get(sides.len() / 2).unwrap_or(&0.0)).min(f64::MAX);
        self.bisection = Bisection::new(&mut centres, 0..processes);
        self.region = Aabb::new([f64::NEG_INFINITY; D], [f64::INFINITY; D]);
        let me = self.world.rank() as usize;
        self.bisection.narrow(me, &mut self.region);
        self.stats.bisected = true;
        Ok(())
    }

    /// Hands over the bodies whose centres have left the region.
    fn migrate(&mut self) -> Result<()> {
        let mut leaving = vec![Vec::new(); self.world.size() as usize];
        self.bodies.retain(|body| {
            let centre = centre(&widened(&body.aabb));
            let stays = contains(&self.region, &Aabb::new(centre, centre));
            if !stays {
                leaving[self.bisection.owner(&centre)].push(*body);
            }
            stays
        });
        let stay = self.bodies.len();
        self.stats.bytes += exchange(self.world, &leaving, &mut self.bodies)?;
        self.own = self.bodies.len();
        self.stats.own = self.own;
        self.stats.migrated = self.own - stay;
        Ok(())
    }

    /// Sends a copy of each own body to the other processes whose region its box reaches, loosened by the longest side of the unisize class:
    /// those near a border to who is behind it, and longer ones to all they reach.
    ///
    /// So a process has all partners of its own bodies of the class. Proof: let `b` overlap such a body `a`. Then `b.mins <= a.maxs`, and
    /// rounding is monotone, so `b.mins - longest <= a.maxs - longest`, which is not above the centre of `a`: if `longest` is
    /// less than the true side, by half a unit in its last place, then the side has so many units that its half makes up for it. The
    /// same holds above. So `b`, loosened, contains the centre, which is in the region.
    fn copy_borders(&mut self) -> Result<()> {
        let me = self.world.rank() as usize;
        let own = self.own().iter().map(|body| widened(&body.aabb));
        let sides = own.map(|aabb| longest_side(&aabb));
        let longest = sides.filter(|&side| side <= self.class).fold(0.0, f64::max);
        let longest = greatest(self.world, longest);
        let mut copies = vec![Vec::new(); self.world.size() as usize];
        let mut reached = Vec::new();
        for body in self.own() {
            let aabb = widened(&body.aabb).loosened(longest);
            if !contains(&self.region, &aabb) {
                reached.clear();
                self.bisection.reach(&aabb, &mut reached);
                let others = reached.iter().filter(|&&p| p != me);
                others.for_each(|&p| copies[p].push(*body));
            }
        }
        self.stats.bytes += exchange(self.world, &copies, &mut self.bodies)?;
        self.stats.copies = self.bodies.len() - self.own;
        Ok(())
    }
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

/// The centre, rounded and finite; if the box is finite, a point of it. It decides who owns a body.
fn centre<const D: usize>(aabb: &Aabb<f64, D>) -> [f64; D] {
    std::array::from_fn(|k| {
        let middle = f64::midpoint(aabb.mins[k], aabb.maxs[k]);
        // From one infinity to the other it is NaN.
        if middle.is_nan() {
            0.0
        } else {
            middle.clamp(f64::MIN, f64::MAX)
        }
    })
}

/// The longest side: infinite or NaN if a side is at infinity.
fn longest_side<const D: usize>(aabb: &Aabb<f64, D>) -> f64 {
    let sides = (0..D).map(|k| aabb.maxs[k] - aabb.mins[k]);
    sides.max_by(f64::total_cmp).unwrap_or(0.0)
}

/// The difference between the largest and the smallest load.
fn spread(loads: &[u64]) -> u64 {
    let (least, most) = (loads.iter().min(), loads.iter().max());
    most.zip(least).map_or(0, |(most, least)| most - least)
}

/// A pair, smaller first.
pub fn sorted<T: Ord>([a, b]: [T; 2]) -> [T; 2] {
    if a <= b { [a, b] } else { [b, a] }
}
