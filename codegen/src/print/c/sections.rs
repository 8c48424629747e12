//! The functions of their own that a long routine consists of.
//!
//! In: the [`Work`](crate::schedule::Work) of a routine. Out: a function of the file alone for each section,
//! and the calls. It never says where to cut.

use std::fmt::Write;
use std::mem;

use super::body::Writer;
use super::declarations::number;
use crate::print::walk::walk;
use crate::schedule::Routine;

/// The macro that keeps compilers from putting a function into the one that calls it.
pub(super) fn apart(name: &str) -> String {
    format!(
        "
/* Compiled by itself: that is what the function is there for. */
#if defined(__GNUC__)
#define {name} __attribute__((noinline))
#elif defined(_MSC_VER)
#define {name} __declspec(noinline)
#else
#define {name}
#endif
"
    )
}

impl Writer<'_> {
    /// The definitions of the functions, which `own` gives names; the calls are written where the writer stands.
    pub(super) fn sections(
        &mut self,
        routine: &Routine,
        own: &mut dyn FnMut(&str) -> String,
    ) -> String {
        let Some(work) = &routine.work else {
            return String::new();
        };
        let (number, apart) = (number(self.real), self.writing.apart());
        self.line(&format!("{number} {}[{}];", work.name, work.len));
        for (place, value) in &work.given {
            let value = self.read(value);
            self.put_at(*place, &value);
        }
        let names: Vec<String> = (work.sections.iter())
            .map(|section| own(&section.name))
            .collect();
        for name in &names {
            self.line(&format!("{name}({});", work.name));
        }
        let caller = mem::take(&mut self.text);
        let mut definitions = String::new();
        for (section, name) in work.sections.iter().zip(names) {
            for (place, name) in &section.taken {
                let value = self.place(*place);
                self.constant(name, &value);
            }
            walk(self, &section.statements);
            let body = mem::take(&mut self.text);
            // Writing to a string cannot fail.
            let _ = writeln!(
                definitions,
                "\nHOMOGEN_FN static {apart} void {name}({number} {}[{}])\n{{\n{body}}}",
                work.name, work.len
            );
        }
        self.text = caller;
        definitions
    }

    /// `work[3]`.
    pub(super) fn place(&self, place: usize) -> String {
        format!("{}[{place}]", self.work)
    }

    /// `work[3] = a;`.
    pub(super) fn put_at(&mut self, place: usize, value: &str) {
        let place = self.place(place);
        self.line(&format!("{place} = {value};"));
    }
}
