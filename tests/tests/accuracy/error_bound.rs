//! Printed error bounds of all functions, compared with measured errors.
//!
//! In: every robot that ships, at random states in the range of the bounds, ends of the range among them. Out: errors
//! are within their bounds, and bounds are not far above the errors. Programs run as generated code does, with and
//! without fused products; the truth is the same function in the frames of the description, in 106 bits.

mod asked;
mod bounds;
mod direct;
mod jointed;
mod solved;
mod states;

use homogen_codegen::Target;
use homogen_codegen::description::Name;
use homogen_codegen::formulation::{Angles, Formulation, Forward, Frame, Parameters};
use homogen_tests::tested::{F32, F64, Fused32, Fused64, Tested};

use asked::{Asked, asked};
use direct::check;
use solved::{
    check_accelerations, check_articulated_derivatives, check_articulated_inverse,
    check_derivatives, check_inverse, check_mobility, check_refined_inverse,
};

fn check_solved<T: Tested>(asked: Asked) {
    assert!(check_accelerations::<T>(asked), "{}", asked.robot);
    check_inverse::<T>(asked);
    check_derivatives::<T>(asked);
}

fn check_both(asked: Asked) {
    check_mobility(asked);
    check::<F64>(asked);
    check::<F32>(asked);
    check::<Fused64>(asked);
    check::<Fused32>(asked);
    check_solved::<F64>(asked);
    check_solved::<F32>(asked);
    check_solved::<Fused64>(asked);
    check_solved::<Fused32>(asked);
}

macro_rules! robot {
    ($robot:ident, $tip:literal) => {
        #[test]
        fn $robot() {
            check_both(asked(stringify!($robot), $tip));
        }
    };
}

robot!(two_link, "tip");
robot!(scara, "tool");
robot!(stanford, "tool");
robot!(stanford_general, "tool");
robot!(puma560, "tool");
robot!(puma560_general, "tool");
robot!(ur5_class, "tool0");
robot!(panda_class, "link8");
robot!(quadruped, "hr_foot");

/// Mimic joints: a velocity moves several joints.
#[test]
fn gripper() {
    check_both(asked("gripper", "l6"));
}

/// Bounds of velocities come from the bodies at the ends of a row of massless links. Solutions are bounded in double
/// precision only.
#[test]
fn with_nothing_between_joints() {
    let asked = with_nothing_between();
    check_mobility(asked);
    check::<F64>(asked);
    check::<F32>(asked);
    check::<Fused64>(asked);
    check::<Fused32>(asked);
    check_solved::<F64>(asked);
    check_solved::<Fused64>(asked);
}

fn with_nothing_between() -> Asked {
    Asked {
        farthest: 1500.0,
        ..asked("nothing_between", "l8")
    }
}

/// Bounds are up to 500 times the worst error with a floating base, and up to 1,400 times if joints with quaternions
/// are carried by others; accelerations are not bounded then in single precision.
#[test]
fn with_quaternions_and_in_a_plane() {
    for asked in with_manifolds() {
        check_mobility(asked);
        check::<F64>(asked);
        check::<F32>(asked);
        check::<Fused64>(asked);
        check::<Fused32>(asked);
    }
    let [free, every] = with_manifolds();
    check_solved::<F64>(free);
    check_solved::<Fused64>(free);
    // The articulated inverse of the other robot is tested below.
    let every = Asked {
        farthest: BY_BODIES,
        ..every
    };
    assert!(check_accelerations::<F64>(every));
    assert!(check_accelerations::<Fused64>(every));
}

/// Largest allowed ratio of bound to error for the articulated-body algorithm with carried quaternions.
const BY_BODIES: f64 = 3500.0;

fn with_manifolds() -> [Asked; 2] {
    [
        Asked {
            floating: true,
            farthest: 250.0,
            ..asked("quadruped", "hr_foot")
        },
        Asked {
            farthest: 800.0,
            ..asked("every_manifold", "l3")
        },
    ]
}

/// Bounds of arms on a floating base are up to 500 times the worst error.
#[test]
fn on_a_floating_base() {
    for (robot, tip) in [("ur5_class", "tool0"), ("puma560_general", "tool")] {
        let asked = Asked {
            floating: true,
            farthest: 250.0,
            ..asked(robot, tip)
        };
        check::<F64>(asked);
        check::<F32>(asked);
        check::<Fused64>(asked);
        check::<Fused32>(asked);
    }
}

/// Distances are bounded where spheres overlap, too.
#[test]
fn with_spheres() {
    for floating in [false, true] {
        let asked = Asked {
            floating,
            farthest: 250.0,
            ..asked("two_arms", "right_hand")
        };
        check::<F64>(asked);
        check::<F32>(asked);
        check::<Fused64>(asked);
        check::<Fused32>(asked);
    }
}

fn panda() -> Asked {
    asked("panda_class", "link8")
}

/// Differences of large sums have loose bounds: up to 5300 times the worst error with fused products. The bounded loss
/// of M is then too large for solutions in single precision.
#[test]
fn in_frame_0() {
    let asked = Asked {
        formulation: Formulation::default().with_frame(Frame::Base),
        farthest: 6500.0,
        ..panda()
    };
    check::<F64>(asked);
    check::<F32>(asked);
    check::<Fused64>(asked);
    check::<Fused32>(asked);
    check_solved::<F64>(asked);
    check_solved::<Fused64>(asked);
    assert!(!check_accelerations::<F32>(asked));
}

#[test]
fn with_the_angles_of_parallel_axes_merged() {
    let formulation = Formulation::default().with_angles(Angles::Merged);
    for (robot, tip) in [("ur5_class", "tool0"), ("puma560_general", "tool")] {
        check_both(Asked {
            formulation,
            ..asked(robot, tip)
        });
    }
}

