//! Enclosures of numbers that are computed during generation, compared with numbers of 256 bits.
//!
//! In: random numbers of 1e-300 to 1e300, residues among them, and random operations on them. Out: an enclosure
//! contains the exact result; it counts as zero only if the result is negligible for an `f64`; a normalised vector has
//! length 1.

use homogen_codegen::expression::{Double, Graph};
use homogen_codegen::matrix::Vector;
use homogen_tests::big::Big;
use homogen_tests::states::Random;

/// An enclosure, the exact number, and the size of the terms that it is a sum of.
#[derive(Clone)]
struct Tracked {
    found: Double,
    exact: Big,
    size: f64,
}

/// Half a unit of the 70th bit: negligible beside the rounding of an `f64`.
const NEGLIGIBLE: f64 = 8.5e-22;

impl Tracked {
    fn number(value: f64) -> Self {
        Self {
            found: Double::from(value),
            exact: Big::new(value),
            size: value.abs(),
        }
    }

    fn distance(&self) -> f64 {
        let high = self.found.to_f64();
        let low = (self.found - Double::from(high)).to_f64();
        let centre = Big::new(high) + Big::new(low);
        (centre - self.exact.clone()).abs().to_f64()
    }

    fn check(&self, how: &str) {
        if !self.found.is_known() {
            return;
        }
        let (distance, radius) = (self.distance(), self.found.radius());
        // Numbers of 256 bits have rounding errors too.
        let rounding = self.size * 1e-70;
        assert!(
            distance <= radius + rounding,
            "{how}: {distance:e} from the centre of {:?}",
            self.found
        );
        let exact = self.exact.clone().abs().to_f64();
        if self.found.is_zero() {
            assert!(
                exact <= NEGLIGIBLE * self.size + 1e-300,
                "{how}: {exact:e} of {:e} is taken for zero",
                self.size
            );
        }
    }
}

/// A random number of any size, or a whole number.
fn number(random: &mut Random, exponents: i32) -> f64 {
    let exponent = f64::from(exponents) * random.unit();
    let number = random.unit() * 10_f64.powf(exponent);
    if random.chance(5) {
        number.round()
    } else {
        number
    }
}

/// Random operations, each on earlier results.
fn walk(random: &mut Random, exponents: i32, most: f64) {
    let mut numbers: Vec<Tracked> = (0..4)
        .map(|_| Tracked::number(number(random, exponents)))
        .collect();
    for _ in 0..16 {
        let a = random.choose(&numbers).clone();
        let b = random.choose(&numbers).clone();
        let next = match random.below(8) {
            0 | 1 => (
                "a sum",
                a.found + b.found,
                a.exact.clone() + b.exact.clone(),
                a.size + b.size,
            ),
            2 | 3 => (
                "a difference",
                a.found - b.found,
                a.exact.clone() - b.exact.clone(),
                a.size + b.size,
            ),
            4 | 5 => (
                "a product",
                a.found * b.found,
                a.exact.clone() * b.exact.clone(),
                a.size * b.size,
            ),
            // A number of 256 bits may have cancelled where the enclosure has not.
            6 if b.found.is_sharp() && b.exact != Big::zero() => {
                let size = a.size / b.found.to_f64().abs();
                let spread = b.size / b.found.to_f64().abs();
                (
                    "a quotient",
                    a.found / b.found,
                    a.exact.clone() / b.exact.clone(),
                    size * spread,
                )
            }
            7 if a.found.is_sharp() && a.found.to_f64() > 0.0 && a.exact > Big::zero() => {
                let spread = a.size / a.found.to_f64();
                let root = a.found.sqrt();
                ("a root", root, a.exact.sqrt(), root.to_f64() * spread)
            }
            _ if a.found.to_f64().abs() < 1e12 && a.found.is_known() => {
                let ((sine, cosine), (exact_sine, exact_cosine)) =
                    (a.found.sin_cos(), a.exact.sin_cos());
                // An error of the angle is one of both.
                let size = a.size.max(1.0);
                if random.chance(2) {
                    ("a sine", sine, exact_sine, size)
                } else {
                    ("a cosine", cosine, exact_cosine, size)
                }
            }
            _ => continue,
        };
        let (how, found, exact, size) = next;
        if !found.is_known() || size > most {
            continue;
        }
        // Underflow counts as an error of this size.
        let size = size.max(1e-298);
        let next = Tracked { found, exact, size };
        next.check(how);
        numbers.push(next);
    }
}

#[test]
fn an_enclosure_contains_the_exact_result() {
    let mut random = Random::new(106);
    for _ in 0..1500 {
        walk(&mut random, 1, 1e100);
        walk(&mut random, 18, 1e250);
        walk(&mut random, 300, 1e300);
    }
}

#[test]
fn products_quotients_and_roots_of_any_size_contain_the_exact_result() {
    let mut random = Random::new(600);
    for _ in 0..3000 {
        let [a, b] = [0; 2].map(|_| Tracked::number(number(&mut random, 300)));
        let of = |found, exact, size| Tracked { found, exact, size };
        let (x, y) = (a.clone(), b.clone());
        of(x.found * y.found, x.exact * y.exact, x.size * y.size).check("a product");
        let (x, y) = (a.clone(), b.clone());
        if y.size > 0.0 {
            of(x.found / y.found, x.exact / y.exact, x.size / y.size).check("a quotient");
        }
        let root = Double::from(a.size).sqrt();
        of(root, Big::new(a.size).sqrt(), root.to_f64()).check("a root");
    }
}

/// Vectors of any length, some with residues.
#[test]
fn a_normalised_vector_has_length_one() {
    let mut random = Random::new(3);
    for _ in 0..3000 {
        let graph = Graph::new();
        let size = 10_f64.powf(300.0 * random.unit());
        let entries = [0; 3].map(|_| {
            let residue = if random.chance(3) {
                10_f64.powi(-17 - i32::try_from(random.below(20)).expect("few"))
            } else {
                1.0
            };
            if random.chance(4) {
                0.0
            } else {
                size * residue * random.unit()
            }
        });
        let vector = Vector::constant(&graph, entries);
        let Some(direction) = vector.normalized() else {
            assert_eq!(entries, [0.0; 3], "{entries:?}");
            continue;
        };
        let square = direction.dot(direction);
        assert!(square.value().expect("a number").is_one(), "{entries:?}");
        // Its direction is that of the vector, also for small entries.
        let largest = entries.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        for (entry, cosine) in entries.iter().zip(direction.0) {
            let cosine = cosine.value().expect("a number").to_f64();
            let expected = entry / largest;
            let ratio = cosine / expected;
            assert!(
                expected == cosine || (0.57..=1.0 + 1e-15).contains(&ratio),
                "{entries:?}: {cosine:e}"
            );
        }
    }
}
