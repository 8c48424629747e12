//! The slider-crank through a full revolution: positions, velocities and accelerations of rod and slider.
//!
//! `cargo run --release -p homogen-examples --bin slider_crank [picture.svg]`
//!
//! The loop is closed by Newton–Raphson at every degree, from the previous position; rates come from
//! A q̇ = 0 and A q̈ = b(H̃). At the dead centres the slider cannot drive the crank: the rank of A without the column
//! of the slider falls.

use homogen::loop_closure::{self, NotClosed};
use homogen::worked_examples::slider_crank::SliderCrank;
use homogen_plot::{self as plot, Axis, Color, Curve, Page, Panel, Scale, Style};
use std::error::Error;
use std::f64::consts::PI;

const SLIDER_CRANK: SliderCrank = SliderCrank {
    crank: 0.05,
    rod: 0.15,
};

/// 600 revolutions a minute \[rad/s\].
const SPEED: f64 = 20.0 * PI;

/// One position of the revolution.
struct Station {
    /// The angle of the crank [°].
    degrees: u32,
    q: [f64; 4],
    qd: [f64; 4],
    qdd: [f64; 4],
    /// Steps of Newton–Raphson.
    iterations: usize,
    /// True at a dead centre of the slider.
    is_dead_centre: bool,
}

fn main() -> Result<(), Box<dyn Error>> {
    let turn = turn()?;
    let most = turn.iter().map(|station| station.iterations).max();
    let dead = turn.iter().filter(|station| station.is_dead_centre);
    let dead: Vec<u32> = dead.map(|station| station.degrees).collect();
    let speeds = turn.iter().map(|station| station.qd[3].abs());
    let accelerations = turn.iter().map(|station| station.qdd[3].abs());
    println!("slider-crank, crank 50 mm, rod 150 mm, at 600 turns a minute");
    println!("  positions closed in at most {} steps", most.unwrap_or(0));
    println!("  dead centres of the slider at {dead:?}°");
    println!("  slider: up to {:.2} m/s", speeds.fold(0.0, f64::max));
    println!(
        "  slider: up to {:.0} m/s²",
        accelerations.fold(0.0, f64::max)
    );
    let path = plot::path_from_arguments("slider_crank");
    plot::write(&path, &page(&turn))?;
    println!("  drawn in {}", path.display());
    Ok(())
}

/// All positions of a revolution, degree by degree.
fn turn() -> Result<Vec<Station>, NotClosed> {
    let closed = SLIDER_CRANK.closed_chain();
    let driven_by_crank = |value: f64| [Some(value), None, None, None];
    let mut q = [0.0, 0.0, 0.0, SLIDER_CRANK.crank + SLIDER_CRANK.rod];
    (0..=360)
        .map(|degrees| {
            let alpha = f64::from(degrees).to_radians();
            let position = loop_closure::position(&closed, &driven_by_crank(alpha), &q)?;
            q = position.q;
            let qd = loop_closure::velocity(&closed, &q, &driven_by_crank(SPEED)).values;
            let qdd = loop_closure::acceleration(&closed, &q, &qd, &driven_by_crank(0.0)).values;
            let driven_by_slider = [None, None, None, Some(1.0)];
            Ok(Station {
                degrees,
                q,
                qd,
                qdd,
                iterations: position.iterations,
                is_dead_centre: loop_closure::velocity(&closed, &q, &driven_by_slider)
                    .is_singular(),
            })
        })
        .collect()
}

fn page(turn: &[Station]) -> Page {
    let curve = |label: &str, color, style, value: &dyn Fn(&Station) -> f64| Curve {
        label: label.into(),
        points: turn
            .iter()
            .map(|station| [f64::from(station.degrees), value(station)])
            .collect(),
        color,
        style,
    };
    let dead = turn.iter().filter(|station| station.is_dead_centre);
    let marks: Vec<_> = dead
        .map(|station| (f64::from(station.degrees), "dead centre".into()))
        .collect();
    let panel = |label, curves| Panel {
        x: Axis {
            label: "angle of the crank [°]",
            scale: Scale::Every(45.0),
        },
        y: Axis {
            label,
            scale: Scale::Linear,
        },
        curves,
        marks: marks.clone(),
        height: 250.0,
        to_scale: false,
    };
    let (blue, red) = (
        (Color::Blue, Style::Line),
        (Color::Vermilion, Style::Dashed),
    );
    // The absolute angle of the rod is that of the crank plus the angle between them.
    Page {
        title: "Slider-crank at 600 turns a minute: l₁ = 50 mm, l₂ = 150 mm".into(),
        panels: vec![
            panel(
                "position",
                vec![
                    curve("slider x [mm]", blue.0, blue.1, &|s| 1e3 * s.q[3]),
                    curve("rod β [°]", red.0, red.1, &|s| {
                        (s.q[0] + s.q[1]).to_degrees()
                    }),
                ],
            ),
            panel(
                "velocity",
                vec![
                    curve("slider [m/s]", blue.0, blue.1, &|s| s.qd[3]),
                    curve("rod [10 rad/s]", red.0, red.1, &|s| {
                        0.1 * (s.qd[0] + s.qd[1])
                    }),
                ],
            ),
            panel(
                "acceleration",
                vec![
                    curve("slider [m/s²]", blue.0, blue.1, &|s| s.qdd[3]),
                    curve("rod [10 rad/s²]", red.0, red.1, &|s| {
                        0.1 * (s.qdd[0] + s.qdd[1])
                    }),
                ],
            ),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::{SLIDER_CRANK, SPEED, page, turn};
    use homogen_plot as plot;

    #[test]
    fn the_turn_agrees_with_the_closed_form() {
        let turn = turn().expect("the crank turns round");
        for station in &turn {
            let alpha = f64::from(station.degrees).to_radians();
            let state = SLIDER_CRANK.state(alpha, SPEED, 0.0);
            for i in 0..4 {
                assert!((station.q[i] - state.q[i]).abs() < 1e-14);
                assert!((station.qd[i] - state.qd[i]).abs() < 1e-12);
                assert!((station.qdd[i] - state.qdd[i]).abs() < 1e-9);
            }
        }
        let dead = turn.iter().filter(|station| station.is_dead_centre);
        assert_eq!(dead.map(|s| s.degrees).collect::<Vec<_>>(), [0, 180, 360]);
    }

    #[test]
    fn the_picture_marks_the_dead_centres() {
        let svg = plot::draw(&page(&turn().expect("the crank turns round")));
        assert_eq!(svg.matches(">dead centre<").count(), 9);
        assert!(!svg.contains("NaN"));
    }
}
