//! What the host computed for every state, as bits: committed, and written again by `run.sh`.
#![expect(clippy::unreadable_literal, reason = "bits are not read")]

include!(concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/expected/",
    env!("ARM"),
    ".rs"
));
