//! The results of the host for every state, as bits; committed, and updated by `run.sh --update`.
#![expect(clippy::unreadable_literal, reason = "bits are not read")]

include!(concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/expected/",
    env!("ARM"),
    ".rs"
));
