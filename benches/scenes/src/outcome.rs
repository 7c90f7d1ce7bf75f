//! The result of comparing a broad phase with Rapier's own, the same for every engine. Its fields are those of the rows that the
//! program `compare` stores.

use crate::timing::Times;
use serde::Serialize;

/// A value for each of the two broad phases that are compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Both<T> {
    /// That of Rapier's own broad phase.
    pub default: T,
    /// That of the broad phase that is compared with it, the candidate.
    #[serde(rename = "ours")]
    pub candidate: T,
}

impl<T> Both<T> {
    /// Computes something from both values, from the default's first.
    pub fn map<U>(self, mut of: impl FnMut(T) -> U) -> Both<U> {
        Both {
            default: of(self.default),
            candidate: of(self.candidate),
        }
    }
}

/// The result of a comparison.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Outcome {
    /// How many steps were simulated.
    pub steps: usize,
    /// How many bodies there were at the end.
    pub bodies: usize,
    /// How many colliders there were at the end.
    pub colliders: usize,
    /// The first difference, with its step; nothing is checked after it.
    pub first_difference: Option<String>,
    /// How many times as fast as the default the candidate was, over all updates but the first: the median over all repeats.
    pub ratio: f64,
    /// How many pairs were held at the end, without those that the narrow phase drops anyway.
    pub pairs: Both<usize>,
    /// How many pairs of colliders touched at the end, in the run that the default drove.
    pub contacts_at_end: usize,
    /// How many sensors were entered at the end, in the run that the default drove.
    pub intersections_at_end: usize,
    /// At how many steps the contacts of both were computed and compared.
    pub contact_checks: usize,
    /// The rays that were cast in the trees of both, and compared.
    pub rays: Rays,
    /// How long the updates took: the medians over all repeats.
    pub broad_phase: Both<Times>,
    /// The scene simulated on each broad phase alone, if it was.
    pub whole_steps: Option<WholeSteps>,
}

/// How many rays were cast.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Rays {
    /// After each step, beside those of the scene itself.
    pub a_step: usize,
    /// All together.
    pub cast: usize,
    /// Those that hit a collider.
    pub hits: usize,
}

/// Whole steps on either broad phase alone, with the script, the solver and the queries.
#[derive(Clone, Debug, Serialize)]
pub struct WholeSteps {
    /// The median over all repeats of the mean over their steps.
    pub ms_per_step: Both<f64>,
    /// The default's time over the candidate's, one of each repeat.
    pub ratio: Spread,
    /// The ratio with a broad phase that takes no time.
    pub limit: Limit,
    /// All simulations, by seed.
    pub repeats: Vec<Repeat>,
}

/// The ratio with a broad phase that takes no time.
///
/// The times are the means over the steps of one more world on the default alone, with its broad phase clocked.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Limit {
    /// A whole step.
    pub ms_per_step: f64,
    /// The part of the broad phase in it.
    pub ms_of_broad_phase: f64,
    /// The time of a step over what is left of it without the broad phase.
    pub ratio: f64,
}

/// Two simulations of one seed.
#[derive(Clone, Debug, Serialize)]
pub struct Repeat {
    /// The seed of the scene.
    pub seed: u64,
    /// The default's time over the candidate's.
    pub ratio: f64,
    /// The end of either simulation.
    pub end: Both<End>,
}

/// The end of a simulation on one broad phase alone.
#[derive(Clone, Debug, Serialize)]
pub struct End {
    /// What is wrong with the scene, if anything is.
    pub complaint: Option<String>,
    /// How many bodies there were.
    pub bodies: usize,
    /// How many of them slept.
    pub asleep: usize,
    /// The kinetic and the potential energy.
    pub energy: f64,
    /// How many pairs its narrow phase held without an active contact or an intersection.
    pub pairs_without_contact: usize,
    /// The whole step, with its rays.
    pub ms_per_step: f64,
}

/// The median and the quartiles of some figures.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Spread {
    /// The lower quartile.
    pub lower: f64,
    /// The median.
    pub median: f64,
    /// The upper quartile.
    pub upper: f64,
}

impl Outcome {
    /// Whether the candidate did the same as the default, as far as was checked.
    pub fn is_equal(&self) -> bool {
        self.first_difference.is_none()
    }

    /// Sets the times of the updates to the medians over these repeats, of which there must be one.
    pub fn time_updates(&mut self, repeats: &[Both<Times>]) {
        let median = |figure: &dyn Fn(&Both<Times>) -> f64| {
            let spread = Spread::of(repeats.iter().map(figure));
            spread.map_or(f64::NAN, |spread| spread.median)
        };
        self.ratio = median(&|both| both.default.ms_per_step / both.candidate.ms_per_step);
        let times = |of: fn(&Both<Times>) -> Times| Times {
            ms_first_update: median(&|both| of(both).ms_first_update),
            ms_per_step: median(&|both| of(both).ms_per_step),
            ms_worst_update: median(&|both| of(both).ms_worst_update),
            updates: of(&repeats[0]).updates,
        };
        self.broad_phase = Both {
            default: times(|both| both.default),
            candidate: times(|both| both.candidate),
        };
    }
}

impl WholeSteps {
    /// The figures of these repeats together; none if there are none.
    pub fn of(repeats: Vec<Repeat>, limit: Limit) -> Option<Self> {
        let spread = |figure: fn(&Repeat) -> f64| Spread::of(repeats.iter().map(figure));
        Some(Self {
            ms_per_step: Both {
                default: spread(|repeat| repeat.end.default.ms_per_step)?.median,
                candidate: spread(|repeat| repeat.end.candidate.ms_per_step)?.median,
            },
            ratio: spread(|repeat| repeat.ratio)?,
            limit,
            repeats,
        })
    }
}

impl Limit {
    /// The limit of steps of this length, of which the broad phase takes a part.
    pub fn of(ms_per_step: f64, ms_of_broad_phase: f64) -> Self {
        Self {
            ms_per_step,
            ms_of_broad_phase,
            ratio: ms_per_step / (ms_per_step - ms_of_broad_phase),
        }
    }
}

impl Spread {
    /// The spread of these figures, interpolated between neighbours; none if there are none.
    pub fn of(figures: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut sorted: Vec<_> = figures.into_iter().collect();
        sorted.sort_by(f64::total_cmp);
        let last = sorted.len().checked_sub(1)?;
        let at = |share: f64| {
            let place = share * last as f64;
            let below = sorted[place.floor() as usize];
            let above = sorted[place.ceil() as usize];
            below + (above - below) * place.fract()
        };
        Some(Self {
            lower: at(0.25),
            median: at(0.5),
            upper: at(0.75),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{Limit, Spread};

    #[test]
    fn the_limit_is_that_of_a_broad_phase_for_nothing() {
        assert_eq!(Limit::of(12.0, 4.0).ratio, 1.5);
    }

    #[test]
    fn quartiles_lie_between_neighbours() {
        assert_eq!(Spread::of([]), None);
        for (figures, [lower, median, upper]) in [
            (&[2.0][..], [2.0, 2.0, 2.0]),
            (&[3.0, 1.0, 2.0], [1.5, 2.0, 2.5]),
            (&[5.0, 1.0, 4.0, 2.0, 3.0], [2.0, 3.0, 4.0]),
        ] {
            let spread = Spread {
                lower,
                median,
                upper,
            };
            assert_eq!(Spread::of(figures.iter().copied()), Some(spread));
        }
    }
}
