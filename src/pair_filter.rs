//! Which pairs a broad phase leaves out although their boxes overlap.

/// Which pairs a broad phase leaves out because the narrow phase would find neither a contact nor an intersection in them.
///
/// A pair that is left out costs nothing in the narrow phase. Unless only its shapes keep it apart, a search drops it, and it costs nothing
/// between searches either. It is reported once it may have an effect and one of its colliders is listed as modified. Rapier's
/// `PhysicsPipeline` lists a collider whenever a property that the filter reads has changed, except for a body's soft CCD in 0.27. A
/// reported pair that bodies, types or groups come to forbid stays until its boxes part, as with the own broad phase of Rapier 0.36.
///
/// `docs/guide.md` says which filter suits which world.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
#[non_exhaustive]
pub enum PairFilter {
    /// None: every pair whose boxes overlap is reported, as by the own broad phase of Rapier 0.27. The default for Rapier 0.27.
    Off,
    /// Pairs of colliders of one body, and pairs whose types of bodies are in the active collision types of neither collider, mainly pairs
    /// of fixed colliders. A collider without a body counts as fixed.
    ///
    /// Contacts and intersections stay the same. There are two differences in Rapier 0.27, whose narrow phase finds the sleeping bodies to
    /// wake through its pairs:
    ///
    /// - A collider that is changed, attached to another body, or removed without waking its body, does not wake a body that it overlaps if
    ///   all pairs of the two are left out.
    /// - `CollisionPipeline` does not list the colliders of a body whose type changes for the second time, so their pairs begin when they are
    ///   listed next.
    Bodies,
    /// Also pairs whose collision groups forbid a contact. The own broad phase of Rapier 0.36 leaves out these pairs.
    ///
    /// In Rapier 0.27, changing a collider does not wake sleeping neighbors with which its groups forbid a contact.
    Groups,
    /// Also pairs whose boxes overlap and whose shapes cannot meet. The default for Rapier 0.36.
    ///
    /// The narrow phase would test such pairs in each step and find nothing: in the corners of boxes around balls, next to tilted capsules,
    /// and within the margins.
    ///
    /// A pair begins when its boxes *and* the present bounding volumes of its shapes are within the prediction distance and the contact
    /// skins. It ends when the boxes with their margins part. It also ends when the volumes are farther apart than both margins, unless the
    /// narrow phase has an active contact of the two. So the margin saves work without adding pairs. Each volume is loosened by a *skin* of
    /// a sixteenth of the margin, and stays while that of the collider differs by less. When the prediction distance or the length unit
    /// becomes smaller, volumes stay as large as they were: there may be more pairs than in a new broad phase, and the parameters may
    /// alternate at no cost. When one of them exceeds its largest value so far, all volumes are read again, for at least twice that value.
    ///
    /// | shape | volume |
    /// |---|---|
    /// | ball, capsule, cuboid, round cuboid, half-space | the shape |
    /// | other convex shapes, segments, triangles, compounds | the oriented box around them |
    /// | meshes, polylines, height fields, voxels, custom shapes | none: their pairs are those of [`Groups`](Self::Groups) |
    ///
    /// Some colliders have no volume, whatever their shape: those with physics hooks, so that hooks are called for the same pairs; those of
    /// bodies with soft CCD; and those of a body with more than 32 colliders at the time of reading.
    ///
    /// Contacts and intersections stay the same. Rapier 0.36 tests a pair again only when its colliders have moved by some hundredths of a
    /// length unit since the pair began, so a contact of two colliders that are still apart may be predicted some steps earlier or later.
    /// Rapier also wakes the body of a changed collider if its narrow phase has ever had a pair of it, and the bodies with which it has pairs.
    /// The patched copy of Rapier 0.36 does this for the pairs that are left out as well. In Rapier 0.27, and in 0.36 without the patch,
    /// changing or removing a collider does not wake a sleeping body, or keep one awake, that is near the collider and does not touch it.
    Shapes,
}
