//! Numbers of a description that a struct field can replace at run time.
//!
//! Each [`Target`] knows the number of its entries, their units and their ranges.

use std::f64::consts::PI;

use proc_macro2::Ident;
use syn::ext::IdentExt;

use crate::joint::actuator::ActuatorQuantity;
use crate::name::Name;
use crate::wording::quoted;

/// A struct field that replaces a number of the description at run time.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// The field.
    pub field: Ident,
    /// The number that it replaces.
    pub target: Target,
    /// Minimum and maximum of each entry, in the unit of the target. By default from 0 to twice the described value,
    /// and symmetric for vectors. The range of a payload is that of its mass, the range of an inertia that of its
    /// moments. Error bounds hold within the range; it is not checked at run time.
    pub range: Option<[f64; 2]>,
}

/// A number that a struct field can replace.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Target {
    /// Mass of a link \[kg\]; one number. The inertia about the centre of mass stays as described; a link without one
    /// is a point mass at its origin.
    MassOf(Name),
    /// Centre of mass of a link in the link's frame \[m\]; three numbers.
    CenterOfMassOf(Name),
    /// Inertia of a link about its centre of mass; I_xx, I_xy, I_xz, I_yy, I_yz, I_zz [kg m²]. The axes are those of
    /// the described inertial, or of the link if there is none.
    InertiaOf(Name),
    /// A body fixed to a link in addition to the description; ten numbers: mass \[kg\], centre of mass in the link's
    /// frame \[m\], and inertia about it in the axes of the link's frame: I_xx, I_xy, I_xz, I_yy, I_yz, I_zz [kg m²].
    PayloadOn(Name),
    /// Acceleration of gravity in the base frame [m/s²]; three numbers.
    Gravity,
    /// Translation from the parent's frame to the joint's \[m\]; three numbers.
    OriginOf(Name),
    /// Frame of a joint in its parent's frame at q = 0; six numbers: x, y, z \[m\], then roll, pitch, yaw \[rad\] about
    /// the fixed axes x, y and z of the parent, in this order.
    PlacementOf(Name),
    /// Origin of the base's frame in frame 0 \[m\], with parallel axes; three numbers. For a floating base: the frame
    /// that q is relative to.
    BasePosition,
    /// Frame of the base in frame 0; six numbers, as for [`PlacementOf`](Self::PlacementOf). Gravity is in frame 0.
    BasePlacement,
    /// Inertia at a joint in addition to the bodies [kg m² or kg]; one number, for each of its velocities.
    ArmatureOf(Name),
    /// Viscous friction of a joint [N m s/rad or N s/m]; one number, for each of its velocities.
    DampingOf(Name),
    /// Coulomb friction of a joint [N m or N]; one number, for each of its velocities.
    FrictionOf(Name),
}

/// Structure of the numbers of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Structure {
    /// One number that is not negative.
    Size,
    /// A vector.
    Vector,
    /// A point and three angles.
    Placement,
    /// A symmetric tensor, by rows.
    Tensor,
    /// A mass, a point, a tensor.
    Payload,
}

impl Structure {
    /// Suffixes of the names of entries.
    const fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Size => &[""],
            Self::Vector => &["_x", "_y", "_z"],
            Self::Placement => &["_x", "_y", "_z", "_roll", "_pitch", "_yaw"],
            Self::Tensor => &["_xx", "_xy", "_xz", "_yy", "_yz", "_zz"],
            Self::Payload => &[
                "_m", "_x", "_y", "_z", "_xx", "_xy", "_xz", "_yy", "_yz", "_zz",
            ],
        }
    }
}

impl Parameter {
    /// The name of the field.
    #[must_use]
    pub fn name(&self) -> String {
        self.field.unraw().to_string()
    }

    /// The names of the entries: that of the field, with a suffix if there are several.
    #[must_use]
    pub fn entries(&self) -> Vec<String> {
        let name = self.name();
        let endings = self.target.structure().endings().iter();
        endings.map(|ending| format!("{name}{ending}")).collect()
    }

