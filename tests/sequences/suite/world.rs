//! The colliders and bodies of a sequence, and how each operation changes them.

use super::rapier::prelude::*;
use super::version::{self, Pose, translation, vector};
use crate::ops::{BodyKind, Groups, List, NewCollider, Op, Parent, Shape, Triple, Types};

/// Rapier's sets and parameters, with the lists of what changed since the last update.
#[derive(Default)]
pub(crate) struct World {
    pub(crate) islands: IslandManager,
    pub(crate) bodies: RigidBodySet,
    pub(crate) colliders: ColliderSet,
    pub(crate) joints: ImpulseJointSet,
    pub(crate) multibody_joints: MultibodyJointSet,
    pub(crate) params: IntegrationParameters,
    pub(crate) modified: Vec<ColliderHandle>,
    pub(crate) removed: Vec<ColliderHandle>,
    /// What is to be done before the next update, in this order.
    pub(crate) ahead: Vec<Ahead>,
    /// Whether an engine's pipeline propagates the changes of a body to its colliders.
    pub(crate) engine_follows_bodies: bool,
    live: Vec<ColliderHandle>,
    live_bodies: Vec<RigidBodyHandle>,
    gone: Vec<ColliderHandle>,
    /// Clones of the sets after each update that was [kept](Self::keep).
    history: Vec<Sets>,
}

/// The sets of a world, and the handles in them.
struct Sets {
    islands: IslandManager,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    live: Vec<ColliderHandle>,
    live_bodies: Vec<RigidBodyHandle>,
}

/// What is done between two updates.
pub(crate) enum Ahead {
    HandOver(Vec<HandedOver>),
    Ask,
    Renew(bool),
}

/// A box to hand over.
#[derive(Clone, Copy)]
pub(crate) struct HandedOver {
    pub(crate) handle: ColliderHandle,
    pub(crate) aabb: Aabb,
    /// The prediction distance with which it was computed; `None` if it is not the collider's box.
    pub(crate) prediction: Option<Real>,
}

impl World {
    pub(crate) fn new(length_unit: Real) -> Self {
        let mut world = Self::default();
        world.params.length_unit = length_unit;
        world
    }

    pub(crate) fn apply(&mut self, op: Op) {
        match op {
            Op::Insert(new, parent) => self.insert(new, parent),
            Op::Push(pick, velocity) => {
                if let Some(body) = nth(&self.live_bodies, pick) {
                    self.bodies[body].set_linvel(vector(velocity), true);
                }
            }
            Op::EnableBody(pick, on) => self.enable_body(pick, on),
            Op::BodyType(pick, kind) => {
                if let Some(body) = self.sound_body(pick) {
                    self.bodies[body].set_body_type(body_type(kind), true);
                    self.list_colliders_of(body);
                }
            }
            Op::RemoveBody {
                body,
                with_colliders,
            } => self.remove_body(body, with_colliders),
            Op::Rewind(updates) => self.rewind(updates),
            Op::LengthUnit(unit) => self.params.length_unit = unit.into(),
            Op::ListStale(list, pick) => {
                if let Some(handle) = nth(&self.gone, pick) {
                    self.list(list, handle);
                }
            }
            Op::ListBogus(list, index, generation) => {
                self.list(list, ColliderHandle::from_raw_parts(index, generation));
            }
            Op::Announce(new, by) => {
                let listed = self.modified.len();
                self.insert(new, Parent::None);
                self.hand_over_from(listed);
                let newest = self.live.len() - 1;
                self.apply(Op::Carry(newest, by));
            }
            Op::Carry(pick, by) => {
                if let Some(handle) = nth(&self.live, pick) {
                    let listed = self.modified.len();
                    self.change(handle, Op::Move(pick, by));
                    self.hand_over_from(listed);
                }
            }
            Op::CarryAll(times, by, is_asked) => {
                for _ in 0..times {
                    self.ahead.push(Ahead::HandOver(Vec::new()));
                    for pick in 0..self.live.len() {
                        self.apply(Op::Carry(pick, by));
                    }
                    self.ahead.push(match is_asked {
                        true => Ahead::Ask,
                        false => Ahead::HandOver(Vec::new()),
                    });
                }
            }
            Op::Ask => self.ahead.push(Ahead::Ask),
            Op::Renew(is_written) => self.ahead.push(Ahead::Renew(is_written)),
            Op::HandOver(pick, at) => {
                if let Some(handle) = nth(&self.live, pick) {
                    self.hand_over_at(handle, at.unwrap_or([f32::NAN; 3]));
                }
            }
            Op::HandOverStale(pick, at) => {
                if let Some(handle) = nth(&self.gone, pick) {
                    self.hand_over_at(handle, at);
                }
            }
            Op::HandOverBogus(index, generation, at) => {
                self.hand_over_at(ColliderHandle::from_raw_parts(index, generation), at);
            }
            Op::Move(pick, _)
            | Op::Shift(pick, _)
            | Op::Teleport(pick, _)
            | Op::Turn(pick, _)
            | Op::Hook(pick, _)
            | Op::Spoil(pick)
            | Op::Resize(pick, _)
            | Op::Skin(pick, _)
            | Op::Sensor(pick, _)
            | Op::Enable(pick, _)
            | Op::Regroup(pick, _)
            | Op::Retype(pick, _)
            | Op::Reparent(pick, _)
            | Op::Remove(pick)
            | Op::Replace(pick, _)
            | Op::ListAgain(_, pick) => {
                if let Some(handle) = nth(&self.live, pick) {
                    self.change(handle, op);
                }
            }
        }
    }

