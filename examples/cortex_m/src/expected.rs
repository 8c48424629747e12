//! What the host computed for every state, as bits: committed, and written again by `run.sh`.

include!(concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/expected/",
    env!("ARM"),
    ".rs"
));
