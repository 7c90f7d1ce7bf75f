//! Where a picture is seen from.

use crate::raster::{Lens, View};
use glam::Vec3;

/// The vertical angle that a camera in space sees: 40 degrees.
const FIELD_OF_VIEW: f32 = 0.7;

/// Where a picture is seen from.
///
/// In three dimensions, up is the second axis, and lengths are those of the world. Angles are in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    target: Vec3,
    yaw: f32,
    pitch: f32,
    /// From a camera in space to its target, or the height of what one above the plane shows.
    distance: f32,
    is_in_space: bool,
}

/// Where a [`Camera`] is and what it shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sight {
    /// In perspective.
    Orbit {
        /// The place of the camera.
        eye: [f32; 3],
        /// The point that it looks at.
        target: [f32; 3],
        /// The vertical angle that it sees.
        field_of_view: f32,
    },
    /// The plane of the first two axes, without perspective.
    TopDown {
        /// The point in the middle.
        center: [f32; 2],
        /// The length between the lower and the upper edge.
        height: f32,
    },
}

impl Camera {
    /// A camera at this distance from what it looks at: in front of it, on the positive third axis, until it is
    /// [turned](Self::turned) and [raised](Self::raised).
    pub fn orbit(target: [f32; 3], distance: f32) -> Self {
        Self {
            target: Vec3::from(target),
            yaw: 0.0,
            pitch: 0.0,
            distance,
            is_in_space: true,
        }
    }

    /// A camera that looks down on the plane of the first two axes, without perspective: a picture shows `height`
    /// units of length from its lower to its upper edge.
    pub fn top_down([x, y]: [f32; 2], height: f32) -> Self {
        Self {
            is_in_space: false,
            ..Self::orbit([x, y, 0.0], height)
        }
    }

    /// Turned by this angle about the vertical through its target, to the right. Default: 0.
    pub fn turned(self, yaw: f32) -> Self {
        Self { yaw, ..self }
    }

    /// Raised by this angle above the horizontal through its target. Default: 0; up to a little less than a right
    /// angle.
    pub fn raised(self, pitch: f32) -> Self {
        let pitch = pitch.clamp(-1.57, 1.57);
        Self { pitch, ..self }
    }

    /// The camera in plain numbers.
    pub fn sight(&self) -> Sight {
        if self.is_in_space {
            Sight::Orbit {
                eye: (self.target + self.back() * self.distance).into(),
                target: self.target.into(),
                field_of_view: FIELD_OF_VIEW,
            }
        } else {
            Sight::TopDown {
                center: [self.target.x, self.target.y],
                height: self.distance,
            }
        }
    }

    /// The direction from its target to itself.
    fn back(&self) -> Vec3 {
        let (sine, cosine) = self.pitch.sin_cos();
        Vec3::new(self.yaw.sin() * cosine, sine, self.yaw.cos() * cosine)
    }

    /// What it looks at.
    pub(crate) fn target(&self) -> Vec3 {
        self.target
    }

    /// About how far from its target it sees things: bodies within this radius cast shadows.
    pub(crate) fn reach(&self) -> f32 {
        self.distance * (1.3 * (FIELD_OF_VIEW / 2.0).tan() + 0.5)
    }

    pub(crate) fn view(&self) -> View {
        let back = self.back();
        if self.is_in_space {
            let lens = Lens::Perspective((FIELD_OF_VIEW / 2.0).tan());
            View::new(self.target + back * self.distance, -back, lens)
        } else {
            View::new(self.target, -back, Lens::Parallel(self.distance / 2.0))
        }
    }
}
