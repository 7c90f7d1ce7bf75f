//! A world that was built for a case, and whether it has failed.

use super::scenes::World;
use super::scenes::rapier::prelude::*;
use super::space::{Place, distance, gap, is_finite, motion, place_of};

/// A body fails this far from its place, in metres, and a joint this far apart, in links: half a box, and half a link.
const HALF: f64 = 0.5;

/// A world that was built for a case.
pub(super) struct Stage {
    pub(super) world: World,
    /// The places of the bodies that should not move.
    pub(super) places: Vec<(RigidBodyHandle, Place)>,
    /// The joints that should hold, each with its bodies.
    pub(super) links: Vec<(ImpulseJointHandle, [RigidBodyHandle; 2])>,
    /// The lower and the upper corner of the box that no body should leave.
    pub(super) bounds: [Place; 2],
    /// Whether only a panic counts as a failure.
    pub(super) is_lawless: bool,
    /// The units in a metre, and in a link.
    pub(super) metre: f64,
    pub(super) link: f64,
}

impl Stage {
    /// Whether a body is not finite or has left its place or bounds, or a joint is torn.
    pub(super) fn has_failed(&self) -> bool {
        if self.is_lawless {
            return false;
        }
        let bodies = &self.world.bodies;
        let has_strayed = |&(handle, place): &(RigidBodyHandle, Place)| {
            exceeds(
                distance(place_of(&bodies[handle]), place),
                HALF * self.metre,
            )
        };
        let is_torn = |&(joint, joined): &(ImpulseJointHandle, [RigidBodyHandle; 2])| {
            let joint = self.world.impulse_joints.get(joint);
            joint.is_none_or(|joint| exceeds(gap(bodies, joined, &joint.data), HALF * self.link))
        };
        let [lo, hi] = self.bounds;
        let is_outside = |(_, body): (_, &RigidBody)| {
            let mut coordinates = place_of(body).into_iter().zip(lo.iter().zip(&hi));
            body.is_dynamic() && coordinates.any(|(x, (lo, hi))| x < *lo || x > *hi)
        };
        self.motions().iter().any(|motion| !is_finite(motion))
            || self.places.iter().any(has_strayed)
            || self.links.iter().any(is_torn)
            || bodies.iter().any(is_outside)
    }

    /// The pose and the velocities of every body as text, which differs if a bit does.
    pub(super) fn motions(&self) -> Vec<String> {
        let bodies = self.world.bodies.iter();
        bodies.map(|(_, body)| motion(body)).collect()
    }
}

/// Whether a figure is above its bound, or no number.
fn exceeds(figure: f64, bound: f64) -> bool {
    figure.is_nan() || figure > bound
}

#[cfg(test)]
mod tests {
    use super::super::scenes;
    use super::super::space::{along, vector};
    use super::*;
    use crate::stability::family::Family;

    /// The world of this family after its last body was moved.
    fn moved(family: &str, by: f64) -> Stage {
        let family = Family::named(family);
        let mut stage = Stage::build(&family.case(family.range[0]), 1);
        let last = stage.world.bodies.iter().last().map(|(handle, _)| handle);
        let body = &mut stage.world.bodies[last.expect("there are bodies")];
        let mut place = place_of(body);
        place[0] += by;
        body.set_translation(vector(place), false);
        stage
    }

    #[test]
    fn each_world_has_its_way_to_fail() {
        for (family, far) in [
            ("stacks", 0.6),
            ("chains", 0.3),
            ("spins", 6.0),
            ("shots-with-ccd", 9.0),
            ("extremes", f64::INFINITY),
        ] {
            assert!(!moved(family, 0.0).has_failed(), "{family}");
            assert!(!moved(family, 0.2).has_failed(), "{family}");
            let may_do_anything = family == "extremes";
            for by in [far, f64::NAN] {
                assert_eq!(moved(family, by).has_failed(), !may_do_anything, "{family}");
            }
        }
    }

    #[test]
    fn a_spin_must_be_finite_as_well() {
        let is_finite = |body: RigidBodyBuilder| is_finite(&motion(&body.build()));
        let spin = |speed| scenes::spin([0.0, 0.0, speed]);
        let body = RigidBodyBuilder::dynamic;
        assert!(is_finite(
            body().angvel(spin(1.0)).translation(vector(along(0, 1.0)))
        ));
        assert!(!is_finite(body().angvel(spin(Real::NAN))));
        assert!(!is_finite(body().angvel(spin(Real::INFINITY))));
        assert!(!is_finite(body().rotation(spin(Real::NAN))));
    }
}
