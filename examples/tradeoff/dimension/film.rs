//! Whole simulations on one broad phase each, and how they differ.

use super::broad_phases;
use super::scenes::rapier::prelude::*;
use super::scenes::{Scene, World};
use crate::course::{Course, Run};
use crate::method::{Margin, Method, Search};
use crate::options::Options;
use unisize_scenes::SceneKind;

/// The time step of the reference is this part of the usual one.
const FINE: usize = 4;

/// A simulation has left another when their bodies are further apart than this part of a typical size.
const LEFT: f64 = 0.01;

const RAPIER: Method = Method {
    search: Search::Rapier,
    margin: Margin::Default,
};

/// Simulates a scene: the reference on Rapier's broad phase, two runs with sorted events, and one run on each method.
pub(super) fn courses(
    kind: SceneKind,
    options: &Options,
    typical_size: Real,
    on_step: &mut impl FnMut(),
) -> Vec<Course> {
    let bodies = options.course_bodies(kind);
    let mut film = |broad_phase: &mut dyn BroadPhase, parts: usize| {
        let scene = Scene::build(kind, bodies, options.seed);
        Film::shoot(scene, broad_phase, options.steps(), parts, &mut *on_step)
    };
    // The last bits of the solver's result depend on the order of events.
    let in_order = |method| broad_phases::create(method, typical_size).sorted();

    let reference = film(&mut in_order(RAPIER), FINE);
    let rapier = film(&mut in_order(RAPIER), 1);
    let course = |run, name: String, film: &Film| {
        film.course(run, name, &reference, &rapier, typical_size.into())
    };
    let automatic = film(&mut in_order(Method::AUTOMATIC), 1);
    let [fine_name, rapier_name] = [format!(", a step of 1/{FINE}"), String::new()]
        .map(|step| format!("{}{step}, events in order", RAPIER.name()));
    let automatic_name = format!("{}, events in order", Method::AUTOMATIC.name());
    let mut courses = vec![
        course(Run::Reference, fine_name, &reference),
        course(Run::RapierInOrder, rapier_name, &rapier),
        course(Run::AutomaticInOrder, automatic_name, &automatic),
    ];
    for method in Method::all(bodies) {
        let mut broad_phase = broad_phases::create(method, typical_size);
        let run = match method.search {
            Search::Rapier => Run::Rapier,
            Search::CommonBox => Run::CommonBox,
            _ => Run::Setting,
        };
        courses.push(course(run, method.name(), &film(&mut broad_phase, 1)));
    }
    courses
}

/// The places of all bodies at each step of a simulation, and its errors.
struct Film {
    /// The places of the bodies that are not fixed, for each step.
    frames: Vec<Vec<Vector<Real>>>,
    dt: f64,
    energy_change: f64,
    /// In length units.
    worst_penetration: f64,
    worst_stretch: Option<f64>,
}

impl Film {
    /// Simulates `steps` steps, each in this many parts.
    fn shoot(
        mut scene: Scene,
        broad_phase: &mut dyn BroadPhase,
        steps: usize,
        parts: usize,
        on_step: &mut impl FnMut(),
    ) -> Self {
        let initial = scene.sanity();
        let dt = scene.world.params.dt;
        let mut film = Self {
            frames: Vec::with_capacity(steps),
            dt: dt.into(),
            energy_change: 0.0,
            worst_penetration: 0.0,
            worst_stretch: None,
        };
        for _ in 0..steps {
            // The script needs the time of a whole step.
            scene.prepare();
            scene.world.params.dt = dt / parts as Real;
            for _ in 0..parts {
                scene.world.step(broad_phase, &(), &());
                let penetration = f64::from(penetration(&scene.world));
                film.worst_penetration = film.worst_penetration.max(penetration);
            }
            scene.world.params.dt = dt;
            let stretch = scene.sanity().max_rope_stretch;
            film.worst_stretch = [film.worst_stretch, stretch]
                .into_iter()
                .flatten()
                .reduce(f64::max);
            film.frames.push(places(&scene.world));
            on_step();
        }
        let end = scene.sanity();
        let supplied = end.supplied_energy - initial.supplied_energy;
        let expected = initial.energy() + supplied;
        film.energy_change = end.energy() / expected - 1.0;
        film
    }

    fn course(
        &self,
        run: Run,
        name: String,
        reference: &Self,
        rapier: &Self,
        typical_size: f64,
    ) -> Course {
        let distances = |other: &Self| {
            let frames = self.frames.iter().zip(&other.frames);
            let distance = frames.map(|(a, b)| root_mean_square(a, b) / typical_size);
            distance.collect::<Vec<_>>()
        };
        let leaves = |other: &Self| {
            let step = distances(other).iter().position(|&d| d > LEFT)?;
            Some((step + 1) as f64 * self.dt)
        };
        Course {
            name,
            run,
            energy_change: self.energy_change,
            worst_penetration: self.worst_penetration / typical_size,
            worst_stretch: self.worst_stretch,
            leaves_reference: leaves(reference),
            leaves_rapier: leaves(rapier),
            most_from_rapier: distances(rapier).into_iter().fold(0.0, f64::max),
            distance_from_rapier: distances(rapier).pop().unwrap_or(0.0),
        }
    }
}

/// The places of the bodies that are not fixed, in the order of their handles.
fn places(world: &World) -> Vec<Vector<Real>> {
    let bodies = world.bodies.iter().map(|(_, body)| body);
    let movable = bodies.filter(|body| !body.is_fixed());
    movable.map(|body| *body.translation()).collect()
}

/// How deep the deepest contact of the last step is.
fn penetration(world: &World) -> Real {
    let pairs = world.narrow_phase.contact_pairs();
    let points = pairs
        .filter(|pair| pair.has_any_active_contact)
        .flat_map(|pair| &pair.manifolds)
        .flat_map(|manifold| &manifold.points);
    points.fold(0.0, |deepest, point| deepest.max(-point.dist))
}

fn root_mean_square(a: &[Vector<Real>], b: &[Vector<Real>]) -> f64 {
    let pairs = a.iter().zip(b);
    let squares: f64 = pairs.map(|(a, b)| f64::from((a - b).norm_squared())).sum();
    (squares / a.len().max(1) as f64).sqrt()
}
