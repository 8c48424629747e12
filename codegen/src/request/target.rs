//! What a struct field stands for: a number of the description that stays free at run time.
//!
//! In: nothing; a shared noun. Each [`Target`] knows how many entries it has, their units, and what
//! they are meant to be within. It never looks at the description.

use std::f64::consts::PI;

use proc_macro2::Ident;
use syn::ext::IdentExt;

use crate::joint::drive::Part;
use crate::name::Name;
use crate::wording::quoted;

/// A struct field that takes the place of a number of the description at run time.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// The field.
    pub field: Ident,
    /// The number it stands for.
    pub target: Target,
    /// The least and the greatest that each of its entries is meant to be, in the unit of what it
    /// stands for; by default from zero to twice what is described, to both sides where it is a
    /// vector. Of a payload it is that of the mass, of an inertia that of its moments. Error bounds are for these; nothing checks it at run time.
    pub range: Option<[f64; 2]>,
}

/// What a struct field can stand for.
#[derive(Clone, Debug)]
pub enum Target {
    /// The mass of a link \[kg\]; one number. The inertia about the centre of mass stays as described;
    /// a link described without one is a point of mass at its origin.
    MassOf(Name),
    /// The centre of mass of a link in the link's frame \[m\]; three numbers.
    CenterOfMassOf(Name),
    /// The inertia of a link about its centre of mass, in the axes of the inertial that is described (the link's
    /// own where none is, or where it is not turned); I_xx, I_xy, I_xz, I_yy, I_yz, I_zz [kg m²].
    InertiaOf(Name),
    /// A body fixed to a link beside all that is described; ten numbers: its mass \[kg\], where its centre of
    /// mass is in the link's frame \[m\], and its inertia about that, in the axes of the link's frame, as I_xx, I_xy,
    /// I_xz, I_yy, I_yz, I_zz [kg m²].
    PayloadOn(Name),
    /// The acceleration of gravity in the base frame [m/s²]; three numbers.
    Gravity,
    /// The translation from the parent's frame to the joint's \[m\]; three numbers.
    OriginOf(Name),
    /// The frame of a joint in its parent's, at q = 0; six numbers: x, y, z \[m\], then roll, pitch, yaw \[rad\], by
    /// which it is turned about the parent's x, y and z, in this order. Any three angles are a turn, so that there
    /// is nothing to be of length 1.
    PlacementOf(Name),
    /// Where the origin of the base's frame is in frame 0 \[m\], the axes of which are those of the base; three
    /// numbers. Of a floating robot it is the frame that q counts from.
    BasePosition,
    /// The frame of the base in frame 0; six numbers, as before. Gravity is seen in frame 0.
    BasePlacement,
    /// The inertia that a joint feels beside that of the bodies [kg m² or kg]; one number, for each of its
    /// velocities.
    ArmatureOf(Name),
    /// The viscous friction of a joint [N m s/rad or N s/m]; one number, as before.
    DampingOf(Name),
    /// The Coulomb friction of a joint [N m or N]; one number, as before.
    FrictionOf(Name),
}

/// How the numbers of a field hang together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// One, never negative.
    Size,
    /// Three along the axes.
    Vector,
    /// A point and three angles.
    Placement,
    /// A symmetric tensor, by rows.
    Tensor,
    /// A mass, a point, a tensor.
    Payload,
}

impl Form {
    /// What the names of entries end in.
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

    /// The names of its entries: the field's, and behind it what tells them apart where there are several.
    #[must_use]
    pub fn entries(&self) -> Vec<String> {
        let name = self.name();
        let endings = self.target.form().endings().iter();
        endings.map(|ending| format!("{name}{ending}")).collect()
    }

