//! What is known of a scene comes out with a small time step, and a seed gives the same start.

use super::scenes::rapier::prelude::*;
use super::space::{UP, along, distance, place_of, vector};
use super::{Stage, run, state};
use crate::accuracy::case::{Case, Run};
use crate::accuracy::scene::Scene;
use crate::finder::{Finder, Setting};
use clap::ValueEnum;

fn case(scene: Scene, frequency: u32) -> Case {
    Case {
        scene,
        finder: Finder::Unisize(Setting::DEFAULT),
        is_sorted: false,
        frequency,
        seed: 1,
        bodies: 20,
        seconds: 1.0,
    }
}

/// The error of this name.
fn error(run: &Run, name: &str) -> f64 {
    let mut errors = run.errors.iter();
    let error = errors.find(|error| error.name.starts_with(name));
    error.expect("there is such an error").value
}

#[test]
fn pendulums_swing_by_the_cosine_and_keep_their_energy() {
    let far = run(&case(Scene::Pendulum, 60));
    let near = run(&case(Scene::Pendulum, 240));
    let swing = error(&near, "distance");
    assert!(swing < 0.02, "{swing}");
    let energies = [&far, &near].map(|run| error(run, "change of energy"));
    assert!(energies[1] < 0.003, "{energies:?}");
    // A quarter of the time step leaves a quarter of the error, or less.
    assert!(energies[1] < 0.35 * energies[0], "{energies:?}");
}

#[test]
fn a_floor_bears_the_weight() {
    for frequency in [60, 240] {
        let case = Case {
            seconds: 3.0,
            // They come to rest soon.
            bodies: 8,
            ..case(Scene::Silo, frequency)
        };
        let weight = error(&run(&case), "weight");
        assert!(weight < 0.01, "{weight}");
    }
}

#[test]
fn towers_stand() {
    let run = run(&case(Scene::Stack, 240));
    let way = error(&run, "largest distance");
    assert!(way < 0.1, "{way}");
}

#[test]
fn continuous_detection_stops_bullets() {
    let missed = [Scene::Bullets, Scene::BulletsSoftCcd, Scene::BulletsCcd].map(|scene| {
        let case = case(scene, 60);
        error(&run(&case), "impacts")
    });
    // Rapier 0.36 stops what hits a fixed wall in any case.
    assert_eq!(missed[0] > 0.3, crate::RAPIER == "0.27", "{missed:?}");
    assert_eq!(missed[1..], [0.0; 2]);
}

#[test]
fn sorted_both_are_the_same_bit_for_bit() {
    for scene in [Scene::Stack, Scene::Pile] {
        let [own, ours] = [Finder::Rapier, Finder::Unisize(Setting::DEFAULT)].map(|finder| {
            let case = Case {
                finder,
                is_sorted: true,
                ..case(scene, 60)
            };
            let run = run(&case);
            (run.state, run.errors)
        });
        assert_eq!(own, ours);
    }
}

#[test]
fn the_state_differs_with_the_smallest_bit() {
    let mut world = Stage::build(&case(Scene::Pile, 60)).world;
    let mut states = vec![state(&world)];
    assert_eq!(state(&world), states[0]);
    let handles = world.bodies.iter().map(|(handle, _)| handle);
    let last = handles.last().expect("a pile has bodies");
    let body = &mut world.bodies[last];
    let mut place = place_of(body);
    place[0] += place[0].abs() * 2.0 * f64::from(Real::EPSILON);
    body.set_translation(vector(place), false);
    states.push(state(&world));
    let slow = along(UP, 1e-30);
    world.bodies[last].set_linvel(vector(slow), false);
    states.push(state(&world));
    states.sort_unstable();
    states.dedup();
    assert_eq!(states.len(), 3);
}

#[test]
fn every_scene_has_errors_that_are_numbers() {
    for &scene in Scene::value_variants() {
        for &finder in crate::FINDERS {
            let case = Case {
                finder,
                seconds: 0.3,
                ..case(scene, 60)
            };
            let run = run(&case);
            assert!(run.milliseconds > 0.0);
            assert!(
                run.errors.iter().all(|error| error.value.is_finite()),
                "{run:?}"
            );
            assert_eq!(run.pairs.is_some(), finder == Finder::Lossy);
        }
    }
}

#[test]
fn a_seed_gives_the_same_start_and_another_a_little_different_one() {
    for &scene in Scene::value_variants() {
        let start = |seed: u64| {
            let stage = Stage::build(&Case {
                seed,
                ..case(scene, 60)
            });
            let bodies = stage.world.bodies.iter().map(|(_, body)| body);
            bodies.map(place_of).collect::<Vec<_>>()
        };
        assert_eq!(start(3), start(3));
        let [one, other] = [start(3), start(4)];
        assert_eq!(one.len(), other.len());
        let ways = one.iter().zip(&other).map(|(a, b)| distance(*a, *b));
        let farthest = ways.fold(0.0, f64::max);
        assert!(
            farthest > 0.0 && farthest < 0.6,
            "{} {farthest}",
            scene.name()
        );
    }
}
