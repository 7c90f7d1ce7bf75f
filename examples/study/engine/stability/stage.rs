//! A world that was built for a case, and what is measured in it.

use super::scenes::World;
use super::scenes::rapier::prelude::*;
use super::space::{Place, distance, gap, is_finite, motion, place_of};
use crate::stability::case::Case;
use crate::stability::end::Measured;

/// A world that was built for a case.
pub(super) struct Stage {
    pub(super) world: World,
    /// Where bodies were put that should stay there.
    pub(super) places: Vec<(RigidBodyHandle, Place)>,
    /// What should hold together: a joint and the bodies that it joins.
    pub(super) links: Vec<(ImpulseJointHandle, [RigidBodyHandle; 2])>,
    /// What bodies should stay in, as the lower and the upper corner.
    pub(super) bounds: [Place; 2],
    /// The units in a metre, and in a link.
    pub(super) metre: f64,
    pub(super) link: f64,
}

impl Stage {
    /// Builds the world of a case with the start of this seed.
    pub(super) fn build(case: &Case, seed: u64) -> Self {
        super::build::build(case, seed)
    }

    /// Measures the world as it is.
    pub(super) fn measure(&self) -> Measured {
        let bodies = &self.world.bodies;
        let strayed = self.places.iter().map(|&(handle, place)| {
            let body = bodies.get(handle);
            body.map_or(f64::NAN, |body| {
                distance(place_of(body), place) / self.metre
            })
        });
        let stretch = self.links.iter().map(|&(joint, joined)| {
            let joint = self.world.impulse_joints.get(joint);
            joint.map_or(f64::NAN, |joint| {
                gap(bodies, joined, &joint.data) / self.link
            })
        });
        let [lo, hi] = self.bounds;
        let is_outside = |body: &&RigidBody| {
            let mut coordinates = place_of(body).into_iter().zip(lo.iter().zip(&hi));
            coordinates.any(|(x, (lo, hi))| x < *lo || x > *hi)
        };
        let all = || bodies.iter().map(|(_, body)| body);
        let motions: Vec<_> = all().map(motion).collect();
        Measured {
            not_finite: motions.iter().filter(|motion| !is_finite(motion)).count(),
            strayed: worst(strayed),
            stretch: worst(stretch),
            outside: all()
                .filter(|body| body.is_dynamic())
                .filter(is_outside)
                .count(),
            bodies: motions,
        }
    }
}

/// The largest figure, or NaN if one is.
fn worst(figures: impl Iterator<Item = f64>) -> f64 {
    figures.fold(0.0, |worst: f64, figure| match figure.is_nan() {
        true => figure,
        false if worst.is_nan() => worst,
        false => worst.max(figure),
    })
}

#[cfg(test)]
mod tests {
    use super::super::flavour;
    use super::super::scenes::rapier::prelude::*;
    use super::{is_finite, motion, worst};

    #[test]
    fn a_spin_must_be_finite_as_well() {
        let is_finite = |body: RigidBodyBuilder| is_finite(&motion(&body.build()));
        let spin = |speed| flavour::spin(speed, [0.0, 0.0, 1.0]);
        let body = RigidBodyBuilder::dynamic;
        assert!(is_finite(body().angvel(spin(1.0))));
        assert!(!is_finite(body().angvel(spin(Real::NAN))));
        assert!(!is_finite(body().angvel(spin(Real::INFINITY))));
        assert!(!is_finite(body().rotation(spin(Real::NAN))));
    }

    #[test]
    fn nothing_is_worse_than_what_is_not_a_number() {
        assert_eq!(worst([1.0, 3.0, 2.0].into_iter()), 3.0);
        assert!(worst([1.0, f64::NAN, 2.0].into_iter()).is_nan());
    }
}
