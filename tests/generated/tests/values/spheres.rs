//! Collision spheres: centres by the poses of their links, distances by their centres, and Jacobians by differences of
//! distances.

use homogen::Robot;
use homogen::robot::{DistanceJacobian, Distances, SphereCenters};
use homogen_random::Random;

/// Two arms that cover their links with spheres.
#[derive(Robot)]
#[robot(urdf = "../robots/two_arms.urdf", collision, quiet, batch)]
#[robot(frames(
    "stand",
    "torso",
    "left_upper",
    "left_fore",
    "left_hand",
    "right_upper",
    "right_hand"
))]
#[robot(generate(sphere_centers, distances, distance_jacobian, frame_poses))]
struct TwoArms;

/// The same on a base that floats, with the distances of both hands and of a hand and the stand alone.
#[derive(Robot)]
#[robot(urdf = "../robots/two_arms.urdf", floating, quiet)]
#[robot(collision("left_hand": "right_hand", "stand": "right_hand"))]
#[robot(generate(sphere_centers, distances, distance_jacobian))]
struct Floating;

const ULP: f64 = f64::EPSILON;

/// Index of the link in `FRAMES`, centre in its frame and radius of each sphere, as the file has them.
const SPHERES: [(usize, [f64; 3], f64); 9] = [
    (0, [0.0, 0.0, 0.2], 0.2),
    (1, [0.01, 0.0, 0.1], 0.15),
    (1, [0.0, 0.02, 0.35], 0.12),
    (2, [0.15, 0.01, -0.02], 0.07),
    (3, [0.05, 0.0, 0.0], 0.05),
    (3, [0.15, 0.0, 0.01], 0.045),
    (4, [0.0, 0.0, 0.0], 0.06),
    (5, [0.15, 0.0, 0.0], 0.07),
    (6, [0.02, 0.0, 0.0], 0.06),
];

fn state(random: &mut Random) -> [f64; 5] {
    let (lower, upper) = (TwoArms::LOWER, TwoArms::UPPER);
    std::array::from_fn(|k| lower[k] + (upper[k] - lower[k]) * (random.unit() + 1.0) / 2.0)
}

fn length(vector: [f64; 3]) -> f64 {
    vector.iter().map(|entry| entry * entry).sum::<f64>().sqrt()
}

#[test]
fn centers_are_points_of_the_links() {
    let mut random = Random::new(1);
    for _ in 0..100 {
        let q = state(&mut random);
        let poses = TwoArms.frame_poses(&q);
        for (found, (link, center, _)) in TwoArms.sphere_centers(&q).iter().zip(SPHERES) {
            let pose = poses[link].to_matrix();
            for (row, found) in pose.iter().zip(found.0) {
                let terms = row.iter().zip(center.iter().chain([&1.0]));
                let expected: f64 = terms.map(|(a, b)| a * b).sum();
                assert!((found - expected).abs() < 4.0 * ULP, "{found} {expected}");
            }
        }
    }
}

#[test]
fn radii_and_names_are_those_of_the_file() {
    assert_eq!(TwoArms::RADII, SPHERES.map(|(_, _, radius)| radius));
    let links = TwoArms::FRAMES;
    for (name, (link, ..)) in TwoArms::SPHERES.iter().zip(SPHERES) {
        assert!(name.starts_with(links[link]), "{name}");
    }
    assert_eq!(
        Floating::PAIRS,
        ["stand/right_hand", "left_hand/right_hand"]
    );
}

#[test]
fn distances_are_those_of_the_centers_of_links_that_no_joint_joins() {
    // By names of spheres: the stand and the torso, and each link and the next.
    let joined = |a: &str, b: &str| {
        let of = |name: &str| {
            name.trim_end_matches(|end: char| end == '_' || end.is_ascii_digit())
                .to_owned()
        };
        let (a, b) = (of(a), of(b));
        let joined = [
            ("stand", "torso"),
            ("torso", "left_upper"),
            ("torso", "right_upper"),
            ("left_upper", "left_fore"),
            // The hands are fixed to the bodies before them.
            ("left_upper", "left_hand"),
            ("left_fore", "left_hand"),
            ("right_upper", "right_hand"),
        ];
        a == b || joined.contains(&(&a, &b))
    };
    let mut random = Random::new(2);
    for _ in 0..100 {
        let q = state(&mut random);
        let centers = TwoArms.sphere_centers(&q).map(|center| center.0);
        let distances = TwoArms.distances(&q);
        let names = TwoArms::SPHERES;
        let mut found = TwoArms::PAIRS.iter().zip(distances);
        for (a, name) in names.iter().enumerate() {
            for (b, other) in names.iter().enumerate().skip(a + 1) {
                if joined(name, other) {
                    continue;
                }
                let (pair, distance) = found.next().expect("a distance of each pair");
                assert_eq!(*pair, format!("{name}/{other}"));
                let between = std::array::from_fn(|k| centers[a][k] - centers[b][k]);
                let expected = length(between) - SPHERES[a].2 - SPHERES[b].2;
                assert!(
                    (distance - expected).abs() < 8.0 * ULP,
                    "{pair}: {distance} {expected}"
                );
            }
        }
        assert_eq!(found.next(), None);
    }
}

