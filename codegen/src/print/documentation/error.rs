//! Error bounds of a function in sentences.
//!
//! In: an [`Accuracy`]. Out: lines of Markdown: one line if one number is enough for all joints, else a list of groups
//! of joints, the largest bound first. Printed numbers are rounded upwards.

use crate::accuracy::{Accuracy, Bound, ErrorBounds, Perturbed};
use crate::module::FoundError;
use crate::wording::code;

/// Maximum number of groups of joints.
const GROUPS: usize = 4;

/// Lines about the errors of a function.
pub fn lines(accuracy: &Accuracy) -> Vec<String> {
    let (what, error_bounds) = match accuracy {
        Accuracy::Unknown(reason) => return vec![format!("Error: no bound: {reason}.")],
        Accuracy::Within(error_bounds) => ("", error_bounds),
        Accuracy::BesideDiagonal(error_bounds) => (
            "entry (i, j) of M⁻¹, relative to √((M⁻¹)ᵢᵢ (M⁻¹)ⱼⱼ), ",
            error_bounds,
        ),
        Accuracy::Backward(Perturbed::Torques, error_bounds) => {
            ("as if τ were off by ", error_bounds)
        }
        Accuracy::Backward(Perturbed::MassMatrix, error_bounds) => (
            "each column is exact for a mass matrix that differs from M by ",
            error_bounds,
        ),
        Accuracy::Backward(Perturbed::UnitForces, error_bounds) => (
            "each column, down to its diagonal entry, as if its unit force were off by ",
            error_bounds,
        ),
        Accuracy::Backward(Perturbed::TorqueDerivatives, error_bounds) => (
            "∂q̈/∂q and ∂q̈/∂q̇ as if the derivatives of τ at the q̈ found were off by ",
            error_bounds,
        ),
    };
    let groups = groups(error_bounds);
    let mut range = error_bounds.range.clone();
    if let Some(reason) = error_bounds.lacks {
        let between = if range.is_empty() { "" } else { "; " };
        range = format!("{range}{between}{}: {reason}", unbounded_type(error_bounds));
    }
    match &*groups {
        [group] => {
            let end = if range.is_empty() { "." } else { "; " };
            let line = format!("Error: {what}at most {}{end}{range}", sizes(&group.worst));
            vec![if range.is_empty() {
                line
            } else {
                format!("{line}.")
            }]
        }
        groups => {
            let range = if range.is_empty() {
                range
            } else {
                format!(" for {range}")
            };
            let mut lines = vec![format!("Error{range}: {what}at most")];
            lines.extend(groups.iter().map(|group| {
                let names = names(&group.joints, error_bounds);
                format!("- {}: {names}", sizes(&group.worst))
            }));
            lines
        }
    }
}

/// Type that has no bound.
fn unbounded_type(error_bounds: &ErrorBounds) -> &'static str {
    let infinite = |bound: &Bound| bound.double.is_some_and(f64::is_infinite);
    if error_bounds.bounds.iter().any(infinite) {
        "no bound in f64"
    } else {
        "no bound in f32"
    }
}

/// Joints with similar bounds.
struct JointGroup {
    /// Indices in the order of q; `None` for bounds of a frame.
    joints: Vec<Option<usize>>,
    /// Largest bound of each unit.
    worst: Vec<Bound>,
}

/// Joints with bounds, in the order of q.
fn joints(error_bounds: &ErrorBounds) -> Vec<Option<&str>> {
    let mut joints: Vec<Option<&str>> = Vec::new();
    for bound in &error_bounds.bounds {
        let joint = bound.joint.as_deref();
        if !joints.contains(&joint) {
            joints.push(joint);
        }
    }
    joints
}

/// At most [`GROUPS`] groups whose numbers are within a factor of each other: two, doubled until there are few enough.
fn groups(error_bounds: &ErrorBounds) -> Vec<JointGroup> {
    let all: Vec<JointGroup> = (joints(error_bounds).into_iter().enumerate())
        .map(|(k, joint)| {
            let own = error_bounds.bounds.iter();
            let own = own.filter(|bound| bound.joint.as_deref() == joint);
            JointGroup {
                joints: vec![joint.map(|_| k)],
                worst: own.cloned().collect(),
            }
        })
        .collect();
    let mut factor = 2.0;
    loop {
        let groups = within(&all, factor);
        if groups.len() <= GROUPS || factor > f64::MAX / 2.0 {
            return groups;
        }
        factor *= 2.0;
    }
}

