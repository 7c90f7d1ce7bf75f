//! Simulates a scene in one flavour of Rapier, and measures its errors. They are read from the world alone, so that they show the pairs
//! that a broad phase has lost.

use super::finder::create;
use super::ours::{Settings, UnisizeBroadPhase};
use super::scenes::rapier::{parry::query, prelude::*};
use super::scenes::{Observed, OwnBroadPhase, Sanity, Scene, Steppable, World, install};
use super::space::{Place, distance, motion, near_pairs, place_of, typical_size};
use crate::accuracy::ensembles::{
    Case, DEEPEST, ENERGY, FRAMES, LOST, MEAN_DEPTH, Run, STRAYED, STRETCH,
};
use cpu_time::ThreadTime;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::time::Duration;
use unisize_scenes::SceneKind;

/// Simulates a case.
pub(crate) fn run(case: &Case) -> Run {
    let scene = Scene::build(case.kind, case.bodies, case.seed);
    // Other pairs are lost with each time step: otherwise a seed that loses none would lose none with any.
    let seed = case.seed << 32 | u64::from(case.frequency);
    let mut broad_phase = create(case.finder, typical_size(&scene.world), seed);
    simulate(case, scene, &mut *broad_phase)
}

/// Whether the runs on Rapier's own broad phase and on unisize are equal to the last bit, with the events of each update in order: all
/// errors, and all bodies at the end.
pub(crate) fn is_same_in_order(case: &Case) -> bool {
    let scene = || Scene::build(case.kind, case.bodies, case.seed);
    let settings = Settings::default().with_filter(crate::FILTER_OF_DEFAULT);
    let ours = Observed::new(UnisizeBroadPhase::with_settings(settings));
    let own = Observed::new(OwnBroadPhase::new());
    let own = simulate(case, scene(), &mut install(own.sorted()));
    let ours = simulate(case, scene(), &mut install(ours.sorted()));
    (own.state, own.errors) == (ours.state, ours.errors)
}

/// Steps a scene to its end, and measures at the same simulated times whatever the time step.
fn simulate(case: &Case, mut scene: Scene, broad_phase: &mut dyn Steppable) -> Run {
    scene.world.params.dt = 1.0 / case.frequency as Real;
    let mut gauge = Gauge::new(&scene);
    let frames = (case.seconds * f64::from(FRAMES)).round() as u32;
    let mut elapsed = Duration::ZERO;
    for _ in 0..frames {
        let start = ThreadTime::now();
        for _ in 0..case.frequency / FRAMES {
            scene.step(broad_phase.for_step(), &(), &());
        }
        elapsed += start.elapsed();
        gauge.look(&scene);
    }
    Run {
        milliseconds: elapsed.as_secs_f64() * 1e3 / case.seconds,
        errors: gauge.read(&scene),
        state: state(&scene.world),
    }
}

/// A hash of the motions of all bodies, and of which of them sleep: it differs if any bit does, unless both are NaN.
fn state(world: &World) -> u64 {
    let mut hasher = DefaultHasher::new();
    for (_, body) in world.bodies.iter() {
        (motion(body), body.is_sleeping()).hash(&mut hasher);
    }
    hasher.finish()
}

/// The largest errors, and a mean, of all frames so far.
struct Gauge {
    initial: Sanity,
    /// The median extent of the colliders that can move.
    size: f64,
    /// Where bodies were at the start.
    places: Vec<(RigidBodyHandle, Place)>,
    energy: f64,
    /// None without joints.
    stretch: Option<f64>,
    deepest: f64,
    depths: (f64, usize),
}

impl Gauge {
    fn new(scene: &Scene) -> Self {
        let bodies = scene.world.bodies.iter();
        let dynamic = bodies.filter(|(_, body)| body.is_dynamic());
        Self {
            initial: scene.sanity(),
            size: f64::from(typical_size(&scene.world)),
            places: dynamic
                .map(|(handle, body)| (handle, place_of(body)))
                .collect(),
            energy: 0.0,
            stretch: None,
            deepest: 0.0,
            depths: (0.0, 0),
        }
    }

    fn look(&mut self, scene: &Scene) {
        let sanity = scene.sanity();
        let start = self.initial.energy();
        self.energy = larger(self.energy, (sanity.energy() - start) / start);
        if let Some(stretch) = sanity.max_rope_stretch {
            self.stretch = Some(larger(self.stretch.unwrap_or(0.0), stretch));
        }
        for depth in depths(&scene.world) {
            self.deepest = larger(self.deepest, depth / self.size);
            self.depths.0 += depth / self.size;
            self.depths.1 += 1;
        }
    }

