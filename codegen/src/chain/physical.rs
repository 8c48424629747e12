//! Checks that inertias are physical.
//!
//! In: the description, its tree, the merged chain. Out: the same chain with warnings added to its report, or errors if
//! the request is strict. Numbers stay as given: computations use non-physical inertias as they are.

use super::tree::Tree;
use super::{Chain, actuator, limits, mimic};
use crate::description::{Description, Inertial, Link, LinkId, Name};
use crate::error::{Diagnostic, Errors, Place};
use crate::expression::{Double, Term};
use crate::list::List;
use crate::matrix::Inertia;
use crate::request::{Request, Target};
use crate::wording::{list, quoted};

/// Relative rounding of the digits that vendors print.
const TOLERANCE: f64 = 1e-9;

/// Checks the inertia of every link that moves.
///
/// # Errors
/// Every warning, if the request is strict.
pub fn check(
    description: &Description,
    request: &Request,
    tree: &Tree,
    mut chain: Chain,
) -> Result<Chain, Errors> {
    let mut warnings = description.warnings.clone();
    warnings.append(&mut chain.report.warnings);
    warnings.extend(actuator::warnings(description, request, tree));
    warnings.extend(limits::warnings(description, tree));
    warnings.extend(mimic::warnings(description, tree));
    // For each link the moving body that it is part of; for each of these, whether any of its links has a mass.
    let mut body = List::filled(None, description.links.len());
    let mut carried: Vec<(LinkId, bool)> = Vec::new();
    for branch in &tree.branches {
        if branch.held.is_some() {
            body[branch.child] = body[branch.parent];
        } else {
            body[branch.child] = Some(carried.len());
            carried.push((branch.child, false));
        }
        let Some(body) = body[branch.child] else {
            continue;
        };
        let link = &description[branch.child];
        let (_, massive) = &mut carried[body];
        *massive |= [Request::weighs, Request::spreads, Request::loads]
            .iter()
            .any(|is| is(request, &link.name));
        if let Some(inertial) = &link.inertial {
            *massive = true;
            if !request.spreads(&link.name) {
                warnings.extend(non_physical(&link.name.text, inertial));
            }
        }
        warnings.extend(part_of_nothing(link, request));
    }
    let massless = carried.iter().filter(|(_, massive)| !massive);
    let massless: Vec<&Name> = massless.map(|&(link, _)| &description[link].name).collect();
    warnings.extend(without_inertia(&massless).filter(|_| !request.is_of_frames_alone()));
    if request.strict && !warnings.is_empty() {
        let mut errors = description.source.errors();
        for warning in warnings {
            errors.push(
                warning.place,
                format!("{} (refused: strict)", warning.message),
            );
        }
        return Err(errors);
    }
    chain.report.warnings = warnings;
    Ok(chain)
}

/// One warning for all links that move and have no inertia, at the first of them.
fn without_inertia(links: &[&Name]) -> Option<Diagnostic> {
    let (first, others) = links.split_first()?;
    let names: Vec<String> = links.iter().map(|link| quoted(&link.text)).collect();
    let names = list(names.iter().map(String::as_str));
    let (noun, verbs) = if others.is_empty() {
        ("link", "moves and has")
    } else {
        ("links", "move and have")
    };
    Some(Diagnostic {
        place: first.place,
        message: format!("{noun} {names} {verbs} no inertia: taken as massless"),
        hint: Some("give it an inertial, with mass 0 if it has none".into()),
    })
}

/// The warning about a non-physical inertia, with the amount: the second moments about the centre of mass, ∫rrᵗdm,
/// must not be negative in any direction.
fn non_physical(link: &str, inertial: &Inertial) -> Option<Diagnostic> {
    let [xx, xy, xz, yy, yz, zz] = inertial.inertia.map(|entry| entry.value);
    let mass = inertial.mass.value;
    let half = (xx + yy + zz) / 2.0;
    let moments = eigenvalues([half - xx, half - yy, half - zz, -xy, -xz, -yz]);
    let least = moments.into_iter().fold(f64::INFINITY, f64::min);
    let size = moments
        .into_iter()
        .fold(0.0_f64, |size, moment| size.max(moment.abs()));
    let link = quoted(link);
    let message = if least < -TOLERANCE * size {
        format!(
            "the inertia of link {link} is not physical: a second moment about its centre of mass \
             is {least:.3e} kg m² ({:.1} % of the largest)",
            100.0 * least / size
        )
    } else if mass == 0.0 && size > 0.0 {
        format!("link {link} has no mass but an inertia")
    } else {
        return None;
    };
    let hint = Some("used as given: correct the file, or make this an error with strict".into());
    Some(Diagnostic {
        place: inertial.place,
        message,
        hint,
    })
}

