//! Draws the picture of the README from the committed report: `report/bars.svg`.

use std::error::Error;
use std::fs;
use std::path::Path;

use homogen_examples::bars;

fn main() -> Result<(), Box<dyn Error>> {
    let report = Path::new(env!("CARGO_MANIFEST_DIR")).join("../report");
    let text = fs::read_to_string(report.join("DETAILS.md"))?;
    let picture = bars::draw(&text).ok_or("the report lacks the rows of the picture")?;
    fs::write(report.join("bars.svg"), picture)?;
    Ok(())
}
