//! What each kernel, margin and filter of unisize costs. None of them may miss a pair.

use super::{Figures, Frames, Study, is_sound, print_by_scene};
use crate::finder::{Finder, Setting};
use crate::output::{Output, number, table};
use anyhow::Result;
use clap::Args;
use unisize::{Kernel, PairFilter};
use unisize_charts::{Axis, Chart, Panel, Series, color};

/// The margins, in typical sizes of a collider, besides the default one.
const MARGINS: [f32; 5] = [0.0, 0.05, 0.1, 0.25, 0.5];

/// Brute force takes too long with more bodies.
const BRUTE_FORCE_BODIES: usize = 2_000;

/// How much faster the best settings may be before the default counts as a bad choice.
const ALLOWED: f64 = 1.1;

/// What does each kernel, margin and filter of unisize cost?
///
/// Exits with 1 if one of them misses a pair whose shapes touch, or nearly do.
#[derive(Args, Clone, Debug)]
pub(crate) struct Arguments {
    #[command(flatten)]
    frames: Frames,
}

/// What is measured with so many bodies, unisize by default first.
pub(crate) fn finders(bodies: usize) -> Vec<Finder> {
    const DEFAULT: Setting = Setting::DEFAULT;
    let margins = MARGINS.map(|sizes| Setting {
        margin: Some(sizes),
        ..DEFAULT
    });
    let kernels =
        [Kernel::RankSweep, Kernel::BruteForce].map(|kernel| Setting { kernel, ..DEFAULT });
    let filters = [PairFilter::Bodies, PairFilter::Groups, PairFilter::Shapes];
    let filters = filters.map(|filter| Setting {
        filter: Some(filter),
        ..DEFAULT
    });
    let settings = [DEFAULT]
        .into_iter()
        .chain(margins)
        .chain(kernels)
        .chain(filters);
    let settings = settings
        .filter(|of| of.kernel != Kernel::BruteForce || bodies <= BRUTE_FORCE_BODIES)
        .map(Finder::Unisize);
    settings.chain([Finder::Rapier]).collect()
}

impl Arguments {
    /// Runs the study; whether unisize has passed.
    pub(crate) fn run(&self) -> Result<bool> {
        let mut output = Output::create("settings", &self.frames.common)?;
        let studies = self.frames.studies(&mut output, finders)?;
        print_best(&studies);
        print_by_scene(
            &studies,
            "Broad and narrow phase, over the default settings",
            |study, figures| number(figures.both / study.default().both),
        );
        print_by_scene(
            &studies,
            "Broad phase alone, over the default settings",
            |study, figures| number(figures.broad / study.default().broad),
        );
        print_by_scene(
            &studies,
            "Pairs held per pair that touches",
            |_, figures| number(figures.held_a_contact()),
        );
        print_recall(&studies);
        for &dim in self.frames.common.dims() {
            output.chart(dim, || chart(dim, &studies))?;
        }
        Ok(is_sound(&studies))
    }
}

/// Prints the default settings beside the best ones.
fn print_best(studies: &[Study]) {
    println!("### The default settings and the best ones, broad and narrow phase, ms/step\n");
    let mut table = table([
        "scene",
        "bodies",
        "default settings",
        "best settings",
        "their time",
        "default over best",
        "within 10 %",
        "Rapier's",
        "Rapier's over default",
    ]);
    for study in studies {
        let default = study.default();
        let is_setting = |finder, _: &Figures| matches!(finder, Finder::Unisize(_));
        let (Some((finder, best)), Some(rapier)) =
            (study.fastest(is_setting), study.of(Finder::Rapier))
        else {
            continue;
        };
        let ratio = default.both / best.both;
        table.add_row([
            study.title(),
            study.bodies.to_string(),
            number(default.both),
            finder.name(),
            number(best.both),
            format!("{:+.1} %", (ratio - 1.0) * 100.0),
            if ratio <= ALLOWED { "yes" } else { "NO" }.to_owned(),
            number(rapier.both),
            number(rapier.both / default.both),
        ]);
    }
    println!("{table}\n");
}

fn print_recall(studies: &[Study]) {
    println!(
        "### Recall: the pairs that are held, of those that should be, by all methods together\n"
    );
    let mut table = table(["scene", "touching", "within the prediction distance"]);
    for study in studies {
        let sum = |pairs: fn(&Figures) -> super::Recall| {
            let recalls = study.finders.iter().map(|of| pairs(&of.1));
            let [found, all] =
                recalls.fold([0, 0], |[found, all], of| [found + of.found, all + of.all]);
            format!("{found} of {all}")
        };
        table.add_row([study.title(), sum(|of| of.touching), sum(|of| of.near)]);
    }
    println!("{table}\n");
}

/// Time against pairs held per contact, a panel for each scene.
fn chart(dim: u8, studies: &[Study]) -> Chart {
    let panels = studies
        .iter()
        .filter(|study| study.dim == dim)
        .map(|study| {
            let point = |figures: &Figures| (figures.held_a_contact(), figures.both);
            let points = |is_meant: &dyn Fn(Setting) -> bool| {
                let finders = study.finders.iter();
                let meant = finders.filter_map(|(finder, figures)| match finder {
                    Finder::Unisize(setting) if is_meant(*setting) => Some(point(figures)),
                    _ => None,
                });
                let mut points: Vec<_> = meant.collect();
                points.sort_by(|a, b| a.0.total_cmp(&b.0));
                points
            };
            let kernel = |kernel: Kernel| points(&move |of| of.kernel == kernel);
            let default = points(&|of| of == Setting::DEFAULT);
            let margins = points(&|of| of.kernel == Kernel::GridSweep && of.filter.is_none());
            let filters = points(&|of| of.filter.is_some());
            let rapier = study.of(Finder::Rapier).map(point);
            Panel::new(
                study.title(),
                Axis::log("pairs held per pair that touches"),
                Axis::log("broad and narrow phase, ms"),
                [
                    Series::new("unisize, default settings", color::RED, default).bold(),
                    Series::new(
                        "unisize, margins of 0 to half a size",
                        color::SALMON,
                        margins,
                    ),
                    Series::new("unisize, filters", color::PINK, filters).unjoined(),
                    Series::new("RankSweep", color::GREEN, kernel(Kernel::RankSweep)),
                    Series::new("BruteForce", color::GREY, kernel(Kernel::BruteForce)),
                    Series::new("Rapier's", color::BLUE, rapier),
                ],
            )
        });
    Chart::new(format!("What settings cost, {dim}D"), panels)
        .columns(3)
        .own_ranges()
}
