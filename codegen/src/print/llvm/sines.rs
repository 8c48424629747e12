//! Function for the sine and the cosine of an angle, or of one angle in each lane.
//!
//! In: the type of a value. Out: `@sin_cos`, private to the module.

use std::fmt::Write;

use super::body::{LlvmWriter, local};
use super::lanes::Lanes;
use crate::formulation::Sines;
use crate::print::sines::{ANGLE, COSINE, SHIFTED, SINE, statements};
use crate::print::walk::walk;

/// Definition. The last step works on bits: in odd quadrants sine and cosine are exchanged, and signs change.
pub(super) fn define(lanes: Lanes, fused: bool) -> String {
    let mut writer = LlvmWriter::new(lanes, fused, Sines::Own);
    walk(&mut writer, &statements(lanes.real));
    let (value, bits) = (lanes.value(), lanes.bits());
    let top = u64::try_from(8 * lanes.size() - 2).expect("32 or 64 bits");
    let [one, places, sign, zero] = [1, top, 1 << (top + 1), 0].map(|of| lanes.integer(of));
    let cast = |name: &str| format!("bitcast {value} {} to {bits}", local(name));
    let mut bind = |name: &str, instruction: &str| writer.bind(name, instruction);
    bind("s.bits", &cast(SINE));
    bind("c.bits", &cast(COSINE));
    bind("quadrant", &cast(SHIFTED));
    bind("odd", &format!("and {bits} %quadrant, {one}"));
    bind("mask", &format!("sub {bits} {zero}, %odd"));
    bind("both", &format!("xor {bits} %s.bits, %c.bits"));
    bind("exchanged", &format!("and {bits} %both, %mask"));
    bind("s.moved", &format!("shl {bits} %quadrant, {places}"));
    bind("next", &format!("add {bits} %quadrant, {one}"));
    bind("c.moved", &format!("shl {bits} %next, {places}"));
    for letter in ["s", "c"] {
        bind(
            &format!("{letter}.sign"),
            &format!("and {bits} %{letter}.moved, {sign}"),
        );
        bind(
            &format!("{letter}.other"),
            &format!("xor {bits} %{letter}.bits, %exchanged"),
        );
        bind(
            &format!("{letter}.found"),
            &format!("xor {bits} %{letter}.other, %{letter}.sign"),
        );
        bind(
            letter,
            &format!("bitcast {bits} %{letter}.found to {value}"),
        );
    }
    bind(
        "pair",
        &format!("insertvalue {{ {value}, {value} }} poison, {value} %s, 0"),
    );
    bind(
        "turn",
        &format!("insertvalue {{ {value}, {value} }} %pair, {value} %c, 1"),
    );
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "define internal {{ {value}, {value} }} {}({value} {}) alwaysinline {{\n{}  ret {{ {value}, {value} }} %turn\n}}\n",
        lanes.sin_cos(),
        local(ANGLE),
        writer.finish()
    );
    text
}
