//! Broad phases over time: what one update takes after some of the colliders have moved.
//!
//! Every broad phase has a world of its own with the same colliders, which are moved outside of the timing.
//! They take turns of some frames each, in one order and then in the other, so that none is always first.

use crate::case::{Case, Motion, Sizes};
use crate::clock::Clock;
use crate::pair_set::PairSet;
use crate::progress::progress_bar;
use crate::report::Report;
use crate::row::Row;
use crate::times::Times;
use anyhow::{Context, Result, bail};
use std::time::Duration;

#[path = "updates/engine"]
mod dim2 {
    use super::{Create, Entry};

    /// For each version the one of this repository first, then the one that it replaces.
    pub(super) const ENTRIES: [Entry<2>; 4] =
        super::entries([v027::OURS, v027::DEFAULT, v036::OURS, v036::DEFAULT]);

    #[path = "."]
    mod v027 {
        use super::Create;
        use rapier2d as rapier;
        use unisize::rapier2d_027 as ours;

        mod contestant;
        mod create_027;
        #[path = "../../../../common/engine_027.rs"]
        mod engine;
        #[path = "../../../../common/frames.rs"]
        mod frames;

        pub(super) use create_027::{DEFAULT, OURS};
    }

    #[path = "."]
    mod v036 {
        use super::Create;
        use rapier2d_036 as rapier;
        use unisize::rapier2d_036 as ours;

        mod contestant;
        mod create_036;
        mod deferred;
        #[path = "../../../../common/engine_036.rs"]
        mod engine;
        #[path = "../../../../common/frames.rs"]
        mod frames;

        pub(super) use create_036::{DEFAULT, OURS};
    }
}

#[path = "updates/engine"]
mod dim3 {
    use super::{Create, Entry};

    /// For each version the one of this repository first, then the one that it replaces.
    pub(super) const ENTRIES: [Entry<3>; 4] =
        super::entries([v027::OURS, v027::DEFAULT, v036::OURS, v036::DEFAULT]);

    #[path = "."]
    mod v027 {
        use super::Create;
        use rapier3d as rapier;
        use unisize::rapier3d_027 as ours;

        mod contestant;
        mod create_027;
        #[path = "../../../../common/engine_027.rs"]
        mod engine;
        #[path = "../../../../common/frames.rs"]
        mod frames;

        pub(super) use create_027::{DEFAULT, OURS};
    }

    #[path = "."]
    mod v036 {
        use super::Create;
        use rapier3d_036 as rapier;
        use unisize::rapier3d_036 as ours;

        mod contestant;
        mod create_036;
        mod deferred;
        #[path = "../../../../common/engine_036.rs"]
        mod engine;
        #[path = "../../../../common/frames.rs"]
        mod frames;

        pub(super) use create_036::{DEFAULT, OURS};
    }
}

/// A broad phase with a world of its own, of whichever version of Rapier.
trait Peer<const D: usize> {
    /// Moves the colliders on by one frame, and returns how long the broad phase takes to learn of it.
    fn advance(&mut self) -> Duration;

    /// How much of the next update is only there because this thread has no other to do it beside the solver. Once before each.
    fn deferred(&mut self) -> Duration;

    /// The pairs that it holds, by the events that it has sent.
    fn held_pairs(&self) -> PairSet;

    /// The boxes themselves, without any margin.
    fn boxes(&self) -> Vec<unisize::Aabb<f32, D>>;
}

/// Creates a broad phase that knows the colliders of a case.
type Create<const D: usize> = fn(&Case) -> Box<dyn Peer<D>>;

/// A broad phase: its name, that of the one of unisize's that it is compared with, and how it is created.
#[derive(Clone, Copy)]
struct Entry<const D: usize> {
    name: &'static str,
    ours: &'static str,
    create: Create<D>,
}