    /// Minimum and maximum of each entry, for the described values: as declared, or else so that they include 0 and
    /// twice the largest described entry (1 if all are 0).
    #[must_use]
    pub fn ranges(&self, described: &[f64]) -> Vec<[f64; 2]> {
        const TIMES: f64 = 2.0;
        let ends = self.range.unwrap_or_else(|| {
            let lengths = described.iter().take(self.target.of_one_unit());
            let largest = lengths.map(|entry| entry.abs()).fold(0.0, f64::max);
            let most = if largest > 0.0 { TIMES * largest } else { 1.0 };
            self.target.range_up_to(most)
        });
        let [_, most] = ends;
        let half = most / 2.0;
        let square = PAYLOAD * PAYLOAD * most;
        let of_entry = |k: usize| match (self.target.structure(), k) {
            (Structure::Payload, 1..=3) => [-PAYLOAD, PAYLOAD],
            (Structure::Payload, 4 | 7 | 9) => [0.0, square],
            (Structure::Payload, 5 | 6 | 8) => [-square / 2.0, square / 2.0],
            (Structure::Placement, 3..) => [-PI, PI],
            (Structure::Tensor, 1 | 2 | 4) => [-half, half],
            _ => ends,
        };
        (0..self.target.entries()).map(of_entry).collect()
    }

    /// The ranges in words: `` `payload` from 0 to 3 kg ``.
    #[must_use]
    pub fn range_words(&self, described: &[f64]) -> String {
        let ranges = self.ranges(described);
        let (name, unit, [least, most]) = (&self.field, self.target.unit(), ranges[0]);
        match self.target.structure() {
            Structure::Payload => format!(
                "`{name}` from {least} to {most} {unit}, its centre of mass up to {PAYLOAD} m along each axis, \
                 its moments of inertia up to {} kg m² and its products up to half of that, as a body has them",
                ranges[4][1]
            ),
            Structure::Placement => {
                format!("lengths of `{name}` ≤ {most} {unit}, its angles ≤ π rad")
            }
            Structure::Tensor => format!(
                "moments of `{name}` from {least} to {most} {unit} and its products up to half of that"
            ),
            Structure::Size | Structure::Vector if least == -most => {
                format!("entries of `{name}` ≤ {most} {unit}")
            }
            Structure::Size | Structure::Vector => {
                format!("`{name}` from {least} to {most} {unit}")
            }
        }
    }

    /// A value for an entry whose described values are all 0: the end of its range; 0 for products of inertia, which
    /// are bounded by the moments, and for placements.
    #[must_use]
    pub fn at_the_end(&self, entry: usize) -> f64 {
        let [_, most] = self.ranges(&[])[entry];
        match (self.target.structure(), entry) {
            (Structure::Placement, _)
            | (Structure::Payload, 5 | 6 | 8)
            | (Structure::Tensor, 1 | 2 | 4) => 0.0,
            _ => most,
        }
    }

    /// Physical values near the described ones, from as many random numbers between 0 and 1.
    pub fn near(&self, described: &[f64], mut unit: impl FnMut() -> f64) -> Vec<f64> {
        let sizes = described.iter().take(self.target.of_one_unit());
        let sizes = sizes.map(|entry| entry.abs());
        let size = sizes.fold(0.0, f64::max);
        let size = if size > 0.0 { size } else { 1.0 };
        let entries = described.iter().enumerate();
        let near = entries.map(|(k, &entry)| {
            let share = unit();
            match (self.target.structure(), k) {
                (Structure::Size, _) | (Structure::Payload, 0) => size * (0.5 + share),
                (Structure::Placement, 3..) => entry + 2.0 * (share - 0.5),
                (Structure::Vector | Structure::Placement, _) => entry + size * (share - 0.5),
                (Structure::Tensor, 0 | 3 | 5) if entry == 0.0 => size * (0.75 + 0.5 * share),
                (Structure::Tensor, _) if entry == 0.0 => 0.1 * size * (share - 0.5),
                (Structure::Tensor, _) => entry * (0.9 + 0.2 * share),
                (Structure::Payload, 1..=3) => PAYLOAD * (2.0 * share - 1.0),
                (Structure::Payload, 4 | 7 | 9) => 0.01 * (0.75 + 0.5 * share),
                (Structure::Payload, _) => 0.004 * (share - 0.5),
            }
        });
        near.collect()
    }
}

/// Maximum distance of a payload's centre of mass from the origin of the link's frame along each axis \[m\], and radius
/// of the payload.
const PAYLOAD: f64 = 0.25;

/// A function that makes a target.
#[derive(Clone, Copy, Debug)]
pub enum TargetOf {
    /// From the name of a link or a joint.
    Item(fn(Name) -> Target),
    /// Without a name.
    Robot(fn() -> Target),
}

