//! The end of a run, one type for all flavours.

use crate::stability::probe::Found;

/// The end of a run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct End {
    /// What was measured, or what the panic said.
    pub(crate) measured: Result<Measured, String>,
}

/// What is measured at the end of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Measured {
    /// How many bodies have a place or a velocity that is not finite.
    pub(crate) not_finite: usize,
    /// How far the body that is farthest from where it was put is from there, in metres.
    pub(crate) strayed: f64,
    /// How far apart the two ends of the widest joint are, in links.
    pub(crate) stretch: f64,
    /// How many bodies are outside of what should hold them by more than their own size.
    pub(crate) outside: usize,
    /// The pose and the velocities of every body, written so that different numbers are different texts.
    pub(crate) bodies: Vec<String>,
}

impl End {
    /// Compares this end, on unisize, with that on Rapier's own broad phase, which should be the same to the last bit.
    pub(crate) fn compare(&self, default: &Self) -> Found {
        match (&self.measured, &default.measured) {
            (_, Err(_)) => Found::Panic,
            (Err(message), Ok(_)) => Found::Difference(format!("a panic: {message}")),
            (Ok(ours), Ok(default)) => {
                let bodies = || ours.bodies.iter().zip(&default.bodies);
                let differ = |(ours, default): &(&String, &String)| ours != default;
                let count = bodies().filter(differ).count();
                match bodies().find(differ) {
                    None if ours.bodies.len() == default.bodies.len() => Found::Equal,
                    None => Found::Difference("the number of bodies".to_owned()),
                    Some((ours, default)) => {
                        Found::Difference(format!("{count} bodies, such as {ours} and {default}"))
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{End, Found, Measured};

    fn end(x: f32) -> End {
        End {
            measured: Ok(Measured {
                bodies: vec!["0".to_owned(), format!("{x:?}")],
                ..Measured::default()
            }),
        }
    }

    #[test]
    fn one_bit_is_a_difference() {
        assert_eq!(end(0.1).compare(&end(0.1)), Found::Equal);
        assert_eq!(end(f32::NAN).compare(&end(f32::NAN)), Found::Equal);
        let is_different = |a: f32, b: f32| matches!(end(a).compare(&end(b)), Found::Difference(_));
        assert!(is_different(0.1, 0.1_f32.next_up()));
        assert!(is_different(0.0, -0.0));
    }

    #[test]
    fn a_panic_counts_where_the_default_has_none() {
        let panic = End {
            measured: Err("why".to_owned()),
        };
        assert_eq!(panic.compare(&panic), Found::Panic);
        assert_eq!(end(0.0).compare(&panic), Found::Panic);
        assert_eq!(
            panic.compare(&end(0.0)),
            Found::Difference("a panic: why".to_owned())
        );
    }
}
