//! Results in a file, a JSON object a line, as `.ci/tables` reads them.

use serde::Serialize;
use std::fs::{File, OpenOptions};
use std::io::{self, Write};
use std::path::Path;

/// What is appended to a file, if there is one.
pub struct JsonLines(Option<File>);

impl JsonLines {
    /// Opens the file, and writes which machine and which command the lines that follow are from.
    pub fn append(path: Option<&Path>) -> io::Result<Self> {
        let open = |path| OpenOptions::new().create(true).append(true).open(path);
        let mut lines = Self(path.map(open).transpose()?);
        let mut arguments = std::env::args();
        let program = arguments.next().unwrap_or_default();
        let program = Path::new(&program).file_stem().unwrap_or_default();
        let arguments = arguments.collect::<Vec<_>>().join(" ");
        lines.write(&serde_json::json!({
            "machine": machine(),
            "command": format!("{} {arguments}", program.to_string_lossy()),
        }))?;
        Ok(lines)
    }

    /// Adds a line.
    pub fn write(&mut self, row: &impl Serialize) -> io::Result<()> {
        match &mut self.0 {
            Some(file) => writeln!(file, "{}", serde_json::to_string(row)?),
            None => Ok(()),
        }
    }
}

/// The processor's own name and the number of cores that this program may use: figures of different machines must not be mixed.
fn machine() -> String {
    let cores = std::thread::available_parallelism().map_or(1, |cores| cores.get());
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let line = info.lines().find(|line| line.starts_with("model name"));
    let name = line.and_then(|line| line.split_once(": "));
    let processor = name.map_or(std::env::consts::ARCH, |(_, name)| name);
    format!("{processor}, {cores} cores")
}
