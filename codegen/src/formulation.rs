//! Formulations: algorithms and frames for the same function, which differ in operation count and rounding.
//!
//! A [`Formulation`] has a choice for each part. The words for the choices are the same in attributes, in build scripts
//! and on the command line.

use crate::wording::{known, list, quoted};

/// A choice for each part; the default is the engine's choice.
///
/// ```
/// use homogen_codegen::formulation::{Formulation, Forward, Parameters};
///
/// let formulation = Formulation::default()
///     .with_parameters(Parameters::Raw)
///     .with_forward(Forward::MassMatrix { refinements: 1 });
/// assert_eq!(formulation.words(), ["raw", "refined = 1"]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Formulation {
    /// Frame of the recursions.
    pub frame: Frame,
    /// Inertial parameters that dynamics starts from.
    pub parameters: Parameters,
    /// Algorithm for accelerations and for the inverse of the mass matrix; `None` for the cheapest of those that are
    /// accurate enough by measurement.
    pub forward: Option<Forward>,
    /// Treatment of the angles of parallel axes.
    pub angles: Angles,
    /// Rounding of products in sums.
    pub products: Products,
    /// Source of sines and cosines.
    pub sines: Sines,
}

/// Frame of the recursions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Frame {
    /// The frame of each link: the fewest operations, and no loss of accuracy far from the base.
    #[default]
    Link,
    /// Frame 0, in which the paper writes every sum.
    Base,
}

/// Inertial parameters that dynamics starts from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Parameters {
    /// Base parameters: mass that does not load a joint is moved to its inboard side.
    #[default]
    Regrouped,
    /// Parameters of the description.
    Raw,
}

/// Algorithm for forward dynamics and for the inverse of the mass matrix, whose columns are accelerations by unit
/// forces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Forward {
    /// Factorisation of the mass matrix.
    MassMatrix {
        /// Number of refinements with the inverse dynamics as residual; at most two.
        refinements: usize,
    },
    /// Articulated-body recursion, with the parameters of the description.
    Articulated,
}

impl Forward {
    /// Factorisation of the mass matrix without refinement.
    pub const UNREFINED: Self = Self::MassMatrix { refinements: 0 };
}

/// Treatment of the angles of consecutive joints with parallel axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Angles {
    /// Each angle has its own sine and cosine; accuracy does not depend on the number of turns.
    #[default]
    Apart,
    /// Angles are summed first if that costs fewer operations. The rounded sum has an error of up to u |q|, with the
    /// unit roundoff u, which matters only beyond a few turns. The frame of a link that carries only such joints keeps
    /// the axes of the link before it.
    Merged,
}

/// Rounding of a product in a sum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Products {
    /// Fused, with one rounding, where the target has the instruction, except for differences that must cancel.
    #[default]
    Fused,
    /// Two roundings, on every target.
    Unfused,
}

/// Source of sines and cosines.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sines {
    /// Sines of this project, all at once: `Scalar::sin_cos_all`; in a file for `core` alone, those in the file or a
    /// function of the user.
    #[default]
    Own,
    /// Sines of the platform, one by one: `Scalar::sin_cos`, which is the standard library's or `libm`'s; in a file for
    /// `core` alone without a function of the user, `libm`'s.
    Platform,
}

/// Reason for the rejection of a formulation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// Message, a sentence without a full stop.
    pub message: String,
    /// Hint with a valid choice.
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

/// Words, the value that each needs, and its choice.
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

/// All words, once each.
pub(crate) fn words() -> Vec<&'static str> {
    let mut words: Vec<&str> = WORDS.iter().map(|(word, ..)| *word).collect();
    words.dedup();
    words
}

