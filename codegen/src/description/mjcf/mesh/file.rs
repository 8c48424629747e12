//! Reads files of meshes: binary STL, OBJ, and MuJoCo's MSH.
//!
//! Vertices are rounded to single precision, as in MuJoCo. Time and memory are proportional to the size of the file.

use super::Mesh;

/// Maximum number of faces of a binary STL file, as in MuJoCo.
const MOST_FACES: usize = 200_000;

/// Reads a file in the format of its ending.
pub(super) fn read(bytes: &[u8], ending: &str) -> Result<Mesh, String> {
    let mesh = match ending.to_ascii_lowercase().as_str() {
        "stl" => stl(bytes),
        "obj" => obj(bytes),
        "msh" => msh(bytes),
        _ => return Err("it is not an STL, OBJ or MSH file".to_owned()),
    }?;
    checked(mesh)
}

/// A mesh of numbers in the XML file.
pub(super) fn of_numbers(corners: &[f64], faces: &[f64]) -> Result<Mesh, String> {
    if !corners.len().is_multiple_of(3) || !faces.len().is_multiple_of(3) {
        return Err("the number of entries of vertex or face is not a multiple of 3".to_owned());
    }
    let corners = corners
        .chunks_exact(3)
        .map(|corner| [corner[0], corner[1], corner[2]].map(single));
    let face = |face: &[f64]| {
        let corner = |number: f64| {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "checked in the condition"
            )]
            let index =
                (number >= 0.0 && number.fract() == 0.0 && number < 1e9).then_some(number as usize);
            index.ok_or_else(|| "a vertex index of a face is not a whole number".to_owned())
        };
        Ok([corner(face[0])?, corner(face[1])?, corner(face[2])?])
    };
    let faces = faces
        .chunks_exact(3)
        .map(face)
        .collect::<Result<_, String>>()?;
    checked(Mesh {
        corners: corners.collect(),
        faces,
    })
}

/// Rounds to single precision.
fn single(number: f64) -> f64 {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "meshes are in single precision"
    )]
    let single = number as f32;
    f64::from(single)
}

fn checked(mesh: Mesh) -> Result<Mesh, String> {
    if mesh.corners.is_empty() {
        return Err("it has no vertices".to_owned());
    }
    if mesh
        .corners
        .iter()
        .flatten()
        .any(|entry| !entry.is_finite())
    {
        return Err("it has an infinite or NaN coordinate".to_owned());
    }
    let mut indices = mesh.faces.iter().flatten();
    if indices.any(|&corner| corner >= mesh.corners.len()) {
        return Err("a face has a vertex that does not exist".to_owned());
    }
    Ok(mesh)
}

fn float(bytes: &[u8], at: usize) -> Option<f64> {
    let word: [u8; 4] = bytes.get(at..at + 4)?.try_into().ok()?;
    Some(f64::from(f32::from_le_bytes(word)))
}

fn count(bytes: &[u8], at: usize) -> Option<usize> {
    let word: [u8; 4] = bytes.get(at..at + 4)?.try_into().ok()?;
    usize::try_from(u32::from_le_bytes(word)).ok()
}

fn corner(bytes: &[u8], at: usize) -> Option<[f64; 3]> {
    Some([
        float(bytes, at)?,
        float(bytes, at + 4)?,
        float(bytes, at + 8)?,
    ])
}

/// Binary STL: each face with its normal and its own three vertices.
fn stl(bytes: &[u8]) -> Result<Mesh, String> {
    const HEAD: usize = 84;
    const FACE: usize = 50;
    let faces = count(bytes, HEAD - 4).filter(|faces| bytes.len() == HEAD + FACE * faces);
    let faces = faces.ok_or("it is not a binary STL file; text files are not supported")?;
    if faces > MOST_FACES {
        return Err(format!("it has more than {MOST_FACES} faces"));
    }
    let mut mesh = Mesh::default();
    for face in 0..faces {
        let first = mesh.corners.len();
        for k in 1..4 {
            let found = corner(bytes, HEAD + FACE * face + 12 * k);
            mesh.corners.extend(found);
        }
        mesh.faces.push([first, first + 1, first + 2]);
    }
    Ok(mesh)
}

