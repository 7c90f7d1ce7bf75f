//! A world that was built for a case, and what is measured in it.

use super::scenes::World;
use super::scenes::rapier::{math::DIM, prelude::*};
use super::version::{Point, Vector};
use super::{flavour, version};
use crate::case::Case;
use crate::end::Measured;
use std::borrow::Borrow;

/// A world that was built for a case.
pub(super) struct Stage {
    pub(super) world: World,
    /// Where bodies were put that should stay there.
    pub(super) places: Vec<(RigidBodyHandle, [f64; DIM])>,
    /// What should hold together: a joint and the bodies that it joins.
    pub(super) links: Vec<(ImpulseJointHandle, [RigidBodyHandle; 2])>,
    /// What bodies should stay in, as the lower and the upper corner.
    pub(super) bounds: [[f64; DIM]; 2],
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
                let now = components(body.translation());
                distance(now, place) / self.metre
            })
        });
        let stretch = self.links.iter().map(|(joint, bodies)| {
            let stretch = self.stretch(*joint, *bodies);
            stretch.map_or(f64::NAN, |stretch| stretch / self.link)
        });
        let [lo, hi] = self.bounds;
        let is_outside = |body: &&RigidBody| {
            let now = components(body.translation());
            (0..DIM).any(|axis| now[axis] < lo[axis] || now[axis] > hi[axis])
        };
        let all = || bodies.iter().map(|(_, body)| body);
        Measured {
            not_finite: all().filter(|body| !is_finite(body)).count(),
            strayed: worst(strayed),
            stretch: worst(stretch),
            outside: all()
                .filter(|body| body.is_dynamic())
                .filter(is_outside)
                .count(),
            bodies: all()
                .map(|body| {
                    let pose = body.position();
                    format!("{pose:?} {:?} {:?}", body.linvel(), body.angvel())
                })
                .collect(),
        }
    }

    /// How far apart the two ends are that a joint holds together.
    fn stretch(&self, joint: ImpulseJointHandle, bodies: [RigidBodyHandle; 2]) -> Option<f64> {
        let joint = self.world.impulse_joints.get(joint)?;
        let end = |body: RigidBodyHandle, anchor: Point| {
            Some(self.world.bodies.get(body)?.position() * anchor)
        };
        let first = end(bodies[0], joint.data.local_anchor1())?;
        let second = end(bodies[1], joint.data.local_anchor2())?;
        Some(distance(components(second - first), [0.0; DIM]))
    }
}

/// The components of a vector, which one version of the engine returns by reference, and another by value.
fn components(vector: impl Borrow<Vector>) -> [f64; DIM] {
    let vector = vector.borrow();
    std::array::from_fn(|axis| f64::from(vector[axis]))
}

fn distance(a: [f64; DIM], b: [f64; DIM]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}

fn is_finite(body: &RigidBody) -> bool {
    let moves = components(body.linvel()).iter().all(|x| x.is_finite());
    moves && version::is_finite(body.position()) && flavour::has_finite_spin(body)
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
    use super::is_finite;

    #[test]
    fn a_spin_must_be_finite_as_well() {
        let spinning = |speed| {
            let spin = flavour::spin(speed, [0.0, 0.0, 1.0]);
            is_finite(&RigidBodyBuilder::dynamic().angvel(spin).build())
        };
        assert!(spinning(1.0));
        assert!(!spinning(Real::NAN));
        assert!(!spinning(Real::INFINITY));
        let turned =
            RigidBodyBuilder::dynamic().rotation(flavour::spin(Real::NAN, [0.0, 0.0, 1.0]));
        assert!(!is_finite(&turned.build()));
    }
}
