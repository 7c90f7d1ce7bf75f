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
use crate::row::Row;
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

    /// For each version the one of this repository first, then the one that it replaces.
    pub(super) const ENTRIES: [Entry<2>; 5] = [
        v027::OURS,
        v027::DEFAULT,
        v036::OURS,
        v036::BVH,
        v026::MULTI_SAP,
    ];

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
        use unisize::rapier2d_027 as ours;

        #[path = "v027.rs"]
        mod engine;
        mod world;
        pub(super) use engine::{DEFAULT, OURS};
    }

    #[path = "."]
    mod v036 {
        use rapier2d_036 as rapier;
        use unisize::rapier2d_036 as ours;

        mod deferred;
        #[path = "v036.rs"]
        mod engine;
        mod world;
        pub(super) use engine::{BVH, OURS};
    }
}

#[path = "updates/engine"]
mod dim3 {
    //! The broad phases for rapier3d.
    use super::peer::Entry;

    /// For each version the one of this repository first, then the one that it replaces.
    pub(super) const ENTRIES: [Entry<3>; 5] = [
        v027::OURS,
        v027::DEFAULT,
        v036::OURS,
        v036::BVH,
        v026::MULTI_SAP,
    ];

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
        use unisize::rapier3d_027 as ours;

        #[path = "v027.rs"]
        mod engine;
        mod world;
        pub(super) use engine::{DEFAULT, OURS};
    }

    #[path = "."]
    mod v036 {
        use rapier3d_036 as rapier;
        use unisize::rapier3d_036 as ours;

        mod deferred;
        #[path = "v036.rs"]
        mod engine;
        mod world;
        pub(super) use engine::{BVH, OURS};
    }
}

/// That of this repository, for Rapier 0.27.
pub(crate) const OURS: &str = "unisize for 0.27, lists";

/// That for Rapier 0.36.
pub(crate) const OURS_HANDED_OVER: &str = "unisize for 0.36, boxes handed over";

/// The one that Rapier 0.27 has itself.
pub(crate) const BVH_027: &str = "Rapier 0.27, BVH";

/// The one that Rapier 0.36 has itself.
pub(crate) const BVH_036: &str = "Rapier 0.36, BVH";

/// Without any margin.
const MULTI_SAP: &str = "Rapier 0.26, multi-SAP";

/// Added to the name of one whose updates do what its engine defers.
pub(crate) const WITHOUT_DEFERRED: &str = ", without the deferred optimization";

/// With more colliders, its cases alone take as long as all others together.
const MULTI_SAP_MAX: usize = 10_000;

/// Boxes that much smaller, as a part of their size, overlap whatever was rounded.
const ROUNDING: f32 = 1e-3;

/// Turns of each broad phase in a case.
const ROUNDS: usize = 5;

/// Numbers of colliders, and frames in a turn.
const EFFORTS: [(usize, usize); 5] = [
    (10, 400),
    (100, 200),
    (1_000, 200),
    (10_000, 24),
    (1 << 17, 8),
];

/// Up to so many colliders, everything runs twice, so that the longest frame is not one that something else held up.
const TWICE_MAX: usize = 1_000;

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
    ours: &'static str,
    choreography: Choreography<D>,
    peer: Box<dyn Peer<D>>,
    times: Times,
    /// What of these could be done beside the solver: of a run of its own, because whoever takes this time leaves the caches
    /// in another state.
    deferred: Times,
}

/// What is timed in a run.
#[derive(Clone, Copy, PartialEq)]
enum Timed {
    Updates,
    Deferred,
}

impl<const D: usize> Contender<D> {
    fn run(&mut self, frames: usize, timed: Timed) {
        self.times.begin_turn();
        self.deferred.begin_turn();
        for _ in 0..frames {
            self.choreography.advance();
            if timed == Timed::Deferred {
                self.deferred.push(self.peer.deferred());
            }
            self.peer.place(self.choreography.centers());
            let time = self.peer.update();
            if timed == Timed::Updates {
                self.times.push(time);
            }
        }
    }
}

