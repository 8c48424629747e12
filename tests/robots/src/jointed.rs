//! Robots whose joints have several velocities or mimic others, derived once with the functions that are compared.
//!
//! In: robots/quadruped.urdf, and inline descriptions. Out: a struct for each robot, and a macro that runs a test for
//! each, with its numbers of velocities and coordinates.

#[cfg(not(doc))]
use homogen::Robot;
use homogen::chain;

use crate::with_every_function;

/// Derives the quadruped.
#[cfg(not(doc))]
macro_rules! quadruped {
    ([$($function:ident),*] $($struct:tt)*) => {
        #[derive(Robot, Clone, Copy, Debug)]
        #[robot(urdf = "../../robots/quadruped.urdf", tip = "hr_foot", floating)]
        #[robot(generate($($function,)* forward_dynamics, mass_matrix_inverse))]
        $($struct)*
    };
}

/// Declares a robot.
macro_rules! robot {
    (
        [$($function:ident),*] $(#[$about:meta])*
        pub struct $name:ident { $($settings:tt)* } $($parts:tt)*
    ) => {
        chain! {
            $(#[$about])*
            pub struct $name {
                $($settings)*, generate($($function,)* forward_dynamics, mass_matrix_inverse)
            }
            $($parts)*
        }
    };
}

#[cfg(not(doc))]
with_every_function! { quadruped!
    /// A quadruped with a floating base.
    pub struct FreeQuadruped;
}

with_every_function! { robot!
    /// A gripper on a wrist: two fingers on coupled prismatic joints, a thumb that mimics one of them, and a guard that
    /// mimics the thumb.
    pub struct Gripper { tip: guard }
    link base;
    joint wrist: revolute(z) { from: base, to: palm, at: xyz(0.0, 0.1, 0.2) rpy(0.3, 0.0, -0.4) }
    link palm { mass: 0.6, com: [0.0, 0.01, 0.04], inertia: [0.002, 0.0015, 0.0008] }
    joint right: prismatic(y) {
        from: palm, to: right_finger, at: xyz(0.0, -0.03, 0.1),
        mimic: left, multiplier: -1.0, offset: 0.002
    }
    link right_finger { mass: 0.05, com: [0.0, 0.004, 0.02], inertia: [2.5e-5, 2e-5, 1e-5] }
    joint left: prismatic(y) { from: palm, to: left_finger, at: xyz(0.0, 0.03, 0.1) }
    link left_finger { mass: 0.05, com: [0.0, -0.004, 0.02], inertia: [2.5e-5, 2e-5, 1e-5] }
    joint thumb: revolute(x) {
        from: palm, to: thumb, at: xyz(0.04, 0.0, 0.08), mimic: left, multiplier: 25.0, offset: 0.1
    }
    link thumb { mass: 0.04, com: [0.0, 0.0, 0.03], inertia: [2e-5, 1e-6, 0.0, 2e-5, -1e-6, 4e-6] }
    joint guard: revolute([0.6, 0.0, 0.8]) {
        from: thumb, to: guard, at: xyz(0.0, 0.0, 0.05), mimic: thumb, multiplier: -0.5
    }
    link guard { mass: 0.02, com: [0.005, 0.0, 0.01], inertia: [4e-6, 4e-6, 2e-6] }
}

#[cfg(not(doc))]
with_every_function! { robot!
    /// Every type of joint, in series and in branches.
    pub struct EveryJoint { tip: tool, gravity: [0.5, -1.0, -9.81] }
    link world;
    joint puck: planar([0.0, 0.6, 0.8]) { from: world, to: puck, at: xyz(0.2, 0.0, 0.1) rpy(0.1, 0.2, 0.3) }
    link puck { mass: 3.0, com: [0.05, 0.02, 0.1], inertia: [0.04, 0.001, 0.002, 0.05, -0.003, 0.06] }
    joint ball: spherical { from: puck, to: upper, at: xyz(0.1, -0.2, 0.3) rpy(0.5, -0.4, 0.3) }
    link upper { mass: 2.0, com: [0.0, 0.1, 0.2], inertia: [0.03, 0.001, -0.002, 0.025, 0.001, 0.02] }
    joint hinge: revolute(y) { from: upper, to: fore, at: xyz(0.0, 0.05, 0.4) rpy(0.2, 0.0, 0.0) }
    link fore { mass: 1.0, com: [0.02, 0.0, 0.15], inertia: [0.01, 0.01, 0.003] }
    joint cross: universal(x, [0.0, 0.8, 0.6]) { from: fore, to: hand, at: xyz(0.0, 0.0, 0.3) }
    link hand { mass: 0.5, com: [0.0, 0.01, 0.05], inertia: [0.002, 0.002, 0.001] }
    joint quill: cylindrical(z) { from: hand, to: quill, at: xyz(0.0, 0.02, 0.1) rpy(0.0, 0.3, 0.0) }
    link quill { mass: 0.3, com: [0.01, 0.0, 0.03], inertia: [0.001, 0.001, 0.0005] }
    joint thread: screw([0.0, 0.28, 0.96], pitch: 0.02) { from: quill, to: tool, at: xyz(0.01, 0.0, 0.1) }
    link tool { mass: 0.2, com: [0.0, 0.005, 0.02], inertia: [0.0004, 0.0004, 0.0002] }
    joint stage: translation { from: upper, to: stage, at: xyz(0.3, 0.0, 0.0) rpy(0.0, 0.0, 1.0) }
    link stage { mass: 0.7, com: [0.0, 0.0, 0.02], inertia: [0.003, 0.004, 0.005] }
    joint spin: continuous(z) { from: stage, to: wheel, at: xyz(0.0, 0.1, 0.05) }
    link wheel { mass: 0.4, com: [0.001, 0.0, 0.0], inertia: [0.001, 0.001, 0.0018] }
    joint gear: revolute(x) {
        from: wheel, to: gear, at: xyz(0.05, 0.0, 0.0), mimic: hinge, multiplier: -3.0, offset: 0.2
    }
    link gear { mass: 0.2, com: [0.0, 0.01, 0.01], inertia: [0.0005, 0.0004, 0.0003] }
    joint tether: floating { from: puck, to: drone, at: xyz(0.0, 0.0, 1.0) rpy(0.0, 0.2, 0.0) }
    link drone { mass: 1.2, com: [0.0, 0.01, 0.02], inertia: [0.01, 0.0, 0.001, 0.012, 0.0, 0.02] }
    joint lift: prismatic([0.0, 0.6, 0.8]) { from: drone, to: pod, at: xyz(0.0, 0.0, -0.1) }
    link pod { mass: 0.3, com: [0.0, 0.0, -0.05], inertia: [0.001, 0.001, 0.0008] }
}

#[cfg(not(doc))]
with_every_function! { robot!
    /// A body in free flight.
    pub struct Brick { floating, gravity: [0.0, 0.0, 0.0] }
    link brick { mass: 2.0, com: [0.03, -0.02, 0.05], inertia: [0.02, 0.001, 0.002, 0.03, -0.001, 0.045] }
}

/// Calls a macro for each of these robots, with a name, the struct, the numbers of velocities and coordinates.
#[macro_export]
macro_rules! for_every_jointed_robot {
    ($run:ident) => {
        $run!(free_quadruped, FreeQuadruped, 18, 19);
        $run!(gripper, Gripper, 2, 2);
        $run!(every_joint, EveryJoint, 23, 25);
        $run!(brick, Brick, 6, 7);
    };
}
