//! The tables on standard output, in Markdown.

use crate::course::{Course, Run};
use crate::method::{Margin, Method, Search};
use crate::study::{Figures, Study};
use comfy_table::presets::ASCII_MARKDOWN;
use comfy_table::{CellAlignment, ColumnConstraint, Table};

/// What the best setting may be faster by before the default counts as a bad choice.
const ALLOWED: f64 = 1.1;

/// Prints what was measured in one scene.
pub(crate) fn print_study(study: &Study) {
    println!(
        "### {} {}D: {} bodies, {} steps, typical size {:.2}, default margin {:.3} of it\n",
        study.scene,
        study.dim,
        study.bodies,
        study.steps,
        study.typical_size,
        study.default_margin / study.typical_size,
    );
    let mut table = table([
        "method",
        "margin, sizes",
        "recall, touching",
        "recall, near",
        "pairs held per contact",
        "precision",
        "broad, ms/step",
        "narrow, ms/step",
        "both, ms/step",
    ]);
    for figures in &study.figures {
        table.add_row(row(figures));
    }
    println!("{table}\n");
    let mut table = self::table([
        "simulated alone",
        "energy change",
        "worst penetration, sizes",
        "worst joint error, segments",
        "leaves the reference after",
        "leaves Rapier after",
        "end distance from Rapier, sizes",
    ]);
    for course in &study.courses {
        table.add_row(course_row(course));
    }
    println!("With {} bodies:\n\n{table}\n", study.course_bodies);
}

fn row(figures: &Figures) -> Vec<String> {
    let margin = match (figures.method.search, figures.method.margin) {
        (Search::CommonBox, _) => "-".to_owned(),
        (_, margin) => margin.label(),
    };
    vec![
        figures.method.search.name().to_owned(),
        margin,
        format!("{} of {}", figures.touching.found, figures.touching.all),
        format!("{} of {}", figures.near.found, figures.near.all),
        format!("{:.2}", figures.held_a_contact()),
        percent(figures.precision()),
        format!("{:.3}", figures.broad),
        format!("{:.3}", figures.both - figures.broad),
        format!("{:.3}", figures.both),
    ]
}

fn course_row(course: &Course) -> Vec<String> {
    let one = |unit: Unit, figure| unit.span([figure].into_iter());
    vec![
        course.name.clone(),
        one(Unit::Percent, Some(course.energy_change)),
        one(Unit::Lengths, Some(course.worst_penetration)),
        one(Unit::Lengths, course.worst_stretch),
        one(Unit::Seconds, course.leaves_reference),
        one(Unit::Seconds, course.leaves_rapier),
        one(Unit::Lengths, Some(course.distance_from_rapier)),
    ]
}

/// Prints how the default settings compare with the best ones, and what accuracy came out, scene by scene.
pub(crate) fn print_summary(studies: &[Study]) {
    println!("### The default settings and the best ones, broad and narrow phase, ms/step\n");
    let mut table = table([
        "scene",
        "bodies",
        "default settings",
        "best settings",
        "",
        "default over best",
        "within 10 %",
        "Rapier 0.27",
        "Rapier over default",
    ]);
    for study in studies {
        let (automatic, best) = (study.automatic(), study.best());
        let ratio = automatic.both / best.both;
        let rapier = study.of(Search::Rapier).next();
        table.add_row(vec![
            title(study),
            study.bodies.to_string(),
            format!("{:.3}", automatic.both),
            best.method.name(),
            format!("{:.3}", best.both),
            format!("{:+.1} %", (ratio - 1.0) * 100.0),
            if ratio <= ALLOWED { "yes" } else { "NO" }.to_owned(),
            rapier.map_or_else(String::new, |r| format!("{:.3}", r.both)),
            rapier.map_or_else(String::new, |r| format!("{:.2}", r.both / automatic.both)),
        ]);
    }
    println!("{table}\n");

    println!("### Pairs held per pair that touches\n");
    let methods = [
        (Search::Rapier, Margin::Default),
        (Search::GridSweep, Margin::Sizes(0.0)),
        (Search::GridSweep, Margin::Default),
        (Search::GridSweep, Margin::Sizes(0.05)),
        (Search::GridSweep, Margin::Sizes(0.1)),
        (Search::GridSweep, Margin::Sizes(0.25)),
        (Search::GridSweep, Margin::Sizes(0.5)),
        (Search::CommonBox, Margin::Sizes(0.0)),
    ]
    .map(|(search, margin)| Method { search, margin });
    let mut head = vec!["scene".to_owned(), "touching pairs seen".to_owned()];
    head.extend(methods.map(|method| method.name()));
    head.push("least recall of all methods".to_owned());
    let mut table = self::table(head);
    for study in studies {
        let figures = &study.figures;
        let contacts = figures.first().map_or(0, |f| f.touching.all);
        let mut row = vec![title(study), contacts.to_string()];
        row.extend(methods.map(|method| {
            let found = figures.iter().find(|f| f.method == method);
            found.map_or_else(String::new, |f| format!("{:.2}", f.held_a_contact()))
        }));
        let recalls = figures
            .iter()
            .flat_map(|f| [f.touching.share(), f.near.share()]);
        row.push(recalls.fold(1.0, f64::min).to_string());
        table.add_row(row);
    }
    println!("{table}\n");
    print_courses(studies);
}

