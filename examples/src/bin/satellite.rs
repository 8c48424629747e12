//! A satellite that reorients itself by moving its arm: the displacement after a closed internal motion.
//!
//! `cargo run --release -p homogen-examples --bin satellite [picture.svg]`
//!
//! There are no external forces and the momentum is zero. After the two joints of the arm have moved along a closed
//! path, the satellite has another orientation. The displacement Q of one cycle repeats in every cycle, and the
//! reversed path undoes it.

use homogen::open_chain::{self, commutator};
use homogen::{
    Chain, Displacement, Error, Inertia, Joint, Pose, Screw, Velocity, newton_euler, vector,
};
use homogen_plot::{self as plot, Axis, Color, Curve, Page, Panel, Scale, Style};
use std::error;
use std::f64::consts::TAU;

/// Time steps of a cycle.
const STEPS: u32 = 600;

const CYCLES: u32 = 5;

/// One moment: number of cycles, the pose of the satellite, and the joints of its arm \[rad\].
struct Moment {
    cycle: f64,
    pose: Pose<f64>,
    q: [f64; 2],
}

/// A path of the joints: angles and their derivatives by the cycle.
type Path = fn(f64) -> ([f64; 2], [f64; 2]);

fn main() -> Result<(), Box<dyn error::Error>> {
    let satellite = Satellite::example();
    let flight = satellite.fly(round, CYCLES)?;
    let after = |cycle: u32| {
        let step = usize::try_from(cycle * STEPS)
            .ok()
            .and_then(|k| flight.get(k));
        step.map_or_else(Pose::identity, |moment| moment.pose)
    };
    let (screw, angle) = displacement(&after(0), &after(1)).log();
    let [x, y, z] = screw.u();
    println!("satellite of 120 kg with an arm of 14 kg, total momentum zero");
    println!(
        "  one cycle of the arm turns it by {:.3}° about ({x:.3}, {y:.3}, {z:.3})",
        angle.to_degrees()
    );
    let (_, angle) = displacement(&after(0), &after(CYCLES)).log();
    println!("  {CYCLES} cycles turn it by {:.3}°", angle.to_degrees());
    println!(
        "  centre of mass moved by {:.1e} m at most",
        satellite.wandering(&flight)
    );
    let path = plot::path_from_arguments("satellite");
    plot::write(&path, &page(&flight))?;
    println!("  drawn in {}", path.display());
    Ok(())
}

/// The path of shoulder and elbow, an ellipse.
fn round(cycle: f64) -> ([f64; 2], [f64; 2]) {
    let (s, c) = (TAU * cycle).sin_cos();
    ([0.9 * s, 0.8 * (1.0 - c)], [0.9 * TAU * c, 0.8 * TAU * s])
}

/// Q₍₁₎ = M₁,₀ M₀,₂, the displacement between two poses in the satellite's own frame (after (5)).
fn displacement(m_0_1: &Pose<f64>, m_0_2: &Pose<f64>) -> Displacement<f64> {
    Displacement::from_relative_pose(m_0_1.inverse() * *m_0_2)
}

struct Satellite {
    /// J of the body that carries the arm, in its own frame.
    body: Inertia<f64>,
    /// The arm, its base fixed in that body.
    arm: Chain<2, 0>,
}

impl Satellite {
    fn example() -> Self {
        let inertia = |mass, center, [xx, yy, zz]: [f64; 3]| {
            let tensor = [[xx, 0.0, 0.0], [0.0, yy, 0.0], [0.0, 0.0, zz]];
            Inertia::from_tensor_at_center_of_mass(mass, center, &tensor)
        };
        let joint = |name, parent, at, axis, inertia| {
            let hinge = Screw::revolute(axis, [0.0; 3]);
            Joint::new(name, parent, Pose::from_translation(at), hinge, inertia)
        };
        let upper = inertia(8.0, [0.5, 0.0, 0.0], [0.05, 0.7, 0.7]);
        let fore = inertia(6.0, [0.4, 0.0, 0.0], [0.04, 0.35, 0.35]);
        Self {
            body: inertia(120.0, [0.0; 3], [14.0, 18.0, 20.0]),
            arm: Chain::new(
                [
                    joint("shoulder", None, [0.5, 0.2, 0.0], [0.0, 0.0, 1.0], upper),
                    joint("elbow", Some(0), [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], fore),
                ],
                [],
                [0.0; 3],
            ),
        }
    }