/// Warnings about fields for the centre of mass or the inertia of a link without mass.
fn part_of_nothing(link: &Link, request: &Request) -> Vec<Diagnostic> {
    let inertial = link.inertial.as_ref();
    if inertial.is_some_and(|inertial| inertial.mass.value != 0.0) || request.weighs(&link.name) {
        return Vec::new();
    }
    let name = quoted(&link.name.text);
    let warnings = request.parameters.iter().filter_map(|parameter| {
        let field = &parameter.field;
        let message = match &parameter.target {
            Target::CenterOfMassOf(of) if of.text == link.name.text => {
                format!(
                    "link {name} has no mass: field `{field}` for its centre of mass changes nothing"
                )
            }
            Target::InertiaOf(of) if of.text == link.name.text => {
                format!("link {name} has no mass but an inertia: field `{field}`")
            }
            _ => return None,
        };
        Some(Diagnostic {
            place: Place::Token(field.span()),
            message,
            hint: Some(format!("give it a mass, or a field with mass_of = {name}")),
        })
    });
    warnings.collect()
}

/// True if an inertia, in any frame, is physical; `None` if it is known at run time only.
#[must_use]
pub fn is_possible(inertia: Inertia<Term<'_>>) -> Option<bool> {
    let known = |term: Term<'_>| term.value().map(Double::to_f64);
    let mass = known(inertia.mass)?;
    let [x, y, z] = inertia.q.map(known).0;
    let [x, y, z] = [x?, y?, z?];
    let [xx, yy, zz, xy, xz, yz] = inertia.second.0.map(known);
    let per_mass = |product: f64| if mass > 0.0 { product / mass } else { 0.0 };
    let moments = eigenvalues([
        xx? - per_mass(x * x),
        yy? - per_mass(y * y),
        zz? - per_mass(z * z),
        xy? - per_mass(x * y),
        xz? - per_mass(x * z),
        yz? - per_mass(y * z),
    ]);
    let size = moments.into_iter().map(f64::abs).sum::<f64>();
    Some(
        mass >= 0.0
            && moments
                .into_iter()
                .all(|moment| moment >= -TOLERANCE * size),
    )
}

/// Eigenvalues of a symmetric matrix xx, yy, zz, xy, xz, yz, by Jacobi's rotations.
fn eigenvalues([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> [f64; 3] {
    let mut m = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    for _ in 0..12 {
        for (p, q, r) in [(0, 1, 2), (0, 2, 1), (1, 2, 0)] {
            if m[p][q] == 0.0 {
                continue;
            }
            let cotangent = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
            let t = 1.0_f64.copysign(cotangent) / (cotangent.abs() + secant(cotangent));
            let c = 1.0 / secant(t);
            let s = t * c;
            m[p][p] -= t * m[p][q];
            m[q][q] += t * m[p][q];
            let (rp, rq) = (m[r][p], m[r][q]);
            (m[r][p], m[p][r]) = (c * rp - s * rq, c * rp - s * rq);
            (m[r][q], m[q][r]) = (s * rp + c * rq, s * rp + c * rq);
            (m[p][q], m[q][p]) = (0.0, 0.0);
        }
    }
    [m[0][0], m[1][1], m[2][2]]
}

/// √(1 + x²), the same on every platform, which the `hypot` of its library is not.
fn secant(x: f64) -> f64 {
    // The square of a larger one may overflow, and the 1 is far below the last digit.
    if x.abs() > 1e100 {
        x.abs()
    } else {
        (1.0 + x * x).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::{eigenvalues, secant};

    #[test]
    fn a_secant_neither_overflows_nor_vanishes() {
        for x in [0.0, -1e-300, 0.75, 1e8, -1e99, 1e101, f64::MAX] {
            assert!(
                (secant(x) - x.hypot(1.0)).abs() <= f64::EPSILON * x.hypot(1.0),
                "{x}"
            );
        }
    }

    #[test]
    fn eigenvalues_have_the_trace_and_the_squares_of_the_matrix() {
        let [a, b, c] = eigenvalues([2.0, 3.0, 5.0, 0.5, -0.25, 1.0]);
        assert!((a + b + c - 10.0).abs() < 1e-14);
        let squares = 4.0 + 9.0 + 25.0 + 2.0 * (0.25 + 0.0625 + 1.0);
        assert!((a * a + b * b + c * c - squares).abs() < 1e-13);
    }

    #[test]
    fn a_diagonal_matrix_has_its_entries() {
        assert_eq!(
            eigenvalues([1.0, -2.0, 3.0, 0.0, 0.0, 0.0]),
            [1.0, -2.0, 3.0]
        );
    }
}
