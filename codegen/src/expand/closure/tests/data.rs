//! The chain with its loops as data, and its header for C.

use super::{FOUR_BAR, PIN, described};
use crate::check::Check;
use crate::expand::{expand, understand};
use crate::function::Function;
use crate::module::Module;
use crate::print::c;
use crate::print::rust::{FormattedSource, Item, Library, print};
use crate::request::{ForC, Request};
use crate::space::Order;

fn module() -> Module {
    let (description, request) = described(&(FOUR_BAR.to_owned() + PIN));
    let request = Request {
        functions: vec![vec![Function::ConstraintJacobian]],
        ..request
    };
    expand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"))
}

#[test]
fn data_of_another_loop_is_refused() {
    let (description, request) = described(&(FOUR_BAR.to_owned() + PIN));
    let chain = understand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    let check = Check::of(&chain).unwrap_or_else(|errors| panic!("{errors}"));
    let mut data = module().data;
    check
        .judge_data(&data)
        .unwrap_or_else(|errors| panic!("{errors}"));
    data.loops.loops[0].rows.reverse();
    let reported = check.judge_data(&data).expect_err("x is y").to_string();
    let start = "in the data, entry 0 (residual \"pin.x\") of constraint would be ";
    assert!(reported.contains(start), "{reported}");
}

#[test]
fn a_robot_with_loops_has_a_mechanism() {
    let (item, library) = (Item::named_after("four bar"), Library::default());
    let text = FormattedSource::new("", &print(&module(), &item, &library)).to_string();
    assert!(
        text.contains("pub const fn closed_loops() -> ::homogen::ClosedLoopRobot<3, 0, 2, 3, 3> {"),
        "{text}"
    );
    for (name, row) in [("pin.x", 0), ("pin.y", 1)] {
        assert!(text.contains(&format!("\"{name}\"")), "{text}");
        assert!(
            text.contains(&format!("::homogen::ResidualKind::Along({row})")),
            "{text}"
        );
    }
    let mut open = module();
    open.data.loops.loops.clear();
    let text = FormattedSource::new("", &print(&open, &item, &library)).to_string();
    assert!(!text.contains("closed_loops"), "{text}");
}

#[test]
fn headers_of_c_count_residuals() {
    let writing = c::COptions {
        prefix: "bars_",
        header: "bars.h",
        asked: "",
        fused: false,
        for_c: ForC::default(),
        templates: false,
        order: Order::AngularFirst,
    };
    let c::CSource { header, .. } = c::print(&module(), &writing);
    for part in [
        "/* Entries of the residuals of loops. */\nenum {\n    BARS_C_PIN_X, /* `pin.x` */\n",
        "    BARS_C_PIN_Y, /* `pin.y` */\n    BARS_NC\n};\n",
        "(const double q[3], double constraint_jacobian[2][3]);",
    ] {
        assert!(header.contains(part), "{header}");
    }
}
