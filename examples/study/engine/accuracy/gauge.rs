//! What measures an error while a stage is simulated.
//!
//! A gauge looks at the world 30 times a simulated second, and has a sample of errors at each look: one of each body, joint or pair,
//! or a single one. What it reads in the end sums all of them up. It reads the world alone, so that it sees what a broad phase has
//! lost.

use super::scenes::World;
use super::scenes::rapier::{
    math::DIM,
    parry::{bounding_volume::BoundingVolume, query},
    prelude::*,
};
use super::space::{GRAVITY, Place, components, distance, gap, place_of};
use super::version::{impulse, joined};
use crate::accuracy::case::Reading;

/// What measures an error.
pub(super) struct Gauge {
    /// Looks at the world at a time.
    look: Look,
    /// What it looks at before this time does not count.
    from: f64,
    readings: Vec<(&'static str, Summary)>,
    tally: Tally,
}

/// The errors of a world at a time.
type Look = Box<dyn Fn(&World, f64) -> Vec<f64>>;

/// How all samples are summed up.
#[derive(Clone, Copy)]
enum Summary {
    /// The largest error of all.
    Largest,
    /// The mean of all errors of all looks.
    Mean,
    /// How far that mean is from one.
    MeanFromOne,
    /// The largest mean of a look.
    LargestMean,
    /// The mean of the last look.
    LastMean,
    /// The largest error of the last look.
    LastLargest,
}

#[derive(Clone, Copy, Default)]
struct Tally {
    count: usize,
    sum: f64,
    largest: f64,
    largest_mean: f64,
    last_mean: f64,
    last_largest: f64,
}

impl Gauge {
    fn new<const N: usize>(
        readings: [(&'static str, Summary); N],
        look: impl Fn(&World, f64) -> Vec<f64> + 'static,
    ) -> Self {
        Self {
            look: Box::new(look),
            from: 0.0,
            readings: readings.into(),
            tally: Tally::default(),
        }
    }

    /// The same from this time on.
    pub(super) fn from(self, from: f64) -> Self {
        Self { from, ..self }
    }

    /// Looks at the world after this many simulated seconds.
    pub(super) fn look(&mut self, world: &World, time: f64) {
        if time > self.from {
            self.tally.add((self.look)(world, time));
        }
    }

    /// The errors by all that was looked at.
    pub(super) fn read(&self) -> impl Iterator<Item = Reading> + '_ {
        let readings = self.readings.iter();
        readings.map(|&(name, summary)| Reading {
            name,
            value: self.tally.read(summary),
        })
    }
}

impl Tally {
    /// Counts a sample. An error that is not a number is infinitely large.
    fn add(&mut self, sample: Vec<f64>) {
        let known = |error: &f64| {
            if error.is_nan() {
                f64::INFINITY
            } else {
                *error
            }
        };
        let sum: f64 = sample.iter().map(known).sum();
        self.count += sample.len();
        self.sum += sum;
        self.last_mean = sum / sample.len().max(1) as f64;
        self.last_largest = sample.iter().map(known).fold(0.0, f64::max);
        self.largest = self.largest.max(self.last_largest);
        self.largest_mean = self.largest_mean.max(self.last_mean);
    }

