//! Rounding errors: printed bounds, the reading of numbers, and hard cases of arithmetic, compared with 256 bits.

mod bound_attacks;
mod bound_climbs;
mod bounds_of_trees;
mod chosen;
mod enclosures;
mod error_bound;
mod exact_reading;
mod hard_cases;
mod hard_cases_geometry;
mod trigonometry;
