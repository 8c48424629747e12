//! How functions are computed, among ways that differ in speed and rounding alone.
//!
//! A shared noun: a choice for each part, and the words that say it in attributes, in build scripts
//! and on the command line. It never knows what a choice is good for.

use crate::wording::{known, list, quoted};

/// One choice for each part; by default what the engine chooses.
///
/// ```
/// use homogen_codegen::formulation::{Formulation, Forward, Parameters};
///
/// let formulation = Formulation {
///     parameters: Parameters::Raw,
///     forward: Some(Forward::MassMatrix { refinements: 1 }),
///     ..Formulation::default()
/// };
/// assert_eq!(formulation.words(), ["raw", "refined = 1"]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Formulation {
    /// The frame in which the recursions run.
    pub frame: Frame,
    /// The inertial parameters that dynamics starts from.
    pub parameters: Parameters,
    /// How accelerations are found from forces, and the inverse of the mass matrix; where none is
    /// chosen, by what is cheapest of what was measured to be accurate enough.
    pub forward: Option<Forward>,
    /// Whether the angles of parallel axes are summed.
    pub angles: Angles,
    /// Whether a product and a sum are rounded once.
    pub products: Products,
    /// Where sines and cosines come from.
    pub sines: Sines,
}

/// The frame in which the recursions run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Frame {
    /// That of each link: the least work, and no digit lost far from the base.
    #[default]
    Link,
    /// Frame 0, in which the paper writes every sum.
    Base,
}

/// Which inertial parameters dynamics starts from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Parameters {
    /// Base parameters: mass that no joint can feel is counted on the other side of it.
    #[default]
    Regrouped,
    /// Those of the description.
    Raw,
}

/// How accelerations are found from forces: by forward dynamics, and as the inverse of the mass matrix,
/// each column of which is the acceleration by a unit force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Forward {
    /// By the mass matrix and its factors.
    MassMatrix {
        /// How often the result is refined, with the inverse dynamics as the residual; at most
        /// twice.
        refinements: usize,
    },
    /// By the articulated-body recursion, which takes the parameters of the description.
    Articulated,
}

impl Forward {
    /// By the mass matrix and its factors, as they come out.
    pub const UNREFINED: Self = Self::MassMatrix { refinements: 0 };
}

/// What becomes of the angles of joints that follow each other with parallel axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Angles {
    /// Each has its sine and cosine, and a function is as accurate at any number of turns.
    #[default]
    Apart,
    /// They are summed first where that is cheaper. It costs the digits that a sum of large angles
    /// has no room for: an error of the angle of up to u |q|, which nobody sees within a few turns.
    /// The frame of a link that carries none but such joints keeps the axes of the link before it.
    Merged,
}

/// Whether a product and a sum become one operation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Products {
    /// Rounded once where the target can, and where nothing that must cancel is spoilt.
    #[default]
    Fused,
    /// Rounded each for itself, on every target.
    Unfused,
}

/// Where sines and cosines come from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sines {
    /// Our own, all at once: those of `Scalar::sin_cos_all`; those that a file for `core` alone
    /// brings along or is given.
    #[default]
    Own,
    /// The platform's, one by one: those of `Scalar::sin_cos`, which are the standard library's or
    /// `libm`'s; `libm`'s in a file for `core` alone that is given none.
    Platform,
}

/// Why a formulation is none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// What is wrong, as a sentence without a full stop.
    pub message: String,
    /// What could be said instead.
    pub hint: String,
}

/// A choice for one part.
#[derive(Clone, Copy, Debug)]
enum Choice {
    Frame(Frame),
    Parameters(Parameters),
    Forward(Forward),
    Angles(Angles),
    Products(Products),
    Sines(Sines),
}