/// Setters of the parts.
macro_rules! setters {
    ($($(#[$about:meta])* $name:ident $part:ident: $kind:ty;)*) => {
        impl Formulation {
            $(
                $(#[$about])*
                #[must_use]
                pub fn $name(self, $part: impl Into<$kind>) -> Self {
                    Self { $part: $part.into(), ..self }
                }
            )*
        }
    };
}

setters! {
    /// The same with another frame of the recursions.
    with_frame frame: Frame;
    /// The same with other inertial parameters.
    with_parameters parameters: Parameters;
    /// The same with an algorithm for accelerations, or `None` for the engine's choice.
    with_forward forward: Option<Forward>;
    /// The same with another treatment of the angles of parallel axes.
    with_angles angles: Angles;
    /// The same with another rounding of products in sums.
    with_products products: Products;
    /// The same with another source of sines and cosines.
    with_sines sines: Sines;
}

impl Formulation {
    /// Choices that differ from the default, in words.
    #[must_use]
    pub fn words(&self) -> Vec<String> {
        let chosen = WORDS.iter().filter(|(.., choice)| {
            choice.is_chosen_in(self) && !choice.is_chosen_in(&Self::default())
        });
        chosen
            .map(|(word, value, _)| written(word, *value))
            .collect()
    }

    /// Checks that all choices can be combined.
    ///
    /// # Errors
    /// If no algorithm has all of them.
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
    fn apply(self, formulation: &mut Formulation) {
        match self {
            Self::Frame(frame) => formulation.frame = frame,
            Self::Parameters(parameters) => formulation.parameters = parameters,
            Self::Forward(forward) => formulation.forward = Some(forward),
            Self::Angles(angles) => formulation.angles = angles,
            Self::Products(products) => formulation.products = products,
            Self::Sines(sines) => formulation.sines = sines,
        }
    }

    fn is_chosen_in(self, formulation: &Formulation) -> bool {
        let mut made = *formulation;
        self.apply(&mut made);
        made == *formulation
    }

    fn is_for_same_part_as(self, other: Self) -> bool {
        std::mem::discriminant(&self) == std::mem::discriminant(&other)
    }
}

/// State of the reading of a formulation.
#[derive(Default)]
#[doc(hidden)]
pub struct FormulationReader {
    formulation: Formulation,
    made: Vec<(String, Choice)>,
}

impl FormulationReader {
    /// Reads a word with its value.
    ///
    /// # Errors
    /// For an unknown word, a missing or unexpected value, or a contradiction to an earlier word.
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
        let text = written(word, value);
        let mut made = self.made.iter();
        if let Some((before, _)) = made.find(|(_, other)| other.is_for_same_part_as(*choice)) {
            return Err(Refusal {
                message: if *before == text {
                    format!("{} is said twice", quoted(&text))
                } else {
                    format!("{} contradicts {}", quoted(&text), quoted(before))
                },
                hint: "leave one of them out".to_owned(),
            });
        }
        choice.apply(&mut self.formulation);
        self.made.push((text, *choice));
        self.formulation.check()
    }

    /// Formulation of all words.
    #[must_use]
    pub fn formulation(self) -> Formulation {
        self.formulation
    }
}

fn written(word: &str, value: Option<&str>) -> String {
    value.map_or_else(|| word.to_owned(), |value| format!("{word} = {value}"))
}

/// `write refined = 0, refined = 1 or …`.
fn values(word: &str) -> String {
    let rows = WORDS.iter().filter(|(known, ..)| *known == word);
    let all: Vec<String> = rows.map(|(word, value, _)| written(word, *value)).collect();
    format!(
        "write {}",
        list(all.iter().map(String::as_str)).replace(" and ", " or ")
    )
}

#[cfg(test)]
mod tests {
    use super::{
        Angles, Formulation, FormulationReader, Forward, Frame, Parameters, Products, Sines,
    };

    /// Formulation of some words, or the message of its rejection.
    fn read(words: &[(&str, Option<&str>)]) -> Result<Formulation, String> {
        let mut reader = FormulationReader::default();
        for (word, value) in words {
            reader
                .take(word, *value)
                .map_err(|refusal| format!("{} ({})", refusal.message, refusal.hint))?;
        }
        Ok(reader.formulation())
    }

    #[test]
    fn every_choice_is_read_and_written() {
        let all = Formulation {
            frame: Frame::Base,
            parameters: Parameters::Raw,
            forward: Some(Forward::MassMatrix { refinements: 2 }),
            angles: Angles::Merged,
            products: Products::Unfused,
            sines: Sines::Platform,
        };
        let words = [
            ("frame_0", None),
            ("raw", None),
            ("refined", Some("2")),
            ("merged", None),
            ("unfused", None),
            ("platform_sines", None),
        ];
        assert_eq!(read(&words), Ok(all));
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
    fn invalid_formulations_are_rejected() {
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
        let formulation = Formulation::default().with_forward(forward);
        assert!(formulation.check().is_err());
    }
}
