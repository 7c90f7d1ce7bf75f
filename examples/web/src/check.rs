//! The checks of all flavours, for Node and for a program on this machine.

use crate::for_engine;
use unisize_scenes::SceneKind;
use wasm_bindgen::prelude::*;

/// The names of all scenes.
#[wasm_bindgen]
pub fn scenes() -> Vec<String> {
    SceneKind::ALL.map(|kind| kind.name().to_owned()).into()
}

/// The first difference between unisize and Rapier's own broad phase in so many steps of a scene.
///
/// # Errors
///
/// A sentence if there is no such engine or scene.
#[wasm_bindgen]
pub fn first_difference(
    engine: &str,
    scene: &str,
    bodies: usize,
    steps: usize,
) -> Result<Option<String>, JsError> {
    let difference = for_engine!(engine, check::first_difference);
    Ok(difference(crate::kind(scene)?, bodies, steps))
}

/// The hash of all events of a scene in hexadecimal digits, which is the same on every platform.
///
/// # Errors
///
/// A sentence if there is no such engine or scene.
#[wasm_bindgen]
pub fn golden(engine: &str, scene: &str) -> Result<String, JsError> {
    let golden = for_engine!(engine, check::golden);
    Ok(format!("{:016x}", golden(crate::kind(scene)?)))
}