/// The words, each with the value that it needs and what it chooses.
#[rustfmt::skip]
const WORDS: [(&str, Option<&str>, Choice); 14] = [
    ("link_frames",    None,      Choice::Frame(Frame::Link)),
    ("frame_0",        None,      Choice::Frame(Frame::Base)),
    ("regrouped",      None,      Choice::Parameters(Parameters::Regrouped)),
    ("raw",            None,      Choice::Parameters(Parameters::Raw)),
    ("refined",        Some("0"), Choice::Forward(Forward::UNREFINED)),
    ("refined",        Some("1"), Choice::Forward(Forward::MassMatrix { refinements: 1 })),
    ("refined",        Some("2"), Choice::Forward(Forward::MassMatrix { refinements: 2 })),
    ("articulated",    None,      Choice::Forward(Forward::Articulated)),
    ("apart",          None,      Choice::Angles(Angles::Apart)),
    ("merged",         None,      Choice::Angles(Angles::Merged)),
    ("fused",          None,      Choice::Products(Products::Fused)),
    ("unfused",        None,      Choice::Products(Products::Unfused)),
    ("own_sines",      None,      Choice::Sines(Sines::Own)),
    ("platform_sines", None,      Choice::Sines(Sines::Platform)),
];

/// The words, each once.
pub(crate) fn words() -> Vec<&'static str> {
    let mut words: Vec<&str> = WORDS.iter().map(|(word, ..)| *word).collect();
    words.dedup();
    words
}

impl Formulation {
    /// What differs from the default, in the words of attributes.
    #[must_use]
    pub fn words(&self) -> Vec<String> {
        let chosen = WORDS
            .iter()
            .filter(|(.., choice)| choice.is_made_in(self) && !choice.is_made_in(&Self::default()));
        chosen.map(|(word, value, _)| said(word, *value)).collect()
    }

    /// Whether all choices can be had together.
    ///
    /// # Errors
    /// Where there is no such way.
    pub fn check(&self) -> Result<(), Refusal> {
        match (self.forward, self.frame) {
            (Some(Forward::Articulated), Frame::Base) => Err(Refusal {
                message: "\"articulated\" contradicts \"frame_0\"".to_owned(),
                hint: "articulated bodies are carried in the frames of the links".to_owned(),
            }),
            (Some(Forward::MassMatrix { refinements: 3.. }), _) => Err(Refusal {
                message: "more than two refinements gain nothing".to_owned(),
                hint: values("refined"),
            }),
            _ => Ok(()),
        }
    }
}

impl Choice {
    fn make_in(self, formulation: &mut Formulation) {
        match self {
            Self::Frame(frame) => formulation.frame = frame,
            Self::Parameters(parameters) => formulation.parameters = parameters,
            Self::Forward(forward) => formulation.forward = Some(forward),
            Self::Angles(angles) => formulation.angles = angles,
            Self::Products(products) => formulation.products = products,
            Self::Sines(sines) => formulation.sines = sines,
        }
    }

    fn is_made_in(self, formulation: &Formulation) -> bool {
        let mut made = *formulation;
        self.make_in(&mut made);
        made == *formulation
    }

    fn is_of_the_part_of(self, other: Self) -> bool {
        std::mem::discriminant(&self) == std::mem::discriminant(&other)
    }
}

/// A formulation as far as it has been said.
#[derive(Default)]
#[doc(hidden)]
pub struct Reader {
    formulation: Formulation,
    made: Vec<(String, Choice)>,
}

impl Reader {
    /// Takes a word, and the value given with it.
    ///
    /// # Errors
    /// Of a word that is none, or comes twice.
    pub fn take(&mut self, word: &str, value: Option<&str>) -> Result<(), Refusal> {
        let rows = || WORDS.iter().filter(|(known, ..)| *known == word);
        if rows().next().is_none() {
            let mut words: Vec<&str> = WORDS.iter().map(|(word, ..)| *word).collect();
            words.dedup();
            return Err(Refusal {
                message: format!("unknown word {}", quoted(word)),
                hint: known(word, "words", &words),
            });
        }
        let Some((.., choice)) = rows().find(|(_, needed, _)| *needed == value) else {
            let needs = rows().any(|(_, needed, _)| needed.is_some());
            let what = if needs {
                "needs a number of refinements"
            } else {
                "takes no value"
            };
            return Err(Refusal {
                message: format!("{} {what}", quoted(word)),
                hint: values(word),
            });
        };
        let said = said(word, value);
        let mut made = self.made.iter();
        if let Some((before, _)) = made.find(|(_, other)| other.is_of_the_part_of(*choice)) {
            return Err(Refusal {
                message: if *before == said {
                    format!("{} is said twice", quoted(&said))
                } else {
                    format!("{} contradicts {}", quoted(&said), quoted(before))
                },
                hint: "leave one of them out".to_owned(),
            });
        }
        choice.make_in(&mut self.formulation);
        self.made.push((said, *choice));
        self.formulation.check()
    }

