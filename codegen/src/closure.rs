//! Types of joints that close loops between two links of the tree.
//!
//! Frame A is fixed to the first link and frame B to the second. The constraints are entries of the pose M of B in A,
//! the product of all matrices along the loop (paper, II: Π M = 1). Each constraint is a [`ResidualKind`].

use crate::number::Number;
use crate::space::Kind;

/// Type of a joint that closes a loop, by the motions that it allows.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Closure {
    /// No motion.
    Fixed,
    /// Rotation about z of A.
    Revolute,
    /// Translation along z of A.
    Prismatic,
    /// Rotation about z of A and translation along it.
    Cylindrical,
    /// Rotation about z of A, and then about z of B.
    Universal,
    /// Translation perpendicular to z of A, and rotation about it.
    Planar,
    /// Any translation.
    Translation,
    /// Any rotation.
    Spherical,
    /// Any motion with the origins of A and B at a fixed distance: a massless rod between two spherical joints.
    Rod {
        /// Its length \[m\].
        length: Number,
    },
}

/// Properties of a type.
pub struct Definition {
    /// Its name in all formats.
    pub word: &'static str,
    /// Number of axes in a description. Of two, the first is z of A and the second z of B; a single one is z of both.
    pub axes: usize,
    /// Its constraints.
    pub rows: &'static [ResidualKind],
    /// Makes the type; the argument is the length of a rod.
    make: fn(Number) -> Closure,
}

/// A constraint: a quantity that is zero if the loop is closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ResidualKind {
    /// Coordinate of the origin of B along an axis of A \[m\].
    Along(usize),
    /// Product of an axis of A and an axis of B, which are perpendicular.
    Product(usize, usize),
    /// Product of z of A and z of B, minus its described value.
    Inclined,
    /// (d² − l²)/2l for the distance d of the origins and the length l: to first order d − l \[m\].
    Distance,
}

const ALONG: [ResidualKind; 3] = [
    ResidualKind::Along(0),
    ResidualKind::Along(1),
    ResidualKind::Along(2),
];
const PARALLEL: [ResidualKind; 2] = [ResidualKind::Product(0, 2), ResidualKind::Product(1, 2)];
const ROTATED: [ResidualKind; 3] = [
    ResidualKind::Product(0, 1),
    ResidualKind::Product(1, 2),
    ResidualKind::Product(2, 0),
];

/// All types, in the order of messages.
pub const ALL: [Definition; 9] = [
    Definition::new(
        "fixed",
        0,
        &[
            ALONG[0], ALONG[1], ALONG[2], ROTATED[0], ROTATED[1], ROTATED[2],
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
        &[ALONG[0], ALONG[1], ROTATED[0], ROTATED[1], ROTATED[2]],
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
        &[ALONG[0], ALONG[1], ALONG[2], ResidualKind::Inclined],
        |_| Closure::Universal,
    ),
    Definition::new("planar", 1, &[ALONG[2], PARALLEL[0], PARALLEL[1]], |_| {
        Closure::Planar
    }),
    Definition::new("translation", 0, &ROTATED, |_| Closure::Translation),
    Definition::new("spherical", 0, &ALONG, |_| Closure::Spherical),
    Definition::new("rod", 0, &[ResidualKind::Distance], |length| Closure::Rod {
        length,
    }),
];

impl Definition {
    const fn new(
        word: &'static str,
        axes: usize,
        rows: &'static [ResidualKind],
        make: fn(Number) -> Closure,
    ) -> Self {
        Self {
            word,
            axes,
            rows,
            make,
        }
    }

    /// The type with a name.
    #[must_use]
    pub fn named(word: &str) -> Option<&'static Self> {
        ALL.iter().find(|kind| kind.word == word)
    }

    /// True for a rod.
    #[must_use]
    pub fn has_length(&self) -> bool {
        self.rows.contains(&ResidualKind::Distance)
    }

    /// A joint of this type; `length` is called for a rod.
    ///
    /// # Errors
    /// The error of `length`.
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
    /// Properties of its type.
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

impl ResidualKind {
    /// Its unit: of a length, or of the cosine of an angle near a right angle.
    #[must_use]
    pub const fn kind(self) -> Kind {
        match self {
            Self::Along(_) | Self::Distance => Kind::Translation,
            Self::Product(..) | Self::Inclined => Kind::Rotation,
        }
    }

    /// Its name: that of the loop if it is the only constraint, otherwise with its axes.
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
