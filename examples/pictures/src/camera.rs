//! Where a picture is seen from: the projection of points and rays.

use crate::shape::{Extent, Ray};
use glam::Vec3;

/// Where a picture is seen from.
///
/// In three dimensions, up is the second axis, and lengths are those of the world. Angles are in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    target: Vec3,
    yaw: f32,
    pitch: f32,
    lens: CameraLens,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum CameraLens {
    Orbit { distance: f32, field_of_view: f32 },
    TopDown { height: f32 },
}

impl Camera {
    /// A camera at this distance from what it looks at: in front of it, on the positive third axis, until it is
    /// [turned](Self::turned) and [raised](Self::raised). It sees a vertical angle of 0.7 (40 degrees).
    pub fn orbit(target: [f32; 3], distance: f32) -> Self {
        Self {
            target: Vec3::from(target),
            yaw: 0.0,
            pitch: 0.0,
            lens: CameraLens::Orbit {
                distance,
                field_of_view: 0.7,
            },
        }
    }

    /// A camera that looks down on the plane of the first two axes, without perspective: a picture shows `height`
    /// units of length from its lower to its upper edge.
    pub fn top_down(center: [f32; 2], height: f32) -> Self {
        Self {
            target: Vec3::new(center[0], center[1], 0.0),
            yaw: 0.0,
            pitch: 0.0,
            lens: CameraLens::TopDown { height },
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

    /// With this vertical angle of view; a top-down camera ignores it. Default: 0.7.
    pub fn field_of_view(mut self, angle: f32) -> Self {
        if let CameraLens::Orbit { field_of_view, .. } = &mut self.lens {
            *field_of_view = angle.clamp(0.01, 3.0);
        }
        self
    }

    /// The camera in plain numbers.
    pub fn sight(&self) -> Sight {
        match self.lens {
            CameraLens::Orbit {
                distance,
                field_of_view,
            } => Sight::Orbit {
                eye: (self.target + self.back() * distance).into(),
                target: self.target.into(),
                field_of_view,
            },
            CameraLens::TopDown { height } => Sight::TopDown {
                center: [self.target.x, self.target.y],
                height,
            },
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
        match self.lens {
            CameraLens::Orbit {
                distance,
                field_of_view,
            } => distance * (1.3 * (field_of_view / 2.0).tan() + 0.5),
            CameraLens::TopDown { height } => height,
        }
    }

    pub(crate) fn view(&self) -> View {
        let back = self.back();
        match self.lens {
            CameraLens::Orbit {
                distance,
                field_of_view,
            } => View::new(
                self.target + back * distance,
                -back,
                Lens::Perspective((field_of_view / 2.0).tan()),
            ),
            CameraLens::TopDown { height } => {
                View::new(self.target, -back, Lens::Parallel(height / 2.0))
            }
        }
    }
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

/// How wide a view is: half the height of what it shows, for each unit of depth or at any depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Lens {
    Perspective(f32),
    Parallel(f32),
}

/// The near plane of a perspective view.
pub(crate) const NEAR: f32 = 1e-3;

/// A point to see from, with the axes of what is seen: right, up, and into the depth.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    origin: Vec3,
    axes: [Vec3; 3],
    pub(crate) lens: Lens,
}

impl View {
    /// A view along `forward`, a unit vector.
    pub(crate) fn new(origin: Vec3, forward: Vec3, lens: Lens) -> Self {
        // Looking straight down, any horizontal axis will do.
        let right = forward.cross(Vec3::Y).try_normalize().unwrap_or(Vec3::X);
        Self {
            origin,
            axes: [right, right.cross(forward), forward],
            lens,
        }
    }

    /// A point of the world in the coordinates of the view.
    pub(crate) fn point(&self, point: Vec3) -> Vec3 {
        self.direction(point - self.origin)
    }

    /// A direction of the world in the coordinates of the view.
    pub(crate) fn direction(&self, direction: Vec3) -> Vec3 {
        Vec3::from(self.axes.map(|axis| axis.dot(direction)))
    }

    /// A direction in the coordinates of the view, in those of the world.
    pub(crate) fn world_direction(&self, direction: Vec3) -> Vec3 {
        let [right, up, forward] = self.axes;
        right * direction.x + up * direction.y + forward * direction.z
    }

    /// A point in the coordinates of the view, in those of the world.
    pub(crate) fn world_point(&self, point: Vec3) -> Vec3 {
        self.origin + self.world_direction(point)
    }
}

/// A view with a raster of samples.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Raster {
    pub(crate) lens: Lens,
    pub(crate) width: usize,
    pub(crate) height: usize,
}

impl Raster {
    /// The ray through a place on the raster; samples are at halves.
    #[inline]
    pub(crate) fn ray(&self, x: f32, y: f32) -> Ray {
        let half = self.height as f32 / 2.0;
        let (x, y) = (x - self.width as f32 / 2.0, half - y);
        match self.lens {
            Lens::Perspective(slope) => Ray {
                origin: Vec3::ZERO,
                direction: Vec3::new(x * slope / half, y * slope / half, 1.0),
            },
            Lens::Parallel(extent) => Ray {
                origin: Vec3::new(x * extent / half, y * extent / half, 0.0),
                direction: Vec3::Z,
            },
        }
    }

