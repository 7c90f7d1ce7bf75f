//! The tables on standard output, in Markdown.

use super::method::{Method, Search};
use super::study::{Figures, Study};
use crate::table::table;

/// Prints the summaries, then a table for each scene.
pub(super) fn print(studies: &[Study]) {
    let (fast, usual): (Vec<_>, Vec<_>) = studies.iter().partition(|study| study.is_fast);
    if !usual.is_empty() {
        println!("### The front: from what misses nothing to what is fastest\n");
        println!(
            "No other method is both faster and misses less. Missed, of all that touch, and the time of broad and narrow phase \
             as a multiple of unisize's default settings:\n"
        );
        print_fronts(&usual);
        println!("### Methods that miss nothing in any scene, and those that do\n");
        print_by_method(&usual);
    }
    if !fast.is_empty() {
        println!("### Fast things: what meets at any time of a step\n");
        print_fronts(&fast);
    }
    for study in studies {
        print_study(study);
    }
}

fn print_fronts(studies: &[&Study]) {
    let mut table = table(["scene", "method", "missed", "time over the default"]);
    for study in studies {
        for (index, figures) in study.front().into_iter().enumerate() {
            let title = if index == 0 {
                study.title()
            } else {
                String::new()
            };
            table.add_row(vec![
                title,
                figures.method.full_name(),
                share(figures),
                format!("{:.2}", study.relative(figures)),
            ]);
        }
    }
    println!("{table}\n");
}

/// The range over scenes of what each method misses, and of its time.
fn print_by_method(studies: &[&Study]) {
    let mut methods: Vec<Method> = Vec::new();
    for figures in studies.iter().flat_map(|study| &study.figures) {
        if !methods.contains(&figures.method) {
            methods.push(figures.method);
        }
    }
    let mut table = table([
        "method",
        "scenes in which it misses something",
        "most missed",
        "time over the default, least",
        "geometric mean",
        "most",
    ]);
    for method in methods {
        let of_method: Vec<_> = (studies.iter())
            .flat_map(|study| study.figures.iter().map(move |figures| (study, figures)))
            .filter(|(_, figures)| figures.method == method)
            .collect();
        let missing = of_method.iter().filter(|(_, f)| !f.misses_nothing());
        let most = (of_method.iter().map(|(_, figures)| figures))
            .max_by(|a, b| a.share_missed().total_cmp(&b.share_missed()));
        let times: Vec<_> = (of_method.iter())
            .map(|(study, figures)| study.relative(figures))
            .collect();
        let mean = times.iter().map(|time| time.ln()).sum::<f64>() / times.len() as f64;
        table.add_row(vec![
            method.full_name(),
            format!("{} of {}", missing.count(), of_method.len()),
            most.map_or_else(String::new, |figures| share(figures)),
            format!("{:.2}", times.iter().copied().fold(f64::INFINITY, f64::min)),
            format!("{:.2}", mean.exp()),
            format!("{:.2}", times.iter().copied().fold(0.0, f64::max)),
        ]);
    }
    println!("{table}\n");
}

fn print_study(study: &Study) {
    println!(
        "### {}: {} bodies, {} steps, typical size {:.2}\n",
        study.title(),
        study.bodies,
        study.steps,
        study.typical_size,
    );
    let mut table = table([
        "method",
        "updated",
        "margin, sizes",
        "missed, of those that touch",
        "missed",
        "pairs held per contact",
        "broad, ms/step",
        "narrow, ms/step",
        "both, ms/step",
        "over the default",
        "on the front",
    ]);
    let front = study.front();
    for figures in &study.figures {
        let Method { feed, .. } = figures.method;
        let name = figures.method.name();
        let is_on_front = front.iter().any(|on| on.method == figures.method);
        let (missed, all) = (figures.touching.missed(), figures.touching.all);
        table.add_row(vec![
            if feed.swept {
                name + ", swept boxes"
            } else {
                name
            },
            format!("every {}", super::method::ordinal(feed.interval)),
            margin(figures.method),
            format!("{missed} of {all}"),
            share(figures),
            format!("{:.2}", figures.held as f64 / all.max(1) as f64),
            format!("{:.3}", figures.broad),
            format!("{:.3}", figures.both - figures.broad),
            format!("{:.3}", figures.both),
            format!("{:.2}", study.relative(figures)),
            if is_on_front { "yes" } else { "" }.to_owned(),
        ]);
    }
    println!("{table}\n");
}

/// The margin of the boxes that a method is fed. Trees have their own on top.
fn margin(method: Method) -> String {
    match method.search {
        _ if method.feed.margin > 0.0 => format!("{} + its own", method.feed.margin),
        Search::Unisize {
            has_margin: false, ..
        }
        | Search::CommonBox(_)
        | Search::HashGrid => "0".to_owned(),
        _ => "its own".to_owned(),
    }
}

/// A share in percent, with two digits that count.
fn share(figures: &Figures) -> String {
    percent(figures.share_missed())
}

fn percent(share: f64) -> String {
    if share == 0.0 {
        return "none".to_owned();
    }
    let percent = share * 100.0;
    let decimals = (1.0 - percent.log10().floor()).clamp(0.0, 6.0) as usize;
    format!("{percent:.decimals$} %")
}

#[cfg(test)]
mod tests {
    use super::percent;

    #[test]
    fn shares_have_two_digits() {
        let shares = [0.0, 0.000_012_3, 0.0012, 0.05, 0.123, 1.0].map(percent);
        let expected = ["none", "0.0012 %", "0.12 %", "5.0 %", "12 %", "100 %"];
        assert_eq!(shares, expected);
    }
}