/// Names for those of a dimension.
const fn entries<const D: usize>([a, b, c, d]: [Create<D>; 4]) -> [Entry<D>; 4] {
    const fn entry<const D: usize>(names: [&'static str; 2], create: Create<D>) -> Entry<D> {
        let [name, ours] = names;
        Entry { name, ours, create }
    }
    [
        entry([OURS, OURS], a),
        entry([BVH_027, OURS], b),
        entry([OURS_HANDED_OVER, OURS_HANDED_OVER], c),
        entry([BVH_036, OURS_HANDED_OVER], d),
    ]
}

/// That of this repository, for Rapier 0.27.
const OURS: &str = "unisize for 0.27, lists";

/// That for Rapier 0.36.
const OURS_HANDED_OVER: &str = "unisize for 0.36, boxes handed over";

/// The one that Rapier 0.27 has itself.
const BVH_027: &str = "Rapier 0.27, BVH";

/// The one that Rapier 0.36 has itself.
const BVH_036: &str = "Rapier 0.36, BVH";

/// Added to the name of one whose updates do what its engine defers.
pub(crate) const WITHOUT_DEFERRED: &str = ", without the deferred optimization";

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

/// Frames before those that are measured: the first updates insert, and trees go on being mended for some more.
const FRAMES_TO_SETTLE: usize = 5;

/// Frames after which trees that were good have aged.
const FRAMES_TO_AGE: usize = 400;

/// A case, and how long it is measured.
struct Task {
    case: Case,
    title: String,
    frames_to_settle: usize,
    frames_a_round: usize,
}

/// Measures every broad phase in two and three dimensions.
pub(crate) fn measure(quick: bool, report: &mut Report) -> Result<Vec<Row>> {
    let mut rows = measure_in(&dim2::ENTRIES, &tasks([0.8, 0.2], quick), report)?;
    rows.extend(measure_in(
        &dim3::ENTRIES,
        &tasks([0.4, 0.1], quick),
        report,
    )?);
    Ok(rows)
}

fn measure_in<const D: usize>(
    entries: &[Entry<D>],
    tasks: &[Task],
    report: &mut Report,
) -> Result<Vec<Row>> {
    let bar = progress_bar(tasks.len() as u64);
    let mut rows = Vec::new();
    for task in tasks {
        let Case { density, count, .. } = task.case;
        let title = format!("{D}D, density {density}, {}, n = {count}", task.title);
        bar.set_message(title.clone());
        for row in contend(entries, task).context(title)? {
            bar.suspend(|| row.report(report))?;
            rows.push(row);
        }
        bar.inc(1);
    }
    Ok(rows)
}

fn tasks(densities: [f64; 2], quick: bool) -> Vec<Task> {
    let efforts = if quick { &QUICK_EFFORTS[..] } else { &EFFORTS };
    let mut tasks = Vec::new();
    for &density in &densities[..if quick { 1 } else { 2 }] {
        let mut add = |motion: Motion, sizes, aged, is_wanted: &dyn Fn(usize) -> bool| {
            for &(count, frames_a_round) in efforts.iter().filter(|effort| is_wanted(effort.0)) {
                let case = Case {
                    count,
                    density,
                    motion,
                    sizes,
                    bodies: true,
                    clock: Clock::for_count(count),
                };
                let words = match sizes {
                    Sizes::One if aged => format!(", after {FRAMES_TO_AGE} frames"),
                    Sizes::One => String::new(),
                    Sizes::OneToFour => ", sizes 1 to 4".to_owned(),
                    Sizes::FewLarge => ", one in 100 is 100 times as large".to_owned(),
                };
                tasks.push(Task {
                    case,
                    title: motion.name() + &words,
                    frames_to_settle: if aged {
                        FRAMES_TO_AGE
                    } else {
                        FRAMES_TO_SETTLE
                    },
                    frames_a_round,
                });
            }
        };
        let (one, all) = (Sizes::One, Motion::OneIn(1));
        add(all, one, false, &|_| true);
        add(all, one, true, &|count| count == LONG_COUNT && !quick);
        // Fewer than one in so many would be no other case than one in as many as there are.
        add(Motion::OneIn(10), one, false, &|count| count >= 10);
        add(Motion::OneIn(100), one, false, &|count| count >= 100);
        add(Motion::InMargin, one, false, &|_| true);
        add(Motion::Nothing, one, false, &|count| count == NOTHING_COUNT);
        add(all, Sizes::OneToFour, false, &|count| count >= MIXED_COUNT);
        add(all, Sizes::FewLarge, false, &|count| count >= MIXED_COUNT);
    }
    tasks
}

/// One broad phase in one case.
struct Contender<const D: usize> {
    entry: Entry<D>,
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
            if timed == Timed::Deferred {
                self.deferred.push(self.peer.deferred());
            }
            let time = self.peer.advance();
            if timed == Timed::Updates {
                self.times.push(time);
            }
        }
    }
}

