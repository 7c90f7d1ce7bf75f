//! A pile of particles: balls are poured into a box, once on Rapier's own broad phase and once on unisize.
//!
//! ```text
//! cargo run --release --features rapier3d-027 --example particles3d -- 8000
//! ```
//!
//! The number of particles may be left out. Prints how long a step takes on either, while they fall and when they lie. Fails if one leaves
//! the box.

use std::time::{Duration, Instant};

use rapier3d::prelude::*;
use unisize::rapier3d_027::UnisizeBroadPhase;

const RADIUS: f32 = 0.2;
/// Half the width of the box.
const HALF: f32 = 4.0;
const STEPS: usize = 360;

struct Pile {
    pipeline: PhysicsPipeline,
    islands: IslandManager,
    broad_phase: Box<dyn BroadPhase>,
    narrow_phase: NarrowPhase,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    impulse_joints: ImpulseJointSet,
    multibody_joints: MultibodyJointSet,
    ccd_solver: CCDSolver,
}

impl Pile {
    fn new(particles: usize, broad_phase: Box<dyn BroadPhase>) -> Self {
        let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
        // A floor and four walls, which face inwards.
        colliders.insert(ColliderBuilder::halfspace(Vector::y_axis()));
        for (normal, axis) in [(1.0, 0), (-1.0, 0), (1.0, 2), (-1.0, 2)] {
            let mut inwards = Vector::zeros();
            inwards[axis] = normal;
            let wall = ColliderBuilder::halfspace(UnitVector::new_unchecked(inwards));
            colliders.insert(wall.translation(inwards * -HALF));
        }
        let mut random = oorandom::Rand32::new(1);
        let spacing = 2.2 * RADIUS;
        let side = ((2.0 * HALF - spacing) / spacing) as usize;
        for i in 0..particles {
            let cell = vector![
                (i % side) as f32 + 0.5,
                (i / (side * side)) as f32 + 1.0,
                (i / side % side) as f32 + 0.5
            ];
            let jitter = Vector::from_fn(|_, _| 0.1 * RADIUS * random.rand_float());
            let corner = vector![-HALF + RADIUS, 0.0, -HALF + RADIUS];
            let particle =
                RigidBodyBuilder::dynamic().translation(corner + cell * spacing + jitter);
            let body = bodies.insert(particle);
            colliders.insert_with_parent(ColliderBuilder::ball(RADIUS), body, &mut bodies);
        }
        Self {
            pipeline: PhysicsPipeline::new(),
            islands: IslandManager::new(),
            broad_phase,
            narrow_phase: NarrowPhase::new(),
            bodies,
            colliders,
            impulse_joints: ImpulseJointSet::new(),
            multibody_joints: MultibodyJointSet::new(),
            ccd_solver: CCDSolver::new(),
        }
    }

    fn step(&mut self) {
        self.pipeline.step(
            &vector![0.0, -9.81, 0.0],
            &IntegrationParameters::default(),
            &mut self.islands,
            &mut *self.broad_phase,
            &mut self.narrow_phase,
            &mut self.bodies,
            &mut self.colliders,
            &mut self.impulse_joints,
            &mut self.multibody_joints,
            &mut self.ccd_solver,
            &(),
            &(),
        );
    }

    fn contacts(&self) -> usize {
        let pairs = self.narrow_phase.contact_pairs();
        pairs.filter(|pair| pair.has_any_active_contact).count()
    }

    /// How many particles are outside of the box by more than a quarter of their size.
    fn lost(&self) -> usize {
        let lost = self.bodies.iter().filter(|(_, body)| {
            let place = body.translation();
            let most = HALF - RADIUS / 2.0;
            place.x.abs() > most || place.z.abs() > most || place.y < RADIUS / 2.0
        });
        lost.count()
    }
}

fn main() {
    let particles = std::env::args().nth(1);
    let particles = particles.map_or(4000, |count| count.parse().expect("a number of particles"));
    let mut worlds = [
        (
            "Rapier's own",
            Pile::new(particles, Box::new(DefaultBroadPhase::new())),
        ),
        (
            "unisize",
            Pile::new(particles, Box::new(UnisizeBroadPhase::new())),
        ),
    ];
    // While they fall, and when they lie.
    let mut times = [[Duration::ZERO; 2]; 2];
    for step in 0..STEPS {
        for ((_, world), times) in worlds.iter_mut().zip(&mut times) {
            let start = Instant::now();
            world.step();
            times[step / (STEPS / 2)] += start.elapsed();
        }
    }
    for ((name, world), times) in worlds.iter().zip(times) {
        let [falling, lying] = times.map(|time| time.as_secs_f64() * 2e3 / STEPS as f64);
        println!(
            "{name:>12}: {falling:.2} ms per step in the first three seconds, {lying:.2} in the next three; {} contacts",
            world.contacts(),
        );
        assert_eq!(world.lost(), 0, "particles have left the box");
    }
}
