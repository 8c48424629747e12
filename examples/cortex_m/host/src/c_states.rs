//! The states of the tests, for C.
//!
//! In: the table of `controller`. Out: a header with the bits of its numbers, which every compiler reads alike.

use std::fmt::Write;

use controller::{JOINTS, STATES, states};

/// The header.
pub fn text() -> String {
    let mut text = format!(
        "/* Written by `host states`: the states on which the controller is tried, as bits of float. */

#define JOINTS {JOINTS}
#define STATES {STATES}

struct state {{
    float q[JOINTS], qd[JOINTS], qdd[JOINTS], tau[JOINTS];
}};

static const union {{
    uint32_t bits[4][JOINTS];
    struct state state;
}} states[STATES] = {{
"
    );
    for state in states() {
        let rows = [state.q, state.qd, state.qdd, state.tau].map(|row| {
            let bits = row.map(|number| format!("{:#010x}", number.to_bits()));
            format!("{{{}}}", bits.join(", "))
        });
        // Writing to a string cannot fail.
        let _ = writeln!(text, "    {{{{{}}}}},", rows.join(", "));
    }
    text.push_str("};\n");
    text
}