#[test]
fn with_the_parameters_of_the_description() {
    check_both(Asked {
        formulation: Formulation::default().with_parameters(Parameters::Raw),
        farthest: 250.0,
        ..panda()
    });
}

/// For most robots in double precision only: the bound of a correction is too loose in single precision.
#[test]
fn refined() {
    let refined = |refinements, robot, tip| Asked {
        formulation: Formulation::default().with_forward(Forward::MassMatrix { refinements }),
        ..asked(robot, tip)
    };
    for refinements in [1, 2] {
        let double = [
            ("panda_class", "link8"),
            ("stanford", "tool"),
            ("quadruped", "hr_foot"),
        ];
        for (robot, tip) in double {
            let asked = refined(refinements, robot, tip);
            assert!(check_accelerations::<F64>(asked));
            assert!(check_refined_inverse::<F64>(asked));
            assert!(check_refined_inverse::<Fused64>(asked));
        }
        let single = refined(refinements, "puma560_general", "tool");
        assert!(check_accelerations::<F32>(single));
        assert!(check_refined_inverse::<F32>(single));
    }
}

/// Articulated inertias are not bounded entry by entry: bounds are up to 2800 times the worst error, and up to 130000
/// times for 16 joints in a row, all of which would need the worst rounding at full speed.
#[test]
fn by_articulated_bodies() {
    let (in_both, in_double) = ([true; 2], [true, false]);
    for (robot, tip, farthest, bounded) in [
        ("two_link", "tip", 1000.0, in_both),
        ("scara", "tool", 1500.0, in_both),
        ("stanford_general", "tool", 1000.0, in_both),
        ("puma560_general", "tool", 1000.0, in_both),
        ("panda_class", "link8", 1500.0, in_double),
        ("quadruped", "hr_foot", 1000.0, in_both),
        // The link of the prismatic joint has no mass of its own.
        ("lift/6", "", 1000.0, in_double),
        ("spatial/16", "", 2e5, in_double),
        ("heavy_tip/1e6", "", 1500.0, in_double),
        ("heavy_base/1e6", "", 1000.0, in_double),
    ] {
        let asked = Asked {
            farthest,
            ..asked(robot, tip)
        };
        check_articulated(asked, bounded);
    }
    let [free, every] = with_manifolds();
    for (asked, farthest) in [
        (free, 1500.0),
        (every, BY_BODIES),
        (with_nothing_between(), 1500.0),
    ] {
        check_articulated(Asked { farthest, ..asked }, in_double);
    }
}

/// `bounded`: true for double and for single precision if bounds must exist.
fn check_articulated(asked: Asked, bounded: [bool; 2]) {
    let asked = Asked {
        formulation: Formulation::default().with_forward(Forward::Articulated),
        ..asked
    };
    let found = [
        check_solved_by_bodies::<F64>(asked),
        check_solved_by_bodies::<F32>(asked),
    ];
    let fused = [
        check_solved_by_bodies::<Fused64>(asked),
        check_solved_by_bodies::<Fused32>(asked),
    ];
    for found in [found, fused] {
        for ([accelerations, inverse, derivatives], bounded) in found.into_iter().zip(bounded) {
            assert_eq!(
                [accelerations, derivatives],
                [bounded; 2],
                "{}",
                asked.robot
            );
            // Entries of the inverse need no range of accelerations.
            assert!(inverse || !bounded, "{}", asked.robot);
        }
    }
}

/// True for accelerations, the inverse and the derivatives if they have bounds.
fn check_solved_by_bodies<T: Tested>(asked: Asked) -> [bool; 3] {
    [
        check_accelerations::<T>(asked),
        check_articulated_inverse::<T>(asked),
        check_articulated_derivatives::<T>(asked),
    ]
}

/// Bounds include the rounding of armature, friction and external wrenches, with every algorithm of forward dynamics.
#[test]
fn with_actuators_and_external_wrenches() {
    for (robot, tip) in [("stanford_general", "tool"), ("panda_class", "link8")] {
        check_both(Asked {
            has_actuators: true,
            farthest: 250.0,
            ..asked(robot, tip)
        });
        for (forward, farthest) in [
            (Forward::MassMatrix { refinements: 1 }, 250.0),
            (Forward::Articulated, 1500.0),
        ] {
            let asked = Asked {
                formulation: Formulation::default().with_forward(forward),
                has_actuators: true,
                farthest,
                ..asked(robot, tip)
            };
            assert!(check_accelerations::<F64>(asked), "{robot}");
            assert!(check_accelerations::<Fused64>(asked), "{robot}");
        }
    }
}

/// Solutions have no bound with run-time inertias or rotations.
#[test]
fn with_run_time_payloads_inertias_and_placements() {
    for (free, farthest) in [
        (
            &[
                (Target::PayloadOn as fn(Name) -> Target, "link8"),
                (Target::InertiaOf, "link5"),
            ][..],
            500.0,
        ),
        // The bound does not use that the columns of a run-time rotation are orthogonal.
        (&[(Target::PlacementOf, "joint4")], 4000.0),
    ] {
        let asked = Asked {
            free,
            farthest,
            ..panda()
        };
        check::<F64>(asked);
        check::<F32>(asked);
        check::<Fused64>(asked);
        check::<Fused32>(asked);
        assert!(!check_accelerations::<F64>(asked));
    }
}

#[test]
fn with_run_time_masses() {
    check_both(Asked {
        loads: &["link3", "link8"],
        ..panda()
    });
}
