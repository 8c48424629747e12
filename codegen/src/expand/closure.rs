//! Residuals that are constant, and loops that cannot close.
//!
//! In: a chain. Out: the chain without the residuals that are zero in every configuration, such as those across the
//! plane of a four-bar, however it is mounted; an error for each residual that is never zero or that joints hardly
//! change, and for each loop without residuals left. A residual that joints change by less than [`LEAST`] of the
//! motion of the links is taken as zero and reported, with a warning if the rounding of `f64` does not explain it.

mod measured;

use crate::chain::{Chain, Loop};
use crate::closure::ResidualKind;
use crate::error::{Diagnostic, Errors};
use crate::space::Kind;
use crate::wording::{list, quoted};
use measured::{MeasuredResidual, measured};

/// Largest residual [m, 1] and largest share of a motion that 10 written digits explain.
const ROUNDED: f64 = 1e-9;

/// The share of the motion of a loop's links below which a residual is left out: 2⁻¹⁰. Such a residual comes from
/// rounded digits of axes and offsets that were meant to be parallel or at right angles.
const LEAST: f64 = 1.0 / 1024.0;

/// The share below which a residual is refused: 2⁻⁶, a misalignment of 0.9°.
const SLIGHT: f64 = 1.0 / 64.0;

/// The chain with the residuals that joints can change.
///
/// # Errors
/// Loops that cannot close, hardly move, or constrain nothing; if `strict` is set, warnings too.
pub fn settled(mut chain: Chain, strict: bool) -> Result<Chain, Errors> {
    if chain.loops.is_empty() {
        return Ok(chain);
    }
    let measured = measured(&chain);
    let mut errors = chain.description.source.errors();
    let mut warnings = Vec::new();
    for (closed, rows) in chain.loops.iter().zip(&measured) {
        refuse(closed, rows, &mut errors);
        warnings.extend(warning(closed, rows));
    }
    if strict {
        for warning in warnings.drain(..) {
            let message = format!("{} (refused: strict)", warning.message);
            errors.push(warning.place, message);
        }
    }
    let mut left_out = Vec::new();
    chain.close(|loops| {
        for (Loop { name, rows, .. }, measured) in loops.iter_mut().zip(measured) {
            let mut measured = measured.iter();
            rows.retain(|row| {
                let constant = measured.next().is_some_and(MeasuredResidual::is_constant);
                left_out.extend(constant.then(|| row.name(name)));
                !constant
            });
        }
    });
    chain.report.closed = left_out;
    chain.report.warnings.extend(warnings);
    errors.into_result(chain)
}

impl MeasuredResidual {
    fn is_constant(&self) -> bool {
        self.share <= LEAST
    }

    /// True if no rounding of the description explains the value.
    fn is_open(&self) -> bool {
        self.is_constant() && self.value.abs() > LEAST * self.size && self.value.abs() > ROUNDED
    }

    /// True if joints change it, but less than can be intended.
    fn is_slight(&self) -> bool {
        !self.is_constant() && self.share <= SLIGHT
    }

    fn is_explained_by_rounding(&self) -> bool {
        self.share <= ROUNDED && self.value.abs() <= ROUNDED
    }
}

/// Errors of one loop.
fn refuse(closed: &Loop, measured: &[MeasuredResidual], errors: &mut Errors) {
    let name = quoted(&closed.name);
    let residual = |row: &ResidualKind| quoted(&row.name(&closed.name));
    let rows = || closed.rows.iter().zip(measured);
    for (row, measured) in rows().filter(|(_, measured)| measured.is_open()) {
        let unit = if row.kind() == Kind::Translation {
            " m"
        } else {
            ""
        };
        let (residual, value) = (residual(row), measured.value);
        errors.push_with_hint(
            closed.place,
            format!("loop {name} cannot close: {residual} is {value}{unit} in every configuration"),
            "put it elsewhere by `at` or `to_at`, or give it a type that leaves this free",
        );
    }
    let slight = rows().filter(|(_, measured)| measured.is_slight());
    let (slight, shares): (Vec<String>, Vec<f64>) = slight
        .map(|(row, measured)| (residual(row), measured.share))
        .unzip();
    if let Some(share) = shares.into_iter().reduce(f64::max) {
        let residuals = list(slight.iter().map(String::as_str));
        errors.push_with_hint(
            closed.place,
            format!(
                "loop {name} blocks the joints: they change {residuals} by at most {share:.0e} of the \
                 links' motion"
            ),
            "axes that should be parallel or at right angles are not: write axes and angles with more digits, or \
             give the loop a type that leaves this free",
        );
    }
    let is_whole = !measured.iter().any(MeasuredResidual::is_open);
    if is_whole && measured.iter().all(MeasuredResidual::is_constant) {
        let message =
            format!("loop {name} constrains nothing: it is closed in every configuration");
        errors.push_with_hint(closed.place, message, "leave it out");
    }
}

/// The warning about the residuals of one loop that are left out although rounding to `f64` does not explain them.
fn warning(closed: &Loop, measured: &[MeasuredResidual]) -> Option<Diagnostic> {
    let slight: Vec<(String, f64)> = (closed.rows.iter().zip(measured))
        .filter(|(_, of)| of.is_constant() && !of.is_open() && !of.is_explained_by_rounding())
        .map(|(row, of)| {
            (
                quoted(&row.name(&closed.name)),
                of.share.max(of.value.abs() / of.size),
            )
        })
        .collect();
    let most = slight.iter().map(|(_, share)| *share).reduce(f64::max)?;
    let names = list(slight.iter().map(|(name, _)| name.as_str()));
    let is = if slight.len() == 1 { "is" } else { "are" };
    Some(Diagnostic {
        place: closed.place,
        message: format!(
            "loop {}: {names} {is} taken as zero, being at most {most:.0e} of the joints' motion",
            quoted(&closed.name)
        ),
        hint: Some("write axes, angles and offsets with more digits".to_owned()),
    })
}

#[cfg(test)]
mod tests;
