//! `<compiler>` and `<option>`: settings of the reader, and gravity.
//!
//! Both elements may occur several times, in the file and in included files. A later one replaces an earlier one,
//! attribute by attribute.

use super::element::Element;
use super::elements::GLOBAL;
use super::reading::Mjcf;
use super::settings::FromGeoms;
use crate::description::{Number, number};

impl<'a> Mjcf<'a> {
    /// Reads one `<compiler>`; its attributes replace earlier ones.
    pub(super) fn read_compiler(&mut self, element: Element<'a>) {
        const SUBJECT: &str = "the compiler";
        let attribute = |name: &str| element.attribute(name);
        let compiler = &self.compiler;
        let (degrees, autolimits, strip) = (compiler.degrees, compiler.autolimits, compiler.strip);
        let (balance, fit, align) = (compiler.balance, compiler.fit_extents, compiler.align_free);
        let from_geoms = compiler.from_geoms;
        let words = [("degree", true), ("radian", false)];
        self.compiler.degrees = self.choice(attribute("angle"), &words, degrees, SUBJECT);
        self.compiler.autolimits = self.flag(attribute("autolimits"), autolimits, SUBJECT);
        self.compiler.strip = self.flag(attribute("strippath"), strip, SUBJECT);
        self.compiler.balance = self.flag(attribute("balanceinertia"), balance, SUBJECT);
        self.compiler.fit_extents = self.flag(attribute("fitaabb"), fit, SUBJECT);
        self.compiler.align_free = self.flag(attribute("alignfree"), align, SUBJECT);
        let words = [
            ("false", FromGeoms::Never),
            ("true", FromGeoms::Always),
            ("auto", FromGeoms::Otherwise),
        ];
        self.compiler.from_geoms =
            self.choice(attribute("inertiafromgeom"), &words, from_geoms, SUBJECT);
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
            self.compiler.groups = range.map(|group| group.value);
        }
        if let Some(bound) = self.number(attribute("boundmass"), SUBJECT) {
            self.compiler.bound_mass = bound.exact();
        }
        if let Some(bound) = self.number(attribute("boundinertia"), SUBJECT) {
            self.compiler.bound_inertia = bound.exact();
        }
        if let Some(total) = self.number(attribute("settotalmass"), SUBJECT) {
            self.compiler.total_mass = Some(total).filter(|total| total.value > 0.0);
        }
        for name in ["assetdir", "meshdir"] {
            if let Some(written) = attribute(name) {
                self.compiler.meshes = self.word(written).text;
            }
        }
        if let Some(written) = attribute("eulerseq") {
            let word = self.word(written);
            let letters: Vec<char> = word.text.chars().collect();
            match <[char; 3]>::try_from(letters) {
                Ok(letters) if letters.iter().all(|letter| "xyzXYZ".contains(*letter)) => {
                    self.compiler.euler = letters;
                }
                _ => self.reader.errors.push_with_hint(
                    word.place,
                    format!("eulerseq of {SUBJECT} is not three letters: {}", word.text),
                    "write x, y and z for axes that rotate with the frame, X, Y and Z for fixed axes",
                ),
            }
        }
    }

    /// Reads gravity from one `<option>`; it replaces an earlier one.
    pub(super) fn read_option(&mut self, element: Element<'a>, gravity: &mut Option<[Number; 3]>) {
        let written = self.numbers::<3>(element.attribute("gravity"), "the option");
        *gravity = written.or(*gravity);
        for flag in element.named("flag") {
            let words = [("enable", true), ("disable", false)];
            if !self.choice(flag.attribute("gravity"), &words, true, "the <flag>") {
                let place = self.place(flag);
                *gravity = Some([0.0; 3].map(|zero| number::computed(zero, place)));
            }
        }
    }
}
