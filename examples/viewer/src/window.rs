//! The window of the system.

use anyhow::{Result, anyhow, ensure};
use kiss3d::post_processing::Tonemap;
use kiss3d::window::Window;
use std::any::Any;
use std::{env, panic};
use unisize_pictures::palette;

/// A hint for error messages.
const WITHOUT: &str = "examples/viewer/README.md explains how to run without a display.";

/// Opens a window of this size in pixels.
///
/// # Errors
/// If there is no display, or no graphics adapter that can draw on it.
pub(crate) fn open([width, height]: [u32; 2]) -> Result<Window> {
    ensure!(
        has_display(),
        "there is no display: neither DISPLAY nor WAYLAND_DISPLAY is set. {WITHOUT}"
    );
    // kiss3d panics where there is nothing to draw with; the error below says so without a backtrace.
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    let window = panic::catch_unwind(|| {
        pollster::block_on(Window::new_with_size("unisize: scenes", width, height))
    });
    panic::set_hook(hook);
    let mut window = window.map_err(|panic| {
        anyhow!(
            "there is no graphics adapter for Vulkan, Metal, DirectX 12 or OpenGL to draw with ({}). {WITHOUT}",
            text_of(&*panic)
        )
    })?;
    window.set_background_color(crate::figures::shown(palette::HORIZON));
    window.set_shadows_enabled(false);
    // Exact colours.
    window.set_tonemap(Tonemap::None);
    Ok(window)
}

/// Whether there may be a display, as far as the environment tells.
fn has_display() -> bool {
    let is_set = |name| env::var_os(name).is_some_and(|value| !value.is_empty());
    let needs_variable = cfg!(all(unix, not(target_os = "macos")));
    !needs_variable
        || ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"]
            .into_iter()
            .any(is_set)
}

fn text_of(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or(panic.downcast_ref::<&str>().copied())
        .unwrap_or("the window could not be opened")
}
