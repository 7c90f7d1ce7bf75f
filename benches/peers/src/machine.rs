//! What the machine is called: figures of different machines must not be mixed.

/// The processor's own name and the number of cores that this program may use.
pub(crate) fn description() -> String {
    let cores = std::thread::available_parallelism().map_or(1, |cores| cores.get());
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let field = |name| {
        let line = info.lines().find(|line| line.starts_with(name))?;
        Some(line.split_once(':')?.1.trim())
    };
    let processor = field("model name").unwrap_or(std::env::consts::ARCH);
    format!("{processor} {cores} cores")
}

/// Lower-case letters, digits and single hyphens; never empty.
pub(crate) fn file_name(description: &str) -> String {
    let plain = description.replace("(R)", " ").replace("(TM)", " ");
    let words = plain.split(|c: char| !c.is_ascii_alphanumeric());
    let words: Vec<_> = words.filter(|word| !word.is_empty()).collect();
    if words.is_empty() {
        return "machine".to_owned();
    }
    words.join("-").to_ascii_lowercase()
}

#[cfg(test)]
mod tests {
    use super::file_name;

    #[test]
    fn a_name_is_fit_for_a_file() {
        let name = file_name("Intel(R) Xeon(R) Processor @ 2.60GHz, 2 cores");
        assert_eq!(name, "intel-xeon-processor-2-60ghz-2-cores");
        assert_eq!(file_name("../"), "machine");
    }
}