/// Prints how whole simulations fared: what all settings of unisize span, beside Rapier as it is and the reference.
fn print_courses(studies: &[Study]) {
    println!("### Whole simulations on one broad phase each\n");
    let mut table = table([
        "scene",
        "bodies",
        "energy change: reference",
        "Rapier",
        "unisize",
        "worst penetration: reference",
        "Rapier",
        "unisize",
        "worst joint error: reference",
        "Rapier",
        "unisize",
        "leaves the reference: Rapier",
        "unisize",
        "leaves Rapier in order: Rapier",
        "unisize",
    ]);
    for study in studies {
        let mut row = vec![title(study), study.course_bodies.to_string()];
        let runs = [Run::Reference, Run::Rapier, Run::Setting];
        let mut span = |runs: &[Run], figure: &dyn Fn(&Course) -> Option<f64>, unit: Unit| {
            row.extend(runs.iter().map(|&run| {
                let courses = study.courses.iter().filter(|course| course.run == run);
                unit.span(courses.map(figure))
            }));
        };
        span(&runs, &|c| Some(c.energy_change), Unit::Percent);
        span(&runs, &|c| Some(c.worst_penetration), Unit::Lengths);
        span(&runs, &|c| c.worst_stretch, Unit::Lengths);
        span(&runs[1..], &|c| c.leaves_reference, Unit::Seconds);
        span(&runs[1..], &|c| c.leaves_rapier, Unit::Seconds);
        table.add_row(row);
    }
    println!("{table}\n");
}

/// How a figure is written.
#[derive(Clone, Copy)]
enum Unit {
    Percent,
    Lengths,
    Seconds,
}

impl Unit {
    fn write(self, figure: f64) -> String {
        match self {
            Self::Percent => format!("{:+.2} %", figure * 100.0),
            Self::Lengths => format!("{figure:.3}"),
            Self::Seconds => format!("{figure:.2} s"),
        }
    }

    /// From the least to the greatest figure. One that is missing is a time that never came, or a joint where there is
    /// none.
    fn span(self, figures: impl Iterator<Item = Option<f64>>) -> String {
        let mut figures: Vec<_> = figures.map(|f| f.unwrap_or(f64::INFINITY)).collect();
        figures.sort_by(f64::total_cmp);
        let write = |figure: f64| match self {
            Self::Seconds if figure.is_infinite() => "never".to_owned(),
            _ if figure.is_infinite() => "-".to_owned(),
            _ => self.write(figure),
        };
        match figures[..] {
            [] => String::new(),
            [least, .., greatest] if write(least) != write(greatest) => {
                format!("{} to {}", write(least), write(greatest))
            }
            [figure, ..] => write(figure),
        }
    }
}

fn title(study: &Study) -> String {
    format!("{} {}D", study.scene, study.dim)
}

fn percent(share: f64) -> String {
    format!("{:.1} %", share * 100.0)
}

/// A table whose first column is text and whose others are figures.
fn table<T: Into<comfy_table::Row>>(head: T) -> Table {
    let mut table = Table::new();
    table.load_preset(ASCII_MARKDOWN).set_header(head);
    for column in table.column_iter_mut() {
        // However wide the terminal is: a line of Markdown must not be broken.
        column.set_constraint(ColumnConstraint::ContentWidth);
        if column.index > 0 {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}
