//! Every robot that ships, derived once with all its functions.
//!
//! In: robots/*.urdf. Out: a struct for each robot, and a macro that runs a test for each.

use homogen::{Robot, Scalar};

use crate::functions::{self, Block, Shared};
use crate::states::State;

/// Derives a robot with all functions, alone and shared.
macro_rules! robot {
    ($(#[$about:meta])* $name:ident, $joints:literal, $file:literal, $tip:literal) => {
        $(#[$about])*
        #[derive(Robot, Clone, Copy, Debug)]
        #[robot(urdf = $file, tip = $tip, generate(all))]
        pub struct $name;

        const _: () = {
            #[derive(Robot)]
            #[robot(urdf = $file, tip = $tip)]
            #[robot(generate(
                all_of(forward_kinematics, geometric_jacobian),
                all_of(mass_matrix, bias),
            ))]
            struct Together;

            impl<T: Scalar> Shared<$joints, T> for $name {
                fn shared(&self, state: &State<T, $joints>) -> [Vec<Block<T>>; 2] {
                    let State { q, qd, .. } = state;
                    let (m, columns) = Together.forward_kinematics_and_geometric_jacobian(q);
                    let (mass, bias) = Together.mass_matrix_and_bias(q, qd);
                    [functions::of_the_tip(&m, &columns), functions::of_the_whole(&mass, &bias)]
                }
            }
        };
    };
}

robot! {
    /// Two links in a vertical plane.
    TwoLink, 2, "../robots/two_link.urdf", "tip"
}
robot! {
    /// Four joints with parallel axes, one of them prismatic.
    Scara, 4, "../robots/scara.urdf", "tool"
}
robot! {
    /// The Stanford arm.
    Stanford, 6, "../robots/stanford.urdf", "tool"
}
robot! {
    /// The Stanford arm without a zero among its inertial parameters.
    StanfordGeneral, 6, "../robots/stanford_general.urdf", "tool"
}
robot! {
    /// The PUMA 560.
    Puma560, 6, "../robots/puma560.urdf", "tool"
}
robot! {
    /// The PUMA 560 without a zero among its inertial parameters.
    Puma560General, 6, "../robots/puma560_general.urdf", "tool"
}
robot! {
    /// Six joints, three of them parallel.
    Ur5Class, 6, "../robots/ur5_class.urdf", "tool0"
}
robot! {
    /// Seven joints.
    PandaClass, 7, "../robots/panda_class.urdf", "link8"
}
robot! {
    /// A tree of twelve joints on a fixed base.
    Quadruped, 12, "../robots/quadruped.urdf", "hr_foot"
}

/// Calls a macro with the file name and the struct of every robot that ships.
#[macro_export]
macro_rules! for_every_robot {
    ($run:ident) => {
        $run!(two_link, TwoLink);
        $run!(scara, Scara);
        $run!(stanford, Stanford);
        $run!(stanford_general, StanfordGeneral);
        $run!(puma560, Puma560);
        $run!(puma560_general, Puma560General);
        $run!(ur5_class, Ur5Class);
        $run!(panda_class, PandaClass);
        $run!(quadruped, Quadruped);
    };
}
