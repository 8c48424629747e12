//! Variants of generated code compared with the derive of the same robot: formulations, scalar types, files for `core`
//! alone, C; text and operation counts are pinned.

mod c99;
mod expansion;
mod formulations;
mod hostile;
mod parameters;
mod platform;
mod prepared;
mod processors;
mod scalars;
mod standalone;
