//! The bodies of a drawing, as instances of three shapes on the graphics card, so that any number is drawn at once.

use kiss3d::color::Color;
use kiss3d::glamx::{Mat3, Vec3};
use kiss3d::light::Light;
use kiss3d::scene::{InstanceData3d, SceneNode3d};
use unisize_pictures::{Drawing, Figure, Solid, palette};

/// The height of the last figure in the plane over the first, as a share of the size of the drawing.
const LAYERS: f32 = 0.1;

/// Segments of a circle: few, since bodies are small and many.
const ROUND: u32 = 14;

/// All shapes with their instances, below one node.
pub(crate) struct Figures {
    root: SceneNode3d,
    light: SceneNode3d,
    spheres: Batch,
    /// Between the ends of capsules, and discs.
    cylinders: Batch,
    cuboids: Batch,
}

/// A shape and its instances.
struct Batch {
    node: SceneNode3d,
    instances: Vec<InstanceData3d>,
}

impl Batch {
    fn new(root: &mut SceneNode3d, mut node: SceneNode3d) -> Self {
        node.set_roughness(0.9);
        root.add_child(node.clone());
        Self {
            node,
            instances: Vec::new(),
        }
    }

    /// Adds an instance at this position, with its unit axes mapped to these.
    fn add(&mut self, position: Vec3, axes: Mat3, color: Color) {
        self.instances.push(InstanceData3d {
            position,
            deformation: axes,
            color,
            ..InstanceData3d::default()
        });
    }

    fn show(&mut self) {
        self.node.set_visible(!self.instances.is_empty());
        self.node.set_instances(&self.instances);
        self.instances.clear();
    }
}

impl Figures {
    pub(crate) fn new() -> Self {
        let mut root = SceneNode3d::empty();
        let light = root.add_light(Light::directional(Vec3::NEG_Y));
        Self {
            spheres: Batch::new(
                &mut root,
                SceneNode3d::sphere_with_subdiv(1.0, ROUND, ROUND / 2),
            ),
            cylinders: Batch::new(
                &mut root,
                SceneNode3d::cylinder_with_subdiv(1.0, 2.0, ROUND),
            ),
            cuboids: Batch::new(&mut root, SceneNode3d::cube(2.0, 2.0, 2.0)),
            light,
            root,
        }
    }

    pub(crate) fn root(&mut self) -> &mut SceneNode3d {
        &mut self.root
    }

    /// Shows a drawing whose size is about `reach`.
    pub(crate) fn show(&mut self, drawing: &Drawing, middle: Vec3, reach: f32) {
        let mut is_flat = true;
        let layer = LAYERS * reach / drawing.figures().count().max(1) as f32;
        for (index, figure) in drawing.figures().enumerate() {
            is_flat &= !figure.is_lit;
            self.add(&figure, index as f32 * layer);
        }
        if let Some([height, _]) = drawing.ground_and_pitch() {
            // The top of a plate, a little below what lies on it.
            let thickness = 0.01 * reach;
            let center = Vec3::new(middle.x, height - 1.1 * thickness, middle.z);
            let half = Vec3::new(2.0 * reach, thickness, 2.0 * reach);
            let color = shown(palette::GROUND);
            self.cuboids.add(center, Mat3::from_diagonal(half), color);
        }
        // Figures in the plane keep their exact colour when lit from the front.
        let sun = if is_flat {
            Vec3::NEG_Z
        } else {
            Vec3::new(-0.45, -1.0, -0.6)
        };
        self.light.set_light(Some(Light::directional(sun)));
        for batch in [&mut self.spheres, &mut self.cylinders, &mut self.cuboids] {
            batch.show();
        }
    }

    fn add(&mut self, figure: &Figure, layer: f32) {
        let color = shown(figure.color);
        match figure.solid {
            Solid::Sphere { center, radius } => self.add_sphere(center.into(), radius, color),
            Solid::Capsule { ends, radius } => {
                let [start, end] = ends.map(Vec3::from);
                let half = (end - start) / 2.0;
                let side = half.any_orthogonal_vector().normalize_or_zero();
                let other = side.cross(half.normalize_or_zero());
                let axes = Mat3::from_cols(side * radius, half, other * radius);
                self.cylinders.add(start.midpoint(end), axes, color);
                self.add_sphere(start, radius, color);
                self.add_sphere(end, radius, color);
            }
            Solid::Cuboid { center, half_edges } => {
                let [x, y, mut z] = half_edges.map(Vec3::from);
                let mut center = Vec3::from(center);
                if !figure.is_lit {
                    // Without thickness it would have no normal.
                    z = Vec3::Z * 1e-6;
                    center.z += layer;
                }
                self.cuboids.add(center, Mat3::from_cols(x, y, z), color);
            }
            Solid::Disc { center, radius } => {
                let axes = Mat3::from_cols(Vec3::X * radius, Vec3::Z * 1e-6, Vec3::NEG_Y * radius);
                self.cylinders
                    .add(Vec3::new(center[0], center[1], layer), axes, color);
            }
        }
    }

    fn add_sphere(&mut self, center: Vec3, radius: f32, color: Color) {
        self.spheres
            .add(center, Mat3::from_diagonal(Vec3::splat(radius)), color);
    }
}

/// Converts a colour of the pictures to one of the window.
pub(crate) fn shown(color: unisize_pictures::Color) -> Color {
    let [red, green, blue] = color.linear();
    Color::new(red, green, blue, 1.0)
}