    fn read(&self, summary: Summary) -> f64 {
        let mean = self.sum / self.count.max(1) as f64;
        match summary {
            Summary::Largest => self.largest,
            Summary::Mean => mean,
            Summary::MeanFromOne => (mean - 1.0).abs(),
            Summary::LargestMean => self.largest_mean,
            Summary::LastMean => self.last_mean,
            Summary::LastLargest => self.last_largest,
        }
    }
}

fn dynamic(world: &World) -> impl Iterator<Item = (RigidBodyHandle, &RigidBody)> {
    world.bodies.iter().filter(|(_, body)| body.is_dynamic())
}

/// A body, and where it should be along the first axis at each time.
pub(super) struct Followed {
    pub(super) body: RigidBodyHandle,
    pub(super) course: Box<dyn Fn(f64) -> f64>,
}

/// How far bodies are from a course of this length that is known.
pub(super) fn course(followed: Vec<Followed>, length: f64) -> Gauge {
    let readings = [(
        "distance from the known course, of its length",
        Summary::LargestMean,
    )];
    Gauge::new(readings, move |world, time| {
        let error = |followed: &Followed| {
            let place = place_of(&world.bodies[followed.body])[0];
            (place - (followed.course)(time)).abs() / length
        };
        followed.iter().map(error).collect()
    })
}

/// How far dynamic bodies of this size are at the end from where they are now.
pub(super) fn displacement(world: &World, size: f64) -> Gauge {
    let places: Vec<_> = dynamic(world)
        .map(|(handle, body)| (handle, place_of(body)))
        .collect();
    let readings = [
        ("mean distance from its place, sizes", Summary::LastMean),
        (
            "largest distance from its place, sizes",
            Summary::LastLargest,
        ),
    ];
    Gauge::new(readings, move |world, _| {
        let way = |&(handle, place): &(RigidBodyHandle, Place)| {
            distance(place_of(&world.bodies[handle]), place) / size
        };
        places.iter().map(way).collect()
    })
}

/// Energy that comes out of nothing, relative to all at the start, above height zero if there is gravity.
pub(super) fn energy_gained(world: &World) -> Gauge {
    let start = energy(world);
    let readings = [("energy gained, of what was put in", Summary::Largest)];
    Gauge::new(readings, move |world, _| {
        vec![(energy(world) - start) / start]
    })
}

/// Energy that comes out of nothing or goes, where none should.
pub(super) fn energy_changed(world: &World, put_in: f64) -> Gauge {
    let start = energy(world);
    let readings = [("change of energy, of what was put in", Summary::Largest)];
    Gauge::new(readings, move |world, _| {
        vec![(energy(world) - start).abs() / put_in]
    })
}

/// The energy of everything that is dynamic: that of motion, and the potential one in the world's gravity.
fn energy(world: &World) -> f64 {
    let energies = dynamic(world).map(|(_, body)| {
        let center = body.center_of_mass();
        let along = |axis: usize| f64::from(world.gravity[axis]) * f64::from(center[axis]);
        let potential = f64::from(body.mass()) * (0..DIM).map(along).sum::<f64>();
        f64::from(body.kinetic_energy()) - potential
    });
    energies.sum()
}

/// The share of the bodies that are at the end where nothing should be.
pub(super) fn outside(name: &'static str, is_outside: impl Fn(Place) -> bool + 'static) -> Gauge {
    Gauge::new([(name, Summary::LastMean)], move |world, _| {
        let places = dynamic(world).map(|(_, body)| place_of(body));
        let is_lost = |place: &Place| place.iter().any(|x| !x.is_finite());
        places
            .map(|place| f64::from(u8::from(is_lost(&place) || is_outside(place))))
            .collect()
    })
}

/// How far bodies of this size are in each other, by Parry's exact queries of all shapes whose boxes overlap: what a broad phase
/// loses is seen all the same.
///
/// The mean is over the pairs that overlap, at all looks, and not over all pairs or bodies. So it does not grow with the number of
/// overlaps, and can fall if more pairs overlap a little.
pub(super) fn penetration(size: f64) -> Gauge {
    let readings = [
        ("largest penetration, sizes", Summary::Largest),
        ("mean penetration, sizes", Summary::Mean),
    ];
    Gauge::new(readings, move |world, _| {
        depths(world)
            .into_iter()
            .map(|depth| depth / size)
            .collect()
    })
}

/// The depths of all pairs that overlap and may not. Each box is compared with each.
fn depths(world: &World) -> Vec<f64> {
    let colliders: Vec<_> = world
        .colliders
        .iter_enabled()
        .map(|(_, collider)| (collider.compute_aabb(), collider))
        .collect();
    let mut depths = Vec::new();
    for (index, (aabb, a)) in colliders.iter().enumerate() {
        for (other, b) in &colliders[..index] {
            if !aabb.intersects(other) || !may_touch(world, a, b) {
                continue;
            }
            let contact = query::contact(a.position(), a.shape(), b.position(), b.shape(), 0.0);
            let contact = contact.expect("the shapes of the stages are supported");
            depths.extend(contact.map(|contact| f64::from(-contact.dist).max(0.0)));
        }
    }
    depths
}

/// Whether two colliders should push each other apart: some joints say that they should not.
fn may_touch(world: &World, a: &Collider, b: &Collider) -> bool {
    let are_joined = a.parent().zip(b.parent()).is_some_and(|(a, b)| {
        let mut joints = world.impulse_joints.joints_between(a, b);
        joints.any(|(_, joint)| !joint.data.contacts_enabled)
    });
    !are_joined && world.may_touch(a, b)
}

/// The speed of what should rest.
pub(super) fn rest() -> Gauge {
    let readings = [("mean speed at rest, units a second", Summary::Mean)];
    Gauge::new(readings, |world, _| {
        let velocities = dynamic(world).map(|(_, body)| components(body.linvel()));
        velocities
            .map(|velocity| distance(velocity, [0.0; DIM]))
            .collect()
    })
}

/// How far apart the two ends are that a joint holds together, in links of this length.
pub(super) fn stretch(link: f64) -> Gauge {
    let readings = [
        ("mean stretch, links", Summary::Mean),
        ("largest stretch, links", Summary::Largest),
    ];
    Gauge::new(readings, move |world, _| {
        let joints = world.impulse_joints.iter();
        joints
            .map(|(_, joint)| gap(&world.bodies, joined(joint), &joint.data) / link)
            .collect()
    })
}

/// The force on a floor, which should be the weight of all dynamic bodies.
pub(super) fn weight(floor: ColliderHandle) -> Gauge {
    let readings = [(
        "weight on the floor that is missing or too much",
        Summary::MeanFromOne,
    )];
    Gauge::new(readings, move |world, _| {
        let pairs = world.narrow_phase.contact_pairs_with(floor);
        let impulses: f64 = pairs.map(|pair| f64::from(impulse(pair))).sum();
        let masses = dynamic(world).map(|(_, body)| f64::from(body.mass()));
        let weight = masses.sum::<f64>() * GRAVITY;
        vec![impulses / f64::from(world.params.dt) / weight]
    })
}

#[cfg(test)]
mod tests {
    use super::{Summary, Tally};

    #[test]
    fn samples_are_summed_up() {
        let mut tally = Tally::default();
        tally.add(vec![1.0, 5.0]);
        tally.add(vec![2.0]);
        tally.add(vec![]);
        tally.add(vec![0.0, 1.0]);
        for (summary, expected) in [
            (Summary::Largest, 5.0),
            (Summary::Mean, 1.8),
            (Summary::MeanFromOne, 0.8),
            (Summary::LargestMean, 3.0),
            (Summary::LastMean, 0.5),
            (Summary::LastLargest, 1.0),
        ] {
            assert!((tally.read(summary) - expected).abs() < 1e-12);
        }
        tally.add(vec![f64::NAN]);
        assert_eq!(tally.read(Summary::Largest), f64::INFINITY);
    }
}