/// A row of the table of targets.
struct TargetRow {
    /// The key in attributes and on command lines.
    key: &'static str,
    of: TargetOf,
    structure: Structure,
    /// The unit of its numbers, or of the first of them.
    unit: &'static str,
    /// Its noun in a sentence, before the name.
    words: &'static str,
}

/// All targets, in the order of the documentation.
#[rustfmt::skip]
const ALL: [TargetRow; 12] = [
    TargetRow { key: "mass_of",        of: TargetOf::Item(Target::MassOf),            structure: Structure::Size,      unit: "kg",                 words: "the mass of link" },
    TargetRow { key: "com_of",         of: TargetOf::Item(Target::CenterOfMassOf),    structure: Structure::Vector,    unit: "m",                  words: "the centre of mass of link" },
    TargetRow { key: "inertia_of",     of: TargetOf::Item(Target::InertiaOf),         structure: Structure::Tensor,    unit: "kg m²",              words: "the inertia of link" },
    TargetRow { key: "payload_on",     of: TargetOf::Item(Target::PayloadOn),         structure: Structure::Payload,   unit: "kg",                 words: "a payload on link" },
    TargetRow { key: "gravity",        of: TargetOf::Robot(|| Target::Gravity),       structure: Structure::Vector,    unit: "m/s²",               words: "gravity" },
    TargetRow { key: "origin_of",      of: TargetOf::Item(Target::OriginOf),          structure: Structure::Vector,    unit: "m",                  words: "the origin of joint" },
    TargetRow { key: "placement_of",   of: TargetOf::Item(Target::PlacementOf),       structure: Structure::Placement, unit: "m",                  words: "the placement of joint" },
    TargetRow { key: "base_position",  of: TargetOf::Robot(|| Target::BasePosition),  structure: Structure::Vector,    unit: "m",                  words: "the position of the base" },
    TargetRow { key: "base_placement", of: TargetOf::Robot(|| Target::BasePlacement), structure: Structure::Placement, unit: "m",                  words: "the placement of the base" },
    TargetRow { key: "armature_of",    of: TargetOf::Item(Target::ArmatureOf),        structure: Structure::Size,      unit: "kg m² or kg",        words: "the armature of joint" },
    TargetRow { key: "damping_of",     of: TargetOf::Item(Target::DampingOf),         structure: Structure::Size,      unit: "N m s/rad or N s/m", words: "the damping of joint" },
    TargetRow { key: "friction_of",    of: TargetOf::Item(Target::FrictionOf),        structure: Structure::Size,      unit: "N m or N",           words: "the friction of joint" },
];

