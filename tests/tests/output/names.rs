//! The names of generated values, compared with the paper's subscripts (appendix B).
//!
//! M₀,₃ is `m_0_3`, W₀,₃₍₃₎ is `w_0_3_in_3`, and n is the frame of the function. `wd` is ω̇ and `h` the acceleration of
//! the reference point, the two parts of H; in dynamics, gravity is subtracted. J in the frame of its own link is that
//! of the link with all that it carries; `c` is its first moment divided by the mass of the robot; Φ is the wrench
//! through its joint. The poses of frames come from the layout; the matrices share nothing else with the engine.

mod matrices;
mod subscripts;
