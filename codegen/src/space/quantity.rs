//! What a function returns: an entity for each entry of some spaces, or several such by name.
//!
//! In: spaces of a robot. Out: how many numbers a result holds, in which arrays, in which units, and
//! whose they are. It never says how a language writes it.

use super::{Kind, Space, Spaces};

/// One of the things that results are made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Entity {
    /// A number.
    Number,
    /// A pose: row by row of the upper 3×4 block (r_xx, r_xy, r_xz, t_x, …).
    Pose,
    /// A velocity matrix: ω_x, ω_y, ω_z, v_x, v_y, v_z.
    Velocity,
    /// An acceleration matrix: row by row of the upper 3×4 block (G, a).
    Acceleration,
    /// A point: x, y, z.
    Point,
    /// A vector: x, y, z.
    Vector,
    /// A momentum matrix: γ_x, γ_y, γ_z, ρ_x, ρ_y, ρ_z.
    Momentum,
    /// An action matrix: c_x, c_y, c_z, f_x, f_y, f_z.
    Action,
    /// A screw: u_x, u_y, u_z, b_x, b_y, b_z.
    Screw,
}

/// An entity for each entry of a product of spaces, the last space's entries next to each other.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// The spaces.
    pub over: &'static [Space],
    /// What there is for each entry of each.
    pub entity: Entity,
    /// The units of one entity's numbers, 1 where there is none, by the kinds of the entries that it is
    /// for.
    pub units: fn(&[Kind]) -> Vec<&'static str>,
}

/// What a function returns: its numbers stand part by part, in this order.
#[derive(Clone, Copy, Debug)]
pub enum Outcome {
    /// A quantity by itself.
    One(Quantity),
    /// Several quantities: a struct of that name with a field each, an object, or an array each.
    Parts(&'static str, &'static [Part]),
}

/// A quantity among several.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// Its name.
    pub name: &'static str,
    /// What it tells, a sentence.
    pub about: &'static str,
    /// What it is.
    pub quantity: Quantity,
}

impl Entity {
    /// The arrays within arrays that hold its numbers, the outermost first.
    #[must_use]
    pub const fn dimensions(self) -> &'static [usize] {
        match self {
            Self::Number => &[],
            Self::Pose | Self::Acceleration => &[3, 4],
            Self::Point | Self::Vector => &[3],
            Self::Velocity | Self::Screw | Self::Momentum | Self::Action => &[6],
        }
    }

    /// How many numbers it is.
    #[must_use]
    pub fn size(self) -> usize {
        self.dimensions().iter().product()
    }

    /// What its numbers are where they stand in arrays, in a sentence.
    #[must_use]
    pub const fn layout(self) -> Option<&'static str> {
        Some(match self {
            Self::Number => return None,
            Self::Pose => "Rows 1 to 3 of the 4×4 matrix: R, t; the fourth is 0, 0, 0, 1.",
            Self::Acceleration => "Rows 1 to 3 of the 4×4 matrix: G, a; the fourth is 0.",
            Self::Velocity => "Order: ω, v.",
            Self::Point | Self::Vector => "Order: x, y, z.",
            Self::Momentum => "Order: γ, ρ.",
            Self::Action => "Order: c, f.",
            Self::Screw => "One screw for each joint; order: u, b.",
        })
    }
}

impl Quantity {
    /// Whether it is one number by itself.
    #[must_use]
    pub fn is_number(&self) -> bool {
        self.over.is_empty() && self.entity == Entity::Number
    }

    /// How many entries each of its spaces has.
    #[must_use]
    pub fn lengths(&self, spaces: &Spaces) -> Vec<usize> {
        self.over.iter().map(|&space| spaces.len(space)).collect()
    }

    /// How many numbers it is.
    #[must_use]
    pub fn size(&self, spaces: &Spaces) -> usize {
        self.lengths(spaces).iter().product::<usize>() * self.entity.size()
    }

    /// The unit of each number.
    #[must_use]
    pub fn units(&self, spaces: &Spaces) -> Vec<&'static str> {
        let mut kinds: Vec<Vec<Kind>> = vec![Vec::new()];
        for &space in self.over {
            let entries = spaces.entries(space);
            let more = kinds.iter().flat_map(|before| {
                let with = |kind| before.iter().copied().chain([kind]).collect();
                entries.iter().map(move |entry| with(entry.kind))
            });
            kinds = more.collect();
        }
        let units = kinds.iter().flat_map(|kinds| (self.units)(kinds));
        units.collect()
    }

    /// The first of its spaces, and the entry of it that a number belongs to; none where it is over no space.
    #[must_use]
    pub fn owner(&self, spaces: &Spaces, number: usize) -> Option<(Space, usize)> {
        let &first = self.over.first()?;
        let each = self.size(spaces) / spaces.len(first);
        Some((first, number / each))
    }
}

impl Outcome {
    /// Its quantities, by name where there are several.
    pub fn parts(self) -> impl Iterator<Item = (Option<&'static str>, Quantity)> {
        let (one, parts): (_, &[Part]) = match self {
            Self::One(quantity) => (Some((None, quantity)), &[]),
            Self::Parts(_, parts) => (None, parts),
        };
        let parts = parts.iter().map(|part| (Some(part.name), part.quantity));
        one.into_iter().chain(parts)
    }

    /// Whether it is one number by itself.
    #[must_use]
    pub fn is_number(self) -> bool {
        matches!(self, Self::One(quantity) if quantity.is_number())
    }

    /// How many numbers it is.
    #[must_use]
    pub fn size(self, spaces: &Spaces) -> usize {
        self.parts().map(|(_, part)| part.size(spaces)).sum()
    }

    /// The numbers of each of its quantities, of all of them.
    #[must_use]
    pub fn split<'n, T>(self, spaces: &Spaces, numbers: &'n [T]) -> Vec<&'n [T]> {
        let mut rest = numbers;
        let parts = self.parts().map(|(_, part)| {
            // Of a function that could not be expanded there are none.
            let (own, others) = rest.split_at(part.size(spaces).min(rest.len()));
            rest = others;
            own
        });
        parts.collect()
    }

    /// The unit of each number.
    #[must_use]
    pub fn units(self, spaces: &Spaces) -> Vec<&'static str> {
        self.parts()
            .flat_map(|(_, part)| part.units(spaces))
            .collect()
    }

    /// The first of the spaces of the quantity that a number is of, and the entry of it that the number
    /// belongs to; none where the quantity is over no space.
    #[must_use]
    pub fn owner(self, spaces: &Spaces, number: usize) -> Option<(Space, usize)> {
        let mut number = number;
        for (_, part) in self.parts() {
            let size = part.size(spaces);
            if number < size {
                return part.owner(spaces, number);
            }
            number -= size;
        }
        None
    }
}
