//! Churn: falling balls of which a share is replaced at every step, so that the indices of colliders are
//! used again at once; a few are disabled for a while or change their collision group.

use super::gas::GHOSTS;
use super::grains::{SPACING, grain};
use super::*;

/// One of this many bodies is replaced at every step.
const REPLACED: usize = 50;
/// The speed at which balls are dropped in.
const SPEED: Real = 20.0;
/// The number of steps after which a ball may be dropped in at the same place.
const CYCLE: usize = 4;
/// The number of steps between two changes of what is disabled, or in the other group.
const INTERVAL: usize = 7;
/// One of this many bodies is disabled, and one is in the other group.
const CHANGED: usize = 200;
/// The speed at which Rapier pushes balls apart that were put into each other.
const PUSHED_APART: Real = 10.0;

/// Replaces some bodies at every step, and changes others.
#[derive(Clone)]
struct Replacement {
    balls: Vec<RigidBodyHandle>,
    disabled: Vec<RigidBodyHandle>,
    ghosts: Vec<RigidBodyHandle>,
    drop_height: Real,
    drop_cells: Lattice,
    next_cell: usize,
}

impl Script for Replacement {
    fn copy(&self) -> Box<dyn Script> {
        Box::new(self.clone())
    }

    fn prepare(&mut self, world: &mut World, cue: &mut Cue) {
        if self.balls.is_empty() {
            return;
        }
        let count = self.balls.len().div_ceil(REPLACED);
        let removed: Vec<_> = (0..count)
            .map(|_| self.remove_any(world, &mut cue.random))
            .collect();
        for (index, (center, shape)) in removed.into_iter().enumerate() {
            // Half of the new ones take the place of an old one, the others are dropped in.
            let ball = match index % 2 {
                0 => ball(center, 0.0),
                _ => self.drop_in(&mut cue.random),
            };
            let collider = ColliderBuilder::new(shape);
            self.balls.push(cue.insert(world, ball, collider));
        }
        if cue.step % INTERVAL == 0 {
            self.change_disabled(world, cue);
        }
        if cue.step % INTERVAL == INTERVAL / 2 {
            self.change_groups(world, cue);
        }
    }
}

impl Replacement {
    /// Removes a random ball, and returns its place and shape.
    fn remove_any(&mut self, world: &mut World, random: &mut Random) -> (Vector, SharedShape) {
        let handle = self.balls.swap_remove(random.index(self.balls.len()));
        let body = &world.bodies[handle];
        let shape = world.colliders[body.colliders()[0]].shared_shape().clone();
        let place = own(body.translation());
        world.remove(handle);
        (place, shape)
    }

    fn drop_in(&mut self, random: &mut Random) -> RigidBodyBuilder {
        let cell = self.drop_cells.center(self.next_cell);
        self.next_cell = (self.next_cell + 1) % self.drop_cells.per_layer();
        let center = cell + along(UP, self.drop_height) + jitter(random, 0.05);
        ball(center, -SPEED)
    }

    fn change_disabled(&mut self, world: &mut World, cue: &mut Cue) {
        for handle in self.disabled.drain(..) {
            if let Some(body) = world.bodies.get_mut(handle) {
                body.set_enabled(true);
                allow_overlap(cue, body.mass());
            }
        }
        self.disabled = self.draw(&mut cue.random);
        for &handle in &self.disabled {
            world.bodies[handle].set_enabled(false);
        }
    }

    fn change_groups(&mut self, world: &mut World, cue: &mut Cue) {
        for handle in self.ghosts.drain(..) {
            regroup(world, cue, handle, InteractionGroups::default());
        }
        self.ghosts = self.draw(&mut cue.random);
        for &handle in &self.ghosts {
            regroup(world, cue, handle, GHOSTS);
        }
    }

    /// Those that are changed this time, some perhaps twice.
    fn draw(&self, random: &mut Random) -> Vec<RigidBodyHandle> {
        let draws = 0..self.balls.len().div_ceil(CHANGED);
        draws
            .map(|_| self.balls[random.index(self.balls.len())])
            .collect()
    }
}

/// Moves the colliders of a ball to a group, if it is still there.
fn regroup(world: &mut World, cue: &mut Cue, handle: RigidBodyHandle, groups: InteractionGroups) {
    let Some(body) = world.bodies.get(handle) else {
        return;
    };
    allow_overlap(cue, body.mass());
    for &collider in body.colliders() {
        world.colliders[collider].set_collision_groups(groups);
    }
}

/// Accounts for the energy of putting a ball into others: it and one more are pushed apart.
fn allow_overlap(cue: &mut Cue, mass: Real) {
    cue.supply(2.0 * mass, PUSHED_APART.powi(2) / 2.0);
}

fn ball(center: Vector, vertical: Real) -> RigidBodyBuilder {
    RigidBodyBuilder::dynamic()
        .translation(center)
        .linvel(along(UP, vertical))
}

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    // The top has cells enough for the balls that are dropped in during a cycle.
    let dropped = bodies.div_ceil(REPLACED).div_ceil(2) * CYCLE;
    let columns = power(dropped as Real, 1.0 / (DIM - 1) as Real).ceil() as usize;
    let columns = columns.max(Lattice::heap(bodies, SPACING, 1.0).columns);
    let lattice = Lattice::with_columns(bodies, SPACING, columns);
    let drop_height = lattice.height() + 3.0;
    let walls = Container::standing(lattice.half_width() + 0.5, drop_height + 2.0);

    let mut stage = Stage::walled(walls);
    let balls = (0..bodies)
        .map(|index| {
            let (center, ball) = grain(lattice.center(index), random);
            stage.insert(center, ball)
        })
        .collect();
    stage.with_script(Replacement {
        balls,
        disabled: Vec::new(),
        ghosts: Vec::new(),
        drop_height,
        drop_cells: lattice,
        next_cell: 0,
    })
}
