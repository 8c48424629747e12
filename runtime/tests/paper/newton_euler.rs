//! SPACELIB's `dyn_eq`: any six of the twelve numbers of Φ = skew[Ẇ J] and Γ = skew[W J].

use crate::dense::{assert_same, assert_within, size_of};
use crate::sample::Random;
use homogen::{Acceleration, Error, Inertia, Real, Velocity, newton_euler};

fn numbers<T: Real>((a, b): ([T; 3], [T; 3])) -> [T; 6] {
    let ([p, q, r], [x, y, z]) = (a, b);
    [p, q, r, x, y, z]
}

/// True for each given number of the twelve: one of each pair, or six at random.
fn masks(random: &mut Random) -> Vec<[bool; 12]> {
    let mut list: Vec<[bool; 12]> = (0..64)
        .map(|bits| std::array::from_fn(|k| (bits >> (k % 6) & 1 == 1) == (k < 6)))
        .collect();
    for _ in 0..100 {
        let mut mask = [false; 12];
        while mask.iter().filter(|given| **given).count() < 6 {
            mask[random.index(12)] = true;
        }
        list.push(mask);
    }
    list
}

fn six_of_twelve<T: Real>() {
    let mut random = Random::new(160);
    let mut solved = 0;
    for mask in masks(&mut random) {
        let j = random.inertia::<T>();
        let w = random.velocity::<T>();
        let gamma = j.momentum(&w);
        let (x, y) = (
            numbers((w.omega(), w.v())),
            numbers((gamma.gamma(), gamma.rho())),
        );
        let kinematic = std::array::from_fn(|i| mask[i].then_some(x[i]));
        let dynamic = std::array::from_fn(|i| mask[i + 6].then_some(y[i]));
        match newton_euler::momentum(&j, kinematic, dynamic) {
            Ok((found, momentum)) => {
                solved += 1;
                // For any condition number, both sides are consistent and contain the given numbers.
                let back = j.momentum(&found);
                let size = size_of(&found.to_matrix()).max(T::constant(1.0));
                let scale = T::constant(4.0) * size * size_of(&j.to_matrix()).max(T::constant(1.0));
                assert_same(&momentum.to_matrix(), &back.to_matrix(), scale, 16.0);
                let (fx, fy) = (
                    numbers((found.omega(), found.v())),
                    numbers((momentum.gamma(), momentum.rho())),
                );
                for i in 0..6 {
                    assert!(!mask[i] || fx[i] == x[i]);
                    assert!(!mask[i + 6] || fy[i] == y[i]);
                }
            }
            // Six random numbers need not determine the others.
            Err(Error::Degenerate { .. }) => assert!(mask[..6] != [true; 6]),
            Err(other) => panic!("{other}"),
        }
    }
    assert!(solved > 100, "only {solved} solved");
}

fn one_of_each_pair_is_well_posed<T: Real>() {
    let mut random = Random::new(161);
    for mask in masks(&mut random).into_iter().take(64) {
        let j = random.inertia::<T>();
        let w = random.velocity::<T>();
        let phi = j.action(&Acceleration::from_velocity_derivative(
            &Velocity::zero(),
            &w,
        ));
        let (x, y) = (numbers((w.omega(), w.v())), numbers((phi.c(), phi.f())));
        let kinematic = std::array::from_fn(|i| mask[i].then_some(x[i]));
        let dynamic = std::array::from_fn(|i| mask[i + 6].then_some(y[i]));
        let (found, action) =
            newton_euler::action(&j, kinematic, dynamic).expect("a body with inertia");
        // The condition number of a random body of six particles is far below this.
        assert_within(
            numbers((found.omega(), found.v())),
            x,
            T::constant(1.0),
            32.0,
        );
        assert_within(numbers((action.c(), action.f())), y, T::constant(4.0), 32.0);
    }
}

fn free_motion_of_a_moving_body<T: Real>() {
    let mut random = Random::new(162);
    for _ in 0..50 {
        let (j, w) = (random.inertia::<T>(), random.velocity::<T>());
        // Direct dynamics: Φ is given and Ẇ unknown; then the inverse.
        let phi = numbers((random.vector::<T>(), random.vector()));
        let (h, action) =
            newton_euler::action_in_motion(&j, &w, [None; 6], phi.map(Some)).expect("inertia");
        assert_within(
            numbers((action.c(), action.f())),
            phi,
            T::constant(16.0),
            8.0,
        );
        let (scale, again) = (
            size_of(&h.to_matrix()) * size_of(&j.to_matrix()),
            j.action(&h),
        );
        assert_same(
            &again.to_matrix(),
            &action.to_matrix(),
            T::constant(8.0) * scale,
            8.0,
        );
        let rate = h.velocity_derivative(&w);
        let rates = numbers((rate.omega(), rate.v()));
        let (back, same) =
            newton_euler::action_in_motion(&j, &w, rates.map(Some), [None; 6]).expect("inertia");
        assert_same(&back.to_matrix(), &h.to_matrix(), T::constant(8.0), 8.0);
        assert_same(
            &same.to_matrix(),
            &action.to_matrix(),
            T::constant(8.0) * scale,
            8.0,
        );
    }
}

fn systems_that_determine_nothing_are_refused<T: Real>() {
    let zero = T::constant(0.0);
    let rod = Inertia::of_particle(T::constant(1.0), [T::constant(1.0), zero, zero])
        + Inertia::of_particle(T::constant(1.0), [T::constant(-1.0), zero, zero]);
    // A rod has no inertia about its axis, and a body without mass has none at all.
    let refused = newton_euler::action(&rod, [None; 6], [Some(T::constant(1.0)); 6]);
    assert!(
        matches!(refused, Err(Error::Degenerate { .. })),
        "{refused:?}"
    );
    let refused = newton_euler::action(&Inertia::zero(), [None; 6], [Some(zero); 6]);
    assert!(matches!(refused, Err(Error::Degenerate { .. })));
    // Too few, too many.
    let refused = newton_euler::momentum(&rod, [None; 6], [None; 6]);
    assert!(matches!(refused, Err(Error::Degenerate { value: 0.0, .. })));
    let refused = newton_euler::momentum(&rod, [Some(zero); 6], [Some(zero); 6]);
    assert!(matches!(
        refused,
        Err(Error::Degenerate { value: 12.0, .. })
    ));
    let nan = newton_euler::momentum(&rod, [Some(T::constant(f64::NAN)); 6], [None; 6]);
    assert!(matches!(nan, Err(Error::NotFinite { .. })));
    // The inverse problem of the same rod is regular: every motion has a momentum.
    let moved = newton_euler::momentum(&rod, [Some(T::constant(1.0)); 6], [None; 6]);
    assert_eq!(moved.map(|(_, gamma)| gamma.gamma()[0]), Ok(zero));
}

in_both_precisions! {
    six_of_twelve
    one_of_each_pair_is_well_posed
    free_motion_of_a_moving_body
    systems_that_determine_nothing_are_refused
}
