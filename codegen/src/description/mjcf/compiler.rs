//! `<compiler>` and `<option>`: settings of the reader, and gravity.
//!
//! Both elements may occur several times, in the file and in included files. A later one replaces an earlier one,
//! attribute by attribute.

use super::element::Element;
use super::elements::GLOBAL;
use super::reading::Mjcf;
use super::settings::{Conflict, FromGeoms};

impl<'a> Mjcf<'a> {
    /// Reads one `<compiler>`; its attributes replace earlier ones of the current model.
    pub(super) fn read_compiler(&mut self, element: Element<'a>) {
        const SUBJECT: &str = "the compiler";
        let attribute = |name: &str| element.attribute(name);
        let mut compiler = self.model().compiler.clone();
        let words = [("degree", true), ("radian", false)];
        compiler.degrees = self.choice(attribute("angle"), &words, compiler.degrees, SUBJECT);
        compiler.autolimits = self.flag(attribute("autolimits"), compiler.autolimits, SUBJECT);
        compiler.strip = self.flag(attribute("strippath"), compiler.strip, SUBJECT);
        compiler.balance = self.flag(attribute("balanceinertia"), compiler.balance, SUBJECT);
        compiler.fit_extents = self.flag(attribute("fitaabb"), compiler.fit_extents, SUBJECT);
        compiler.align_free = self.flag(attribute("alignfree"), compiler.align_free, SUBJECT);
        let words = [
            ("false", FromGeoms::Never),
            ("true", FromGeoms::Always),
            ("auto", FromGeoms::Otherwise),
        ];
        compiler.from_geoms = self.choice(
            attribute("inertiafromgeom"),
            &words,
            compiler.from_geoms,
            SUBJECT,
        );
        let words = [
            ("warning", Conflict::Warning),
            ("merge", Conflict::Merge),
            ("error", Conflict::Error),
        ];
        compiler.conflict = self.choice(attribute("conflict"), &words, compiler.conflict, SUBJECT);
        if self.choice(
            attribute("coordinate"),
            &[("local", false), ("global", true)],
            false,
            SUBJECT,
        ) {
            let hint = "convert the file by MuJoCo 2.3.3, which reads and saves it";
            self.refuse(element, GLOBAL.to_owned(), hint);
        }
        if let Some(range) = self.numbers::<2>(attribute("inertiagrouprange"), SUBJECT) {
            compiler.groups = range.map(|group| group.value);
        }
        if let Some(bound) = self.number(attribute("boundmass"), SUBJECT) {
            compiler.bound_mass = bound.exact();
        }
        if let Some(bound) = self.number(attribute("boundinertia"), SUBJECT) {
            compiler.bound_inertia = bound.exact();
        }
        if let Some(total) = self.number(attribute("settotalmass"), SUBJECT) {
            compiler.total_mass = Some(total).filter(|total| total.value > 0.0);
        }
        for name in ["assetdir", "meshdir"] {
            if let Some(written) = attribute(name) {
                compiler.meshes = self.word(written).text;
            }
        }
        if let Some(written) = attribute("eulerseq") {
            let word = self.word(written);
            let letters: Vec<char> = word.text.chars().collect();
            match <[char; 3]>::try_from(letters) {
                Ok(letters) if letters.iter().all(|letter| "xyzXYZ".contains(*letter)) => {
                    compiler.euler = letters;
                }
                _ => self.reader.errors.push_with_hint(
                    word.place,
                    format!("eulerseq of {SUBJECT} is not three letters: {}", word.text),
                    "write x, y and z for axes that rotate with the frame, X, Y and Z for fixed axes",
                ),
            }
        }
        self.model_mut().compiler = compiler;
    }

    /// Reads gravity from one `<option>`; it replaces an earlier one.
    pub(super) fn read_option(&mut self, element: Element<'a>) {
        let written = self.numbers::<3>(element.attribute("gravity"), "the option");
        let mut gravity = self.model().gravity;
        gravity.written = written.or(gravity.written);
        for flag in element.named("flag") {
            if let Some(written) = flag.attribute("gravity") {
                let words = [("enable", false), ("disable", true)];
                let is_off = self.choice(Some(written), &words, false, "the <flag>");
                gravity.is_off = Some((is_off, self.place(flag)));
            }
        }
        self.model_mut().gravity = gravity;
    }
}
