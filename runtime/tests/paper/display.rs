//! `Display` of every matrix.

use homogen::{Acceleration, Action, Displacement, Inertia, Momentum, Pose, Screw, Velocity};

#[test]
fn columns_are_aligned() {
    let turn = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let m = Pose::new(turn, [0.5, 12.25, 0.0]);
    assert_eq!(
        m.to_string(),
        "[0 -1 0   0.5]\n[1  0 0 12.25]\n[0  0 1     0]\n[0  0 0     1]"
    );
    assert_eq!(
        format!("{m:.1}"),
        "[0.0 -1.0 0.0  0.5]\n[1.0  0.0 0.0 12.2]\n[0.0  0.0 1.0  0.0]\n[0.0  0.0 0.0  1.0]"
    );
    assert_eq!(
        format!("{m:5.0}").lines().next(),
        Some("[    0    -1     0     0]")
    );
}

/// The text has every entry of the matrix.
#[test]
fn every_matrix_shows_its_entries() {
    let (u, v) = ([0.25, -1.5, 3.0], [0.5, 1.0 / 3.0, -40.0]);
    let rows = [u, v, [1.0, 2.0, 4.0]];
    let shown: [(String, [[f64; 4]; 4]); 8] = {
        let m = Pose::new(rows, u);
        let q = Displacement::new(rows, v);
        let (l, w) = (Screw::new(u, v), Velocity::new(u, v));
        let h = Acceleration::new(rows, v);
        let j = Inertia::new([1.0, 2.0, 3.0, 0.1, 0.2, 0.3], u, 2.0);
        let (gamma, phi) = (Momentum::new(u, v), Action::new(u, v));
        [
            (m.to_string(), m.to_matrix()),
            (q.to_string(), q.to_matrix()),
            (l.to_string(), l.to_matrix()),
            (w.to_string(), w.to_matrix()),
            (h.to_string(), h.to_matrix()),
            (j.to_string(), j.to_matrix()),
            (gamma.to_string(), gamma.to_matrix()),
            (phi.to_string(), phi.to_matrix()),
        ]
    };
    for (text, matrix) in shown {
        let lines = text.lines().map(|line| line.trim_matches(['[', ']']));
        let read = lines.map(|line| {
            let words = line.split_whitespace();
            let numbers = words.map(|word| word.parse::<f64>().expect("a number"));
            numbers.collect::<Vec<_>>()
        });
        let read: Vec<_> = read.collect();
        assert_eq!(read, matrix.map(Vec::from), "{text}");
    }
}
