//! What proves that a processor has registers of 256 and of 512 bits, whose instructions code for its target may not
//! have.

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
pub use pulp::x86::{V3 as Narrow, V4 as Wide};

/// Nothing: the target tells all of the processor.
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
pub type Narrow = ();

/// Nothing: the target tells all of the processor.
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
pub type Wide = ();
