//! The runs in one flavour of Rapier: one source, compiled once for each.

use super::{flavour, ours, scenes, version};

mod build;
mod clocked;
mod contender;
mod shift;
mod stage;
mod together;

use crate::case::Case;
use crate::caught::caught;
use crate::end::End;
use crate::options::Options;
use crate::row::{Found, Row};
use contender::Contender;
use stage::Stage;

pub(super) use clocked::Clocked;
pub(crate) use shift::shift;

/// Runs a case from all its starts; `on_run` is called after each.
pub(crate) fn study(case: &Case, options: &Options, on_run: impl FnMut()) -> Row {
    study_of(Contender::Ours, case, options, on_run)
}

fn study_of(candidate: Contender, case: &Case, options: &Options, mut on_run: impl FnMut()) -> Row {
    let mut run = |contender: Contender, seed| {
        let end = simulate(contender, case, seed);
        on_run();
        end
    };
    let mut of = |contender: Contender| {
        let seeds = options.seeds();
        seeds.map(|seed| run(contender, seed)).collect::<Vec<_>>()
    };
    let (default, ours) = (of(Contender::Rapier), of(candidate));
    let in_order = options.exact_seeds().map(|seed| {
        let [default, ours] =
            [Contender::RapierInOrder, candidate.in_order()].map(|contender| run(contender, seed));
        match ours.compare(&default) {
            // Rapier 0.36 sweeps fast bodies through the tree, which has its answers in an order of its own.
            Found::Difference(difference) => {
                let is_by_tree = candidate == Contender::Ours && {
                    let on_its_tree = simulate(Contender::OursOnRapiersTree, case, seed);
                    on_its_tree.compare(&default) == Found::Equal
                };
                match is_by_tree {
                    true => Found::ByTree,
                    false => Found::Difference(difference).of_seed(seed),
                }
            }
            found => found,
        }
    });
    let in_order = in_order.collect();
    let pairs = options.exact_seeds().map(|seed| {
        let found = together::compare(candidate, case, seed);
        on_run();
        found.of_seed(seed)
    });
    Row {
        dim: super::DIM,
        pairs: pairs.collect(),
        case: case.clone(),
        default,
        ours,
        in_order,
    }
}

/// One run of a case on one broad phase.
fn simulate(contender: Contender, case: &Case, seed: u64) -> End {
    simulate_steps(contender, case, seed, case.steps())
}

/// So many steps of it.
fn simulate_steps(contender: Contender, case: &Case, seed: u64, steps: usize) -> End {
    let run = || {
        let mut stage = Stage::build(case, seed);
        let mut broad_phase = contender.create();
        for _ in 0..steps {
            stage.world.step(broad_phase.for_step(), &(), &());
        }
        stage.measure()
    };
    End {
        measured: caught(run),
    }
}

#[cfg(test)]
mod tests {
    use super::contender::Contender;
    use super::study_of;
    use crate::family::Family;
    use crate::options::Options;
    use crate::verdict::Verdict;

    /// What reports no pairs lets everything fall through everything.
    #[test]
    fn a_broken_broad_phase_fails_alone() {
        for family in [Family::Stacks, Family::MassRatios, Family::Spins] {
            let case = family.cases().swap_remove(0);
            let row = study_of(Contender::Blind, &case, &Options::quick(), || ());
            assert_eq!(row.verdict(100), Verdict::OursAlone, "{}", family.name());
            assert!(row.in_order.difference.is_some());
            assert!(!row.is_sound(100));
        }
    }

    #[test]
    fn a_panic_is_not_put_down_to_rapier() {
        let case = Family::Stacks.cases().swap_remove(0);
        let row = study_of(Contender::Panicking, &case, &Options::quick(), || ());
        for check in [&row.in_order, &row.pairs] {
            assert_eq!(check.panicked, 0);
            let difference = check.difference.as_ref().unwrap();
            assert!(difference.contains("a panic: on purpose"), "{difference}");
        }
        assert!(row.panic_alone().is_some());
        assert!(!row.is_sound(1));
    }

    #[test]
    fn unisize_does_what_rapier_does() {
        for family in Family::ALL {
            let cases = family.cases();
            let case = cases[cases.len() / 2].clone().lasting_at_most(0.5);
            let row = study_of(Contender::Ours, &case, &Options::quick(), || ());
            assert_eq!(row.in_order.difference, None, "{}", family.name());
            assert_eq!(row.pairs.difference, None, "{}", family.name());
            assert!(row.is_sound(1), "{}", family.name());
        }
    }
}
