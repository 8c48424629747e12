//! Numbers as exporters write them.
//!
//! In: a source of random numbers, and the style of a robot. Out: words: lengths and masses in the robot's units,
//! residues of 1e-18 to 1e-6, right angles with 2 to 17 digits, and angles near them.

use std::f64::consts::FRAC_PI_2;

use crate::states::Random;

use super::super::robot::{FrontEnd, zeros};
use super::super::written::Written;

/// The style of a robot's numbers.
pub(super) struct Numbers<'r> {
    pub(super) random: &'r mut Random,
    /// True if some zeros are written as residues.
    pub(super) residues: bool,
    /// The reader that reads them.
    pub(super) front_end: FrontEnd,
    /// Its unit of length [m].
    pub(super) length: f64,
    /// Its unit of mass \[kg\].
    pub(super) mass: f64,
}

impl Numbers<'_> {
    /// A number of ±10⁻¹⁸ to ±10⁻⁶ with a few digits.
    pub(super) fn residue(&mut self) -> Written {
        let exponent = 6 + self.random.below(13);
        let exponent = i32::try_from(exponent).expect("a small number");
        // Powers of ten as literals are the same on every machine.
        let size: f64 = format!("1e-{exponent}").parse().expect("a number");
        let value = size * (1.5 + self.random.unit()) * self.sign();
        let digits = 1 + self.random.below(8);
        Written::digits(value, digits)
    }

    /// 0, or a residue in a robot with residues.
    pub(super) fn zero(&mut self) -> Written {
        if self.residues && self.random.chance(3) {
            self.residue()
        } else {
            Written::zero()
        }
    }

    /// A number with 2 to 17 digits; in an inline description sometimes a multiple of a third or a seventh.
    pub(super) fn part(&mut self, size: f64) -> Written {
        if self.front_end == FrontEnd::Inline && self.random.chance(6) {
            let (times, of) = (1 + self.random.below(6), *self.random.choose(&[3, 7]));
            let sign = if self.random.chance(2) { "" } else { "-" };
            return Written::new(format!("{sign}{times}*{size:e}/{of}"));
        }
        let value = size * self.random.unit();
        self.number(value)
    }

    /// The number with 2 to 17 digits.
    pub(super) fn number(&mut self, value: f64) -> Written {
        let digits = *self.random.choose(&[2, 3, 4, 6, 9, 17]);
        Written::digits(value, digits)
    }

    /// Three numbers up to a size, some of them zeros or residues.
    pub(super) fn vector(&mut self, size: f64) -> [Written; 3] {
        [(); 3].map(|()| {
            if self.random.chance(3) {
                self.zero()
            } else {
                self.part(size)
            }
        })
    }

    /// A vector along a coordinate axis, but for residues.
    pub(super) fn along(&mut self, size: f64) -> [Written; 3] {
        let mut vector = self.nothing();
        let k = self.random.below(3);
        vector[k] = {
            let value = size * self.random.unit();
            self.number(value)
        };
        vector
    }

    /// A zero vector, but for residues.
    pub(super) fn nothing(&mut self) -> [Written; 3] {
        zeros().map(|_: Written| self.zero())
    }

    pub(super) fn sign(&mut self) -> f64 {
        if self.random.chance(2) { 1.0 } else { -1.0 }
    }

    /// A random angle: mostly zero or a right angle.
    pub(super) fn angle(&mut self) -> Written {
        match self.random.below(16) {
            0..=6 => self.zero(),
            7..=10 => self.right_angle(),
            11 => self.near_right_angle(),
            12 if self.random.chance(2) => self.huge_angle(),
            13 if self.front_end == FrontEnd::Inline => {
                let angles = ["pi/3", "-pi/6", "2*pi/7", "3*pi/4", "-pi/180", "1.5*pi"];
                Written::new(*self.random.choose(&angles))
            }
            _ => {
                let value = 3.0 * self.random.unit();
                self.number(value)
            }
        }
    }

    /// A multiple of π/2 with 2 to 17 decimals, or by `pi`.
    pub(super) fn right_angle(&mut self) -> Written {
        if self.front_end == FrontEnd::Inline && self.random.chance(3) {
            return Written::new(*self.random.choose(&["pi/2", "-pi/2", "pi", "-pi"]));
        }
        let quarters = *self.random.choose(&[-3.0, -2.0, -1.0, 1.0, 2.0, 3.0, 4.0]);
        let decimals = 2 + self.random.below(16);
        Written::decimals(quarters * FRAC_PI_2, decimals)
    }

    /// A right angle with an error of 1e-3 to 1e-15, or truncated where it should be rounded.
    fn near_right_angle(&mut self) -> Written {
        let off = *self
            .random
            .choose(&[1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-15]);
        let value = self.sign() * FRAC_PI_2 + self.sign() * off;
        let decimals = *self.random.choose(&[4, 7, 10, 16]);
        Written::decimals(value, decimals)
    }

    /// An angle up to 1e3 to 1e6 rad; sometimes a multiple of a right angle.
    fn huge_angle(&mut self) -> Written {
        let size = *self.random.choose(&[1e3, 1e4, 1e5, 1e6]);
        let value = size * self.random.unit();
        let decimals = 2 + self.random.below(6);
        if self.random.chance(2) {
            Written::decimals((value / FRAC_PI_2).round() * FRAC_PI_2, decimals)
        } else {
            Written::decimals(value, decimals)
        }
    }

    /// An axis of length 1, or of a length from 1e-3 to 1e3.
    pub(super) fn axis(&mut self) -> [Written; 3] {
        let axis = self.unit_axis();
        if !self.random.chance(3) {
            return axis;
        }
        let exponent = i32::try_from(self.random.below(6)).expect("a small number") - 3;
        let length: f64 = format!("1e{exponent}").parse().expect("a number");
        let length = length * (5.5 + 4.5 * self.random.unit());
        axis.map(|entry| match entry.value() {
            0.0 => entry,
            value => self.number(length * value),
        })
    }

    /// An axis of length 1, mostly along a coordinate axis, sometimes nearly.
    fn unit_axis(&mut self) -> [Written; 3] {
        let mut axis = [0.0; 3];
        let k = self.random.below(3);
        axis[k] = self.sign();
        match self.random.below(6) {
            // A residue whose square is negligible beside 1 leaves the length at 1 to rounding.
            0 if self.residues => {
                let mut words = axis.map(|entry| Written::digits(entry, 2));
                let residue = self.residue();
                if residue.value().abs() < 1e-8 {
                    words[(k + 1) % 3] = residue;
                }
                return words;
            }
            1 if self.residues => {
                axis[(k + 1) % 3] = self.residue().value();
                axis[(k + 2) % 3] = self.residue().value();
            }
            2 => axis = [(); 3].map(|()| self.random.unit()),
            3 => axis[(k + 1) % 3] = self.random.unit(),
            _ => return axis.map(|entry| Written::digits(entry, 2)),
        }
        let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
        axis.map(|entry| Written::digits(entry / length, 17))
    }
}
