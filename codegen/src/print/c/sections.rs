//! Sections of a long routine in C.
//!
//! In: the [`Work`](crate::schedule::Work) of a routine. Out: a private function for each section, and the calls.

use std::fmt::Write;
use std::mem;

use super::body::CWriter;
use super::declarations::number;
use crate::print::expression::{Spelling, subscript};
use crate::print::walk::walk;
use crate::schedule::{Cells, Routine};

/// Macro that prevents inlining.
pub(super) fn no_inline_macro(name: &str) -> String {
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

impl CWriter<'_> {
    /// Definitions of the functions, which `own` names; the calls are appended to the text of the writer.
    pub(super) fn sections(
        &mut self,
        routine: &Routine,
        own: &mut dyn FnMut(&str) -> String,
    ) -> String {
        let Some(work) = &routine.work else {
            return String::new();
        };
        let (number, no_inline) = (number(self.real), self.options.no_inline());
        self.line(&format!("{number} {}[{}];", work.name, work.len));
        for (place, value) in &work.initial {
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
            for (place, name) in &section.loads {
                let value = self.place(*place);
                self.constant(name, &value);
            }
            walk(self, &section.statements);
            let body = mem::take(&mut self.text);
            // Writing to a string cannot fail.
            let _ = writeln!(
                definitions,
                "\nHOMOGEN_FN HOMOGEN_CLONES static {no_inline} void {name}({number} {}[{}])\n{{\n{body}}}",
                work.name, work.len
            );
        }
        self.text = caller;
        definitions
    }

    /// `columns[3][column]` or `work[7 + column]`.
    pub(super) fn cell(&self, row: &Cells, column: &str) -> String {
        match row {
            Cells::Table(table, row) => format!("{table}[{row}][{column}]"),
            Cells::Work(first) => format!(
                "{}[{}]",
                self.work,
                subscript(*first, &[(1, &column.to_owned())])
            ),
        }
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
