//! Where page and core leave each other numbers and words.

use core::cell::RefCell;
use rimroll::InvalidInput;

/// What lies between a call and the reading of its answer.
#[derive(Default)]
struct Exchange {
    arguments: Vec<f64>,
    numbers: Vec<f64>,
    text: String,
}

thread_local! {
    static EXCHANGE: RefCell<Exchange> = RefCell::default();
}

/// Where the page is to write its next `count` arguments.
#[unsafe(no_mangle)]
pub extern "C" fn arguments(count: usize) -> *mut f64 {
    EXCHANGE.with_borrow_mut(|exchange| {
        exchange.arguments.clear();
        exchange.arguments.resize(count, f64::NAN);
        exchange.arguments.as_mut_ptr()
    })
}

/// Where the numbers of the last answer are.
#[unsafe(no_mangle)]
pub extern "C" fn numbers() -> *const f64 {
    EXCHANGE.with_borrow(|exchange| exchange.numbers.as_ptr())
}

/// How many they are.
#[unsafe(no_mangle)]
pub extern "C" fn number_count() -> usize {
    EXCHANGE.with_borrow(|exchange| exchange.numbers.len())
}

/// Where the words of the last answer are, in UTF-8.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    EXCHANGE.with_borrow(|exchange| exchange.text.as_ptr())
}

/// How many bytes they have.
#[unsafe(no_mangle)]
pub extern "C" fn text_length() -> usize {
    EXCHANGE.with_borrow(|exchange| exchange.text.len())
}

/// The arguments of the call that is being answered.
pub fn asked() -> Vec<f64> {
    EXCHANGE.with_borrow_mut(|exchange| core::mem::take(&mut exchange.arguments))
}

/// Leaves numbers for the page.
pub fn answer(numbers: impl IntoIterator<Item = f64>) {
    EXCHANGE.with_borrow_mut(|exchange| {
        exchange.numbers.clear();
        exchange.numbers.extend(numbers);
    });
}

/// Leaves words for the page.
pub fn say(words: &str) {
    EXCHANGE.with_borrow_mut(|exchange| {
        exchange.text.clear();
        exchange.text.push_str(words);
    });
}

/// Leaves names for the page, one space between them.
pub fn name(names: impl IntoIterator<Item = &'static str>) {
    say(&names.into_iter().collect::<Vec<_>>().join(" "));
}

/// What was asked for, or nothing and the core's refusal in words.
pub fn unless_refused<T>(result: Result<T, InvalidInput>) -> Option<T> {
    result.map_err(|refusal| say(&refusal.to_string())).ok()
}
