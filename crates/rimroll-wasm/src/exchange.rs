//! The buffers through which page and core exchange numbers and text.

use core::cell::RefCell;
use rimroll::InvalidInput;

/// The buffers between a call and the reading of its results.
#[derive(Default)]
struct Exchange {
    arguments: Vec<f64>,
    numbers: Vec<f64>,
    text: String,
}

thread_local! {
    static EXCHANGE: RefCell<Exchange> = RefCell::default();
}

/// The address at which the page must write its next `count` arguments.
#[unsafe(no_mangle)]
pub extern "C" fn arguments(count: usize) -> *mut f64 {
    EXCHANGE.with_borrow_mut(|exchange| {
        exchange.arguments.clear();
        exchange.arguments.resize(count, f64::NAN);
        exchange.arguments.as_mut_ptr()
    })
}

/// The address of the numbers of the last result.
#[unsafe(no_mangle)]
pub extern "C" fn numbers() -> *const f64 {
    EXCHANGE.with_borrow(|exchange| exchange.numbers.as_ptr())
}

/// The count of these numbers.
#[unsafe(no_mangle)]
pub extern "C" fn number_count() -> usize {
    EXCHANGE.with_borrow(|exchange| exchange.numbers.len())
}

/// The address of the text of the last result, in UTF-8.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    EXCHANGE.with_borrow(|exchange| exchange.text.as_ptr())
}

/// The length of this text in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn text_length() -> usize {
    EXCHANGE.with_borrow(|exchange| exchange.text.len())
}

/// The arguments of the current call.
pub fn given_arguments() -> Vec<f64> {
    EXCHANGE.with_borrow_mut(|exchange| core::mem::take(&mut exchange.arguments))
}

/// Provides numbers to the page.
pub fn answer(numbers: impl IntoIterator<Item = f64>) {
    EXCHANGE.with_borrow_mut(|exchange| {
        exchange.numbers.clear();
        exchange.numbers.extend(numbers);
    });
}

/// Provides text to the page.
pub fn say(words: &str) {
    EXCHANGE.with_borrow_mut(|exchange| {
        exchange.text.clear();
        exchange.text.push_str(words);
    });
}

/// Provides names to the page, separated by spaces.
pub fn name(names: impl IntoIterator<Item = &'static str>) {
    say(&names.into_iter().collect::<Vec<_>>().join(" "));
}

/// The value, or `None` with the core's error message as the text.
pub fn unless_refused<T>(result: Result<T, InvalidInput>) -> Option<T> {
    result.map_err(|refusal| say(&refusal.to_string())).ok()
}
