//! The outcome of a whole simulation, one type for both dimensions.

/// What a simulation was run on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Run {
    /// Rapier's broad phase with a fine time step and sorted events.
    Reference,
    /// Rapier's broad phase with sorted events.
    RapierInOrder,
    /// The default settings with sorted events: the same pairs in the same order as [`RapierInOrder`](Self::RapierInOrder).
    AutomaticInOrder,
    /// Rapier's broad phase as it is.
    Rapier,
    /// Settings of unisize, as they are.
    Setting,
    /// The kernel of the paper on boxes of one size.
    CommonBox,
}

/// The outcome of a whole simulation.
#[derive(Clone, Debug)]
pub(crate) struct Course {
    pub(crate) name: String,
    pub(crate) run: Run,
    /// The energy at the end over the initial and the supplied energy, less one.
    pub(crate) energy_change: f64,
    /// The deepest contact of all steps, in typical sizes of a collider.
    pub(crate) worst_penetration: f64,
    /// The largest error of a joint of all steps, in lengths of a rope's segment.
    pub(crate) worst_stretch: Option<f64>,
    /// When it first left the reference, in seconds.
    pub(crate) leaves_reference: Option<f64>,
    /// When it first left the simulation on Rapier's broad phase with sorted events, in seconds.
    pub(crate) leaves_rapier: Option<f64>,
    /// The greatest and the last distance from that one, in typical sizes: the root mean square over bodies.
    pub(crate) most_from_rapier: f64,
    pub(crate) distance_from_rapier: f64,
}