/// Groups whose numbers are within a factor of each other, the largest bound first.
fn within(all: &[JointGroup], factor: f64) -> Vec<JointGroup> {
    let mut rest: Vec<&JointGroup> = all.iter().collect();
    let size = |group: &JointGroup| numbers(&group.worst).fold(0.0, f64::max);
    // The sort is stable: equal bounds keep their order.
    rest.sort_by(|a, b| size(b).total_cmp(&size(a)));
    let mut groups: Vec<JointGroup> = Vec::new();
    for group in rest {
        let close = |other: &&mut JointGroup| {
            let units = |group: &JointGroup| -> Vec<&str> {
                group.worst.iter().map(|bound| bound.unit).collect()
            };
            let pairs = numbers(&group.worst).zip(numbers(&other.worst));
            let framed = |group: &JointGroup| group.joints.contains(&None);
            framed(group) == framed(other)
                && units(group) == units(other)
                && pairs
                    .clone()
                    .all(|(a, b)| a == b || a.max(b) <= factor * a.min(b))
        };
        match groups.iter_mut().find(close) {
            Some(other) => {
                other.joints.extend(&group.joints);
                for (most, bound) in other.worst.iter_mut().zip(&group.worst) {
                    let larger = |a: Option<f64>, b: Option<f64>| a.zip(b).map(|(a, b)| a.max(b));
                    most.double = larger(most.double, bound.double);
                    most.single = larger(most.single, bound.single);
                }
            }
            None => groups.push(JointGroup {
                joints: group.joints.clone(),
                worst: group.worst.clone(),
            }),
        }
    }
    for group in &mut groups {
        group.joints.sort_unstable();
    }
    groups
}

/// All numbers of some bounds.
fn numbers(bounds: &[Bound]) -> impl Iterator<Item = f64> + Clone {
    let both = bounds.iter().flat_map(|bound| [bound.double, bound.single]);
    both.flatten()
}

/// Names of joints; three or more consecutive ones are given by the first and the last.
fn names(places: &[Option<usize>], error_bounds: &ErrorBounds) -> String {
    let names = joints(error_bounds);
    let name = |k: usize| names[k].map_or_else(String::new, code);
    let mut words: Vec<String> = Vec::new();
    let places: Vec<usize> = places.iter().flatten().copied().collect();
    if places.is_empty() {
        return "of the frame".to_owned();
    }
    let mut rest = &*places;
    while let [first, ..] = *rest {
        let row = rest
            .iter()
            .zip(first..)
            .take_while(|(k, place)| *k == place);
        let row = row.count();
        if row > 2 {
            words.push(format!("{} to {}", name(first), name(rest[row - 1])));
        } else {
            words.extend(rest[..row].iter().map(|&k| name(k)));
        }
        rest = &rest[row..];
    }
    words.join(", ")
}

/// Line about the largest error found.
pub fn found(found: &FoundError) -> String {
    let uphill = match found.uphill {
        0 => String::new(),
        more => format!(" and {more} uphill from the worst"),
    };
    format!(
        "Error found: {} of the largest result in {}, in {} random states{uphill}.",
        upwards(found.relative),
        found.scalar.name(),
        found.random,
    )
}

/// `3.4e-14 N m in f64, 1.8e-5 N m in f32`.
fn sizes(bounds: &[Bound]) -> String {
    let worst = |name: &str, of: fn(&Bound) -> Option<f64>| {
        let sizes: Option<Vec<f64>> = bounds.iter().map(of).collect();
        let sizes = sizes.filter(|sizes| sizes.iter().all(|size| size.is_finite()))?;
        let sizes = sizes.into_iter().map(upwards).zip(bounds);
        let sizes: Vec<String> = sizes
            .map(|(size, bound)| match bound.unit {
                "1" => size,
                unit => format!("{size} {unit}"),
            })
            .collect();
        Some(format!("{} in {name}", sizes.join(" and ")))
    };
    let (double, single) = (
        worst("f64", |bound| bound.double),
        worst("f32", |bound| bound.single),
    );
    let sizes: Vec<String> = double.into_iter().chain(single).collect();
    sizes.join(", ")
}