    /// W of the body in its own frame at total momentum zero: Γ = skew\[W J\] solved for W.
    fn velocity(&self, q: &[f64; 2], qd: &[f64; 2]) -> Result<Velocity<f64>, Error> {
        let motions = open_chain::motions(&self.arm, q, qd, &[0.0; 2]);
        let [upper, fore] = open_chain::inertias(&self.arm, &motions.map(|motion| motion.pose));
        let internal = upper.momentum(&motions[0].velocity) + fore.momentum(&motions[1].velocity);
        let ([a, b, c], [d, e, f]) = (internal.gamma(), internal.rho());
        let opposite = [a, b, c, d, e, f].map(|x| Some(-x));
        let (w, _) = newton_euler::momentum(&(self.body + upper + fore), [None; 6], opposite)?;
        Ok(w)
    }

    /// The motion of the body while its arm follows `path`, by the Magnus series to fourth order.
    fn fly(&self, path: Path, cycles: u32) -> Result<Vec<Moment>, Error> {
        let h = 1.0 / f64::from(STEPS);
        let w_at = |cycle: f64| {
            let (q, qd) = path(cycle);
            self.velocity(&q, &qd)
        };
        let mut pose = Pose::identity();
        let mut flight = Vec::new();
        for k in 0..=cycles * STEPS {
            let cycle = f64::from(k) * h;
            let (q, _) = path(cycle);
            flight.push(Moment { cycle, pose, q });
            let (w_0, w_1) = (w_at(cycle)?, w_at(cycle + h)?);
            let mean = w_0 + scaled(4.0, &w_at(cycle + 0.5 * h)?) + w_1;
            let twist = scaled(1.0 / 6.0, &mean) + scaled(h / 12.0, &commutator(&w_0, &w_1));
            pose = pose * twist.displacement(h).to_relative_pose();
        }
        Ok(flight)
    }

    /// The largest displacement of the common centre of mass \[m\].
    fn wandering(&self, flight: &[Moment]) -> f64 {
        let centers = flight.iter().map(|moment| {
            let poses = open_chain::poses(&self.arm, &moment.q);
            let [upper, fore] = open_chain::inertias(&self.arm, &poses);
            let all = self.body + upper + fore;
            moment.pose.change_frame(&all).center_of_mass()
        });
        let mut first = None;
        centers.fold(0.0, |worst: f64, center| {
            let from = *first.get_or_insert(center);
            worst.max(vector::norm(vector::sub(center, from)))
        })
    }
}

fn scaled(factor: f64, w: &Velocity<f64>) -> Velocity<f64> {
    Velocity::new(
        vector::scale(factor, w.omega()),
        vector::scale(factor, w.v()),
    )
}

