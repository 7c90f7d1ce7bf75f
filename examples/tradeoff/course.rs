//! How a whole simulation went, the same type for both dimensions.

/// What a simulation was run on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Run {
    /// Rapier's broad phase with a fine time step and its events in order.
    Reference,
    /// Rapier's broad phase with its events in order.
    RapierInOrder,
    /// The default settings with events in order: the same pairs in the same order as [`RapierInOrder`](Self::RapierInOrder).
    AutomaticInOrder,
    /// Rapier's broad phase as it is.
    Rapier,
    /// Settings of unisize, as they are.
    Setting,
    /// The kernel of the paper on boxes of one size.
    CommonBox,
}

/// How a whole simulation went.
#[derive(Clone, Debug)]
pub(crate) struct Course {
    pub(crate) name: String,
    pub(crate) run: Run,
    /// The energy at the end over what there was at the start and what the script brought in, less one.
    pub(crate) energy_change: f64,
    /// The deepest contact of all steps, in typical sizes.
    pub(crate) worst_penetration: f64,
    /// The largest error of a joint of all steps, in lengths of a rope's segment.
    pub(crate) worst_stretch: Option<f64>,
    /// When it first was elsewhere than the simulation of a quarter of the time step, in seconds.
    pub(crate) leaves_reference: Option<f64>,
    /// When it first was elsewhere than the simulation on Rapier's broad phase with its events in order, in seconds.
    pub(crate) leaves_rapier: Option<f64>,
    /// How far it is from that one at the most, and in the end, in typical sizes, as a root of the mean of squares over bodies.
    pub(crate) most_from_rapier: f64,
    pub(crate) distance_from_rapier: f64,
}
