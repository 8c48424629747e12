//! The joints that close loops: what they leave free between two links that hang on the base anyhow.
//!
//! A shared noun, and the table of all kinds. A frame A is fixed to one link and a frame B to the other;
//! what such a joint closes are entries of M of B in A, which is the product of all matrices along the
//! loop (paper, II: Π M = 1). Each of them is a [`Row`]. It never knows how links move.

use crate::number::Number;
use crate::space::Kind;

/// What a joint that closes a loop leaves free.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Closure {
    /// Nothing.
    Fixed,
    /// To turn about z of A.
    Revolute,
    /// To slide along z of A.
    Prismatic,
    /// Both.
    Cylindrical,
    /// To turn about z of A, and then about z of B.
    Universal,
    /// To slide across z of A, and to turn about it.
    Planar,
    /// To slide anywhere.
    Translation,
    /// To turn anyhow.
    Spherical,
    /// All that keeps the origins of A and B so far apart \[m\]: a rod without mass between two spherical
    /// joints.
    Rod {
        /// Its length \[m\].
        length: Number,
    },
}

/// What is known of a kind.
pub struct Definition {
    /// What it is called in every reader.
    pub word: &'static str,
    /// How many axes a description gives it: of two the first is z of A and the second z of B, of one it is
    /// z of both.
    pub axes: usize,
    /// What it closes.
    pub rows: &'static [Row],
    /// Makes it; a rod asks for its length.
    make: fn(Number) -> Closure,
}

/// An equation of a closure: something that is zero where the loop is closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Row {
    /// How far the origin of B is from that of A along an axis of A \[m\].
    Along(usize),
    /// An axis of A times an axis of B, which are perpendicular.
    Product(usize, usize),
    /// z of A times z of B, beyond what it is as described.
    Inclined,
    /// (d² − l²)/2l of the distance d of the origins and the length l: to first order d − l \[m\].
    Distance,
}

const ALONG: [Row; 3] = [Row::Along(0), Row::Along(1), Row::Along(2)];
const PARALLEL: [Row; 2] = [Row::Product(0, 2), Row::Product(1, 2)];
const TURNED: [Row; 3] = [Row::Product(0, 1), Row::Product(1, 2), Row::Product(2, 0)];

/// All kinds, in the order in which messages list them.
pub const ALL: [Definition; 9] = [
    Definition::new(
        "fixed",
        0,
        &[
            ALONG[0], ALONG[1], ALONG[2], TURNED[0], TURNED[1], TURNED[2],
        ],
        |_| Closure::Fixed,
    ),
    Definition::new(
        "revolute",
        1,
        &[ALONG[0], ALONG[1], ALONG[2], PARALLEL[0], PARALLEL[1]],
        |_| Closure::Revolute,
    ),
    Definition::new(
        "prismatic",
        1,
        &[ALONG[0], ALONG[1], TURNED[0], TURNED[1], TURNED[2]],
        |_| Closure::Prismatic,
    ),
    Definition::new(
        "cylindrical",
        1,
        &[ALONG[0], ALONG[1], PARALLEL[0], PARALLEL[1]],
        |_| Closure::Cylindrical,
    ),
    Definition::new(
        "universal",
        2,
        &[ALONG[0], ALONG[1], ALONG[2], Row::Inclined],
        |_| Closure::Universal,
    ),
    Definition::new("planar", 1, &[ALONG[2], PARALLEL[0], PARALLEL[1]], |_| {
        Closure::Planar
    }),
    Definition::new("translation", 0, &TURNED, |_| Closure::Translation),
    Definition::new("spherical", 0, &ALONG, |_| Closure::Spherical),
    Definition::new("rod", 0, &[Row::Distance], |length| Closure::Rod { length }),
];

impl Definition {
    const fn new(
        word: &'static str,
        axes: usize,
        rows: &'static [Row],
        make: fn(Number) -> Closure,
    ) -> Self {
        Self {
            word,
            axes,
            rows,
            make,
        }
    }

    /// The kind of that name.
    #[must_use]
    pub fn named(word: &str) -> Option<&'static Self> {
        ALL.iter().find(|kind| kind.word == word)
    }

    /// Whether it has a length.
    #[must_use]
    pub fn has_length(&self) -> bool {
        self.rows.contains(&Row::Distance)
    }

    /// A joint of this kind; `length` is asked for where it has one.
    ///
    /// # Errors
    /// That of `length`.
    pub fn with_length<E>(&self, length: impl FnOnce() -> Result<Number, E>) -> Result<Closure, E> {
        let length = if self.has_length() {
            length()?
        } else {
            Number::default()
        };
        Ok((self.make)(length))
    }
}

impl Closure {
    /// What is known of its kind.
    #[must_use]
    pub const fn definition(self) -> &'static Definition {
        let [
            fixed,
            revolute,
            prismatic,
            cylindrical,
            universal,
            planar,
            translation,
            spherical,
            rod,
        ] = &ALL;
        match self {
            Self::Fixed => fixed,
            Self::Revolute => revolute,
            Self::Prismatic => prismatic,
            Self::Cylindrical => cylindrical,
            Self::Universal => universal,
            Self::Planar => planar,
            Self::Translation => translation,
            Self::Spherical => spherical,
            Self::Rod { .. } => rod,
        }
    }

    /// The length of a rod \[m\].
    #[must_use]
    pub const fn length(self) -> Option<Number> {
        match self {
            Self::Rod { length } => Some(length),
            _ => None,
        }
    }
}

impl Row {
    /// What it measures: a length, or the cosine of an angle that is near a right one.
    #[must_use]
    pub const fn kind(self) -> Kind {
        match self {
            Self::Along(_) | Self::Distance => Kind::Slide,
            Self::Product(..) | Self::Inclined => Kind::Turn,
        }
    }

    /// What it is called: as the loop is, where that has one alone, or with the axes that it is about.
    #[must_use]
    pub fn name(self, of: &str) -> String {
        let axis = |k: usize| ["x", "y", "z"][k];
        match self {
            Self::Along(k) => format!("{of}.{}", axis(k)),
            Self::Product(i, j) => format!("{of}.{}{}", axis(i), axis(j)),
            Self::Inclined => format!("{of}.zz"),
            Self::Distance => of.to_owned(),
        }
    }
}
