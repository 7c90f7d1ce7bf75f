//! The camera of the window: it orbits a point in space, or looks down on the plane.

use kiss3d::camera::{Camera3d, OrbitCamera3d, Projection};
use kiss3d::event::{MouseButton, WindowEvent};
use kiss3d::glamx::{Mat4, Pose3, Vec3};
use kiss3d::window::Canvas;
use unisize_pictures::{Camera, Sight};

/// The nominal angle of a view without perspective: only its product with the distance matters.
const PARALLEL_ANGLE: f32 = 0.7;

/// The aspect ratio of the scenes' films.
const FILM_ASPECT: f32 = 16.0 / 9.0;

/// A camera that is moved by the mouse and centred on the part of the window beside the panel.
pub(crate) struct Eye {
    orbit: OrbitCamera3d,
    /// How far the picture is shifted to the left, as a share of half the width of the window.
    shift: f32,
}

impl Eye {
    /// A camera that starts with this view, in a window whose free part has this aspect ratio.
    pub(crate) fn new(camera: &Camera, aspect: f32) -> Self {
        let mut orbit = match camera.sight() {
            Sight::Orbit {
                eye,
                target,
                field_of_view,
            } => {
                let [eye, target] = [eye, target].map(Vec3::from);
                let reach = eye.distance(target);
                OrbitCamera3d::new_with_frustum(
                    field_of_view,
                    0.01 * reach,
                    50.0 * reach,
                    eye,
                    target,
                )
            }
            Sight::TopDown { center, height } => {
                let target = Vec3::new(center[0], center[1], 0.0);
                // At least what a film would show.
                let height = height * (FILM_ASPECT / aspect).max(1.0);
                let distance = height / 2.0 / (PARALLEL_ANGLE / 2.0).tan();
                let mut orbit = OrbitCamera3d::new_with_frustum(
                    PARALLEL_ANGLE,
                    0.01,
                    20.0 * distance,
                    target + Vec3::Z * distance,
                    target,
                );
                orbit.set_projection(Projection::Orthographic);
                orbit.rebind_rotate_button(None);
                orbit.rebind_drag_button(Some(MouseButton::Button1));
                orbit
            }
        };
        // The key would make it look at the origin.
        orbit.rebind_reset_key(None);
        Self { orbit, shift: 0.0 }
    }

    /// Adapts to the size of the window and the width of the panel.
    pub(crate) fn fit(&mut self, canvas: &Canvas, [width, height]: [u32; 2], panel: f32) {
        // The camera gets an event only when the size changes.
        let size = WindowEvent::FramebufferSize(width.max(1), height.max(1));
        self.orbit.handle_event(canvas, &size);
        self.shift = panel / width.max(1) as f32;
    }

    /// A point that is seen in the same place but is nearer by this distance.
    pub(crate) fn nearer(&self, point: Vec3, by: f32) -> Vec3 {
        let way = match self.orbit.projection() {
            Projection::Perspective => self.orbit.eye() - point,
            Projection::Orthographic => self.orbit.eye() - self.orbit.at(),
        };
        point + way.normalize_or_zero() * by
    }

    /// Its distance from its target.
    pub(crate) fn distance(&self) -> f32 {
        self.orbit.dist()
    }

    /// The point that it looks at.
    pub(crate) fn target(&self) -> Vec3 {
        self.orbit.at()
    }

    fn to_the_left(&self) -> Mat4 {
        Mat4::from_translation(Vec3::new(-self.shift, 0.0, 0.0))
    }
}

impl Camera3d for Eye {
    fn handle_event(&mut self, canvas: &Canvas, event: &WindowEvent) {
        self.orbit.handle_event(canvas, event);
    }

    fn eye(&self) -> Vec3 {
        self.orbit.eye()
    }

    fn view_transform(&self) -> Pose3 {
        self.orbit.view_transform()
    }

    fn transformation(&self) -> Mat4 {
        self.to_the_left() * self.orbit.transformation()
    }

    fn inverse_transformation(&self) -> Mat4 {
        self.transformation().inverse()
    }

    fn clip_planes(&self) -> (f32, f32) {
        self.orbit.clip_planes()
    }

    fn update(&mut self, canvas: &Canvas) {
        self.orbit.update(canvas);
    }

    fn view_transform_pair(&self, pass: usize) -> (Pose3, Mat4) {
        let (view, projection) = self.orbit.view_transform_pair(pass);
        (view, self.to_the_left() * projection)
    }
}
