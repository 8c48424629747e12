//! The unit of each number of a result, 1 where it has none.
//!
//! In: which joints slide. Out: units, in the order of the numbers.

pub(super) fn pose(_: &[bool]) -> Vec<&'static str> {
    rows("1", "m")
}

pub(super) fn acceleration(_: &[bool]) -> Vec<&'static str> {
    rows("1/s²", "m/s²")
}

pub(super) fn velocity(_: &[bool]) -> Vec<&'static str> {
    ["rad/s", "m/s"].map(|unit| [unit; 3]).concat()
}

pub(super) fn screws(slides: &[bool]) -> Vec<&'static str> {
    let b = by_joint(slides, "m", "1").into_iter();
    b.flat_map(|b| ["1", "1", "1", b, b, b]).collect()
}

pub(super) fn forces(slides: &[bool]) -> Vec<&'static str> {
    by_joint(slides, "N m", "N")
}

pub(super) fn accelerations(slides: &[bool]) -> Vec<&'static str> {
    by_joint(slides, "rad/s²", "m/s²")
}

pub(super) fn inertias(slides: &[bool]) -> Vec<&'static str> {
    by_pair(slides, ["kg m²", "kg m", "kg"])
}

pub(super) fn inverse_inertias(slides: &[bool]) -> Vec<&'static str> {
    by_pair(slides, ["1/(kg m²)", "1/(kg m)", "1/kg"])
}

fn rows(rotation: &'static str, translation: &'static str) -> Vec<&'static str> {
    [rotation, rotation, rotation, translation].repeat(3)
}

fn by_joint(slides: &[bool], turning: &'static str, sliding: &'static str) -> Vec<&'static str> {
    let units = slides
        .iter()
        .map(|&slides| if slides { sliding } else { turning });
    units.collect()
}

/// Of two joints that turn, of which one does, of which none does.
fn by_pair(slides: &[bool], [both, one, none]: [&'static str; 3]) -> Vec<&'static str> {
    let pairs = slides
        .iter()
        .flat_map(|a| slides.iter().map(move |b| (*a, *b)));
    pairs
        .map(|pair| match pair {
            (false, false) => both,
            (true, true) => none,
            _ => one,
        })
        .collect()
}
