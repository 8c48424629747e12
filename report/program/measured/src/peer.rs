//! Functions of other programs, one call a state.
//!
//! In: the maker, the type of number, a symbol and a library. Out: a [`Case`] for comparison with ours.

use std::cell::RefCell;
use std::error::Error;
use std::ops::Range;
use std::rc::Rc;

use homogen::Scalar;

use crate::case::Case;
use crate::entries::Entries;
use crate::library::Foreign;
use crate::truth::Truths;

/// A function with its arguments.
struct Peer<T> {
    function: Foreign<T>,
    states: Vec<T>,
    /// The ranges of the arguments in a state.
    places: [Range<usize>; 3],
    result: RefCell<Vec<T>>,
}

/// The program by MAKER, TYPE, SYMBOL and LIBRARY, for one of our functions.
pub fn load(what: &[String; 4], function: &str, truths: &Truths) -> Result<Case, Box<dyn Error>> {
    match &*what[1] {
        "f64" => load_of::<f64>(what, "f64", function, truths),
        "f32" => load_of::<f32>(what, "f32", function, truths),
        other => Err(format!("no type {other}").into()),
    }
}

fn load_of<T: Scalar + Entries + 'static>(
    [maker, _, symbol, path]: &[String; 4],
    scalar: &'static str,
    function: &str,
    truths: &Truths,
) -> Result<Case, Box<dyn Error>> {
    let truth = truths.of(scalar);
    let peer = Rc::new(Peer {
        function: Foreign::load(path, symbol)?,
        states: truth.arguments().iter().map(|x| T::constant(*x)).collect(),
        places: truth.places(function),
        result: RefCell::new(vec![T::constant(0.0); truth.entries()]),
    });
    // Users of Pinocchio read results in place: copies are not part of its time.
    let copies = maker != "pinocchio";
    let length = truth.length();
    let same = Rc::clone(&peer);
    Ok(Case {
        name: format!("{maker}/{symbol}"),
        scalar,
        batch: Box::new(move || {
            for state in peer.states.chunks_exact(length) {
                peer.call(state, copies);
            }
        }),
        results: Box::new(move |state| {
            same.call(&same.states[state * length..][..length], true);
            let mut numbers = Vec::new();
            for entry in &*same.result.borrow() {
                entry.push(&mut numbers);
            }
            numbers
        }),
        entries: Vec::new(),
    })
}

impl<T> Peer<T> {
    fn call(&self, state: &[T], copies: bool) {
        let arguments = self.places.each_ref().map(|place| &state[place.clone()]);
        let mut result = self.result.borrow_mut();
        self.function
            .call(arguments, copies.then(|| result.as_mut_slice()));
    }
}