impl Target {
    /// All keys.
    #[must_use]
    pub fn keys() -> Vec<&'static str> {
        ALL.iter().map(|row| row.key).collect()
    }

    /// The function that makes the target of a key.
    #[must_use]
    pub fn of(key: &str) -> Option<TargetOf> {
        let row = ALL.iter().find(|row| row.key == key);
        row.map(|row| row.of)
    }

    fn definition(&self) -> &'static TargetRow {
        let is = |row: &&TargetRow| {
            let other = match row.of {
                TargetOf::Item(of) => of(Name::default()),
                TargetOf::Robot(of) => of(),
            };
            std::mem::discriminant(self) == std::mem::discriminant(&other)
        };
        ALL.iter().find(is).unwrap_or(&ALL[0])
    }

    /// Its key in attributes and on the command line.
    #[must_use]
    pub fn key(&self) -> &'static str {
        self.definition().key
    }

    /// The link or the joint, if there is one.
    #[must_use]
    pub const fn item(&self) -> Option<&Name> {
        match self {
            Self::MassOf(item)
            | Self::CenterOfMassOf(item)
            | Self::InertiaOf(item)
            | Self::PayloadOn(item)
            | Self::OriginOf(item)
            | Self::PlacementOf(item)
            | Self::ArmatureOf(item)
            | Self::DampingOf(item)
            | Self::FrictionOf(item) => Some(item),
            Self::Gravity | Self::BasePosition | Self::BasePlacement => None,
        }
    }

    /// The structure of its numbers.
    fn structure(&self) -> Structure {
        self.definition().structure
    }

    /// The unit of its numbers, or of the first of them.
    #[must_use]
    pub fn unit(&self) -> &'static str {
        self.definition().unit
    }

    /// The joint and the quantity, for a target of armature, damping or friction.
    #[must_use]
    pub const fn actuators(&self) -> Option<(&Name, ActuatorQuantity)> {
        match self {
            Self::ArmatureOf(joint) => Some((joint, ActuatorQuantity::Armature)),
            Self::DampingOf(joint) => Some((joint, ActuatorQuantity::Damping)),
            Self::FrictionOf(joint) => Some((joint, ActuatorQuantity::Friction)),
            _ => None,
        }
    }

    /// The link whose inertia it changes, with the noun of the changed number.
    #[must_use]
    pub const fn weighs(&self) -> Option<(&Name, &'static str)> {
        match self {
            Self::MassOf(link) | Self::CenterOfMassOf(link) => Some((link, "its mass")),
            Self::InertiaOf(link) => Some((link, "its inertia")),
            Self::PayloadOn(link) => Some((link, "a payload on it")),
            _ => None,
        }
    }

    /// The range for a single bound: from 0 to it, and symmetric for entries with signs.
    #[must_use]
    pub fn range_up_to(&self, most: f64) -> [f64; 2] {
        match self.structure() {
            Structure::Size | Structure::Tensor | Structure::Payload => [0.0, most],
            Structure::Vector | Structure::Placement => [-most, most],
        }
    }

    /// An error of a range, and a hint.
    #[must_use]
    pub fn refusal(&self, [least, most]: [f64; 2]) -> Option<[&'static str; 2]> {
        let example = match (self, self.structure()) {
            (Self::Gravity, _) => "write range = 12.0, or range = -12.0..=12.0 for the same",
            (_, Structure::Size | Structure::Tensor | Structure::Payload) => {
                "write range = 0.0..=3.0, or range = 3.0 for the same"
            }
            (_, Structure::Vector | Structure::Placement) => {
                "write range = 0.5, or range = -0.5..=0.5 for the same"
            }
        };
        let problem = if !(least.is_finite() && most.is_finite()) {
            "is not finite"
        } else if least > most {
            "is empty"
        } else if matches!(self, Self::MassOf(_) | Self::PayloadOn(_)) && least < 0.0 {
            "has negative masses"
        } else if self.structure() == Structure::Tensor && least < 0.0 {
            "has negative moments of inertia"
        } else if self.structure() == Structure::Size && least < 0.0 {
            "has negative numbers"
        } else {
            return None;
        };
        Some([problem, example])
    }

    /// True if both targets share a number.
    #[must_use]
    pub fn is(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::MassOf(one), Self::MassOf(other))
            | (Self::CenterOfMassOf(one), Self::CenterOfMassOf(other))
            | (Self::InertiaOf(one), Self::InertiaOf(other))
            | (Self::PayloadOn(one), Self::PayloadOn(other))
            | (
                Self::OriginOf(one) | Self::PlacementOf(one),
                Self::OriginOf(other) | Self::PlacementOf(other),
            )
            | (Self::ArmatureOf(one), Self::ArmatureOf(other))
            | (Self::DampingOf(one), Self::DampingOf(other))
            | (Self::FrictionOf(one), Self::FrictionOf(other)) => one.text == other.text,
            (Self::Gravity, Self::Gravity) => true,
            (one, other) => one.places_base() && other.places_base(),
        }
    }

    /// Its noun in a sentence, with the name.
    #[must_use]
    pub fn words(&self) -> String {
        let words = self.definition().words;
        match self.item() {
            Some(item) => format!("{words} {}", quoted(&item.text)),
            None => words.to_owned(),
        }
    }

    /// Number of leading entries with the same unit.
    fn of_one_unit(&self) -> usize {
        match self.structure() {
            Structure::Placement => 3,
            _ => self.entries(),
        }
    }

    /// Number of entries.
    #[must_use]
    pub fn entries(&self) -> usize {
        self.structure().endings().len()
    }

    /// True if the columns of regressors depend on it, and not only their factors.
    #[must_use]
    pub const fn enters_regressors(&self) -> bool {
        matches!(
            self,
            Self::OriginOf(_) | Self::PlacementOf(_) | Self::BasePlacement | Self::Gravity
        )
    }

    /// True if it places the base.
    #[must_use]
    pub const fn places_base(&self) -> bool {
        matches!(self, Self::BasePosition | Self::BasePlacement)
    }

    /// True for a payload, which has a type of its own in the runtime.
    #[must_use]
    pub const fn is_payload(&self) -> bool {
        matches!(self, Self::PayloadOn(_))
    }
}
