//! Fast balls shot at a thin wall in Rapier, with each kind of continuous collision detection, on Rapier's broad phase and on
//! unisize.

use crate::table::{Table, digits};
use rapier3d::prelude::*;
use unisize::rapier3d_027::UnisizeBroadPhase;
use unisize_scenes::dim3::World;

const BALLS: usize = 400;
const QUICK_BALLS: usize = 25;
const RADIUS: f32 = 0.1;

/// The wall is a tenth of a ball thick.
const WALL_HALF_THICKNESS: f32 = 0.01;

/// Metres per second: seventeen sizes per step.
const SPEED: f32 = 200.0;

/// After this many steps, a ball that nothing stops is far beyond the wall.
const STEPS: usize = 30;

/// The continuous collision detection of a ball.
#[derive(Clone, Copy)]
struct Kind {
    name: &'static str,
    is_bullet: bool,
    /// How far ahead soft CCD looks, in metres.
    prediction: f32,
}

const KINDS: [Kind; 3] = [
    Kind {
        name: "nothing",
        is_bullet: false,
        prediction: 0.0,
    },
    Kind {
        name: "soft CCD: swept boxes",
        is_bullet: false,
        prediction: 4.0,
    },
    Kind {
        name: "CCD: bullets",
        is_bullet: true,
        prediction: 0.0,
    },
];

/// The outcome.
struct Outcome {
    /// Balls beyond the wall.
    through: usize,
    /// The most contact pairs at the end of a step.
    most_pairs: usize,
    places: Vec<Vector<f32>>,
}

pub(super) fn table(quick: bool) -> Table {
    let balls = if quick { QUICK_BALLS } else { BALLS };
    let mut table = Table::new([
        "balls have",
        "through the wall: Rapier's broad phase",
        "unisize",
        "most contact pairs: Rapier's",
        "unisize ",
        "greatest distance between the two runs, m",
    ]);
    for kind in KINDS {
        let default = shoot(kind, balls, &mut DefaultBroadPhase::new());
        let ours = shoot(kind, balls, &mut UnisizeBroadPhase::new());
        let places = default.places.iter().zip(&ours.places);
        let distance = places.map(|(a, b)| (a - b).norm()).fold(0.0, f32::max);
        let of_balls = |outcome: &Outcome| format!("{} of {balls}", outcome.through);
        table.push([
            kind.name.to_owned(),
            of_balls(&default),
            of_balls(&ours),
            default.most_pairs.to_string(),
            ours.most_pairs.to_string(),
            digits(f64::from(distance)),
        ]);
    }
    table
}

fn shoot(kind: Kind, balls: usize, broad_phase: &mut dyn BroadPhase) -> Outcome {
    let mut world = World::new(Vector::zeros());
    let side = (balls as f32).sqrt().ceil() as usize;
    let half_width = side as f32 * 2.0 * RADIUS;
    let wall = ColliderBuilder::cuboid(WALL_HALF_THICKNESS, half_width, half_width);
    world.colliders.insert(wall);
    let handles: Vec<_> = (0..balls)
        .map(|i| {
            let [row, column] = [i / side, i % side].map(|k| k as f32 * 4.0 * RADIUS);
            let place = vector![
                // At several distances: at a single one, all might stop in the wall by chance.
                -5.0 - (i % 7) as f32 * 0.3,
                row - half_width + RADIUS,
                column - half_width + RADIUS
            ];
            let body = RigidBodyBuilder::dynamic()
                .translation(place)
                .linvel(vector![SPEED, 0.0, 0.0])
                .ccd_enabled(kind.is_bullet)
                .soft_ccd_prediction(kind.prediction);
            world.insert(body, ColliderBuilder::ball(RADIUS))
        })
        .collect();
    let mut most_pairs = 0;
    for _ in 0..STEPS {
        world.step(broad_phase, &(), &());
        most_pairs = most_pairs.max(world.narrow_phase.contact_pairs().count());
    }
    let place = |&handle: &RigidBodyHandle| *world.bodies[handle].translation();
    let places: Vec<_> = handles.iter().map(place).collect();
    Outcome {
        through: places.iter().filter(|place| place.x > 0.0).count(),
        most_pairs,
        places,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn continuous_detection_stops_what_would_fly_through() {
        let through = KINDS.map(|kind| shoot(kind, 25, &mut UnisizeBroadPhase::new()).through);
        assert_eq!(through, [25, 0, 0]);
    }
}