    /// Keeps clones of the sets.
    pub(crate) fn keep(&mut self) {
        self.history.push(Sets {
            islands: self.islands.clone(),
            bodies: self.bodies.clone(),
            colliders: self.colliders.clone(),
            live: self.live.clone(),
            live_bodies: self.live_bodies.clone(),
        });
    }

    /// Puts back the clones that were kept so many updates ago, if there are some.
    fn rewind(&mut self, updates: usize) {
        let kept = self.history.len().checked_sub(updates);
        let Some(sets) = kept.and_then(|i| self.history.drain(i..).next()) else {
            return;
        };
        Sets {
            islands: self.islands,
            bodies: self.bodies,
            colliders: self.colliders,
            live: self.live,
            live_bodies: self.live_bodies,
        } = sets;
        let all = self.colliders.iter_mut().map(|(handle, _)| handle);
        self.modified = all.collect();
        self.removed.clear();
        let live = &self.live;
        self.gone.retain(|handle| !live.contains(handle));
    }

    fn list(&mut self, list: List, handle: ColliderHandle) {
        match list {
            List::Modified => self.modified.push(handle),
            List::Removed => self.removed.push(handle),
        }
    }

    /// Hands over the boxes of what is listed from there on, instead.
    fn hand_over_from(&mut self, listed: usize) {
        for handle in self.modified.split_off(listed) {
            self.hand_over(handle);
        }
    }

    /// Hands over the box of a collider, or lists it where boxes are not handed over.
    fn hand_over(&mut self, handle: ColliderHandle) {
        let collider = &self.colliders[handle];
        match version::handed_over_box(collider, &self.params, &self.bodies) {
            Some(aabb) => self.hand_over_box(HandedOver {
                handle,
                aabb,
                prediction: Some(self.params.prediction_distance()),
            }),
            None => self.modified.push(handle),
        }
    }

    /// Hands over a box, together with those before.
    fn hand_over_box(&mut self, handed_over: HandedOver) {
        match self.ahead.last_mut() {
            Some(Ahead::HandOver(boxes)) => boxes.push(handed_over),
            _ => self.ahead.push(Ahead::HandOver(vec![handed_over])),
        }
    }

    /// Hands over a box around some place.
    fn hand_over_at(&mut self, handle: ColliderHandle, at: Triple) {
        let aabb = SharedShape::ball(0.5).compute_aabb(&translation(at));
        self.hand_over_box(HandedOver {
            handle,
            aabb,
            prediction: None,
        });
    }