#[test]
fn jacobians_are_the_derivatives_of_distances() {
    let mut random = Random::new(3);
    let step = 1e-5;
    for _ in 0..100 {
        let q = state(&mut random);
        let jacobian = TwoArms.distance_jacobian(&q);
        for k in 0..q.len() {
            let [more, less] = [step, -step].map(|by| {
                let mut q = q;
                q[k] += by;
                TwoArms.distances(&q)
            });
            for (pair, row) in jacobian.iter().enumerate() {
                let expected = (more[pair] - less[pair]) / (2.0 * step);
                // The third derivative of a distance grows with the square of its inverse.
                assert!((row[k] - expected).abs() < 1e-6, "{}", TwoArms::PAIRS[pair]);
            }
        }
    }
}

#[test]
fn distances_are_the_same_bits_wherever_a_floating_base_is() {
    let mut random = Random::new(4);
    for _ in 0..100 {
        let joints = state(&mut random);
        let at = |root: [f64; 7]| -> [f64; 12] {
            std::array::from_fn(|k| *root.get(k).unwrap_or(&joints[k.saturating_sub(7)]))
        };
        let here = at([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
        let far = at([1e6, -3e5, 2e4, 0.5, -0.5, 0.5, 0.5]);
        assert_eq!(Floating.distances(&here), Floating.distances(&far));
        let jacobian = Floating.distance_jacobian(&far);
        assert_eq!(jacobian, Floating.distance_jacobian(&here));
        // The base moves all spheres.
        assert!(jacobian.iter().all(|row| row[..6] == [0.0; 6]));
        // Both robots have pairs in the order of the spheres.
        let both = [5, 21].map(|pair| (TwoArms::PAIRS[pair], TwoArms.distances(&joints)[pair]));
        for ((pair, expected), (name, found)) in both
            .iter()
            .zip(Floating::PAIRS.iter().zip(Floating.distances(&here)))
        {
            assert_eq!(pair, name);
            assert!((found - expected).abs() < 8.0 * ULP, "{found} {expected}");
        }
    }
}

#[test]
fn batches_have_the_values_of_single_states() {
    let mut random = Random::new(5);
    let states: Vec<[f64; 5]> = (0..11).map(|_| state(&mut random)).collect();
    let mut distances = vec![[0.0; 22]; states.len()];
    TwoArms
        .distances_batch(&states, &mut distances)
        .expect("as long");
    let mut jacobians = vec![[[0.0; 5]; 22]; states.len()];
    TwoArms
        .distance_jacobian_batch(&states, &mut jacobians)
        .expect("as long");
    let mut centers = vec![TwoArms.sphere_centers(&states[0]); states.len()];
    TwoArms
        .sphere_centers_batch(&states, &mut centers)
        .expect("as long");
    for (k, q) in states.iter().enumerate() {
        assert_eq!(distances[k], TwoArms.distances(q));
        assert_eq!(jacobians[k], TwoArms.distance_jacobian(q));
        assert_eq!(centers[k], TwoArms.sphere_centers(q));
    }
}

/// The least distance of any robot with spheres.
fn clearance<R: Distances<N, P>, const N: usize, const P: usize>(robot: &R, q: &[f64; N]) -> f64 {
    robot.distances(q).into_iter().fold(f64::INFINITY, f64::min)
}

#[test]
fn traits_serve_generic_code() {
    fn has_all<const N: usize, R>(_: &R)
    where
        R: SphereCenters<N, 9> + DistanceJacobian<N, 22>,
    {
    }
    has_all(&TwoArms);
    let q = [0.0; 5];
    let least = TwoArms
        .distances(&q)
        .into_iter()
        .fold(f64::INFINITY, f64::min);
    assert_eq!(clearance(&TwoArms, &q).to_bits(), least.to_bits());
}