/// OBJ: the first group that has faces, of three or four vertices.
fn obj(bytes: &[u8]) -> Result<Mesh, String> {
    let text = String::from_utf8_lossy(bytes);
    let mut mesh = Mesh::default();
    // Indices count the vertices of all groups.
    let mut polygons: Vec<Vec<usize>> = Vec::new();
    let mut is_over = false;
    for line in text.lines() {
        let mut words = line.split_ascii_whitespace();
        match words.next() {
            Some("v") => {
                let mut entry = || words.next()?.parse().ok().map(single);
                let corner = entry().zip(entry()).zip(entry());
                let ((x, y), z) = corner.ok_or("a vertex has fewer than three numbers")?;
                mesh.corners.push([x, y, z]);
            }
            Some("g" | "o") => is_over |= !polygons.is_empty(),
            Some("f") if !is_over => {
                let count = mesh.corners.len();
                let corner = |word: &str| {
                    let index: i64 = word.split('/').next()?.parse().ok()?;
                    let index = if index < 0 {
                        i64::try_from(count).ok()?.checked_add(index)?
                    } else {
                        index - 1
                    };
                    usize::try_from(index).ok()
                };
                let corners: Option<Vec<usize>> = words.map(corner).collect();
                let corners = corners.ok_or("a face has a vertex that does not exist")?;
                polygons.push(corners);
            }
            _ => {}
        }
    }
    for polygon in polygons {
        match *polygon {
            [a, b, c] => mesh.faces.push([a, b, c]),
            [a, b, c, d] => mesh.faces.extend(cut(&mesh.corners, [a, b, c, d])?),
            _ => {
                return Err(
                    "it has a face with fewer than three or more than four vertices".to_owned(),
                );
            }
        }
    }
    Ok(mesh)
}

/// Splits a face of four vertices along its shorter diagonal.
fn cut(corners: &[[f64; 3]], [a, b, c, d]: [usize; 4]) -> Result<[[usize; 3]; 2], String> {
    let length = |from: usize, to: usize| {
        let (from, to) = (corners.get(from)?, corners.get(to)?);
        let parts = from.iter().zip(to).map(|(a, b)| single(b - a));
        Some(parts.map(|part| single(part * part)).sum::<f64>())
    };
    let lengths = length(a, c).zip(length(b, d));
    let (first, second) = lengths.ok_or("a face has a vertex that does not exist")?;
    Ok(if first < second {
        [[a, b, c], [a, c, d]]
    } else {
        [[a, b, d], [b, c, d]]
    })
}

