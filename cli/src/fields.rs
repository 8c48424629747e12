//! Options that add run-time fields: `--field` and `--range`, in the words of attributes.

use clap::Args;
use homogen_codegen::builder::Builder;
use homogen_codegen::request::{Target, setting};

/// Fields of the struct.
#[derive(Args, Clone, Debug)]
pub(super) struct Fields {
    /// A number that stays free at run time, as a field of the struct: payload=payload_on:hand,
    /// m=mass_of:hand, c=com_of:hand, i=inertia_of:hand, o=origin_of:elbow, p=placement_of:elbow,
    /// a=armature_of:elbow, d=damping_of:elbow, f=friction_of:elbow, g=gravity, b=base_position,
    /// b=base_placement
    #[arg(long = "field", value_name = "FIELD=WORD[:NAME]")]
    #[arg(value_parser = |text: &str| field(text).map(|_| text.to_owned()))]
    free: Vec<String>,
    /// The range of each number of a field, for error bounds: payload=0..3
    #[arg(long = "range", value_name = "FIELD=LEAST..MOST", value_parser = range)]
    ranges: Vec<(String, [f64; 2])>,
}

impl Fields {
    /// The builder with these fields; the first range without a field is an error.
    pub(super) fn of(&self, builder: Builder) -> Result<Builder, String> {
        let fields = self.free.iter().map(|text| field(text));
        let fields = fields.collect::<Result<Vec<_>, _>>()?;
        let has = |name: &String| fields.iter().any(|(field, _)| field == name);
        if let Some((name, _)) = self.ranges.iter().find(|(name, _)| !has(name)) {
            return Err(format!("--range needs a --field with the name `{name}`"));
        }
        Ok(fields
            .into_iter()
            .fold(builder, |builder, (field, target)| {
                let mut ranges = self.ranges.iter();
                match ranges.find(|(name, _)| *name == field) {
                    Some((_, [least, most])) => {
                        builder.parameter_within(field, target, *least..=*most)
                    }
                    None => builder.parameter(field, target),
                }
            }))
    }
}

/// A field with its target.
fn field(text: &str) -> Result<(&str, Target), String> {
    let (field, target) = text
        .split_once('=')
        .ok_or("write FIELD=WORD:NAME, such as payload=payload_on:hand")?;
    Ok((field, setting::text::target(target)?))
}

fn range(text: &str) -> Result<(String, [f64; 2]), String> {
    let ends = text.split_once('=').and_then(|(field, ends)| {
        let (least, most) = ends.split_once("..")?;
        let most = most.strip_prefix('=').unwrap_or(most);
        Some((field.to_owned(), [least.parse().ok()?, most.parse().ok()?]))
    });
    ends.ok_or_else(|| "write FIELD=LEAST..MOST, such as payload=0..3".to_owned())
}
