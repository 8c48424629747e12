//! Every function of some hard robots.
//!
//! In: a type of number. Out: a row for a function, a column for a robot in hard states.

use homogen_codegen::formulation::Formulation;
use homogen_codegen::{Function, Real};
use homogen_plot::heat::Map;

use super::{FAST, Hard, MANY_TURNS, STRAIGHT, Truth};

/// The columns.
const CASES: [Hard; 12] = [
    Hard::new("arm", "panda_class/0"),
    Hard::new("10 km away", "panda_class/1e4"),
    Hard::new("nothing zero", "spatial/8"),
    Hard::new("payload of 1 t", "payload/1e3"),
    Hard::new("angles to 10⁵ rad", "panda_class/0").at(MANY_TURNS),
    Hard::new("rates to 10⁴ rad/s", "panda_class/0").moving(FAST),
    Hard::new("floating, 1000 km away", "quadruped/0").floating(1e6),
    Hard::new("8 rods, straight", "planar/8").at(STRAIGHT),
    Hard::new("tip of 1 t", "heavy_tip/1e3"),
    Hard::new("shrinking rods", "shrinking/8"),
    Hard::new("rod of 0.1 mm", "short_link/1e-4"),
    Hard::new("thin rods", "thin_rod/0"),
];

/// Number of states; each error is the worst of these.
const STATES: usize = 40;

/// The types of numbers, one for each map, with their names.
pub const TYPES: [&str; 2] = ["f64", "f32"];

/// Measures all of them, in each of the [`TYPES`].
pub fn maps() -> [Map; 2] {
    let mut maps = TYPES.map(empty);
    for function in Function::ALL {
        let truths = CASES.map(|hard| Truth::of(&hard, function, STATES));
        for (map, scalar) in maps.iter_mut().zip([Real::F64, Real::F32]) {
            let cells = truths.iter();
            let cells = cells.map(|truth| truth.worst(Formulation::default(), scalar));
            map.rows.push((function.name().to_owned(), cells.collect()));
        }
    }
    maps
}

fn empty(scalar: &str) -> Map {
    Map {
        title: format!("Hard cases: worst error of every function in {scalar}"),
        unit: "units of roundoff".into(),
        columns: CASES.iter().map(|hard| hard.title.to_owned()).collect(),
        rows: Vec::new(),
        scale: [0.0, 8.0],
    }
}
