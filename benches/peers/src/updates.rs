//! Broad phases over time: what one update takes after some of the colliders have moved.
//!
//! Every broad phase has a world of its own with the same colliders, which are moved outside of the timing.
//! They take turns of some frames each, in one order and then in the other, so that none is always first.

mod choreography;
mod motion;
mod peer;
mod sizes;

use crate::pair_set::PairSet;
use crate::progress::Progress;
use crate::row::{self, Row};
use crate::times::Times;
use anyhow::{Context, Result, bail};
use choreography::Choreography;
use motion::Motion;
use peer::{Entry, Peer};
use sizes::Sizes;

#[path = "updates/engine"]
mod dim2 {
    //! The broad phases for rapier2d.
    use super::peer::Entry;

    /// The one of this repository first, then the one that it replaces.
    pub(super) const ENTRIES: [Entry<2>; 4] =
        [v027::OURS, v027::DEFAULT, v036::BVH, v026::MULTI_SAP];

    #[path = "."]
    mod v026 {
        use rapier2d_026 as rapier;

        #[path = "v026.rs"]
        mod engine;
        mod world;
        pub(super) use engine::MULTI_SAP;
    }

    #[path = "."]
    mod v027 {
        use rapier2d as rapier;
        use unisize::rapier2d as ours;

        #[path = "v027.rs"]
        mod engine;
        mod world;
        pub(super) use engine::{DEFAULT, OURS};
    }

    #[path = "."]
    mod v036 {
        use rapier2d_036 as rapier;

        #[path = "v036.rs"]
        mod engine;
        mod world;
        pub(super) use engine::BVH;
    }
}

#[path = "updates/engine"]
mod dim3 {
    //! The broad phases for rapier3d.
    use super::peer::Entry;

    /// The one of this repository first, then the one that it replaces.
    pub(super) const ENTRIES: [Entry<3>; 4] =
        [v027::OURS, v027::DEFAULT, v036::BVH, v026::MULTI_SAP];

    #[path = "."]
    mod v026 {
        use rapier3d_026 as rapier;

        #[path = "v026.rs"]
        mod engine;
        mod world;
        pub(super) use engine::MULTI_SAP;
    }

    #[path = "."]
    mod v027 {
        use rapier3d as rapier;
        use unisize::rapier3d as ours;

        #[path = "v027.rs"]
        mod engine;
        mod world;
        pub(super) use engine::{DEFAULT, OURS};
    }

    #[path = "."]
    mod v036 {
        use rapier3d_036 as rapier;

        #[path = "v036.rs"]
        mod engine;
        mod world;
        pub(super) use engine::BVH;
    }
}

/// Boxes that much smaller, as a part of their size, overlap whatever was rounded.
const ROUNDING: f32 = 1e-3;

/// Turns of each broad phase in a case.
const ROUNDS: usize = 5;

/// Numbers of colliders, and frames in a turn.
const EFFORTS: [(usize, usize); 5] = [
    (10, 400),
    (100, 200),
    (1_000, 80),
    (10_000, 24),
    (1 << 17, 12),
];

const QUICK_EFFORTS: [(usize, usize); 2] = [(100, 50), (10_000, 5)];

/// The number for the motion that goes on for long: with more, it would take minutes.
const LONG_COUNT: usize = 10_000;

/// The least number for colliders of mixed sizes.
const MIXED_COUNT: usize = 10_000;

/// The number for an update that learns of nothing: it hardly depends on it.
const NOTHING_COUNT: usize = 1 << 17;

/// Measures every broad phase in two and three dimensions.
pub(crate) fn measure(quick: bool, progress: &Progress) -> Result<Vec<Row>> {
    let mut rows = measure_in(&dim2::ENTRIES, [0.8, 0.2], quick, progress)?;
    rows.extend(measure_in(&dim3::ENTRIES, [0.4, 0.1], quick, progress)?);
    Ok(rows)
}

fn measure_in<const D: usize>(
    entries: &[Entry<D>],
    densities: [f64; 2],
    quick: bool,
    progress: &Progress,
) -> Result<Vec<Row>> {
    let efforts = if quick { &QUICK_EFFORTS[..] } else { &EFFORTS };
    let mut cases = Vec::new();
    for &density in &densities[..if quick { 1 } else { 2 }] {
        for sizes in Sizes::ALL {
            for motion in Motion::ALL {
                let efforts = efforts.iter();
                let wanted = efforts.filter(|(count, _)| is_wanted(motion, sizes, *count, quick));
                cases.extend(wanted.map(|effort| (density, motion, sizes, effort)));
            }
        }
    }
    progress.expect(cases.len());
    let mut rows = Vec::new();
    for (density, motion, sizes, &(count, frames)) in cases {
        let start = Choreography::new(count, density, motion, sizes);
        let title = start.title();
        let case = format!("updates, {D}D, density {density}, {title}, n = {count}");
        progress.begin(case.clone());
        let of_case = contend(entries, &start, density, frames).context(case)?;
        rows.extend(of_case);
        progress.end();
    }
    Ok(rows)
}

