//! Methods on the same frames: a scene that Rapier's own broad phase drives, and none of them.
//!
//! At each step every method gets the world as it is, in a new random order, and has a narrow phase of its own. The figure of a
//! method is the mean over the steps: an update of unisize that searches takes longer than others, and must count.

use super::seldom::Seldom;
use super::space::typical_size;
use super::{ours, scenes, version};

mod contestant;
mod truth;

use crate::finder::{Finder, LOST_ONE_IN};
use crate::missed::{Course, Figures};
use contestant::{Contestant, Lap, Stage};
use oorandom::Rand32;
use ours::{Settings, UnisizeBroadPhase};
use scenes::rapier::prelude::*;
use scenes::{Observed, Scene, lossy};
use truth::Truth;
use version::BroadPhase;

/// One in this many steps, the first ones, is not timed: memory is allocated.
const WARM_UP: usize = 10;

/// Measures all methods on one course.
pub(crate) fn race(course: &Course<'_>, mut on_step: impl FnMut()) -> Vec<Figures> {
    let mut scene = Scene::build(course.kind, course.bodies, course.seed);
    let mut driver = Observed::new(DefaultBroadPhase::new())
        .with_lists()
        .sorted();
    for _ in 0..course.lead_in {
        scene.step(&mut driver, &(), &());
        driver.take_updates();
    }
    let typical_size = typical_size(&scene.world);
    let mut contestants: Vec<_> = (course.finders.iter())
        .map(|&finder| Contestant::new(create(finder, typical_size, course.seed)))
        .collect();
    let mut figures = vec![Figures::default(); contestants.len()];
    let mut turns: Vec<_> = (0..contestants.len()).collect();
    let mut laps = vec![Lap::default(); contestants.len()];
    let mut random = Rand32::new(course.seed);
    let mut timed = 0;
    for step in 1..=course.steps {
        scene.step(&mut driver, &(), &());
        let updates = driver.take_updates().into_iter();
        let moved: Vec<_> = match step {
            // Nobody has heard of anything yet.
            1 => {
                let colliders = scene.world.colliders.iter();
                colliders.map(|(handle, _)| handle).collect()
            }
            _ => updates.flat_map(|update| update.modified).collect(),
        };
        let mut stage = Stage::of(&scene.world);
        for last in (1..turns.len()).rev() {
            turns.swap(last, random.rand_range(0..last as u32 + 1) as usize);
        }
        for &turn in &turns {
            laps[turn] = contestants[turn].step(&mut stage, &moved);
        }
        let is_timed = step > course.steps / WARM_UP;
        timed += u32::from(is_timed);
        for (figures, lap) in figures.iter_mut().zip(&laps).filter(|_| is_timed) {
            figures.broad += lap.broad.as_secs_f64() * 1e3;
            figures.both += lap.both.as_secs_f64() * 1e3;
        }
        if step % course.truth_every == 0 {
            let truth = Truth::of(&scene.world, typical_size);
            for (figures, contestant) in figures.iter_mut().zip(&contestants) {
                let touching = contestant.recall(&truth.touching);
                figures.touching.add(touching);
                figures.near.add(contestant.recall(&truth.near));
                figures.held += contestant.held();
                figures.frames += 1;
                figures.frames_with_misses += usize::from(touching.missed() > 0);
            }
        }
        on_step();
    }
    for figures in &mut figures {
        figures.broad /= f64::from(timed);
        figures.both /= f64::from(timed);
    }
    figures
}

/// An empty broad phase.
fn create(finder: Finder, typical_size: Real, seed: u64) -> Box<dyn BroadPhase> {
    match finder {
        Finder::Rapier => Box::new(DefaultBroadPhase::new()),
        Finder::Unisize(kernel, margin) => {
            let settings = Settings::default().with_kernel(kernel);
            Box::new(UnisizeBroadPhase::with_settings(match margin {
                None => settings,
                Some(sizes) => settings.with_margin(sizes * typical_size),
            }))
        }
        Finder::Seldom(interval) => Box::new(Seldom::new(UnisizeBroadPhase::new(), interval)),
        Finder::Grid(cell) => {
            Box::new(version::hash_grid(cell).expect("this version steps on grids"))
        }
        Finder::Lossy => Box::new(lossy(DefaultBroadPhase::new(), LOST_ONE_IN, seed).0),
    }
}

#[cfg(test)]
mod tests {
    use super::race;
    use crate::finder::{Cell, Finder};
    use crate::missed::{Course, FINDERS};
    use unisize_scenes::SceneKind;

    #[test]
    fn only_what_can_miss_misses() {
        let course = Course {
            kind: SceneKind::MixedEight,
            bodies: 150,
            seed: 1,
            lead_in: 60,
            steps: 12,
            truth_every: 3,
            finders: &FINDERS,
        };
        for (finder, figures) in FINDERS.into_iter().zip(race(&course, || ())) {
            let name = finder.name();
            assert!(figures.touching.all > 0 && figures.held >= figures.touching.found);
            assert!(
                figures.broad > 0.0 && figures.both > figures.broad,
                "{name}"
            );
            assert_eq!(figures.frames, 4);
            if finder.is_exact() {
                assert_eq!(figures.touching.missed(), 0, "{name}");
                assert_eq!(figures.near.missed(), 0, "{name}");
                assert_eq!(figures.frames_with_misses, 0, "{name}");
            }
            // What is larger than the median is missed.
            if finder == Finder::Grid(Cell::Median) {
                assert!(figures.touching.missed() > 0 && figures.frames_with_misses > 0);
            }
        }
    }
}
