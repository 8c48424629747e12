//! Values of generated functions: compared with the generic recursions, with Pinocchio's numbers, with the laws of
//! mechanics, and with 256 bits.
//!
//! One program, as are the other three: tests share what is instantiated of the library, and run side by side.

mod actuators;
mod agreement;
mod configurations;
mod derivatives;
mod driven_joints;
mod eval_reference;
mod external;
mod forward_dynamics;
mod identities;
mod ik;
mod in_place;
mod joints;
mod long_functions;
mod loops;
mod mechanisms;
mod oracle;
mod reference;
mod regressor;
mod residues;
mod spheres;
mod steps;
mod time_steps;
mod trees;