    /// What all the words say together.
    #[must_use]
    pub fn formulation(self) -> Formulation {
        self.formulation
    }
}

fn said(word: &str, value: Option<&str>) -> String {
    value.map_or_else(|| word.to_owned(), |value| format!("{word} = {value}"))
}

/// `write refined = 0, refined = 1 or …`.
fn values(word: &str) -> String {
    let rows = WORDS.iter().filter(|(known, ..)| *known == word);
    let all: Vec<String> = rows.map(|(word, value, _)| said(word, *value)).collect();
    format!(
        "write {}",
        list(all.iter().map(String::as_str)).replace(" and ", " or ")
    )
}

#[cfg(test)]
mod tests {
    use super::{Angles, Formulation, Forward, Frame, Parameters, Products, Reader, Sines};

    /// What some words say, or why not.
    fn read(words: &[(&str, Option<&str>)]) -> Result<Formulation, String> {
        let mut reader = Reader::default();
        for (word, value) in words {
            reader
                .take(word, *value)
                .map_err(|refusal| format!("{} ({})", refusal.message, refusal.hint))?;
        }
        Ok(reader.formulation())
    }

    #[test]
    fn every_part_is_said_and_told_again() {
        let all = Formulation {
            frame: Frame::Base,
            parameters: Parameters::Raw,
            forward: Some(Forward::MassMatrix { refinements: 2 }),
            angles: Angles::Merged,
            products: Products::Unfused,
            sines: Sines::Platform,
        };
        let said = [
            ("frame_0", None),
            ("raw", None),
            ("refined", Some("2")),
            ("merged", None),
            ("unfused", None),
            ("platform_sines", None),
        ];
        assert_eq!(read(&said), Ok(all));
        assert_eq!(
            all.words(),
            [
                "frame_0",
                "raw",
                "refined = 2",
                "merged",
                "unfused",
                "platform_sines"
            ]
        );
        let defaults = [("fused", None), ("own_sines", None), ("regrouped", None)];
        assert_eq!(read(&defaults), Ok(Formulation::default()));
        assert!(Formulation::default().words().is_empty());
    }

    #[test]
    fn what_is_no_formulation_is_told() {
        for (words, refusal) in [
            (
                vec![("row", None)],
                "unknown word \"row\" (did you mean \"raw\"? known words: link_frames, frame_0, \
                 regrouped, raw, refined, articulated, apart, merged, fused, unfused, own_sines \
                 and platform_sines)",
            ),
            (
                vec![("raw", Some("1"))],
                "\"raw\" takes no value (write raw)",
            ),
            (
                vec![("refined", None)],
                "\"refined\" needs a number of refinements \
                 (write refined = 0, refined = 1 or refined = 2)",
            ),
            (
                vec![("refined", Some("3"))],
                "\"refined\" needs a number of refinements \
                 (write refined = 0, refined = 1 or refined = 2)",
            ),
            (
                vec![("articulated", None), ("refined", Some("1"))],
                "\"refined = 1\" contradicts \"articulated\" (leave one of them out)",
            ),
            (
                vec![("articulated", None), ("frame_0", None)],
                "\"articulated\" contradicts \"frame_0\" \
                 (articulated bodies are carried in the frames of the links)",
            ),
            (
                vec![("raw", None), ("raw", None)],
                "\"raw\" is said twice (leave one of them out)",
            ),
        ] {
            assert_eq!(read(&words), Err(refusal.to_owned()));
        }
    }

    #[test]
    fn refinements_without_end_are_refused() {
        let forward = Some(Forward::MassMatrix { refinements: 9 });
        let formulation = Formulation {
            forward,
            ..Formulation::default()
        };
        assert!(formulation.check().is_err());
    }
}
