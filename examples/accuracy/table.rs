//! The tables, in Markdown.

use crate::case::{Finder, LOST_ONE_IN, Method, Scalar};
use crate::statistics::Median;
use crate::study::Study;
use crate::verdict::{Comparison, LEVEL, Verdict};

/// Prints the errors and times of a scene: medians over the seeds, with their intervals.
pub(crate) fn print_study(study: &Study, seeds: usize) {
    println!(
        "\n### {} {}D\n\n{} {} bodies, {} s, {seeds} seeds.\n",
        study.scene.name(),
        study.dim,
        study.scene.description(),
        study.bodies,
        digits(study.seconds),
    );
    let steps = study
        .frequencies
        .iter()
        .map(|frequency| format!(" 1/{frequency} s |"));
    println!(
        "| what | numbers | broad phase |{}",
        steps.collect::<String>()
    );
    println!("|---|---|---|{}", "---:|".repeat(study.frequencies.len()));
    print_rows("ms of computing for 1 s", study, |method, frequency| {
        study.milliseconds(method, frequency)
    });
    for (index, name) in study.errors().into_iter().enumerate() {
        print_rows(name, study, |method, frequency| {
            study.error(method, frequency, index)
        });
    }
}

fn print_rows(what: &str, study: &Study, median: impl Fn(Method, u32) -> Median) {
    for (index, &method) in study.methods.iter().enumerate() {
        let what = if index == 0 { what } else { "" };
        let cells = study
            .frequencies
            .iter()
            .map(|&frequency| format!(" {} |", range(median(method, frequency))));
        println!(
            "| {what} | {} | {} |{}",
            method.scalar.name(),
            method.finder.name(),
            cells.collect::<String>()
        );
    }
}

/// Prints which methods could be told apart.
pub(crate) fn print_verdict(verdict: &Verdict) {
    println!("\n## Can unisize be told apart from Rapier's own broad phase?\n");
    println!(
        "A test on the same starts for each error, over all time steps; {} tests, by Holm's correction; where all runs are the same, \
         there is nothing to test. Medians are those of 1/60 s. Less than {LEVEL} is told apart.\n",
        verdict.tests
    );
    print_comparisons("unisize", &verdict.ours);
    println!("\n## Would it be noticed?\n");
    println!(
        "The control is Rapier's own broad phase, of whose pairs one in {LOST_ONE_IN} is lost. Its p-values are multiplied by {}: \
         the number of tests above, or of its own if those are more. That is at least as strict as Holm's correction.\n",
        verdict.control_factor
    );
    print_comparisons("control", &verdict.control);
}

/// Prints a row for each scene: the least of its p-values.
pub(crate) fn print_summary(verdict: &Verdict, studies: &[Study]) {
    println!("\n## In short\n");
    println!(
        "The least corrected p of all errors of a scene. Below {LEVEL}, the broad phase is told apart from Rapier's own. Pairs are those \
         of all runs of the control.\n"
    );
    println!(
        "| scene | unisize: least p | told apart | control: least p | told apart | pairs found | lost |"
    );
    println!("|---|---:|---|---:|---|---:|---:|");
    for study in studies {
        let least = |comparisons: &[Comparison]| {
            let of_study = comparisons.iter().filter(|comparison| {
                (comparison.dim, comparison.scene) == (study.dim, study.scene)
            });
            let least = of_study
                .map(|comparison| comparison.adjusted)
                .fold(1.0, f64::min);
            format!("{} | {}", digits(least), yes(least < LEVEL))
        };
        let control = study
            .methods
            .iter()
            .find(|method| method.finder == Finder::Control);
        let [found, lost] = control.map_or([0; 2], |method| study.pairs(*method));
        println!(
            "| {} {}D | {} | {} | {found} | {lost} |",
            study.scene.name(),
            study.dim,
            least(&verdict.ours),
            least(&verdict.control),
        );
    }
}

fn print_comparisons(other: &str, comparisons: &[Comparison]) {
    println!(
        "| scene | error | numbers | Rapier's | {other} | worse / better / same | p | corrected | told apart |"
    );
    println!("|---|---|---|---:|---:|---:|---:|---:|---|");
    for comparison in comparisons {
        println!(
            "| {} {}D | {} | {} | {} | {} | {} / {} / {} | {} | {} | {} |",
            comparison.scene.name(),
            comparison.dim,
            comparison.error,
            comparison.scalar.name(),
            digits(comparison.own.value),
            digits(comparison.other.value),
            comparison.worse,
            comparison.better,
            comparison.same,
            digits(comparison.p),
            digits(comparison.adjusted),
            yes(comparison.is_told_apart()),
        );
    }
}

/// Prints what follows from all of it.
pub(crate) fn print_conclusion(verdict: &Verdict, studies: usize) {
    let noticed = verdict.noticed();
    match verdict.is_same() {
        true => println!(
            "\nunisize is not told apart from Rapier's own broad phase in any of {} tests.",
            verdict.tests
        ),
        false => println!("\nunisize IS TOLD APART from Rapier's own broad phase."),
    }
    match noticed.is_empty() {
        true => println!("The control is told apart in NO scene: these tests say nothing."),
        false => println!(
            "The control is told apart in {} of {studies} scenes.",
            noticed.len()
        ),
    }
}

/// Prints whether what was told apart is so by the order of events alone.
pub(crate) fn print_order(study: &Study, scalar: Scalar, is_same: bool) {
    let place = format!("{} {}D, {}", study.scene.name(), study.dim, scalar.name());
    match is_same {
        true => println!(
            "{place}: with the events in the same order, all runs are the same bit for bit. The order alone differs."
        ),
        false => println!("{place}: runs DIFFER even with the events in the same order."),
    }
}

fn yes(is_true: bool) -> &'static str {
    if is_true { "yes" } else { "no" }
}

/// A median with its interval.
fn range(median: Median) -> String {
    format!(
        "{} ({}–{})",
        digits(median.value),
        digits(median.low),
        digits(median.high)
    )
}

/// A number with three digits that count.
fn digits(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let power = value.abs().log10().floor() as i32;
    match power {
        -3..=5 => format!("{value:.*}", (2 - power).max(0) as usize),
        _ => format!("{value:.1e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::digits;

    #[test]
    fn three_digits_count() {
        let numbers = [0.0, 0.00123456, 0.5, 12.3456, 1234.5, 1.0e-6];
        let texts = numbers.map(digits);
        assert_eq!(texts, ["0", "0.00123", "0.500", "12.3", "1234", "1.0e-6"]);
    }
}
