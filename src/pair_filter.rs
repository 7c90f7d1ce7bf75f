//! Which pairs are left out although their boxes overlap.

/// Which pairs a broad phase leaves out because the narrow phase would find neither a contact nor an intersection in them.
///
/// A pair that is left out is dropped as soon as a search finds it, and costs nothing between searches or in the narrow
/// phase. It is reported as soon as it may have an effect and one of its colliders is listed as modified. Rapier's
/// `PhysicsPipeline` lists a collider whenever what the filter looks at has changed. A reported pair that bodies, types or groups come to
/// forbid stays until its boxes part, as with Rapier 0.36's own broad phase.
///
/// | world | leaves out |
/// |---|---|
/// | a map of many fixed colliders that touch | [`Bodies`](Self::Bodies) |
/// | bodies of hundreds of colliders | [`Bodies`](Self::Bodies) |
/// | crowds of which most members ignore each other | [`Groups`](Self::Groups) |
/// | balls, capsules and boxes that move freely or lie in heaps | [`Shapes`](Self::Shapes) |
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
#[non_exhaustive]
pub enum PairFilter {
    /// No pair is left out: every pair whose boxes overlap is reported, as by Rapier 0.27's own broad phase. Default for
    /// Rapier 0.27.
    Off,
    /// Pairs of colliders of one body, and pairs of colliders whose types of bodies are among the active collision types
    /// of neither: above all two fixed ones, where a collider without a body counts as fixed.
    ///
    /// Contacts and intersections are the same. There are two differences in Rapier 0.27, whose narrow phase finds the
    /// sleeping bodies to wake through the pairs that it knows:
    ///
    /// - A collider that is changed, given to another body, or removed without waking its body, does not wake the body
    ///   whose colliders it overlaps if all pairs of the two are left out.
    /// - `CollisionPipeline` does not list the colliders of a body whose type changes for the second time, so their pairs
    ///   begin when they are listed next.
    Bodies,
    /// Also pairs whose collision groups forbid it: what Rapier 0.36's own broad phase leaves out.
    ///
    /// In Rapier 0.27, changing a collider does not wake sleeping neighbours that its groups forbid.
    Groups,
    /// Also pairs whose boxes overlap and whose shapes cannot meet. Default for Rapier 0.36.
    ///
    /// The narrow phase would look at them in every step to find nothing: in the corners of boxes around balls, beside tilted
    /// capsules, and within the margins.
    ///
    /// A pair begins when the two are within the prediction distance and their contact skins, by their boxes *and* by bounding
    /// volumes of their shapes, as they are in this update. It ends when the boxes with their margins part, or the volumes are
    /// farther apart than both margins and the narrow phase has no contact of the two that is still active. So the margin saves work and costs no pairs. What has moved by less than a sixteenth of the margin
    /// in a step is *slow* until it leaves its box: then its volume is loosened by as much, and looked at again only when it has moved by more.
    ///
    /// | shape | volume |
    /// |---|---|
    /// | ball, capsule, cuboid, round cuboid, half-space | the shape |
    /// | other convex shapes, segments, triangles, compounds | the oriented box around them |
    /// | meshes, polylines, height fields, voxels, custom shapes | none: their pairs are those of [`Groups`](Self::Groups) |
    ///
    /// Colliders with physics hooks have none either, so hooks are called for the same pairs, and so have those whose box is
    /// larger than the shape: with soft CCD, or soft; and those of a body that had more than 32 colliders when they were read, most of
    /// which lie within it. Where boxes are handed over one by one, only balls have volumes.
    ///
    /// Contacts and intersections are the same. Rapier 0.36 looks at a pair again only when the two have moved by some hundredths of a
    /// length unit, counted from when the pair began: of two that are still apart, a contact may be foreseen some steps earlier or later.
    /// Rapier also wakes the body of a changed collider if its narrow phase has ever had a pair of it, and the bodies that it holds pairs
    /// with. The patched copy of Rapier 0.36 does so for the pairs that are left out here as well. In Rapier 0.27, and in 0.36 without the
    /// copy, changing or removing a collider does not wake a sleeping body, or keep one awake, that is near it and does not touch it.
    Shapes,
}
