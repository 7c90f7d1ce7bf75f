//! The first line of the output: whether anything both is faster than unisize's default settings and misses nothing.

use super::study::{Figures, Study};

/// Whether anything beats the default settings, in one line. It is about scenes where contacts are looked for at the end of a
/// step, and where there are any.
pub(crate) fn verdict(studies: &[Study]) -> String {
    let is_counted = |study: &&Study| !study.is_fast && study.touching() > 0;
    let studies: Vec<_> = studies.iter().filter(is_counted).collect();
    let of = |study: &Study, figures: &Figures| {
        let ratio = study.relative(figures);
        format!(
            "{}: {} ({ratio:.2} of its time)",
            study.title(),
            figures.method.full_name()
        )
    };
    let list = |is_told: fn(&Figures) -> bool| {
        let fastest = studies.iter().filter_map(|study| {
            let mut faster = study.faster().into_iter();
            faster.find(|f| is_told(f)).map(|f| of(study, f))
        });
        fastest.collect::<Vec<_>>()
    };
    let all = list(|_| true);
    let others = list(|figures| !figures.method.is_setting());
    let exact = list(|figures| !figures.method.is_setting() && figures.method.is_exact());
    format!(
        "In {} of {} scenes a method that misses nothing is faster than unisize's default{}. In {} of them one is that is not \
         just another setting of unisize{}. In {} of them one is that could not have missed anything either{}.",
        all.len(),
        studies.len(),
        told(&all),
        others.len(),
        told(&others),
        exact.len(),
        told(&exact),
    )
}

fn told(list: &[String]) -> String {
    match list {
        [] => String::new(),
        _ => format!(": {}", list.join("; ")),
    }
}

#[cfg(test)]
mod tests {
    use super::super::method::Search;
    use super::super::study::tests::study;
    use super::verdict;
    use unisize::Kernel;

    #[test]
    fn the_verdict_hides_nothing() {
        let setting = Search::Unisize {
            kernel: Kernel::GridSweep,
            foresight: None,
            has_margin: false,
        };
        let studies = [
            study(&[(Search::HashGrid, 199, 1.0)]),
            study(&[(setting, 200, 1.0), (Search::HashGrid, 200, 1.5)]),
            study(&[(setting, 200, 1.8)]),
        ];
        assert_eq!(
            verdict(&studies),
            "In 2 of 3 scenes a method that misses nothing is faster than unisize's default: \
             ropes 2D: unisize, GridSweep, no margin (0.50 of its time); \
             ropes 2D: unisize, GridSweep, no margin (0.90 of its time). \
             In 1 of them one is that is not just another setting of unisize: \
             ropes 2D: hash grid of centres (0.75 of its time). \
             In 0 of them one is that could not have missed anything either."
        );
    }

    #[test]
    fn exact_methods_are_told_apart_and_scenes_without_contacts_left_out() {
        let mut empty = study(&[(Search::HashGrid, 0, 1.0)]);
        for figures in &mut empty.figures {
            figures.touching = Default::default();
        }
        let studies = [study(&[(Search::Rapier027, 200, 1.6)]), empty];
        let rapier = "ropes 2D: Rapier 0.27 (0.80 of its time)";
        assert_eq!(
            verdict(&studies),
            format!(
                "In 1 of 1 scenes a method that misses nothing is faster than unisize's default: {rapier}. In 1 of them one \
                 is that is not just another setting of unisize: {rapier}. In 1 of them one is that could not have missed \
                 anything either: {rapier}."
            )
        );
    }
}