    fn list_colliders_of(&mut self, body: RigidBodyHandle) {
        for &handle in self.bodies[body].colliders() {
            // The engine lists whatever was borrowed mutably.
            self.colliders.get_mut(handle);
            self.modified.push(handle);
        }
    }

    /// Carries out an operation on one collider.
    fn change(&mut self, handle: ColliderHandle, op: Op) {
        match op {
            Op::Remove(_) => return self.remove(handle),
            Op::Replace(_, new) => {
                self.remove(handle);
                // Not reported: another collider at its index must be enough.
                self.removed.pop();
                return self.insert(new, Parent::None);
            }
            Op::ListAgain(list, _) => return self.list(list, handle),
            Op::Enable(_, true) if self.is_on_unsound_body(handle) => return,
            _ => self.modified.push(handle),
        }
        match op {
            Op::Move(_, by) => {
                let pose = version::moved(self.pose(handle), by);
                self.place(handle, pose);
            }
            Op::Teleport(_, to) => self.place(handle, translation(to)),
            Op::Turn(_, angles) => {
                let pose = self.pose(handle) * super::rotation(angles);
                self.place(handle, pose);
            }
            Op::Spoil(_) => self.place(handle, translation([f32::NAN; 3])),
            Op::Reparent(_, to) => {
                let parent = to.and_then(|pick| self.sound_body(pick));
                self.colliders.set_parent(handle, parent, &mut self.bodies);
            }
            _ => {}
        }
        let collider = &mut self.colliders[handle];
        match op {
            Op::Shift(_, by) => {
                let pose = *collider.position() * translation(by);
                if let Some(local) = collider.position_wrt_parent().copied() {
                    collider.set_position_wrt_parent(local * translation(by));
                }
                collider.set_position(pose);
            }
            Op::Resize(_, shape) => collider.set_shape(shared_shape(shape)),
            Op::Skin(_, skin) => collider.set_contact_skin(skin.into()),
            Op::Sensor(_, on) => collider.set_sensor(on),
            Op::Hook(_, on) => collider.set_active_hooks(match on {
                true => ActiveHooks::FILTER_CONTACT_PAIRS,
                false => ActiveHooks::empty(),
            }),
            Op::Enable(_, on) => collider.set_enabled(on),
            Op::Regroup(_, groups) => collider.set_collision_groups(interaction_groups(groups)),
            Op::Retype(_, types) => collider.set_active_collision_types(collision_types(types)),
            _ => {}
        }
    }

    /// A body, unless the engine's solver cannot handle it: it panics if a disabled body has an enabled collider,
    /// or changes its type.
    fn sound_body(&self, pick: usize) -> Option<RigidBodyHandle> {
        let body = nth(&self.live_bodies, pick)?;
        (self.bodies[body].is_enabled() || !self.engine_follows_bodies).then_some(body)
    }

    fn is_on_unsound_body(&self, handle: ColliderHandle) -> bool {
        let parent = self.colliders[handle].parent();
        self.engine_follows_bodies && parent.is_some_and(|body| !self.bodies[body].is_enabled())
    }

    /// The pose of a collider's body, or its own if it has none.
    fn pose(&self, handle: ColliderHandle) -> Pose {
        let collider = &self.colliders[handle];
        match collider.parent() {
            Some(body) => *self.bodies[body].position(),
            None => *collider.position(),
        }
    }

    /// Puts a collider there, or its body with all that is on it.
    fn place(&mut self, handle: ColliderHandle, pose: Pose) {
        let Some(parent) = self.colliders[handle].parent() else {
            self.colliders[handle].set_position(pose);
            return;
        };
        let body = &mut self.bodies[parent];
        body.set_position(pose, true);
        body.set_vels(RigidBodyVelocity::zero(), true);
        for &handle in self.bodies[parent].colliders() {
            let collider = &mut self.colliders[handle];
            let local = collider.position_wrt_parent().expect("it is on a body");
            let pose = pose * *local;
            collider.set_position(pose);
        }
        self.list_colliders_of(parent);
    }

