//! The window of the system.

use anyhow::{Result, anyhow};
use kiss3d::window::Window;
use std::any::Any;
use std::panic;
use unisize_pictures::palette;

/// Opens a window of so many pixels.
///
/// # Errors
/// If there is no display, or no graphics adapter that can draw on it.
pub(crate) fn open([width, height]: [u32; 2]) -> Result<Window> {
    // The library ends with a panic where there is nothing to draw with, which is no news worth a backtrace.
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    let window = panic::catch_unwind(|| {
        pollster::block_on(Window::new_with_size("unisize: scenes", width, height))
    });
    panic::set_hook(hook);
    let mut window = window.map_err(|panic| {
        anyhow!(
            "there is nothing to draw with: {}.\n\
             A display is needed, and a graphics adapter for Vulkan, Metal, DirectX 12 or OpenGL. How Debian does without \
             both is said in the README of the viewer.",
            text_of(&*panic)
        )
    })?;
    window.set_background_color(crate::figures::shown(palette::HORIZON));
    window.set_shadows_enabled(false);
    Ok(window)
}

fn text_of(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or(panic.downcast_ref::<&str>().copied())
        .unwrap_or("the window could not be opened")
}