/// MSH: counts, vertices, normals, texture coordinates, faces.
fn msh(bytes: &[u8]) -> Result<Mesh, String> {
    const HEAD: usize = 16;
    let read = || {
        let [corners, normals, places, faces] = [0, 4, 8, 12].map(|at| count(bytes, at));
        let (corners, normals, places, faces) = (corners?, normals?, places?, faces?);
        let sizes = [(corners, 12), (normals, 12), (places, 8), (faces, 12)];
        let mut size = HEAD;
        let mut starts = [0; 4];
        for (start, (count, each)) in starts.iter_mut().zip(sizes) {
            *start = size;
            size = size.checked_add(count.checked_mul(each)?)?;
        }
        if size != bytes.len() {
            return None;
        }
        let corners = (0..corners).map(|k| corner(bytes, starts[0] + 12 * k));
        let index = |at: usize| count(bytes, at);
        let faces = (0..faces).map(|k| {
            let at = starts[3] + 12 * k;
            Some([index(at)?, index(at + 4)?, index(at + 8)?])
        });
        Some(Mesh {
            corners: corners.collect::<Option<_>>()?,
            faces: faces.collect::<Option<_>>()?,
        })
    };
    read().ok_or_else(|| "its size does not match its counts".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tetrahedron.
    const CORNERS: [[f64; 3]; 4] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

    fn floats(entries: impl IntoIterator<Item = f64>) -> Vec<u8> {
        #[expect(clippy::cast_possible_truncation, reason = "small whole numbers")]
        let bytes = entries
            .into_iter()
            .map(|entry| (entry as f32).to_le_bytes());
        bytes.flatten().collect()
    }

    fn counts(entries: impl IntoIterator<Item = usize>) -> Vec<u8> {
        let word = |entry: usize| u32::try_from(entry).unwrap().to_le_bytes();
        entries.into_iter().flat_map(word).collect()
    }

    fn binary_stl() -> Vec<u8> {
        let mut bytes = vec![b' '; 80];
        bytes.extend(counts([4]));
        for face in FACES {
            bytes.extend(floats([0.0; 3]));
            bytes.extend(floats(face.into_iter().flat_map(|corner| CORNERS[corner])));
            bytes.extend([0, 0]);
        }
        bytes
    }

    fn faces(mesh: &Mesh) -> Vec<[[f64; 3]; 3]> {
        let corners = |face: &[usize; 3]| face.map(|corner| mesh.corners[corner]);
        mesh.faces.iter().map(corners).collect()
    }

    #[test]
    fn each_format_gives_the_same() {
        let wanted = Mesh {
            corners: CORNERS.to_vec(),
            faces: FACES.to_vec(),
        };
        let text = "# a\no t\nv 0 0 0\nv 1 0 0 0.5\nv 0 1 0\nv 0 0 1\nvn 0 0 1\n\
                    f 1//1 3//1 2//1\ns off\nf 1 2 4\nf -4/1 -1/1 -2/1\nf 2/1/1 3 4\no other\nf 1 2 3\n";
        assert_eq!(read(text.as_bytes(), "OBJ").unwrap(), wanted);
        assert_eq!(faces(&read(&binary_stl(), "stl").unwrap()), faces(&wanted));
        let mut bytes = counts([4, 0, 4, 4]);
        bytes.extend(floats(CORNERS.into_iter().flatten()));
        bytes.extend(floats([0.5; 8]));
        bytes.extend(counts(FACES.into_iter().flatten()));
        assert_eq!(read(&bytes, "msh").unwrap(), wanted);
        let corners: Vec<f64> = CORNERS.into_iter().flatten().collect();
        #[expect(clippy::cast_precision_loss, reason = "small numbers")]
        let numbers: Vec<f64> = FACES
            .into_iter()
            .flatten()
            .map(|corner| corner as f64)
            .collect();
        assert_eq!(of_numbers(&corners, &numbers).unwrap(), wanted);
    }

    #[test]
    fn faces_of_four_corners_are_cut_along_the_shorter_diagonal() {
        let text = "v 0 0 0\nv 1 0 0\nv 3 2 0\nv 0 1 0\nf 1 2 3 4\n";
        let mesh = read(text.as_bytes(), "obj").unwrap();
        assert_eq!(mesh.faces, [[0, 1, 3], [1, 2, 3]]);
    }

    #[test]
    fn damaged_files_are_refused() {
        let refusal = |bytes: &[u8], ending: &str| read(bytes, ending).unwrap_err();
        assert!(refusal(b"solid a", "stl").contains("not a binary STL"));
        assert!(refusal(&binary_stl()[..200], "stl").contains("not a binary STL"));
        assert!(refusal(&counts([4, 0, 0, 4]), "msh").contains("size"));
        assert!(refusal(&counts([usize::from(u16::MAX) << 16, 0, 0, 0]), "msh").contains("size"));
        assert!(refusal(b"v 0 0\n", "obj").contains("three numbers"));
        assert!(refusal(b"v 0 0 0\nf 1 2 3\n", "obj").contains("vertex that does not exist"));
        assert!(refusal(b"v 0 0 0\nf 0 1 1\n", "obj").contains("vertex that does not exist"));
        assert!(refusal(b"v 0 0 0\nf 1 1 1 1 1\n", "obj").contains("more than four"));
        assert!(refusal(b"v 0 0 1e99\nf 1 1 1\n", "obj").contains("infinite or NaN"));
        assert!(refusal(b"f\n", "obj").contains("fewer than three"));
        assert!(refusal(b"# nothing\n", "obj").contains("no vertices"));
        assert!(refusal(b"", "dae").contains("not an STL"));
    }
}
