//! Tables in Parquet: as other writers make them, and read back by another reader.

use std::fs::{self, File};

use ::parquet::basic::Compression;
use ::parquet::data_type::{ByteArrayType, DoubleType};
use ::parquet::file::properties::WriterProperties;
use ::parquet::file::reader::{FileReader, SerializedFileReader};
use ::parquet::file::writer::SerializedFileWriter;
use ::parquet::record::Field;
use ::parquet::schema::parser::parse_message_type;

use super::{Folder, eval, many, numbers, refused, refused_states, same};
use crate::cli::Answer;

/// A list of a row, some of whose numbers may not be there.
type Row<'a> = &'a [Option<f64>];

/// A table as Arrow's writers make it, compressed, some rows to a group: lists of numbers that may be absent.
fn table(path: &str, columns: &[(&str, Vec<Row<'_>>)], group: usize) {
    let schema = columns.iter().map(|(name, _)| {
        format!(
            "optional group {name} (LIST) {{ repeated group list {{ optional double element; }} }}"
        )
    });
    let schema = format!(
        "message schema {{ optional binary label; {} }}",
        schema.collect::<String>()
    );
    let schema = parse_message_type(&schema).expect("a schema");
    let properties = WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        .build();
    let file = File::create(path).expect("a temporary file");
    let mut file =
        SerializedFileWriter::new(file, schema.into(), properties.into()).expect("a table");
    let rows = columns[0].1.len();
    for first in (0..rows).step_by(group) {
        let mut rows_of_group = file.next_row_group().expect("a group");
        let last = rows.min(first + group);
        let mut label = rows_of_group
            .next_column()
            .expect("a column")
            .expect("there is one");
        let levels = vec![0; last - first];
        label
            .typed::<ByteArrayType>()
            .write_batch(&[], Some(&levels), None)
            .expect("nothing");
        label.close().expect("a column");
        for (_, column) in columns {
            let rows = &column[first..last];
            let numbers: Vec<f64> = rows
                .iter()
                .flat_map(|row| row.iter().flatten())
                .copied()
                .collect();
            let defined = rows.iter().flat_map(|row| match row {
                [] => vec![1],
                row => row
                    .iter()
                    .map(|number| 2 + i16::from(number.is_some()))
                    .collect(),
            });
            let defined: Vec<i16> = defined.collect();
            let again = rows
                .iter()
                .flat_map(|row| (0..row.len().max(1)).map(|k| i16::from(k > 0)));
            let again: Vec<i16> = again.collect();
            let mut column = rows_of_group
                .next_column()
                .expect("a column")
                .expect("there is one");
            let writer = column.typed::<DoubleType>();
            writer
                .write_batch(&numbers, Some(&defined), Some(&again))
                .expect("numbers");
            column.close().expect("a column");
        }
        rows_of_group.close().expect("a group");
    }
    file.close().expect("a table");
}

#[test]
fn a_table_gives_the_bits_of_json() {
    let folder = Folder::new("table");
    let (q, qd, states) = many();
    let states = folder.write("states.json", states);
    let [given, kept, out] =
        ["given.parquet", "kept.parquet", "out.npy"].map(|name| folder.path(name));
    let [q, qd] = [q, qd].map(|numbers| numbers.into_iter().map(Some).collect::<Vec<_>>());
    table(
        &given,
        &[("qd", qd.chunks(2).collect()), ("q", q.chunks(2).collect())],
        500,
    );
    for function in ["bias", "kinetic_energy"] {
        let words = ["--function", function, "--states"];
        assert_eq!(
            eval(&[&words[..], &[&states, "-o", &out]].concat()),
            Answer::default()
        );
        let expected = numbers(&out);
        assert_eq!(
            eval(&[&words[..], &[&given, "-o", &out]].concat()),
            Answer::default()
        );
        assert!(same(&numbers(&out), &expected), "{function}");
        // Results in a table are read back by another reader.
        assert_eq!(
            eval(&[&words[..], &[&given, "-o", &kept]].concat()),
            Answer::default()
        );
        let file =
            SerializedFileReader::new(File::open(&kept).expect("it was written")).expect("a table");
        let mut found = Vec::new();
        for row in file.get_row_iter(None).expect("rows") {
            let row = row.expect("a row");
            let [(name, field)] = row.get_column_iter().collect::<Vec<_>>()[..] else {
                panic!("{row:?} has one column");
            };
            assert_eq!(name, function);
            match field {
                Field::Double(number) => found.push(*number),
                Field::ListInternal(list) => {
                    found.extend(list.elements().iter().map(|field| match field {
                        Field::Double(number) => *number,
                        other => panic!("{other:?} is no number"),
                    }));
                }
                other => panic!("{other:?} is no result"),
            }
        }
        assert!(same(&found, &expected), "{function}");
    }
    assert_eq!(
        folder.names(),
        ["given.parquet", "kept.parquet", "out.npy", "states.json"]
    );
}

#[test]
fn rows_that_are_no_states_are_refused() {
    let folder = Folder::new("rows");
    let path = folder.path("rows.parquet");
    let good = [Some(0.5), Some(0.25)];
    let mut rows: Vec<Row<'_>> = vec![&good; 7];
    for (row, found) in [
        (&[Some(1.0)][..], "1 numbers for 2"),
        (&[], "0 numbers for 2"),
        (&[Some(1.0), None], "1 numbers for 2"),
        (&[Some(1.0), None, Some(2.0)], "a null"),
        (&[Some(1.0), Some(2.0), Some(3.0)], "3 numbers for 2"),
    ] {
        rows[5] = row;
        table(&path, &[("q", rows.clone())], 3);
        assert_eq!(
            refused_states(&folder, &path),
            format!("error: rows.parquet: state 5 has {found} in \"q\"\n")
        );
    }
    let words = ["--function", "bias", "--states", &path, "-o", "never.npy"];
    assert_eq!(
        refused(&folder, &words),
        "error: rows.parquet: has no column \"qd\"\n"
    );
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told_of_a_table() {
    let folder = Folder::new("full-table");
    let (.., states) = many();
    let states = folder.write("states.json", states);
    let full = folder.path("full.parquet");
    std::os::unix::fs::symlink("/dev/full", &full).expect("a link");
    let found = refused(
        &folder,
        &["--function", "gravity", "--states", &states, "-o", &full],
    );
    assert!(
        found.starts_with("error: cannot write full.parquet: No space left on device"),
        "{found}"
    );
}

#[test]
fn a_table_that_is_none_is_refused() {
    let folder = Folder::new("no-table");
    let (.., states) = many();
    let states = folder.write("states.json", states);
    let table = folder.path("table.parquet");
    let words = ["--function", "gravity", "--states", &states, "-o", &table];
    assert_eq!(eval(&words), Answer::default());
    let bytes = fs::read(&table).expect("it was written");
    for (name, bytes) in [
        ("empty", &[][..]),
        ("cut", &bytes[..bytes.len() / 2]),
        ("text", b"PAR1 and no more"),
    ] {
        let path = folder.write(&format!("{name}.parquet"), bytes);
        let found = refused_states(&folder, &path);
        assert!(
            found.starts_with(&format!(
                "error: {name}.parquet: cannot be read as Parquet: "
            )),
            "{found}"
        );
    }
}
