//! A robot's description of itself: names, limits and the neutral configuration, as lists that every language prints.
//!
//! In: a [`Module`]. Out: lists with their names and documentation. It formats no number.

use super::steps;
use crate::module::Module;
use crate::space::{Entry, Space};

/// A list of names.
#[derive(Clone, Debug)]
pub struct NameList<'m> {
    /// The name of the list, in small letters.
    pub name: &'static str,
    /// Its documentation.
    pub about: &'static str,
    /// The names, in the order of the entries.
    pub names: Vec<&'m str>,
}

/// A list of numbers, one for each coordinate or velocity.
#[derive(Clone, Debug)]
pub struct NumberList {
    /// The name of the list, in small letters.
    pub name: &'static str,
    /// Its documentation.
    pub about: &'static str,
    /// The numbers; infinite where the description has none.
    pub numbers: Vec<f64>,
}

/// Documentation of the configurations with names.
pub const CONFIGURATIONS: &str = "Configurations with names, from the keyframes of the description [rad, m, quaternions x, y, z, w].";

/// Names of joints, coordinates, velocities and frames, and of spheres and their pairs if there are any.
#[must_use]
pub fn names(module: &Module) -> Vec<NameList<'_>> {
    let (spaces, data) = (&module.spaces, &module.data);
    let list = |name, about, names| NameList { name, about, names };
    let mut lists = vec![
        list(
            "joints",
            "Names of the joints that move, parents before children.",
            data.names.iter().map(|name| &**name).collect(),
        ),
        list(
            "coordinates",
            "Names of the entries of q.",
            spaces.names(Space::Coordinates).collect(),
        ),
        list(
            "velocities",
            "Names of the entries of q̇, q̈ and τ.",
            spaces.names(Space::Velocities).collect(),
        ),
        list(
            "frames",
            "Names of the frames that have poses and Jacobians, the end effector first.",
            data.frames.iter().map(|(name, _)| &**name).collect(),
        ),
    ];
    if !spaces.spheres.is_empty() {
        lists.push(list(
            "spheres",
            "Names of the collision spheres: those of their links, with numbers where a link has several.",
            spaces.names(Space::Spheres).collect(),
        ));
        lists.push(list(
            "pairs",
            "Names of the pairs of collision spheres that have distances.",
            spaces.names(Space::Pairs).collect(),
        ));
    }
    lists
}

/// The radii of collision spheres, if there are any.
#[must_use]
pub fn radii(module: &Module) -> Option<NumberList> {
    let numbers = module.radii.clone();
    (!numbers.is_empty()).then_some(NumberList {
        name: "radii",
        about: "Radii of the collision spheres, in m.",
        numbers,
    })
}

/// Limits of q, q̇ and τ.
#[must_use]
pub fn limits(module: &Module) -> [NumberList; 4] {
    let ends = |entries: &[Entry], end: usize| -> Vec<f64> {
        let unlimited = [f64::NEG_INFINITY, f64::INFINITY];
        let ranges = entries.iter().map(|entry| entry.range.unwrap_or(unlimited));
        ranges.map(|range| range[end]).collect()
    };
    let (coordinates, velocities) = (&module.spaces.coordinates, &module.spaces.velocities);
    let list = |name, about, numbers| NumberList {
        name,
        about,
        numbers,
    };
    [
        list(
            "lower",
            "Lower limits of q [rad or m].",
            ends(coordinates, 0),
        ),
        list(
            "upper",
            "Upper limits of q [rad or m].",
            ends(coordinates, 1),
        ),
        list(
            "max_velocity",
            "Limits of |q̇| [rad/s or m/s].",
            ends(velocities, 1),
        ),
        list(
            "max_effort",
            "Limits of |τ| [N m or N].",
            module.efforts.clone(),
        ),
    ]
}

/// The configuration at which every joint is where it was placed.
#[must_use]
pub fn neutral(module: &Module) -> NumberList {
    NumberList {
        name: "neutral",
        about: "The configuration at which every joint is where it was placed: zeros, and 0, 0, 0, 1 of quaternions (x, y, \
                z, w).",
        numbers: steps::neutral(module),
    }
}