fn page(flight: &[Moment]) -> Page {
    let curve = |label: &str, color, style, value: &dyn Fn(&Moment) -> f64| Curve {
        label: label.into(),
        points: flight
            .iter()
            .map(|moment| [moment.cycle, value(moment)])
            .collect(),
        color,
        style,
    };
    let turned = |axis: usize| {
        move |moment: &Moment| {
            let (screw, angle) = Displacement::from_relative_pose(moment.pose).log();
            (angle * screw.u()[axis]).to_degrees()
        }
    };
    let panel = |label, curves, height| Panel {
        x: Axis {
            label: "cycles of the arm",
            scale: Scale::Every(1.0),
        },
        y: Axis {
            label,
            scale: Scale::Linear,
        },
        curves,
        marks: Vec::new(),
        height,
        to_scale: false,
    };
    Page {
        title: "A satellite turns by moving its arm, without momentum".into(),
        panels: vec![
            panel(
                "joint angle [°]",
                vec![
                    curve("shoulder", Color::Blue, Style::Line, &|m| {
                        m.q[0].to_degrees()
                    }),
                    curve("elbow", Color::Vermilion, Style::Dashed, &|m| {
                        m.q[1].to_degrees()
                    }),
                ],
                220.0,
            ),
            panel(
                "turned by φ u [°]",
                vec![
                    curve("about x", Color::Blue, Style::Line, &turned(0)),
                    curve("about y", Color::Orange, Style::Line, &turned(1)),
                    curve("about z", Color::Green, Style::Line, &turned(2)),
                ],
                280.0,
            ),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::{Moment, STEPS, Satellite, displacement, round};
    use homogen::{Chain, Displacement, Inertia, Joint, Pose, Screw};

    /// The rotation of a satellite with a planar arm in one cycle: the integral over the cycle of the rate at which
    /// the angular momentum is zero, for bodies in the plane.
    fn rotation_in_the_plane() -> f64 {
        const POINTS: u32 = 400;
        let rate = |cycle: f64| {
            let ([q_1, q_2], [qd_1, qd_2]) = round(cycle);
            let along = |length: f64, angle: f64| [length * angle.cos(), length * angle.sin()];
            let (upper, fore) = (along(1.0, q_1), along(0.4, q_1 + q_2));
            // Mass, moment of inertia, angular rate and position of the three bodies, relative to the first.
            let hinge = [0.5, 0.2];
            let half = [hinge[0] + 0.5 * upper[0], hinge[1] + 0.5 * upper[1]];
            let end = [hinge[0] + upper[0] + fore[0], hinge[1] + upper[1] + fore[1]];
            let turn = |[x, y]: [f64; 2], rate: f64| [-y * rate, x * rate];
            let (v_upper, v_fore) = (turn(upper, qd_1), turn(fore, qd_1 + qd_2));
            let bodies = [
                (120.0, 20.0, 0.0, [0.0; 2], [0.0; 2]),
                (8.0, 0.7, qd_1, half, v_upper.map(|v| 0.5 * v)),
                (
                    6.0,
                    0.35,
                    qd_1 + qd_2,
                    end,
                    [v_upper[0] + v_fore[0], v_upper[1] + v_fore[1]],
                ),
            ];
            let mean = |of: &dyn Fn(usize) -> f64| {
                (0..3).map(|i| bodies[i].0 * of(i)).sum::<f64>() / 134.0
            };
            let center = [mean(&|i| bodies[i].3[0]), mean(&|i| bodies[i].3[1])];
            let drift = [mean(&|i| bodies[i].4[0]), mean(&|i| bodies[i].4[1])];
            let (mut whole, mut internal) = (0.0, 0.0);
            for (mass, moment, spin, at, v) in bodies {
                let (x, y) = (at[0] - center[0], at[1] - center[1]);
                let (v_x, v_y) = (v[0] - drift[0], v[1] - drift[1]);
                whole += moment + mass * (x * x + y * y);
                internal += moment * spin + mass * (x * v_y - y * v_x);
            }
            -internal / whole
        };
        // The mean of equidistant values of a periodic function is accurate to rounding.
        let sum: f64 = (0..POINTS)
            .map(|k| rate(f64::from(k) / f64::from(POINTS)))
            .sum();
        sum / f64::from(POINTS)
    }

    #[test]
    fn in_a_plane_the_displacement_is_an_integral() {
        let inertia = |mass, center, moment: f64| {
            let tensor = [
                [0.5 * moment, 0.0, 0.0],
                [0.0, 0.6 * moment, 0.0],
                [0.0, 0.0, moment],
            ];
            Inertia::from_tensor_at_center_of_mass(mass, center, &tensor)
        };
        let joint = |name, parent, at, inertia| {
            let hinge = Screw::revolute([0.0, 0.0, 1.0], [0.0; 3]);
            Joint::new(name, parent, Pose::from_translation(at), hinge, inertia)
        };
        let (upper, fore) = (
            inertia(8.0, [0.5, 0.0, 0.0], 0.7),
            inertia(6.0, [0.4, 0.0, 0.0], 0.35),
        );
        let satellite = Satellite {
            body: inertia(120.0, [0.0; 3], 20.0),
            arm: Chain::new(
                [
                    joint("shoulder", None, [0.5, 0.2, 0.0], upper),
                    joint("elbow", Some(0), [1.0, 0.0, 0.0], fore),
                ],
                [],
                [0.0; 3],
            ),
        };
        let flight = satellite.fly(round, 1).expect("bodies with mass");
        let (screw, angle) = Displacement::from_relative_pose(end(&flight)).log();
        let known = rotation_in_the_plane();
        assert!(known.abs() > 0.01);
        let found = angle * screw.u()[2];
        assert!((found - known).abs() < 1e-10, "{found} is not {known}");
    }

    fn end(flight: &[Moment]) -> Pose<f64> {
        flight.last().expect("not empty").pose
    }

    fn angle_between(from: &Pose<f64>, to: &Pose<f64>) -> f64 {
        displacement(from, to).log().1
    }

    #[test]
    fn the_center_of_mass_does_not_move() {
        let satellite = Satellite::example();
        let flight = satellite.fly(round, 1).expect("bodies with mass");
        assert!(satellite.wandering(&flight) < 1e-10);
    }

    #[test]
    fn every_cycle_has_the_same_displacement() {
        let flight = Satellite::example()
            .fly(round, 2)
            .expect("bodies with mass");
        let at = |cycle: u32| flight[usize::try_from(cycle * STEPS).expect("small")].pose;
        let [first, second] = [displacement(&at(0), &at(1)), displacement(&at(1), &at(2))];
        let difference = angle_between(&first.to_relative_pose(), &second.to_relative_pose());
        assert!(first.log().1 > 0.01 && difference < 1e-12, "{difference}");
    }

    #[test]
    fn the_path_gone_backwards_takes_it_back() {
        let satellite = Satellite::example();
        let there = end(&satellite.fly(round, 1).expect("bodies with mass"));
        let back = |cycle: f64| {
            let (q, [a, b]) = round(1.0 - cycle);
            (q, [-a, -b])
        };
        let back = end(&satellite.fly(back, 1).expect("bodies with mass"));
        let both = Displacement::from_relative_pose(there * back);
        assert!(both.log().1 < 1e-12);
    }
}
