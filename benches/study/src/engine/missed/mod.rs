//! Methods on the same frames: a scene that Rapier's own broad phase drives, and none of them.
//!
//! At each step every method gets the world as it is, in a new random order, and has a narrow phase of its own. The figure of a
//! method is the mean over the steps: an update of unisize that searches takes longer than others, and must count.

use super::finder::{Created, create};
use super::scenes::rapier::prelude::*;
use super::scenes::{Observed, Scene};
use super::space::typical_size;
use super::{scenes, space};

mod contestant;
mod truth;

use crate::missed::{Course, FINDERS, Figures};
use contestant::{Contestant, Stage};
use oorandom::Rand32;
use truth::Truth;

/// One in this many steps, the first ones, is not timed: memory is allocated.
const WARM_UP: usize = 10;

/// Measures all methods on one course.
pub(crate) fn race(course: &Course) -> Vec<Figures> {
    let mut scene = Scene::build(course.kind, course.bodies, course.seed);
    let mut driver = Observed::new(DefaultBroadPhase::new())
        .with_lists()
        .sorted();
    for _ in 0..course.lead_in {
        scene.step(&mut driver, &(), &());
        driver.take_updates();
    }
    let typical_size = typical_size(&scene.world);
    let mut contestants =
        FINDERS.map(|finder| Contestant::new(create(finder, typical_size, course.seed)));
    let mut figures = vec![Figures::default(); contestants.len()];
    let mut turns: Vec<_> = (0..contestants.len()).collect();
    let mut random = Rand32::new(course.seed);
    let warm_up = course.steps / WARM_UP;
    for step in 1..=course.steps {
        scene.step(&mut driver, &(), &());
        let updates = driver.take_updates().into_iter();
        let moved: Vec<_> = match step {
            // No contestant knows any collider yet.
            1 => scene
                .world
                .colliders
                .iter()
                .map(|(handle, _)| handle)
                .collect(),
            _ => updates.flat_map(|update| update.modified).collect(),
        };
        let mut stage = Stage::of(&scene.world);
        for last in (1..turns.len()).rev() {
            turns.swap(last, random.rand_range(0..last as u32 + 1) as usize);
        }
        for &turn in &turns {
            let time = contestants[turn].step(&mut stage, &moved);
            if step > warm_up {
                let each_ms = 1e3 / (course.steps - warm_up) as f64;
                figures[turn].both += time.as_secs_f64() * each_ms;
            }
        }
        if step % course.truth_every == 0 {
            let truth = Truth::of(&scene.world, typical_size);
            for (figures, contestant) in figures.iter_mut().zip(&contestants) {
                let missed = contestant.missed(&truth.touching);
                figures.touching += truth.touching.len();
                figures.missed += missed;
                figures.near_missed += contestant.missed(&truth.near);
                figures.held += contestant.held();
                figures.frames += 1;
                figures.frames_with_misses += usize::from(missed > 0);
            }
        }
    }
    figures
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
        };
        for (finder, figures) in FINDERS.into_iter().zip(race(&course)) {
            let name = finder.name();
            let found = figures.touching - figures.missed;
            assert!(found > 0 && figures.held >= found, "{name}");
            assert!(figures.both > 0.0, "{name}");
            assert_eq!(figures.frames, 4);
            if finder.is_exact() {
                let misses = (
                    figures.missed,
                    figures.near_missed,
                    figures.frames_with_misses,
                );
                assert_eq!(misses, (0, 0, 0), "{name}");
            }
            // What is larger than the median is missed.
            if finder == Finder::Grid(Cell::Median) {
                assert!(figures.missed > 0 && figures.frames_with_misses > 0);
            }
        }
    }
}
