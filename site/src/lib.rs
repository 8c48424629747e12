//! The engine as a WebAssembly module without imports.
//!
//! A page writes bytes to memory from [`allocate`], and passes them on: a file by [`take`], a request in JSON by
//! [`answer`]. The answer is JSON as well, at [`text`], of the length that `answer` returned, until the next call.
//! `homogen_page::session` documents requests and answers.

use std::cell::RefCell;

use homogen_page::session::Session;

/// The open robot, the bytes that come in, and the last answer.
#[derive(Default)]
struct State {
    session: Session,
    input: Vec<u8>,
    answer: String,
}

thread_local! {
    /// The only one: the module has one thread.
    static STATE: RefCell<State> = RefCell::default();
}

/// Address of memory for `length` bytes of input, until the next call of [`take`] or [`answer`].
#[expect(unsafe_code, reason = "the name of an exported function")]
#[unsafe(no_mangle)]
pub extern "C" fn allocate(length: usize) -> *mut u8 {
    STATE.with_borrow_mut(|state| {
        state.input = vec![0; length];
        state.input.as_mut_ptr()
    })
}

/// Takes the input as the file of the next robot.
#[expect(unsafe_code, reason = "the name of an exported function")]
#[unsafe(no_mangle)]
pub extern "C" fn take() {
    STATE.with_borrow_mut(|state| state.session.take(std::mem::take(&mut state.input)));
}

/// Answers the input, a request in JSON. Returns the number of bytes of the answer.
#[expect(unsafe_code, reason = "the name of an exported function")]
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> usize {
    STATE.with_borrow_mut(|state| {
        let request = std::mem::take(&mut state.input);
        state.answer = state.session.answer(&String::from_utf8_lossy(&request));
        state.answer.len()
    })
}

/// Address of the last answer, in UTF-8.
#[expect(unsafe_code, reason = "the name of an exported function")]
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    STATE.with_borrow(|state| state.answer.as_ptr())
}
