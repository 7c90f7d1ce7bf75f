//! Every scene, small, with Rapier's broad phase and each kernel of ours: the pairs held, the contacts and the
//! intersections are equal after every step. `examples/compare` does the same at full size.
#![cfg(feature = "_adapter")]

#[macro_use]
mod flavours;

#[allow(unused_macros)]
macro_rules! flavour {
    ($name:ident, $rapier:ident, $unisize:ident, $dim:tt, $version:tt) => {
        mod $name {
            use unisize::$unisize::{Kernel, Settings, UnisizeBroadPhase};
            use unisize_scenes::SceneKind;
            use unisize_scenes::$name::{Candidate, Comparison};

            fn compare(kernel: Kernel, bodies: usize, steps: usize) {
                let mut settings = Settings::default();
                settings.kernel = kernel;
                let candidate = Candidate::new(
                    move || UnisizeBroadPhase::with_settings(settings),
                    |ours| ours.pairs().collect(),
                    UnisizeBroadPhase::as_query_pipeline,
                )
                .with_validation(UnisizeBroadPhase::validate);
                for kind in SceneKind::ALL {
                    let mut comparison = Comparison::new(kind, bodies, 7);
                    comparison.steps = steps;
                    comparison.repeats = 0;
                    comparison.rays = 4;
                    let outcome = comparison.run(&candidate);
                    let name = kind.name();
                    assert!(outcome.is_equal(), "{name}: {:?}", outcome.first_difference);
                    assert!(
                        bodies < 2 || outcome.pairs.default > 0,
                        "{name} has no pairs"
                    );
                }
            }

            #[test]
            fn grid_sweep() {
                compare(Kernel::GridSweep, 150, 60);
            }

            #[test]
            fn rank_sweep() {
                compare(Kernel::RankSweep, 150, 60);
            }

            #[test]
            fn one_body_or_none() {
                compare(Kernel::GridSweep, 1, 10);
                compare(Kernel::GridSweep, 0, 10);
            }
        }
    };
}

for_each_027!(flavour);
