//! Results of functions: one entity for each entry of some spaces, or several such results by name.
//!
//! In: the spaces of a robot. Out: number of values, shape of arrays, units, and the entry that each value belongs to.

use super::{Kind, Space, Spaces};

/// Type of the elements of a result.
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
    /// A wrench matrix: c_x, c_y, c_z, f_x, f_y, f_z.
    Action,
    /// A screw: u_x, u_y, u_z, b_x, b_y, b_z.
    Screw,
}

/// Order of the two halves of six numbers that turn and move.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Order {
    /// v before ω, f before the couple, the linear momentum before the angular one.
    LinearFirst,
    /// The other way round, as programs have it.
    AngularFirst,
}

impl Order {
    /// Place of an entry of arrays of six numbers, which programs have angular first.
    #[must_use]
    pub const fn place(self, entry: usize) -> usize {
        let within = entry % 6;
        match self {
            Self::LinearFirst => entry - within + (within + 3) % 6,
            Self::AngularFirst => entry,
        }
    }

    /// Two halves, the angular one given first.
    #[must_use]
    pub const fn halves(self, [angular, linear]: [&str; 2]) -> [&str; 2] {
        match self {
            Self::LinearFirst => [linear, angular],
            Self::AngularFirst => [angular, linear],
        }
    }
}

/// An array of entities over a product of spaces, the last space's entries next to each other.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// Spaces, the outermost first.
    pub over: &'static [Space],
    /// Element for each combination of entries.
    pub entity: Entity,
    /// Units of the values of one entity, "1" if dimensionless, by the kinds of the entries that it belongs to.
    pub units: fn(&[Kind]) -> Vec<&'static str>,
}

/// Result of a function; values are stored part by part, in this order.
#[derive(Clone, Copy, Debug)]
pub enum Outcome {
    /// A single quantity.
    One(Quantity),
    /// Several quantities with the name of their struct: a field each, an object in JSON, or an array each in C.
    Parts(&'static str, &'static [Part]),
}

/// A named quantity of a result.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// Name of the field.
    pub name: &'static str,
    /// Sentence for its documentation.
    pub about: &'static str,
    /// The quantity.
    pub quantity: Quantity,
}

impl Entity {
    /// Shape of its array, the outermost dimension first.
    #[must_use]
    pub const fn dimensions(self) -> &'static [usize] {
        match self {
            Self::Number => &[],
            Self::Pose | Self::Acceleration => &[3, 4],
            Self::Point | Self::Vector => &[3],
            Self::Velocity | Self::Screw | Self::Momentum | Self::Action => &[6],
        }
    }

    /// The fourth row of a 4×4 matrix, whose array has the first three; `None` for other entities.
    #[must_use]
    pub const fn fourth_row(self) -> Option<[f64; 4]> {
        match self {
            Self::Pose => Some([0.0, 0.0, 0.0, 1.0]),
            Self::Acceleration => Some([0.0; 4]),
            _ => None,
        }
    }

    /// Number of values.
    #[must_use]
    pub fn size(self) -> usize {
        self.dimensions().iter().product()
    }

    /// Letters of the angular and the linear half of six numbers; `None` for other entities.
    #[must_use]
    pub const fn halves(self) -> Option<[&'static str; 2]> {
        match self {
            Self::Velocity => Some(["ω", "v"]),
            Self::Momentum => Some(["γ", "ρ"]),
            Self::Action => Some(["c", "f"]),
            Self::Screw => Some(["u", "b"]),
            _ => None,
        }
    }

    /// Sentence about the order of values in arrays; `None` for a number.
    #[must_use]
    pub fn layout(self, order: Order) -> Option<String> {
        if let Some(halves) = self.halves() {
            let [first, second] = order.halves(halves);
            let start = match self {
                Self::Screw => "One screw for each joint; order",
                _ => "Order",
            };
            return Some(format!("{start}: {first}, {second}."));
        }
        let text = match self {
            Self::Pose => "Rows 1 to 3 of the 4×4 matrix: R, t; the fourth is 0, 0, 0, 1.",
            Self::Acceleration => "Rows 1 to 3 of the 4×4 matrix: G, a; the fourth is 0.",
            Self::Point | Self::Vector => "Order: x, y, z.",
            _ => return None,
        };
        Some(text.to_owned())
    }
}

impl Quantity {
    /// True for a single number.
    #[must_use]
    pub fn is_number(&self) -> bool {
        self.over.is_empty() && self.entity == Entity::Number
    }

    /// Number of entries of each space.
    #[must_use]
    pub fn lengths(&self, spaces: &Spaces) -> Vec<usize> {
        self.over.iter().map(|&space| spaces.len(space)).collect()
    }

    /// Number of values.
    #[must_use]
    pub fn size(&self, spaces: &Spaces) -> usize {
        self.lengths(spaces).iter().product::<usize>() * self.entity.size()
    }

    /// Unit of each value.
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

    /// First space, and the entry of it that a value belongs to; `None` without spaces.
    #[must_use]
    pub fn owner(&self, spaces: &Spaces, number: usize) -> Option<(Space, usize)> {
        let &first = self.over.first()?;
        let each = self.size(spaces) / spaces.len(first);
        Some((first, number / each))
    }
}

impl Outcome {
    /// Quantities, with their names if there are several.
    pub fn parts(self) -> impl Iterator<Item = (Option<&'static str>, Quantity)> {
        let (one, parts): (_, &[Part]) = match self {
            Self::One(quantity) => (Some((None, quantity)), &[]),
            Self::Parts(_, parts) => (None, parts),
        };
        let parts = parts.iter().map(|part| (Some(part.name), part.quantity));
        one.into_iter().chain(parts)
    }

    /// True for a single number.
    #[must_use]
    pub fn is_number(self) -> bool {
        matches!(self, Self::One(quantity) if quantity.is_number())
    }

    /// Number of values.
    #[must_use]
    pub fn size(self, spaces: &Spaces) -> usize {
        self.parts().map(|(_, part)| part.size(spaces)).sum()
    }

    /// Splits the values of the whole result into those of each quantity.
    #[must_use]
    pub fn split<'n, T>(self, spaces: &Spaces, numbers: &'n [T]) -> Vec<&'n [T]> {
        let mut rest = numbers;
        let parts = self.parts().map(|(_, part)| {
            // A function that could not be expanded has no values.
            let (own, others) = rest.split_at(part.size(spaces).min(rest.len()));
            rest = others;
            own
        });
        parts.collect()
    }

    /// Unit of each value.
    #[must_use]
    pub fn units(self, spaces: &Spaces) -> Vec<&'static str> {
        self.parts()
            .flat_map(|(_, part)| part.units(spaces))
            .collect()
    }

    /// First space of the quantity that a value belongs to, and its entry; `None` if the quantity has no space.
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
