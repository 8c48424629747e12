//! Random robots with closed loops, in any orientation, through the whole generator, compared with equations of motion
//! in 256 bits: see [`homogen_tests::mechanisms`]. `cargo run --release -p homogen-tests --bin mechanisms` runs a
//! thousand.

use homogen_tests::mechanisms::draw::Kind;
use homogen_tests::mechanisms::judge::Outcome;
use homogen_tests::mechanisms::{Trial, examine};

/// The run whose robots are tested.
const RUN: u64 = 0;

/// The number of right robots of some indices; all others must be reported as singular or refused by name.
fn right(indices: impl Iterator<Item = usize>) -> usize {
    let mut failures = Vec::new();
    let mut right = 0;
    for index in indices {
        match examine(Trial::numbered(RUN, index)) {
            Ok(Outcome::Right(_)) => right += 1,
            Ok(Outcome::Singular | Outcome::Refused) => {}
            Err(message) => failures.push(message),
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    right
}

/// True except for Stewart platforms, which take most of the time.
fn is_short(index: usize) -> bool {
    Trial::numbered(RUN, index).kind != Kind::Stewart
}

#[test]
fn robots_written_with_all_digits_move_as_drawn() {
    let indices: Vec<usize> = (0..20).filter(|&index| is_short(index)).collect();
    assert_eq!(right(indices.iter().copied()), indices.len());
}

#[test]
fn robots_written_with_few_digits_move_or_are_reported() {
    assert!(right((20..40).filter(|&index| is_short(index))) >= 8);
}

#[test]
fn robots_in_single_precision_move_or_are_reported() {
    let first =
        (0..200).find(|&index| Trial::numbered(RUN, index).scalar == homogen_codegen::Real::F32);
    let first = first.expect("a third of them");
    assert!(right((first..first + 10).filter(|&index| is_short(index))) >= 5);
}

#[test]
fn a_stewart_platform_moves_as_drawn() {
    let stewart = (0..20)
        .find(|&index| !is_short(index))
        .expect("every tenth");
    assert_eq!(right(std::iter::once(stewart)), 1);
}

/// A Bennett linkage whose residuals nearly depend on each other near some closed configurations, and not in all.
#[test]
fn a_linkage_is_judged_away_from_its_singular_configurations() {
    let bennett = Trial::numbered(1, 446);
    assert_eq!(bennett.kind, Kind::Bennett);
    let outcome = examine(bennett);
    assert!(matches!(outcome, Ok(Outcome::Right(_))), "{outcome:?}");
}

/// Linkages with a ball in an inclined plane, where the first two of the ball's three residuals nearly depend on each
/// other: the third is eliminated before one of them.
#[test]
fn residuals_are_eliminated_in_an_order_that_keeps_digits() {
    for index in [1, 571, 1331] {
        let linkage = Trial::numbered(7, index);
        assert_eq!(linkage.kind, Kind::FourBarWithBall);
        let outcome = examine(linkage);
        assert!(
            matches!(outcome, Ok(Outcome::Right(_))),
            "{index}: {outcome:?}"
        );
    }
}

/// The same linkage with three digits. A search for a closed configuration ends where the ball is a millimetre off and
/// seems to be free to move across the plane.
#[test]
fn a_linkage_that_closes_in_single_configurations_alone_is_reported() {
    for index in [151, 1111] {
        let linkage = Trial::numbered(7, index);
        assert_eq!((linkage.kind, linkage.digits), (Kind::FourBarWithBall, 3));
        let outcome = examine(linkage);
        assert!(
            matches!(outcome, Ok(Outcome::Singular)),
            "{index}: {outcome:?}"
        );
    }
}
