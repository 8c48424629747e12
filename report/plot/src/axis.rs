//! Range and ticks of an axis.
//!
//! In: numbers and a scale. Out: fractions of the axis, and ticks with what is written there. It
//! knows no pixels but those that a label needs.

use super::Scale;

/// The range of an axis; of its logarithms on a logarithmic one.
pub(super) struct Span {
    pub low: f64,
    pub high: f64,
    scale: Scale,
}

impl Span {
    /// The range of values with a margin at both ends: a share of the range, or on a logarithmic axis decades, which
    /// ends at whole ones.
    pub fn of(scale: Scale, values: impl Iterator<Item = f64>, margin: f64) -> Self {
        let position = |x: f64| position(scale, x);
        let (low, high) = values
            .map(position)
            .filter(|x| x.is_finite())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
                (low.min(x), high.max(x))
            });
        let (low, high) = if low > high { (0.0, 1.0) } else { (low, high) };
        let (low, high) = match scale {
            Scale::Log => ((low - margin).floor(), (high + margin).ceil()),
            _ => (low - margin * (high - low), high + margin * (high - low)),
        };
        // A constant needs some room as well.
        let (low, high) = if high > low {
            (low, high)
        } else {
            (low - 1.0, high + 1.0)
        };
        Self { low, high, scale }
    }

    /// From 0 at the low end to 1 at the high one.
    pub fn fraction(&self, x: f64) -> f64 {
        let x = position(self.scale, x);
        (x - self.low) / (self.high - self.low)
    }

    /// Ticks and what is written there.
    pub fn ticks(&self, room: f64) -> Vec<(f64, String)> {
        let step = match self.scale {
            Scale::Every(step) => step,
            Scale::Doubling => 1.0,
            Scale::Log => ((self.high - self.low) * 28.0 / room).ceil().max(1.0),
            Scale::Linear => round_step((self.high - self.low) * 60.0 / room),
        };
        let first = (self.low / step - 1e-9).ceil();
        (0..200)
            .map(|k| (first + f64::from(k)) * step)
            .take_while(|x| *x <= self.high + 1e-9 * step)
            .map(|x| match self.scale {
                Scale::Log => (10_f64.powf(x), format!("10{}", superscript(x))),
                Scale::Doubling => (x.exp2(), number(x.exp2(), 1.0)),
                Scale::Linear | Scale::Every(_) => (x, number(x, step)),
            })
            .collect()
    }
}

/// The position of a number on an axis.
fn position(scale: Scale, x: f64) -> f64 {
    match scale {
        Scale::Linear | Scale::Every(_) => x,
        Scale::Log => x.log10(),
        Scale::Doubling => x.log2(),
    }
}

/// The next larger 1, 2 or 5 times a power of ten.
fn round_step(least: f64) -> f64 {
    let power = 10_f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0, 10.0]
        .map(|digit| digit * power)
        .into_iter()
        .find(|step| *step >= least)
        .unwrap_or(least)
}

/// `x` with as many decimals as `step` has, and a true minus sign.
fn number(x: f64, step: f64) -> String {
    let decimals = (0..8)
        .find(|d| {
            let scaled = step * 10_f64.powi(*d);
            (scaled - scaled.round()).abs() < 1e-6
        })
        .unwrap_or(8);
    // What is left of zero after additions is zero.
    let x = if x.abs() < 1e-9 * step { 0.0 } else { x };
    let decimals = usize::try_from(decimals).unwrap_or(0);
    format!("{x:.decimals$}").replace('-', "−")
}

/// A whole number, raised.
fn superscript(x: f64) -> String {
    let raised = |c| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        _ => '⁰',
    };
    format!("{x:.0}").chars().map(raised).collect()
}

#[cfg(test)]
mod tests {
    use super::super::Scale;
    use super::{Span, number, round_step};

    #[test]
    fn steps_are_round() {
        for (least, step) in [(0.013, 0.02), (0.2, 0.2), (3.0, 5.0), (70.0, 100.0)] {
            assert!((round_step(least) / step - 1.0_f64).abs() < 1e-12);
        }
    }

    #[test]
    fn numbers_have_the_decimals_of_their_step() {
        assert_eq!(number(-0.1 - 0.2, 0.1), "−0.3");
        assert_eq!(number(1e-17, 0.5), "0.0");
        assert_eq!(number(90.0, 90.0), "90");
    }

    #[test]
    fn powers_of_ten_span_whole_decades() {
        let span = Span::of(Scale::Log, [2e-3, 40.0, 0.0].into_iter(), 0.0);
        let ticks: Vec<String> = span
            .ticks(600.0)
            .into_iter()
            .map(|(_, label)| label)
            .collect();
        assert_eq!(ticks, ["10⁻³", "10⁻²", "10⁻¹", "10⁰", "10¹", "10²"]);
    }
}