    /// Where a point is on the raster; `None` if it is too near to be seen.
    pub(crate) fn place(&self, point: Vec3) -> Option<[f32; 2]> {
        let scale = self.samples_per_unit(point.z)?;
        Some([
            self.width as f32 / 2.0 + point.x * scale,
            self.height as f32 / 2.0 - point.y * scale,
        ])
    }

    /// The samples per unit of length at this depth; `None` if that is too near to be seen.
    fn samples_per_unit(&self, depth: f32) -> Option<f32> {
        let half = self.height as f32 / 2.0;
        match self.lens {
            Lens::Perspective(slope) => (depth >= NEAR).then(|| half / slope / depth),
            Lens::Parallel(extent) => Some(half / extent),
        }
    }

    /// The samples that something of this extent may cover: columns and rows, as `[first, end]` each. `None` if there
    /// are none.
    pub(crate) fn cover(&self, extent: &Extent) -> Option<[[usize; 2]; 2]> {
        let far = self.samples_per_unit(extent.hi.z)?;
        let near = match self.lens {
            Lens::Perspective(_) => self.samples_per_unit(extent.lo.z.max(NEAR))?,
            Lens::Parallel(_) => far,
        };
        let span = |lo: f32, hi: f32, middle: f32, count: usize| {
            // Something to the left is leftmost where it is near, something to the right where it is far.
            let lo = middle + (lo * near).min(lo * far);
            let hi = middle + (hi * near).max(hi * far);
            // Conversions saturate, and NaN becomes 0.
            let first = (lo - 0.5).ceil().max(0.0) as usize;
            let end = ((hi - 0.5).floor() + 1.0).max(0.0) as usize;
            (first < end.min(count)).then(|| [first, end.min(count)])
        };
        let (half_width, half_height) = (self.width as f32 / 2.0, self.height as f32 / 2.0);
        Some([
            span(extent.lo.x, extent.hi.x, half_width, self.width)?,
            span(-extent.hi.y, -extent.lo.y, half_height, self.height)?,
        ])
    }
}

#[cfg(test)]
mod tests {
    use super::{Camera, Raster, Sight};
    use glam::Vec3;

    fn place(camera: &Camera, point: [f32; 3]) -> Option<[f32; 2]> {
        let view = camera.view();
        let raster = Raster {
            lens: view.lens,
            width: 200,
            height: 100,
        };
        raster.place(view.point(Vec3::from(point)))
    }

    #[test]
    fn the_target_is_in_the_middle() {
        for yaw in [0.0, 1.0, 4.0] {
            let orbit = Camera::orbit([1.0, 2.0, 3.0], 5.0).turned(yaw).raised(0.5);
            let [x, y] = place(&orbit, [1.0, 2.0, 3.0]).unwrap();
            assert!((x - 100.0).abs() < 1e-3 && (y - 50.0).abs() < 1e-3);
            assert!(
                place(&orbit, [1.0, 3.0, 3.0]).unwrap()[1] < 50.0,
                "up is up"
            );
        }
        assert_eq!(place(&Camera::orbit([0.0; 3], 5.0), [0.0, 0.0, 6.0]), None);
    }

    #[test]
    fn a_plane_is_seen_to_scale() {
        let camera = Camera::top_down([10.0, 20.0], 4.0);
        assert_eq!(place(&camera, [10.0, 20.0, 7.0]), Some([100.0, 50.0]));
        assert_eq!(place(&camera, [12.0, 22.0, 0.0]), Some([150.0, 0.0]));
    }

    #[test]
    fn a_sight_says_where_it_is() {
        let level = Camera::orbit([1.0, 2.0, 3.0], 5.0).field_of_view(0.5);
        let expected = Sight::Orbit {
            eye: [1.0, 2.0, 8.0],
            target: [1.0, 2.0, 3.0],
            field_of_view: 0.5,
        };
        assert_eq!(level.sight(), expected);
        let Sight::Orbit { eye, .. } = level.raised(0.5).sight() else {
            panic!("it is still in perspective");
        };
        assert!(eye[1] > 2.0, "it is raised");
        let center = [10.0, 20.0];
        let height = 4.0;
        let plane = Camera::top_down(center, height).sight();
        assert_eq!(plane, Sight::TopDown { center, height });
    }

    #[test]
    fn a_turn_is_to_the_right() {
        // From the right, what is in front is seen on the left.
        let camera = Camera::orbit([0.0; 3], 5.0).turned(0.3);
        assert!(place(&camera, [0.0, 0.0, 1.0]).unwrap()[0] < 100.0);
    }
}
