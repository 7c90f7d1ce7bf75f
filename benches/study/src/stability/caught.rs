//! Expected panics: caught and returned, without a trace on standard error.

use std::any::Any;
use std::cell::{Cell, RefCell};
use std::panic::{AssertUnwindSafe, Location, catch_unwind, set_hook, take_hook};
use std::sync::Once;

thread_local! {
    static IS_QUIET: Cell<bool> = const { Cell::new(false) };
    /// Where the last panic was.
    static PLACE: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Runs a function that may panic. The error is the message of the panic and its place.
pub(crate) fn caught<T>(run: impl FnOnce() -> T) -> Result<T, String> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let usual = take_hook();
        set_hook(Box::new(move |info| {
            if IS_QUIET.get() {
                PLACE.set(info.location().map(place).unwrap_or_default());
            } else {
                usual(info);
            }
        }));
    });
    let before = IS_QUIET.replace(true);
    let result = catch_unwind(AssertUnwindSafe(run));
    IS_QUIET.set(before);
    result.map_err(|panic| format!("{} ({})", message(&*panic), PLACE.take()))
}

fn message(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
    text.unwrap_or("no message").to_owned()
}

fn place(location: &Location<'_>) -> String {
    // The folders differ from one machine to the next.
    let file = location.file().rsplit(['/', '\\']).next();
    format!("{}:{}", file.unwrap_or_default(), location.line())
}

#[cfg(test)]
mod tests {
    use super::caught;

    #[test]
    fn a_panic_is_told() {
        assert_eq!(caught(|| 1), Ok(1));
        let message = "so and so".to_owned();
        let told = caught(|| panic!("{message}")).unwrap_err();
        assert!(told.starts_with("so and so ("), "{told}");
        assert!(told.contains("(caught.rs:"), "{told}");
        assert!(caught(|| panic!("so")).unwrap_err().starts_with("so ("));
    }
}