fn is_wanted(motion: Motion, sizes: Sizes, count: usize, quick: bool) -> bool {
    match motion {
        Motion::OneIn(1) if sizes != Sizes::One => count >= MIXED_COUNT,
        _ if sizes != Sizes::One => false,
        // Fewer than one in so many would be no other case than one in as many as there are.
        Motion::OneIn(stride) => count >= stride,
        Motion::InMargin => true,
        Motion::AllForLong => count == LONG_COUNT && !quick,
        Motion::Nothing => count == NOTHING_COUNT,
    }
}

/// One broad phase in one case.
struct Contender<const D: usize> {
    name: &'static str,
    choreography: Choreography<D>,
    peer: Box<dyn Peer<D>>,
    times: Times,
}

impl<const D: usize> Contender<D> {
    fn run(&mut self, frames: usize) {
        self.times.begin_turn();
        for _ in 0..frames {
            self.choreography.advance();
            self.peer.place(self.choreography.centers());
            self.times.push(self.peer.update());
        }
    }
}

fn contend<const D: usize>(
    entries: &[Entry<D>],
    start: &Choreography<D>,
    density: f64,
    frames_a_round: usize,
) -> Result<Vec<Row>> {
    let enter = |entry: &Entry<D>| {
        let mut contender = Contender {
            name: entry.name,
            choreography: start.clone(),
            peer: (entry.create)(start),
            times: Times::default(),
        };
        contender.run(start.motion().frames_to_settle());
        contender.times = Times::default();
        contender
    };
    let is_measured = |entry: &&Entry<D>| entry.takes_large || !start.has_large();
    let mut contenders: Vec<_> = entries.iter().filter(is_measured).map(enter).collect();
    for round in 0..ROUNDS {
        let run = |contender: &mut Contender<D>| contender.run(frames_a_round);
        if round % 2 == 0 {
            contenders.iter_mut().for_each(run);
        } else {
            contenders.iter_mut().rev().for_each(run);
        }
    }

    let held: Vec<_> = contenders.iter().map(|c| c.peer.held_pairs()).collect();
    let is_right = check(&contenders, &held)?;
    let row = |(contender, held): (&Contender<D>, &PairSet)| Row {
        subject: "updates".into(),
        dimension: D,
        density,
        motion: start.title(),
        count: start.centers().len(),
        contender: contender.name.into(),
        setting: String::new(),
        frames: contender.times.count(),
        typical_ms: contender.times.typical(),
        mean_ms: contender.times.mean(),
        worst_ms: contender.times.worst(),
        pairs: held.len(),
        ratio: f64::NAN,
    };
    let checked = contenders.iter().zip(&held).zip(is_right);
    let right = checked.filter_map(|(contender, is_right)| is_right.then_some(contender));
    let mut rows: Vec<_> = right.map(row).collect();
    row::set_ratios(&mut rows);
    Ok(rows)
}

/// Every broad phase must hold every pair of colliders that overlap, and may hold more: each has margins of its
/// own. The first two have the same, and must hold the same. The one without any margin may miss a pair that touches, but
/// for rounding. Another one that misses a pair is told of, and left out.
fn check<const D: usize>(contenders: &[Contender<D>], held: &[PairSet]) -> Result<Vec<bool>> {
    let mut is_right = Vec::new();
    for (i, (contender, held)) in contenders.iter().zip(held).enumerate() {
        let smaller = if i < 2 { 0.0 } else { ROUNDING };
        let overlapping = PairSet::of_boxes(&contender.choreography.boxes(smaller))?;
        let missing = overlapping.missing_in(held);
        if missing > 0 {
            let name = contender.name;
            let case = contender.choreography.title();
            let count = contender.choreography.centers().len();
            let defect = format!("{name} does not hold {missing} pairs that overlap");
            if i < 2 {
                bail!(defect);
            }
            eprintln!("{defect}, and is left out: {D}D, {case}, n = {count}");
        }
        is_right.push(missing == 0);
    }
    let [ours, default, ..] = held else {
        return Ok(is_right);
    };
    match ours.difference(default) {
        Some(difference) => {
            bail!("unisize and the broad phase that it replaces hold different pairs: {difference}")
        }
        None => Ok(is_right),
    }
}
