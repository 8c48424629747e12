//! The names of generated values against the paper's subscripts (appendix B).
//!
//! M₀,₃ is `m_0_3`, W₀,₃₍₃₎ is `w_0_3_in_3`, and n is the frame that a function is of; `wd` is ω̇ and `h` the
//! acceleration of the pole, the two parts of H, in dynamics less gravity. J in the frame of its own link
//! is that of the link with all it carries, `c` its first moment by the mass of the robot, and Φ the action
//! through its joint. Where frames stand is read from the layout; the matrices share nothing else with the
//! engine.

mod matrices;
mod subscripts;