fn contend<const D: usize>(
    entries: &[Entry<D>],
    start: &Choreography<D>,
    density: f64,
    frames_a_round: usize,
) -> Result<Vec<Row>> {
    let mut contenders = follow(entries, start, frames_a_round, Timed::Updates);
    let deferring = entries.iter().filter(|entry| entry.name == BVH_036);
    let mut deferring = follow(deferring, start, frames_a_round, Timed::Deferred);
    if start.centers().len() <= TWICE_MAX {
        let again = follow(entries, start, frames_a_round, Timed::Updates);
        for (contender, again) in contenders.iter_mut().zip(again) {
            contender.times.repeated(again.times);
        }
        let again = entries.iter().filter(|entry| entry.name == BVH_036);
        let again = follow(again, start, frames_a_round, Timed::Deferred);
        for (contender, again) in deferring.iter_mut().zip(again) {
            contender.deferred.repeated(again.deferred);
        }
    }
    for deferring in deferring {
        let same = contenders.iter_mut().find(|c| c.name == deferring.name);
        same.expect("both runs have it").deferred = deferring.deferred;
    }

    let held: Vec<_> = contenders.iter().map(|c| c.peer.held_pairs()).collect();
    let is_right = check(&contenders, &held)?;
    let row = |name: &str, contender: &Contender<D>, times: &Times, pairs: usize| Row {
        subject: "updates".into(),
        dimension: D,
        density,
        motion: start.title(),
        count: start.centers().len(),
        contender: name.to_owned().into(),
        setting: String::new(),
        frames: times.count(),
        typical_ms: times.typical(),
        mean_ms: times.mean(),
        worst_ms: times.worst(),
        pairs,
        ratio: match contenders.iter().find(|ours| ours.name == contender.ours) {
            Some(ours) => times.mean() / ours.times.mean(),
            None => f64::NAN,
        },
    };
    let mut rows = Vec::new();
    for ((contender, held), is_right) in contenders.iter().zip(&held).zip(is_right) {
        if !is_right {
            continue;
        }
        rows.push(row(contender.name, contender, &contender.times, held.len()));
        if !contender.deferred.is_zero() {
            let name = format!("{}{WITHOUT_DEFERRED}", contender.name);
            let rest = contender.times.without(&contender.deferred);
            rows.push(row(&name, contender, &rest, held.len()));
        }
    }
    Ok(rows)
}

/// All frames of a case.
fn follow<'a, const D: usize>(
    entries: impl IntoIterator<Item = &'a Entry<D>>,
    start: &Choreography<D>,
    frames_a_round: usize,
    timed: Timed,
) -> Vec<Contender<D>> {
    let enter = |entry: &Entry<D>| {
        let mut contender = Contender {
            name: entry.name,
            ours: entry.ours,
            choreography: start.clone(),
            peer: (entry.create)(start),
            times: Times::default(),
            deferred: Times::default(),
        };
        contender.run(start.motion().frames_to_settle(), timed);
        contender.times = Times::default();
        contender.deferred = Times::default();
        contender
    };
    let count = start.centers().len();
    let is_measured = |entry: &&Entry<D>| {
        (entry.takes_large || !start.has_large())
            && (entry.name != MULTI_SAP || count <= MULTI_SAP_MAX)
    };
    let entries = entries.into_iter().filter(is_measured);
    let mut contenders: Vec<_> = entries.map(enter).collect();
    for round in 0..ROUNDS {
        let run = |contender: &mut Contender<D>| contender.run(frames_a_round, timed);
        if round % 2 == 0 {
            contenders.iter_mut().for_each(run);
        } else {
            contenders.iter_mut().rev().for_each(run);
        }
    }
    contenders
}

/// Every broad phase must hold every pair of colliders that overlap, and may hold more: each has margins of its
/// own. Unisize has those of the one that it replaces, and must hold the same. The one without any margin may miss a pair that
/// touches, but for rounding. One of another version that misses a pair is told of, and left out.
fn check<const D: usize>(contenders: &[Contender<D>], held: &[PairSet]) -> Result<Vec<bool>> {
    let mut is_right = Vec::new();
    for (contender, held) in contenders.iter().zip(held) {
        let has_margin = contender.name != MULTI_SAP;
        let smaller = if has_margin { 0.0 } else { ROUNDING };
        let overlapping = PairSet::of_boxes(&contender.choreography.boxes(smaller))?;
        let missing = overlapping.missing_in(held);
        if missing > 0 {
            let name = contender.name;
            let case = contender.choreography.title();
            let count = contender.choreography.centers().len();
            let defect = format!("{name} does not hold {missing} pairs that overlap");
            if has_margin {
                bail!(defect);
            }
            eprintln!("{defect}, and is left out: {D}D, {case}, n = {count}");
        }
        is_right.push(missing == 0);
    }
    // Each of unisize's is followed by the one that it replaces.
    for (pair, held) in contenders.windows(2).zip(held.windows(2)) {
        let [ours, default] = pair else { continue };
        if ours.name != ours.ours || default.ours != ours.name {
            continue;
        }
        if let Some(difference) = held[0].difference(&held[1]) {
            let names = [ours.name, default.name].join(" and ");
            bail!("{names} hold different pairs: {difference}");
        }
    }
    Ok(is_right)
}
