//! Wrong edits of the paper's equations in the runtime, and of names in generated code.
//!
//! Each is noticed by the test that the runtime's checklist names beside the equation.

use super::{Mutation, Test};

/// All mutations of this file, in the order of the checklist.
pub const EQUATIONS: &[Mutation] = &[
    Mutation {
        name: "change of frame: the reference point moved the other way",
        file: "runtime/src/matrix/form.rs",
        from: "cross(m_r_s.translation(), u)",
        to: "cross(u, m_r_s.translation())",
        noticed_by: row("translation::shifted_frames_move_the_pole_alone::f64"),
    },
    Mutation {
        name: "composition: half of the Coriolis term",
        file: "runtime/src/matrix/acceleration.rs",
        from: "let two = T::constant(2.0);",
        to: "let two = T::constant(1.0);",
        noticed_by: row("composition::composed_motion::f64"),
    },
    Mutation {
        name: "gravity as a matrix: upwards",
        file: "runtime/src/matrix/acceleration.rs",
        from: "Self::new([[T::constant(0.0); 3]; 3], g)",
        to: "Self::new([[T::constant(0.0); 3]; 3], scale(T::constant(-1.0), g))",
        noticed_by: row("dynamics::gravity_as_a_matrix::f64"),
    },
    Mutation {
        name: "names: the frame of a branch by the number of its joint",
        file: "codegen/src/model/carry.rs",
        from: "(Frame::Link, Some(parent)) => parent.into(),\n            (Frame::Link, None) | (Frame::Base, _) => Numeral::BASE,",
        to: "(Frame::Link, _) => Numeral(self.body.number() - 1),\n            (Frame::Base, _) => Numeral::BASE,",
        noticed_by: Test {
            package: "homogen-tests",
            target: &["--test", "output"],
            name: "names::subscripts::names_are_those_of_appendix_b",
        },
    },
    Mutation {
        name: "angles: axes carried the other way",
        file: "runtime/src/paper/angles.rs",
        from: "cross(first, second)",
        to: "cross(second, first)",
        noticed_by: row("angles::rates_and_second_rates_are_derivatives::f64"),
    },
    Mutation {
        name: "lines: the distance along the line, not across",
        file: "runtime/src/paper/geometry.rs",
        from: "norm(cross(self.direction, sub(point, self.point)))",
        to: "dot(self.direction, sub(point, self.point)).abs()",
        noticed_by: row("nearest::distances_are_the_least_over_parameters::f64"),
    },
];

const fn row(name: &'static str) -> Test {
    Test {
        package: "homogen",
        target: &["--test", "paper"],
        name,
    }
}