    /// The least and the greatest of each entry, where this is described in its place: as declared, or
    /// else so that they hold zero and twice the largest entry that is described (1 where none is).
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
        let of_entry = |k: usize| match (self.target.form(), k) {
            (Form::Payload, 1..=3) => [-PAYLOAD, PAYLOAD],
            (Form::Payload, 4 | 7 | 9) => [0.0, square],
            (Form::Payload, 5 | 6 | 8) => [-square / 2.0, square / 2.0],
            (Form::Placement, 3..) => [-PI, PI],
            (Form::Tensor, 1 | 2 | 4) => [-half, half],
            _ => ends,
        };
        (0..self.target.entries()).map(of_entry).collect()
    }

    /// Those ranges in words: `` `payload` from 0 to 3 kg ``.
    #[must_use]
    pub fn range_words(&self, described: &[f64]) -> String {
        let ranges = self.ranges(described);
        let (name, unit, [least, most]) = (&self.field, self.target.unit(), ranges[0]);
        match self.target.form() {
            Form::Payload => format!(
                "`{name}` from {least} to {most} {unit}, its centre of mass up to {PAYLOAD} m along each axis, \
                 its moments of inertia up to {} kg m² and its products up to half of that, as a body has them",
                ranges[4][1]
            ),
            Form::Placement => format!("lengths of `{name}` ≤ {most} {unit}, its angles ≤ π rad"),
            Form::Tensor => format!(
                "moments of `{name}` from {least} to {most} {unit} and its products up to half of that"
            ),
            Form::Size | Form::Vector if least == -most => {
                format!("entries of `{name}` ≤ {most} {unit}")
            }
            Form::Size | Form::Vector => format!("`{name}` from {least} to {most} {unit}"),
        }
    }

    /// What to take an entry for in whose place nothing but zeros are described: the end of its range; nothing
    /// of products of inertia, of which a body can have no more than its moments allow, and of a placement,
    /// which is one.
    #[must_use]
    pub fn at_the_end(&self, entry: usize) -> f64 {
        let [_, most] = self.ranges(&[])[entry];
        match (self.target.form(), entry) {
            (Form::Placement, _) | (Form::Payload, 5 | 6 | 8) | (Form::Tensor, 1 | 2 | 4) => 0.0,
            _ => most,
        }
    }

    /// Numbers near what is described, such as a body has, by as many between 0 and 1 as they are.
    pub fn near(&self, described: &[f64], mut unit: impl FnMut() -> f64) -> Vec<f64> {
        let sizes = described.iter().take(self.target.of_one_unit());
        let sizes = sizes.map(|entry| entry.abs());
        let size = sizes.fold(0.0, f64::max);
        let size = if size > 0.0 { size } else { 1.0 };
        let entries = described.iter().enumerate();
        let near = entries.map(|(k, &entry)| {
            let share = unit();
            match (self.target.form(), k) {
                (Form::Size, _) | (Form::Payload, 0) => size * (0.5 + share),
                (Form::Placement, 3..) => entry + 2.0 * (share - 0.5),
                (Form::Vector | Form::Placement, _) => entry + size * (share - 0.5),
                (Form::Tensor, 0 | 3 | 5) if entry == 0.0 => size * (0.75 + 0.5 * share),
                (Form::Tensor, _) if entry == 0.0 => 0.1 * size * (share - 0.5),
                (Form::Tensor, _) => entry * (0.9 + 0.2 * share),
                (Form::Payload, 1..=3) => PAYLOAD * (2.0 * share - 1.0),
                (Form::Payload, 4 | 7 | 9) => 0.01 * (0.75 + 0.5 * share),
                (Form::Payload, _) => 0.004 * (share - 0.5),
            }
        });
        near.collect()
    }
}

/// How far from the origin of the link's frame the centre of a payload is meant to be along each axis \[m\], and
/// how far its parts from that.
const PAYLOAD: f64 = 0.25;

/// A function that makes a target.
#[derive(Clone, Copy, Debug)]
pub enum TargetOf {
    /// The name of a link or a joint.
    Item(fn(Name) -> Target),
    /// Nothing.
    Robot(fn() -> Target),
}

/// A row of the table of targets.
struct Definition {
    /// The key in attributes and on command lines.
    key: &'static str,
    of: TargetOf,
    form: Form,
    /// The unit of its numbers, or of the first of them.
    unit: &'static str,
    /// Its noun in a sentence, before the name.
    words: &'static str,
}