    /// The errors. A lost pair shows in the first ones.
    fn read(&self, scene: &Scene) -> Vec<(&'static str, f64)> {
        let sanity = scene.sanity();
        let lost = sanity.fallen_through + sanity.not_finite;
        let count = self.places.len().max(1) as f64;
        let mut errors = Vec::new();
        if scene.kind() == SceneKind::Columns {
            let way = |&(handle, place): &(RigidBodyHandle, Place)| {
                distance(place_of(&scene.world.bodies[handle]), place) / self.size
            };
            errors.push((STRAYED, self.places.iter().map(way).fold(0.0, larger)));
        }
        errors.extend(self.stretch.map(|stretch| (STRETCH, stretch)));
        errors.extend([
            (DEEPEST, self.deepest),
            (MEAN_DEPTH, self.depths.0 / self.depths.1.max(1) as f64),
            (LOST, lost as f64 / count),
            (ENERGY, self.energy),
        ]);
        // A sum may be no number although each of its parts is one.
        for (_, error) in &mut errors {
            *error = larger(0.0, *error);
        }
        errors
    }
}

/// The larger error. One that is not a number is infinitely large.
fn larger(a: f64, b: f64) -> f64 {
    if b.is_nan() { f64::INFINITY } else { a.max(b) }
}

/// The penetration depths of all colliders that should not overlap, by Parry's exact queries. Half-spaces do not count: a body that sinks
/// into one counts as lost.
fn depths(world: &World) -> Vec<f64> {
    let mut depths = Vec::new();
    for [(_, a), (_, b)] in near_pairs(world, 0.0) {
        let is_unbounded = |collider: &Collider| collider.shape().as_halfspace().is_some();
        if is_unbounded(a) || is_unbounded(b) || are_joined(world, a, b) {
            continue;
        }
        let contact = query::contact(a.position(), a.shape(), b.position(), b.shape(), 0.0);
        let contact = contact.expect("the shapes of the scenes are supported");
        depths.extend(contact.map(|contact| f64::from(-contact.dist).max(0.0)));
    }
    depths
}

/// Whether a joint of two colliders' bodies disables their contacts.
fn are_joined(world: &World, a: &Collider, b: &Collider) -> bool {
    a.parent().zip(b.parent()).is_some_and(|(a, b)| {
        let mut joints = world.impulse_joints.joints_between(a, b);
        joints.any(|(_, joint)| !joint.data.contacts_enabled)
    })
}

#[cfg(test)]
mod tests {
    use super::super::space::{along, vector};
    use super::*;
    use crate::accuracy::SCENES;
    use crate::finder::Finder;

    fn case(kind: SceneKind, finder: Finder) -> Case {
        Case {
            kind,
            finder,
            frequency: 60,
            seed: 1,
            bodies: 30,
            seconds: 0.5,
        }
    }

    #[test]
    fn sorted_both_are_the_same_bit_for_bit() {
        for kind in SCENES {
            assert!(is_same_in_order(&case(kind, Finder::DEFAULT)));
        }
    }

    #[test]
    fn the_state_differs_with_the_smallest_bit() {
        let mut world = Scene::build(SceneKind::FallingBalls, 30, 1).world;
        let resting = state(&world);
        assert_eq!(state(&world), resting);
        let last = world.bodies.iter().last().expect("there are bodies").0;
        let mut place = place_of(&world.bodies[last]);
        place[0] += place[0].abs() * 2.0 * f64::from(Real::EPSILON);
        world.bodies[last].set_translation(vector(place), false);
        let moved = state(&world);
        world.bodies[last].set_linvel(vector(along(0, 1e-30)), false);
        let pushed = state(&world);
        assert!(resting != moved && moved != pushed && pushed != resting);
    }

    #[test]
    fn errors_are_numbers_and_a_seed_gives_its_own() {
        for kind in SCENES {
            for &finder in crate::finder::FINDERS {
                let run = run(&case(kind, finder));
                assert!(run.milliseconds > 0.0);
                assert!(run.errors.iter().all(|(_, error)| error.is_finite()));
            }
            let of_seed = |seed| {
                let case = Case {
                    seed,
                    ..case(kind, Finder::DEFAULT)
                };
                run(&case).state
            };
            assert_eq!(of_seed(2), of_seed(2));
            assert_ne!(of_seed(2), of_seed(3));
        }
    }

    #[test]
    fn a_broad_phase_that_reports_nothing_shows_in_the_errors() {
        for kind in SCENES {
            let case = Case {
                seconds: 1.5,
                ..case(kind, Finder::DEFAULT)
            };
            let scene = Scene::build(kind, case.bodies, case.seed);
            let blind = Observed::new(UnisizeBroadPhase::new()).silent();
            let wrong = simulate(&case, scene, &mut install(blind)).errors;
            let right = run(&case).errors;
            let shows = |((_, wrong), (_, right)): (&(_, f64), &(_, f64))| {
                *wrong > 0.1 && *wrong > 2.0 * right
            };
            assert!(wrong.iter().zip(&right).any(shows), "{wrong:?} {right:?}");
        }
    }

    #[test]
    fn what_is_not_a_number_is_infinitely_wrong() {
        assert_eq!(larger(1.0, f64::NAN), f64::INFINITY);
        assert_eq!([larger(1.0, 2.0), larger(2.0, 1.0)], [2.0; 2]);
    }
}