/// Two significant digits, rounded upwards.
fn upwards(size: f64) -> String {
    let near = |size: f64| format!("{size:.1e}");
    let text = near(size);
    match text.parse::<f64>() {
        Ok(printed) if printed < size => near(size * 1.05),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::{found, lines, upwards};
    use crate::accuracy::{Accuracy, Bound, ErrorBounds, Perturbed};
    use crate::module::FoundError;
    use crate::real::Real;

    #[test]
    fn two_digits_are_never_less_than_the_number() {
        for size in [0.0, 1.0, 1.04e-15, 1.06e-15, 9.99e-7, 9.51e-7, 4.4e-16] {
            let text = upwards(size);
            let printed: f64 = text.parse().expect("a number");
            assert!((size..=1.11 * size).contains(&printed), "{size:e}: {text}");
        }
    }

    fn bound(joint: &str, unit: &'static str, double: f64, single: f64) -> Bound {
        Bound {
            joint: (!joint.is_empty()).then(|| joint.to_owned()),
            unit,
            double: (double > 0.0).then_some(double),
            single: (single > 0.0).then_some(single),
        }
    }

    fn error_bounds(bounds: Vec<Bound>) -> ErrorBounds {
        ErrorBounds {
            bounds,
            range: "q within its limits".to_owned(),
            lacks: None,
        }
    }

    #[test]
    fn one_number_for_all_joints_is_a_line() {
        let pose = error_bounds(vec![
            bound("", "1", 1.34e-15, 7.2e-7),
            bound("", "m", 2e-15, 1e-6),
        ]);
        assert_eq!(
            lines(&Accuracy::Within(pose)),
            [
                "Error: at most 1.4e-15 and 2.0e-15 m in f64, 7.2e-7 and 1.0e-6 m in f32; q within \
                 its limits."
            ]
        );
        let single = error_bounds(vec![
            bound("a", "N m", 0.0, 3.1e-5),
            bound("b", "N m", 0.0, 1.6e-5),
        ]);
        assert_eq!(
            lines(&Accuracy::Within(single)),
            ["Error: at most 3.1e-5 N m in f32; q within its limits."]
        );
        let nowhere = ErrorBounds {
            range: String::new(),
            ..error_bounds(vec![bound("a", "N m", 1e-16, 0.0)])
        };
        assert_eq!(
            lines(&Accuracy::Within(nowhere)),
            ["Error: at most 1.0e-16 N m in f64."]
        );
    }

    #[test]
    fn joints_are_grouped_by_their_bounds() {
        let torques = error_bounds(vec![
            bound("wrist-1", "N m", 1e-15, 0.0),
            bound("hip`", "N m", 5e-14, 0.0),
            bound("knee", "N m", 3e-14, 0.0),
            bound("ankle", "N m", 2.9e-14, 0.0),
            bound("slide", "N", 1e-14, 0.0),
            bound("tip", "N m", 6e-16, 0.0),
        ]);
        assert_eq!(
            lines(&Accuracy::Within(torques)),
            [
                "Error for q within its limits: at most",
                "- 5.0e-14 N m in f64: `hip'` to `ankle`",
                "- 1.0e-14 N in f64: `slide`",
                "- 1.0e-15 N m in f64: `wrist-1`, `tip`",
            ]
        );
    }

    #[test]
    fn long_lists_are_shortened() {
        let many = (0..40_i32).map(|k| bound(&format!("j{k}"), "N m", 0.5_f64.powi(k), 0.0));
        let found = lines(&Accuracy::Within(error_bounds(many.collect())));
        assert!(found.len() <= 5, "{found:#?}");
        assert!(found[1].contains("`j0` to `j"), "{found:#?}");
    }

    #[test]
    fn the_error_found_states_its_states() {
        let random = FoundError {
            scalar: Real::F32,
            relative: 1.31e-6,
            random: 32,
            uphill: 0,
        };
        assert_eq!(
            found(&random),
            "Error found: 1.4e-6 of the largest result in f32, in 32 random states."
        );
        let uphill = FoundError {
            scalar: Real::F64,
            uphill: 112,
            ..random
        };
        assert_eq!(
            found(&uphill),
            "Error found: 1.4e-6 of the largest result in f64, in 32 random states and 112 uphill from the worst."
        );
    }

    #[test]
    fn sentences_name_the_bounded_quantity() {
        let torques = error_bounds(vec![bound("a", "N m", 2.1e-12, 0.0)]);
        assert_eq!(
            lines(&Accuracy::Backward(Perturbed::Torques, torques)),
            ["Error: as if τ were off by at most 2.1e-12 N m in f64; q within its limits."]
        );
        let moments = ErrorBounds {
            lacks: Some("rounding may outweigh it"),
            ..error_bounds(vec![bound("a", "kg m²", 1e-15, f64::INFINITY)])
        };
        assert_eq!(
            lines(&Accuracy::Backward(Perturbed::MassMatrix, moments)),
            [
                "Error: each column is exact for a mass matrix that differs from M by at most 1.0e-15 kg m² in \
                 f64; q within its limits; no bound in f32: rounding may outweigh it."
            ]
        );
        assert_eq!(
            lines(&Accuracy::Unknown("nobody knows")),
            ["Error: no bound: nobody knows."]
        );
    }
}
