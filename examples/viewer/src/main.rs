//! Shows the scenes of the examples live, in a window, with either broad phase or both.
//!
//! ```text
//! cargo run --release -- --scene rope3d
//! ```
//!
//! A [`stage::Stage`] is a scene with its broad phases. Only the folder `dimension` knows an engine; it is compiled once for
//! each dimension. What is seen is what the scene would draw into its film.

mod camera;
mod chart;
#[path = "../../show/choice.rs"]
mod choice;
mod figures;
mod history;
mod lines;
mod options;
mod panel;
mod setup;
mod stage;
mod viewer;
mod window;

#[path = "dimension"]
mod dim2 {
    //! Scenes in two dimensions.
    use crate::choice;
    use scenes::rapier;
    use unisize::rapier2d_027 as ours;
    use unisize_scenes::dim2 as scenes;

    #[path = "../../../show/gorge.rs"]
    mod gorge;
    mod live;
    #[path = "../../../show/rivals.rs"]
    mod rivals;
    #[path = "../../../show/world.rs"]
    mod show;
    mod watched;
    pub(crate) use gorge::Gorge;
    pub(crate) use live::Live;
}

#[path = "dimension"]
mod dim3 {
    //! Scenes in three dimensions.
    use crate::choice;
    use scenes::rapier;
    use unisize::rapier3d_027 as ours;
    use unisize_scenes::dim3 as scenes;

    #[path = "../../../show/implosion.rs"]
    mod implosion;
    mod live;
    #[path = "../../../show/pour.rs"]
    mod pour;
    #[path = "../../../show/rivals.rs"]
    mod rivals;
    #[path = "../../../show/ropes.rs"]
    mod ropes;
    #[path = "../../../show/world.rs"]
    mod show;
    #[cfg(test)]
    mod tests;
    mod watched;
    pub(crate) use implosion::Implosion;
    pub(crate) use live::Live;
    pub(crate) use pour::Pour;
    pub(crate) use ropes::Ropes;
}

use clap::Parser;
use options::Options;
use std::process::ExitCode;

fn main() -> ExitCode {
    match viewer::run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}
