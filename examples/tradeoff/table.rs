//! The tables on standard output, in Markdown.

use crate::course::{Course, Run};
use crate::method::{Margin, Method, Search};
use crate::study::{Figures, Recall, Study};
use comfy_table::presets::ASCII_MARKDOWN;
use comfy_table::{CellAlignment, ColumnConstraint, Table};

/// How much faster the best settings may be before the default counts as a bad choice.
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

/// Prints the default settings beside the best ones, and the accuracy, scene by scene.
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

    print_by_method(
        studies,
        "Broad and narrow phase, over the default settings",
        |study, figures| figures.both / study.automatic().both,
    );
    print_by_method(
        studies,
        "Broad phase alone, over the default settings",
        |study, figures| figures.broad / study.automatic().broad,
    );
    print_by_method(studies, "Pairs held per pair that touches", |_, figures| {
        figures.held_a_contact()
    });

    println!(
        "### Recall: the pairs that are held, of those that should be, by all methods together\n"
    );
    let mut table = self::table(["scene", "touching", "within the prediction distance"]);
    for study in studies {
        let of = |recall: fn(&Figures) -> Recall| {
            let recalls = study.figures.iter().map(recall);
            let sum = recalls.fold([0, 0], |[found, all], r| [found + r.found, all + r.all]);
            format!("{} of {}", sum[0], sum[1])
        };
        table.add_row(vec![title(study), of(|f| f.touching), of(|f| f.near)]);
    }
    println!("{table}\n");
    print_courses(studies);
}

/// Prints a figure of every scene and method. Margins have the same effect on all kernels, and are listed for the fast one.
fn print_by_method(studies: &[Study], what: &str, figure: impl Fn(&Study, &Figures) -> f64) {
    println!("### {what}\n");
    let mut methods = Vec::new();
    for figures in studies.iter().flat_map(|study| &study.figures) {
        let Method { search, margin } = figures.method;
        let is_told = search != Search::RankSweep || margin == Margin::Default;
        if is_told && !methods.contains(&figures.method) {
            methods.push(figures.method);
        }
    }
    let mut head = vec!["scene".to_owned()];
    head.extend(methods.iter().map(|method| method.name()));
    let mut table = table(head);
    for study in studies {
        let mut row = vec![title(study)];
        row.extend(methods.iter().map(|&method| {
            let found = study.figures.iter().find(|f| f.method == method);
            found.map_or_else(String::new, |f| format!("{:.2}", figure(study, f)))
        }));
        table.add_row(row);
    }
    println!("{table}\n");
}

/// Prints the outcomes of whole simulations: the range over all settings of unisize, beside Rapier and the reference.
fn print_courses(studies: &[Study]) {
    const ALL: [Run; 3] = [Run::Reference, Run::Rapier, Run::Setting];
    let span = |study: &Study, runs: &[Run], figure: &Figure| {
        let of_run = |&run: &Run| {
            let courses = study.courses.iter().filter(|course| course.run == run);
            figure.unit.span(courses.map(figure.of))
        };
        runs.iter().map(of_run).collect::<Vec<_>>()
    };

    println!("### Whole simulations on one broad phase each: errors\n");
    let mut table = table([
        "scene",
        "bodies",
        "energy change: reference",
        "Rapier",
        "unisize",
        "worst penetration, sizes: reference",
        "Rapier",
        "unisize",
        "worst joint error, segments: reference",
        "Rapier",
        "unisize",
    ]);
    for study in studies {
        let mut row = vec![title(study), study.course_bodies.to_string()];
        for figure in [&ENERGY, &PENETRATION, &STRETCH] {
            row.extend(span(study, &ALL, figure));
        }
        table.add_row(row);
    }
    println!("{table}\n");

    println!("### Whole simulations on one broad phase each: how soon they differ\n");
    let mut table = self::table([
        "scene",
        "leaves the reference: Rapier",
        "unisize",
        "leaves Rapier with its events in order: Rapier as it is",
        "unisize",
        "unisize with its events in order",
    ]);
    for study in studies {
        let mut row = vec![title(study)];
        row.extend(span(study, &ALL[1..], &LEAVES_REFERENCE));
        row.extend(span(study, &ALL[1..], &LEAVES_RAPIER));
        row.extend(span(study, &[Run::AutomaticInOrder], &LEAVES_RAPIER));
        table.add_row(row);
    }
    println!("{table}\n");
}

/// A figure of a simulation.
struct Figure {
    of: fn(&Course) -> Option<f64>,
    unit: Unit,
}

const ENERGY: Figure = Figure {
    of: |course| Some(course.energy_change),
    unit: Unit::Percent,
};
const PENETRATION: Figure = Figure {
    of: |course| Some(course.worst_penetration),
    unit: Unit::Lengths,
};
const STRETCH: Figure = Figure {
    of: |course| course.worst_stretch,
    unit: Unit::Lengths,
};
const LEAVES_REFERENCE: Figure = Figure {
    of: |course| course.leaves_reference,
    unit: Unit::Seconds,
};
const LEAVES_RAPIER: Figure = Figure {
    of: |course| course.leaves_rapier,
    unit: Unit::Seconds,
};

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

    /// From the least to the greatest figure. A missing one is a time that never came, or the joint error of a scene without
    /// joints.
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
pub(crate) fn table<T: Into<comfy_table::Row>>(head: T) -> Table {
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