fn contend<const D: usize>(entries: &[Entry<D>], task: &Task) -> Result<Vec<Row>> {
    let deferring: Vec<_> = entries
        .iter()
        .filter(|e| e.name == BVH_036)
        .copied()
        .collect();
    let mut contenders = follow(entries, task, Timed::Updates);
    let mut aside = follow(&deferring, task, Timed::Deferred);
    if task.case.count <= TWICE_MAX {
        let again = follow(entries, task, Timed::Updates);
        for (contender, again) in contenders.iter_mut().zip(again) {
            contender.times.repeated(again.times);
        }
        let again = follow(&deferring, task, Timed::Deferred);
        for (contender, again) in aside.iter_mut().zip(again) {
            contender.deferred.repeated(again.deferred);
        }
    }
    for aside in aside {
        let is_same = |contender: &&mut Contender<D>| contender.entry.name == aside.entry.name;
        let same = contenders.iter_mut().find(is_same);
        same.expect("both runs have it").deferred = aside.deferred;
    }

    let held: Vec<_> = contenders.iter().map(|c| c.peer.held_pairs()).collect();
    check(&contenders, &held)?;
    let row = |name: String, contender: &Contender<D>, times: Times, pairs: usize| {
        let is_ours = |ours: &&Contender<D>| ours.entry.name == contender.entry.ours;
        let ours = contenders.iter().find(is_ours);
        Row {
            subject: "updates",
            dim: D,
            density: task.case.density,
            motion: task.title.clone(),
            count: task.case.count,
            contender: name,
            setting: String::new(),
            pairs,
            ratio: ours.map_or(f64::NAN, |ours| times.mean() / ours.times.mean()),
            times,
        }
    };
    let mut rows = Vec::new();
    for (contender, held) in contenders.iter().zip(&held) {
        let (name, times) = (contender.entry.name, &contender.times);
        rows.push(row(name.to_owned(), contender, times.clone(), held.len()));
        if !contender.deferred.is_zero() {
            let rest = times.without(&contender.deferred);
            rows.push(row(
                format!("{name}{WITHOUT_DEFERRED}"),
                contender,
                rest,
                held.len(),
            ));
        }
    }
    Ok(rows)
}

/// All frames of a case.
fn follow<const D: usize>(entries: &[Entry<D>], task: &Task, timed: Timed) -> Vec<Contender<D>> {
    let enter = |entry: &Entry<D>| {
        let mut contender = Contender {
            entry: *entry,
            peer: (entry.create)(&task.case),
            times: Times::default(),
            deferred: Times::default(),
        };
        contender.run(task.frames_to_settle, timed);
        contender.times = Times::default();
        contender.deferred = Times::default();
        contender
    };
    let mut contenders: Vec<_> = entries.iter().map(enter).collect();
    for round in 0..ROUNDS {
        let run = |contender: &mut Contender<D>| contender.run(task.frames_a_round, timed);
        if round % 2 == 0 {
            contenders.iter_mut().for_each(run);
        } else {
            contenders.iter_mut().rev().for_each(run);
        }
    }
    contenders
}

/// Every broad phase must hold every pair of colliders that overlap, and may hold more: each has margins of its
/// own. Unisize has those of the one that it replaces, and must hold the same.
fn check<const D: usize>(contenders: &[Contender<D>], held: &[PairSet]) -> Result<()> {
    for (contender, held) in contenders.iter().zip(held) {
        let missing = PairSet::of_boxes(&contender.peer.boxes())?.missing_in(held);
        if missing > 0 {
            bail!(
                "{} does not hold {missing} pairs that overlap",
                contender.entry.name
            );
        }
    }
    // Each of unisize's is followed by the one that it replaces.
    for (pair, held) in contenders.windows(2).zip(held.windows(2)) {
        let [ours, default] = [pair[0].entry, pair[1].entry];
        if ours.name != ours.ours || default.ours != ours.name {
            continue;
        }
        if let Some(difference) = held[0].difference(&held[1]) {
            bail!(
                "{} and {} hold different pairs: {difference}",
                ours.name,
                default.name
            );
        }
    }
    Ok(())
}
