//! A few figures in three: the median, and the quartiles around it.

use serde::Serialize;

/// The median and the quartiles of some figures.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(super) struct Spread {
    pub(super) lower: f64,
    pub(super) median: f64,
    pub(super) upper: f64,
}

impl Spread {
    /// The spread of these figures, interpolated between neighbours; none if there are none.
    pub(super) fn of(figures: impl IntoIterator<Item = f64>) -> Option<Self> {
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
    use super::Spread;

    #[test]
    fn quartiles_lie_between_neighbours() {
        assert_eq!(Spread::of([]), None);
        for (figures, [lower, median, upper]) in [
            (&[2.0][..], [2.0, 2.0, 2.0]),
            (&[3.0, 1.0], [1.5, 2.0, 2.5]),
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