    fn insert(&mut self, new: NewCollider, parent: Parent) {
        let collider = ColliderBuilder::new(shared_shape(new.shape))
            .sensor(new.sensor)
            .enabled(new.enabled)
            .collision_groups(interaction_groups(new.groups))
            .active_collision_types(collision_types(new.types));
        let parent = match parent {
            Parent::None => None,
            Parent::New(kind) => {
                let body = RigidBodyBuilder::new(body_type(kind)).translation(vector(new.at));
                self.live_bodies.push(self.bodies.insert(body));
                self.live_bodies.last().copied()
            }
            Parent::Existing(pick) => self.sound_body(pick),
        };
        let handle = match parent {
            Some(parent) => self
                .colliders
                .insert_with_parent(collider, parent, &mut self.bodies),
            None => self.colliders.insert(collider.translation(vector(new.at))),
        };
        self.live.push(handle);
        self.modified.push(handle);
    }

    fn remove(&mut self, handle: ColliderHandle) {
        version::remove_collider(self, handle);
        self.bury(handle);
    }

    fn bury(&mut self, handle: ColliderHandle) {
        self.live.retain(|&other| other != handle);
        self.gone.push(handle);
        self.removed.push(handle);
    }

    fn enable_body(&mut self, pick: usize, on: bool) {
        let Some(body) = nth(&self.live_bodies, pick) else {
            return;
        };
        self.bodies[body].set_enabled(on);
        if !self.engine_follows_bodies {
            for &handle in self.bodies[body].colliders() {
                self.colliders[handle].set_enabled(on);
            }
            self.list_colliders_of(body);
        }
    }

    fn remove_body(&mut self, pick: usize, with_colliders: bool) {
        let Some(body) = nth(&self.live_bodies, pick) else {
            return;
        };
        self.live_bodies.retain(|&other| other != body);
        for handle in self.bodies[body].colliders().to_vec() {
            if with_colliders {
                self.bury(handle);
            } else {
                self.modified.push(handle);
            }
        }
        version::remove_body(self, body, with_colliders);
    }
}

fn nth<T: Copy>(items: &[T], pick: usize) -> Option<T> {
    items.get(pick % items.len().max(1)).copied()
}

fn body_type(kind: BodyKind) -> RigidBodyType {
    match kind {
        BodyKind::Dynamic => RigidBodyType::Dynamic,
        BodyKind::Fixed => RigidBodyType::Fixed,
        BodyKind::KinematicPosition => RigidBodyType::KinematicPositionBased,
        BodyKind::KinematicVelocity => RigidBodyType::KinematicVelocityBased,
    }
}

fn shared_shape(shape: Shape) -> SharedShape {
    match shape {
        Shape::Ball(radius) => SharedShape::ball(radius.into()),
        Shape::Cuboid(half) => SharedShape::new(Cuboid::new(vector(half))),
        Shape::Capsule(half, radius) => SharedShape::capsule_y(half.into(), radius.into()),
        Shape::Compound(radius, gap) => SharedShape::compound(vec![
            (translation([0.0; 3]), SharedShape::ball(radius.into())),
            (translation([gap; 3]), SharedShape::ball(radius.into())),
        ]),
        Shape::HalfSpace(normal) => version::half_space(normal),
    }
}

fn interaction_groups(groups: Groups) -> InteractionGroups {
    let bits = [groups.memberships, groups.filter].map(Group::from_bits_truncate);
    version::groups(bits[0], bits[1])
}

fn collision_types(types: Types) -> ActiveCollisionTypes {
    match types {
        Types::Usual => ActiveCollisionTypes::default(),
        Types::Fixed => ActiveCollisionTypes::KINEMATIC_FIXED | ActiveCollisionTypes::FIXED_FIXED,
        Types::All => ActiveCollisionTypes::all(),
        Types::None => ActiveCollisionTypes::empty(),
    }
}
