//! The edits that turn a copy of Rapier into a patched one, as data.
//!
//! [`BroadPhaseBvh`] gets one private field, an optional broad phase of the user's. If it is set, `update`, `set_aabb` and the tree for
//! queries use it. No signature changes, so a program that compiles with Rapier compiles with the copy.
//!
//! [`BroadPhaseBvh`]: https://docs.rs/rapier3d/0.36.1/rapier3d/geometry/struct.BroadPhaseBvh.html

use anyhow::{Result, ensure};

/// How an edit changes the text that it finds.
pub(crate) enum Change {
    Replace(&'static str),
    Before(&'static str),
    After(&'static str),
}

/// An edit of a text that must occur as often as it does in the version that the edit was written for.
pub(crate) struct Edit {
    /// The file, relative to the folder of the package.
    pub(crate) file: &'static str,
    /// The purpose, for the note in the copy.
    pub(crate) purpose: &'static str,
    /// The text to look for.
    pub(crate) find: &'static str,
    /// The number of times that the text must occur.
    pub(crate) times: usize,
    /// The change. `{package}` stands for the package's name.
    pub(crate) change: Change,
}

impl Edit {
    /// The text with every occurrence edited.
    pub(crate) fn apply(&self, text: &str, package: &str) -> Result<String> {
        let found = text.matches(self.find).count();
        ensure!(
            found == self.times,
            "{}: expected the text below {} times, found {found}; nothing was written\n{}",
            self.file,
            self.times,
            self.find,
        );
        let new = match self.change {
            Change::Replace(new) => new.to_owned(),
            Change::Before(new) => format!("{new}{}", self.find),
            Change::After(new) => format!("{}{new}", self.find),
        };
        Ok(text.replace(self.find, &new.replace("{package}", package)))
    }
}

/// The packages that can be patched.
pub(crate) const PACKAGES: [&str; 4] = ["rapier2d", "rapier3d", "rapier2d-f64", "rapier3d-f64"];

/// The version that the edits were written for.
pub(crate) const VERSION: &str = "0.36.1";

/// New files: name, contents and purpose.
pub(crate) const FILES: &[(&str, &str, &str)] = &[
    (
        "build.rs",
        include_str!("../seam/build.rs"),
        "tells dependents that this copy is patched",
    ),
    (
        "src/geometry/broad_phase_bvh/custom.rs",
        include_str!("../seam/custom.rs"),
        "`CustomBroadPhase`, and `custom`, `custom_ref` and `custom_mut` of `BroadPhaseBvh`",
    ),
];

/// The field of a set.
const LAST_UPDATE: &str = r#"    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    pub(crate) last_update: crate::geometry::LastUpdate,
"#;

/// The edits of existing files.
pub(crate) const EDITS: &[Edit] = &[
    Edit {
        file: "Cargo.toml",
        purpose: "a build script, and `links`, which passes its message to dependents",
        find: "\nbuild = false\n",
        times: 1,
        change: Change::Replace("\nbuild = \"build.rs\"\nlinks = \"opened-{package}\"\n"),
    },
    Edit {
        file: "src/geometry/mod.rs",
        purpose: "exports `CustomBroadPhase` and `PipelineInput`",
        find: "pub use self::broad_phase_bvh::{BroadPhaseBvh, BvhOptimizationStrategy};",
        times: 1,
        change: Change::After(
            "
pub(crate) use self::broad_phase_bvh::{LastUpdate, note_swept};
pub use self::broad_phase_bvh::{CustomBroadPhase, PipelineInput};",
        ),
    },
    Edit {
        file: "src/geometry/collider_set.rs",
        purpose: "a set knows which update has seen it last; serde skips it",
        find: "    pub(crate) removed_colliders: Vec<ColliderHandle>,\n",
        times: 1,
        change: Change::After(LAST_UPDATE),
    },
    Edit {
        file: "src/geometry/collider_set.rs",
        purpose: "no update has seen a new set",
        find: "            removed_colliders: Vec::new(),\n",
        times: 2,
        change: Change::After("            last_update: Default::default(),\n"),
    },
    Edit {
        file: "src/dynamics/rigid_body_set.rs",
        purpose: "a set knows which update has seen it last; serde skips it",
        find: "    pub(crate) default_fixed: RigidBody,\n",
        times: 1,
        change: Change::After(LAST_UPDATE),
    },
    Edit {
        file: "src/dynamics/rigid_body_set.rs",
        purpose: "no update has seen a new set",
        find: "            default_fixed: RigidBodyBuilder::fixed().build(),\n",
        times: 2,
        change: Change::After("            last_update: Default::default(),\n"),
    },
    Edit {
        file: "src/geometry/broad_phase_bvh/mod.rs",
        purpose: "the new module",
        find: "mod update;\n",
        times: 1,
        change: Change::Replace(
            "mod custom;
mod update;

use self::custom::Custom;
pub(crate) use self::custom::{LastUpdate, note_swept};
pub use self::custom::{CustomBroadPhase, PipelineInput};
",
        ),
    },
    Edit {
        file: "src/geometry/broad_phase_bvh/mod.rs",
        purpose: "the field `custom`; serde skips it, so a loaded broad phase is Rapier's own",
        find: "    deferred_optimize_pending: bool,\n",
        times: 1,
        change: Change::After(
            r#"    /// If set, it replaces the tree.
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    custom: Custom,
"#,
        ),
    },
    Edit {
        file: "src/geometry/broad_phase_bvh/mod.rs",
        purpose: "`set_aabb` calls the custom broad phase",
        find: "        let change_detection_skin = self.change_detection_skin(params, &aabb);\n",
        times: 1,
        change: Change::Before(
            "        if let Some(custom) = &mut self.custom.broad_phase {
            return custom.set_aabb(params, handle, aabb);
        }
",
        ),
    },
    Edit {
        file: "src/geometry/broad_phase_bvh/update.rs",
        purpose: "`update` calls the custom broad phase",
        find: "        self.frame_index = self.frame_index.overflowing_add(1).0;\n",
        times: 1,
        change: Change::Before(
            "        let (modified, removed) = (modified_colliders, removed_colliders);
        if self.custom.update(None, params, colliders, bodies, modified, removed, events) {
            return;
        }
",
        ),
    },
    Edit {
        file: "src/pipeline/physics_pipeline/substep.rs",
        purpose: "passes the boxes of all colliders that a step has moved in one call",
        find: "        for (handle, aabb) in &self.end_step_collider_aabbs {
            broad_phase.set_aabb(integration_parameters, *handle, *aabb);
        }
",
        times: 1,
        change: Change::Replace(
            "        broad_phase.set_aabbs(integration_parameters, &self.end_step_collider_aabbs);
",
        ),
    },
    Edit {
        file: "src/pipeline/physics_pipeline/solve.rs",
        purpose: "a broad phase that is new in a running world receives all colliders",
        find: "        broad_phase.update(\n",
        times: 1,
        change: Change::Replace("        broad_phase.update_in_pipeline(\n            narrow_phase,\n"),
    },
    Edit {
        file: "src/pipeline/collision_pipeline.rs",
        purpose: "a broad phase that is new in a running world receives all colliders",
        find: "        broad_phase.update(\n",
        times: 1,
        change: Change::Replace("        broad_phase.update_in_pipeline(\n            narrow_phase,\n"),
    },
    Edit {
        file: "src/pipeline/physics_pipeline/solve.rs",
        purpose: "a changed collider wakes its neighbors, whether the pairs were reported or not",
        find: "        if handle_user_changes {
",
        times: 1,
        change: Change::After("            broad_phase.wake_unreported(islands, bodies, colliders);
"),
    },
    Edit {
        file: "src/pipeline/user_changes.rs",
        purpose: "a list of the colliders of changed bodies whose contacts reach farther or whose rotation is of any length",
        find: "    modified_colliders: &mut ModifiedColliders,
) {
    enum FinalAction {
",
        times: 1,
        change: Change::Replace(
            "    modified_colliders: &mut ModifiedColliders,
    mut swept: Option<&mut Vec<ColliderHandle>>,
) {
    enum FinalAction {
",
        ),
    },
    Edit {
        file: "src/pipeline/user_changes.rs",
        purpose: "fills the list while the bodies are in the cache",
        find: "            let activation = rb.activation;\n",
        times: 1,
        change: Change::After(
            "            if let Some(swept) = &mut swept {
                crate::geometry::note_swept(swept, rb);
            }
",
        ),
    },
    Edit {
        file: "src/pipeline/physics_pipeline/substep.rs",
        purpose: "passes the list of the custom broad phase",
        find: "            &modified_bodies,
            &mut modified_colliders,
",
        times: 1,
        change: Change::After("            broad_phase.swept(),\n"),
    },
    Edit {
        file: "src/pipeline/collision_pipeline.rs",
        purpose: "the same without dynamics",
        find: "            &modified_bodies,
            &mut modified_colliders,
",
        times: 1,
        change: Change::After("            broad_phase.swept(),\n"),
    },
    Edit {
        file: "src/pipeline/physics_pipeline/substep.rs",
        purpose: "passes the colliders of multibodies, whose rotations may be of any length",
        find: "        // Disabled colliders are treated as if they were removed.
",
        times: 1,
        change: Change::Before("        let links = multibody_joints.multibodies().flat_map(|it| it.links().map(|link| link.rigid_body_handle()));
        broad_phase.note_links(bodies, links);

"),
    },
    Edit {
        file: "src/pipeline/query_pipeline.rs",
        purpose: "queries, and with them CCD, use the tree of the custom broad phase",
        find: "            bvh: &self.tree,\n",
        times: 2,
        change: Change::Replace("            bvh: self.bvh(),\n"),
    },
    Edit {
        file: "src/dynamics/ccd/ccd_solver.rs",
        purpose: "CCD against a list of fixed colliders does not ask for the tree",
        find: "        {
            let query_pipeline = broad_phase.as_query_pipeline(
                narrow_phase.query_dispatcher(),
                bodies,
                colliders,
                QueryFilter::default(),
            );
            let (bvh, dispatcher) = (query_pipeline.bvh, query_pipeline.dispatcher);
",
        times: 1,
        change: Change::Replace(
            "        {
            let dispatcher = narrow_phase.query_dispatcher();
",
        ),
    },
    Edit {
        file: "src/dynamics/ccd/ccd_solver.rs",
        purpose: "CCD against all colliders asks for the tree when it needs it",
        find: "                None => CcdTargets::FullBvh(bvh),\n",
        times: 1,
        change: Change::Replace(
            "                None => CcdTargets::FullBvh(broad_phase.bvh()),\n",
        ),
    },
    Edit {
        file: "src/pipeline/physics_world.rs",
        purpose: "queries use the tree of the custom broad phase",
        find: "        let bvh = &self.broad_phase.tree;\n",
        times: 4,
        change: Change::Replace("        let bvh = self.broad_phase.bvh();\n"),
    },
];