/// All of them, in the order of the documentation.
#[rustfmt::skip]
const ALL: [Definition; 12] = [
    Definition { key: "mass_of",        of: TargetOf::Item(Target::MassOf),            form: Form::Size,      unit: "kg",                 words: "the mass of link" },
    Definition { key: "com_of",         of: TargetOf::Item(Target::CenterOfMassOf),    form: Form::Vector,    unit: "m",                  words: "the centre of mass of link" },
    Definition { key: "inertia_of",     of: TargetOf::Item(Target::InertiaOf),         form: Form::Tensor,    unit: "kg m²",              words: "the inertia of link" },
    Definition { key: "payload_on",     of: TargetOf::Item(Target::PayloadOn),         form: Form::Payload,   unit: "kg",                 words: "a payload on link" },
    Definition { key: "gravity",        of: TargetOf::Robot(|| Target::Gravity),       form: Form::Vector,    unit: "m/s²",               words: "gravity" },
    Definition { key: "origin_of",      of: TargetOf::Item(Target::OriginOf),          form: Form::Vector,    unit: "m",                  words: "the origin of joint" },
    Definition { key: "placement_of",   of: TargetOf::Item(Target::PlacementOf),       form: Form::Placement, unit: "m",                  words: "the placement of joint" },
    Definition { key: "base_position",  of: TargetOf::Robot(|| Target::BasePosition),  form: Form::Vector,    unit: "m",                  words: "the position of the base" },
    Definition { key: "base_placement", of: TargetOf::Robot(|| Target::BasePlacement), form: Form::Placement, unit: "m",                  words: "the placement of the base" },
    Definition { key: "armature_of",    of: TargetOf::Item(Target::ArmatureOf),        form: Form::Size,      unit: "kg m² or kg",        words: "the armature of joint" },
    Definition { key: "damping_of",     of: TargetOf::Item(Target::DampingOf),         form: Form::Size,      unit: "N m s/rad or N s/m", words: "the damping of joint" },
    Definition { key: "friction_of",    of: TargetOf::Item(Target::FrictionOf),        form: Form::Size,      unit: "N m or N",           words: "the friction of joint" },
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

    fn definition(&self) -> &'static Definition {
        let is = |row: &&Definition| {
            let other = match row.of {
                TargetOf::Item(of) => of(Name::default()),
                TargetOf::Robot(of) => of(),
            };
            std::mem::discriminant(self) == std::mem::discriminant(&other)
        };
        ALL.iter().find(is).unwrap_or(&ALL[0])
    }

    /// Its key in attributes and on command lines.
    #[must_use]
    pub fn key(&self) -> &'static str {
        self.definition().key
    }

    /// The link or the joint whose number it is.
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

    /// How its numbers hang together.
    fn form(&self) -> Form {
        self.definition().form
    }

    /// The unit of its numbers, or of the first of them.
    #[must_use]
    pub fn unit(&self) -> &'static str {
        self.definition().unit
    }

    /// The joint and the part of its drive, where it is of one.
    #[must_use]
    pub const fn drives(&self) -> Option<(&Name, Part)> {
        match self {
            Self::ArmatureOf(joint) => Some((joint, Part::Armature)),
            Self::DampingOf(joint) => Some((joint, Part::Damping)),
            Self::FrictionOf(joint) => Some((joint, Part::Friction)),
            _ => None,
        }
    }

    /// The link whose mass it changes, or how that is spread, and what it is of that.
    #[must_use]
    pub const fn weighs(&self) -> Option<(&Name, &'static str)> {
        match self {
            Self::MassOf(link) | Self::CenterOfMassOf(link) => Some((link, "its mass")),
            Self::InertiaOf(link) => Some((link, "its inertia")),
            Self::PayloadOn(link) => Some((link, "a payload on it")),
            _ => None,
        }
    }

    /// The range that one number stands for: from zero to it, to both sides where entries have signs.
    #[must_use]
    pub fn range_up_to(&self, most: f64) -> [f64; 2] {
        match self.form() {
            Form::Size | Form::Tensor | Form::Payload => [0.0, most],
            Form::Vector | Form::Placement => [-most, most],
        }
    }

    /// What is wrong with a range of its entries, and what to write instead.
    #[must_use]
    pub fn refusal(&self, [least, most]: [f64; 2]) -> Option<[&'static str; 2]> {
        let example = match (self, self.form()) {
            (Self::Gravity, _) => "write range = 12.0, or range = -12.0..=12.0 for the same",
            (_, Form::Size | Form::Tensor | Form::Payload) => {
                "write range = 0.0..=3.0, or range = 3.0 for the same"
            }
            (_, Form::Vector | Form::Placement) => {
                "write range = 0.5, or range = -0.5..=0.5 for the same"
            }
        };
        let problem = if !(least.is_finite() && most.is_finite()) {
            "is not finite"
        } else if least > most {
            "is empty"
        } else if matches!(self, Self::MassOf(_) | Self::PayloadOn(_)) && least < 0.0 {
            "has negative masses"
        } else if self.form() == Form::Tensor && least < 0.0 {
            "has negative moments of inertia"
        } else if self.form() == Form::Size && least < 0.0 {
            "has negative numbers"
        } else {
            return None;
        };
        Some([problem, example])
    }

    /// Whether both are the same number, or one of them is among what the other is.
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

    /// What it is in a sentence.
    #[must_use]
    pub fn words(&self) -> String {
        let words = self.definition().words;
        match self.item() {
            Some(item) => format!("{words} {}", quoted(&item.text)),
            None => words.to_owned(),
        }
    }

    /// How many of its first numbers are of one unit.
    fn of_one_unit(&self) -> usize {
        match self.form() {
            Form::Placement => 3,
            _ => self.entries(),
        }
    }

    /// How many numbers the field holds.
    #[must_use]
    pub fn entries(&self) -> usize {
        self.form().endings().len()
    }

    /// Whether the columns of regressors depend on it, and not only what they are multiplied with.
    #[must_use]
    pub const fn enters_regressors(&self) -> bool {
        matches!(
            self,
            Self::OriginOf(_) | Self::PlacementOf(_) | Self::BasePlacement | Self::Gravity
        )
    }

    /// Whether it says where the base is.
    #[must_use]
    pub const fn places_base(&self) -> bool {
        matches!(self, Self::BasePosition | Self::BasePlacement)
    }

    /// Whether it is a payload, which has a type of its own beside the runtime.
    #[must_use]
    pub const fn is_payload(&self) -> bool {
        matches!(self, Self::PayloadOn(_))
    }
}
