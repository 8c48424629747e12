//! The picture of the README and of the report's first page: times of functions of an arm as bars, of homogen and other
//! programs, each with its error.
//!
//! In: the details of the report. Out: an SVG.

use std::fmt::Write;

/// The heading of the table that is drawn.
const PART: &str = "### Panda with hand: other programs\n";

/// The title of the picture.
pub const TITLE: &str = "Time and error of functions of a Panda: homogen, CasADi and Pinocchio";

/// The functions that are drawn: the name in the report, the name in the picture, and true if the refined one is
/// drawn as well.
const GROUPS: [(&str, &str, bool); 3] = [
    ("`inverse_dynamics`", "inverse dynamics", false),
    ("`mass_matrix`", "mass matrix", false),
    ("`forward_dynamics`", "forward dynamics", true),
];

/// A bar: its label, the columns whose minimum is its time, the column of its error.
struct Bar {
    name: &'static str,
    times: &'static [usize],
    error: usize,
    color: &'static str,
}

const OURS: Bar = Bar {
    name: "homogen",
    times: &[3],
    error: 11,
    color: "#0072b2",
};

const REFINED: Bar = Bar {
    name: "homogen, refined once",
    ..OURS
};

/// The arithmetic of both tuned programs is the same.
const OTHERS: [Bar; 3] = [
    Bar {
        name: "CasADi C, tuned",
        times: &[7, 8],
        error: 14,
        color: "#8b949e",
    },
    Bar {
        name: "CasADi C",
        times: &[6],
        error: 13,
        color: "#8b949e",
    },
    Bar {
        name: "Pinocchio",
        times: &[5],
        error: 12,
        color: "#8b949e",
    },
];

const WIDTH: f64 = 800.0;
/// The left end of the bars, and the length of the longest, which leaves room for its label.
const LEFT: f64 = 182.0;
const LONGEST: f64 = 330.0;
const HEIGHT_OF_BAR: f64 = 17.0;
const GAP: f64 = 40.0;
const TOP: f64 = 92.0;

/// The picture; `None` if the report lacks a row.
#[must_use]
pub fn draw(report: &str) -> Option<String> {
    let (_, part) = report.split_once(PART)?;
    let row = |function: &str| {
        let start = format!("| {function} | f64 |");
        let row = part.lines().find(|line| line.starts_with(&start))?;
        Some(row.split('|').map(str::trim).collect::<Vec<_>>())
    };
    let mut longest: f64 = 0.0;
    for (function, ..) in GROUPS {
        for bar in [OURS].iter().chain(&OTHERS) {
            longest = longest.max(bar.time(&row(function)?)?);
        }
    }
    let scale = LONGEST / longest;
    let mut svg = String::new();
    let mut y = TOP;
    for (function, title, is_refined) in GROUPS {
        text(&mut svg, (24.0, y), title, "font-weight=\"bold\"");
        y += 8.0;
        let cells = row(function)?;
        let refined = row(&format!("{function}, refined once")).filter(|_| is_refined);
        let ours = [(&OURS, &cells)].into_iter();
        let ours = ours.chain(refined.as_ref().map(|cells| (&REFINED, cells)));
        let least = OURS.time(&cells)?;
        for (bar, cells) in ours.chain(OTHERS.iter().map(|bar| (bar, &cells))) {
            let time = bar.time(cells)?;
            let ratio = if bar.times == OURS.times {
                String::new()
            } else {
                format!(" · {:.1} times as long", time / least)
            };
            let label = format!("{time} ns{ratio} · error {}", cells.get(bar.error)?);
            bar.draw(&mut svg, y, (time * scale, &label));
            y += HEIGHT_OF_BAR;
        }
        y += GAP - 8.0;
    }
    let height = y - 12.0;
    Some(head(height) + &svg + "</svg>\n")
}

impl Bar {
    /// Its time in a row of the report [ns].
    fn time(&self, cells: &[&str]) -> Option<f64> {
        let times = self.times.iter();
        let times = times.map(|&column| cells.get(column)?.parse::<f64>().ok());
        times
            .collect::<Option<Vec<_>>>()?
            .into_iter()
            .reduce(f64::min)
    }

    fn draw(&self, svg: &mut String, y: f64, (length, label): (f64, &str)) {
        let (color, inner, middle) = (self.color, HEIGHT_OF_BAR - 3.0, y + 12.0);
        text(svg, (LEFT - 8.0, middle), self.name, "text-anchor=\"end\"");
        // Writing to a string cannot fail.
        let _ = writeln!(
            svg,
            r#"<rect x="{LEFT}" y="{y}" width="{length:.1}" height="{inner}" rx="2" fill="{color}"/>"#
        );
        text(svg, (LEFT + length + 8.0, middle), label, "");
    }
}

fn head(height: f64) -> String {
    let (width, inner) = (WIDTH - 1.0, height - 1.0);
    let mut svg = format!(
        r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" height="{height}" font-family="Helvetica, Arial, sans-serif" font-size="13" fill="#1f2328">
<title>{TITLE}</title>
<rect x="0.5" y="0.5" width="{width}" height="{inner}" rx="8" fill="#ffffff" stroke="#c8ccd0"/>
"##
    );
    let title =
        "A Panda with its hand: one call, in f64, on one thread, all compiled for this processor";
    text(
        &mut svg,
        (24.0, 32.0),
        title,
        "font-size=\"16\" font-weight=\"bold\"",
    );
    let about = "Shorter is better. Errors are the worst over random states, in units of roundoff (u = 1.1e-16).";
    text(&mut svg, (24.0, 54.0), about, "fill=\"#59636e\"");
    svg
}

fn text(svg: &mut String, (x, y): (f64, f64), words: &str, style: &str) {
    // Writing to a string cannot fail.
    let _ = writeln!(svg, r#"<text x="{x:.1}" y="{y:.1}" {style}>{words}</text>"#);
}
