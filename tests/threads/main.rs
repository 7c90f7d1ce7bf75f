//! Worlds that a program steps on threads of its own: among jobs of a Rayon pool, next to them, and before it starts a pool.
//!
//! A step that waits for itself never ends, and there is one global pool for each process. So each test is a process with a time limit.
#![cfg(all(
    feature = "_adapter",
    feature = "parallel",
    not(target_family = "wasm")
))]

use std::env;
use std::process::{Command, Stdio, exit};
use std::thread::sleep;
use std::time::{Duration, Instant};

#[path = "../common/flavours.rs"]
#[macro_use]
mod flavours;

#[allow(unused_macros)]
macro_rules! flavour {
    ($name:ident, $rapier:ident, $unisize:ident, $dim:tt, $version:tt) => {
        #[path = "."]
        mod $name {
            use unisize::$unisize::UnisizeBroadPhase;
            use $rapier as rapier;

            mod suite;

            #[path = "../common/crowd"]
            mod versions {
                use super::rapier;

                #[path = $version]
                pub(super) mod version;
            }
            use versions::version;
        }
    };
}

for_each_027!(flavour);
for_each_036!(flavour);

/// Many times as long as a test takes.
const LIMIT: Duration = Duration::from_secs(120);

/// The exit code of a process that has run a test. It is 0 if there is no such test.
const DONE: i32 = 42;

/// Runs the body of a test as a process of its own, which must end.
fn in_a_process(module: &str, test: &str, body: fn()) {
    const IS_CHILD: &str = "UNISIZE_TEST_IS_CHILD";
    if env::var_os(IS_CHILD).is_some() {
        body();
        exit(DONE);
    }
    let (_, module) = module.split_once("::").expect("the crate is first");
    let mut child = Command::new(env::current_exe().expect("it has a path"));
    child.args(["--nocapture", "--exact", &format!("{module}::{test}")]);
    let child = child.env(IS_CHILD, "1").stdout(Stdio::null()).spawn();
    let mut child = child.expect("it runs again");
    let began = Instant::now();
    let status = loop {
        match child.try_wait().expect("it is a child") {
            None if began.elapsed() < LIMIT => sleep(Duration::from_millis(10)),
            status => break status,
        }
    };
    if status.is_none() {
        child.kill().expect("it stands still");
    }
    let code = status.map(|status| status.code());
    assert_eq!(code, Some(Some(DONE)), "`None` if it stands still");
}

// rustfmt does not look into macros.
#[cfg(rustfmt)]
mod suite;
