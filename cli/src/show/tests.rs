//! Pages as text: their elements and data.

use std::ffi::OsString;

use serde_json::Value;

use super::{SCRIPT, SCRIPT_HASH, STYLE, STYLE_HASH};
use crate::{Answer, answer};
use homogen_codegen::function::Function;
use homogen_page::packed::base_64;

/// Files by name, read as standard input.
const SCARA: &str = include_str!("../../../robots/scara.urdf");

fn show(options: &str, input: &str) -> Answer {
    let words = ["homogen", "show", "-"].into_iter();
    let words = words.chain(options.split_whitespace());
    answer(words.map(OsString::from), &mut input.as_bytes())
}

/// The page of a robot without errors, and its data.
fn page(options: &str, input: &str) -> (String, Value) {
    let answer = show(options, input);
    assert_eq!(answer.code, 0, "{}", answer.remarks);
    let start = "id=\"data\">";
    let at = answer.output.find(start).expect("there is data") + start.len();
    let data = answer.output[at..].split("</script>").next();
    let data = serde_json::from_str(data.expect("it ends")).expect("JSON");
    (answer.output, data)
}

/// Unpacks a text as a browser does.
fn unpacked(packed: &str) -> String {
    let value = |letter: u8| match letter {
        b'A'..=b'Z' => letter - b'A',
        b'a'..=b'z' => letter - b'a' + 26,
        b'0'..=b'9' => letter - b'0' + 52,
        b'+' => 62,
        _ => 63,
    };
    let letters: Vec<u8> = packed.bytes().filter(|&letter| letter != b'=').collect();
    let bytes = letters.chunks(4).flat_map(|four| {
        let bits = four
            .iter()
            .fold(0_u32, |bits, &letter| bits << 6 | u32::from(value(letter)));
        let bits = bits << (6 * (4 - four.len()));
        bits.to_be_bytes()[1..four.len()].to_vec()
    });
    let bytes: Vec<u8> = bytes.collect();
    let text = miniz_oxide::inflate::decompress_to_vec(&bytes).expect("it was deflated");
    String::from_utf8(text).expect("UTF-8")
}

/// SHA-256 (FIPS 180-4).
fn sha_256(text: &str) -> [u8; 32] {
    let primes: Vec<u32> = (2_u32..312)
        .filter(|n| (2..*n).all(|d| n % d != 0))
        .collect();
    // The first 32 bits of the fractions of roots of primes, in integer arithmetic.
    let fraction = |prime: u32, power: u32| {
        let wanted = u128::from(prime) << (32 * power);
        let bits = (0..40).rev();
        let root = bits.fold(0_u128, |root, bit| {
            let more = root | 1 << bit;
            if more.pow(power) <= wanted {
                more
            } else {
                root
            }
        });
        u32::try_from(root & 0xffff_ffff).expect("32 bits")
    };
    let constants: Vec<u32> = primes[..64]
        .iter()
        .map(|&prime| fraction(prime, 3))
        .collect();
    let mut state: Vec<u32> = primes[..8]
        .iter()
        .map(|&prime| fraction(prime, 2))
        .collect();
    let mut bytes = text.as_bytes().to_vec();
    let bits = bytes.len() as u64 * 8;
    bytes.push(0x80);
    while bytes.len() % 64 != 56 {
        bytes.push(0);
    }
    bytes.extend(bits.to_be_bytes());
    for block in bytes.chunks(64) {
        let words = block.chunks(4);
        let mut w: Vec<u32> = words
            .map(|word| u32::from_be_bytes(word.try_into().expect("four bytes")))
            .collect();
        for t in 16..64 {
            let (a, b) = (w[t - 15], w[t - 2]);
            let small = a.rotate_right(7) ^ a.rotate_right(18) ^ (a >> 3);
            let large = b.rotate_right(17) ^ b.rotate_right(19) ^ (b >> 10);
            w.push(
                w[t - 16]
                    .wrapping_add(small)
                    .wrapping_add(w[t - 7])
                    .wrapping_add(large),
            );
        }
        let [mut a, mut b, mut c, mut d, mut e, mut f, mut g, mut h] =
            <[u32; 8]>::try_from(&*state).expect("eight words");
        for (w, k) in w.iter().zip(&constants) {
            let sum = e.rotate_right(6) ^ e.rotate_right(11) ^ e.rotate_right(25);
            let first = h
                .wrapping_add(sum)
                .wrapping_add((e & f) ^ (!e & g))
                .wrapping_add(*k)
                .wrapping_add(*w);
            let sum = a.rotate_right(2) ^ a.rotate_right(13) ^ a.rotate_right(22);
            let second = sum.wrapping_add((a & b) ^ (a & c) ^ (b & c));
            (h, g, f, e) = (g, f, e, d.wrapping_add(first));
            (d, c, b, a) = (c, b, a, first.wrapping_add(second));
        }
        for (before, after) in state.iter_mut().zip([a, b, c, d, e, f, g, h]) {
            *before = before.wrapping_add(after);
        }
    }
    let bytes: Vec<u8> = state.iter().flat_map(|word| word.to_be_bytes()).collect();
    bytes.try_into().expect("32 bytes")
}

#[test]
fn the_policy_has_the_hashes_of_script_and_style() {
    let abc = base_64(&sha_256("abc"));
    assert_eq!(abc, "ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=");
    for (name, text, hash) in [
        ("SCRIPT_HASH", SCRIPT, SCRIPT_HASH),
        ("STYLE_HASH", STYLE, STYLE_HASH),
    ] {
        let found = base_64(&sha_256(text));
        assert_eq!(hash, found, "{name} in cli/src/show.rs is to be {found}");
        assert!(!text.contains("</"), "{name}: the element would end there");
        assert!(
            !text.contains('%') || !text.contains("%data%"),
            "{name} has a mark"
        );
    }
}

#[test]
fn nothing_but_script_and_style_may_run_and_nothing_is_fetched() {
    let (page, _) = page("--functions gravity", SCARA);
    let policy = page.split("Content-Security-Policy\" content=\"").nth(1);
    let policy = policy
        .and_then(|rest| rest.split('"').next())
        .expect("a policy");
    assert!(
        policy.starts_with("default-src 'none'; script-src 'sha256-"),
        "{policy}"
    );
    assert!(
        !policy.contains("unsafe") && !policy.contains('*'),
        "{policy}"
    );
    for external in [
        "src=",
        "http:",
        "https:",
        "url(",
        "@import",
        "innerHTML",
        "eval(",
    ] {
        let own = page.split("<script type=").next().expect("a head");
        assert!(!own.contains(external), "{external} in the page");
        assert!(!SCRIPT.contains(external), "{external} in the script");
        assert!(!STYLE.contains(external), "{external} in the style");
    }
}

/// Text that could end or begin an element, or hide in one.
const EVIL: [&str; 6] = [
    "</script><script>alert(1)</script>",
    "<!--<script>",
    "\"'><img src=x onerror=alert(1)>",
    "%data%%script%",
    "a\u{202e}b\u{200b}c",
    "&lt;b&gt; ]]> $1 `x` \\u003c",
];

/// An arm with such names.
fn evil_arm(evil: &str) -> String {
    let evil = evil
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('"', "&quot;");
    SCARA
        .replace("name=\"", &format!("name=\"{evil}"))
        .replace("link=\"", &format!("link=\"{evil}"))
        .replace("joint=\"", &format!("joint=\"{evil}"))
}

#[test]
fn names_of_a_hostile_file_stay_data() {
    let (clean, _) = page("--functions gravity,forward_kinematics", SCARA);
    let outside = |page: &str| {
        let start = page.find("id=\"data\">").expect("data");
        let end = start + page[start..].find("</script>").expect("its end");
        (page[..start].to_owned(), page[end..].to_owned())
    };
    for evil in EVIL {
        let (page, data) = page("--functions gravity,forward_kinematics", &evil_arm(evil));
        // The rest of the page is unchanged.
        assert_eq!(outside(&page), outside(&clean), "{evil}");
        let start = page.find("id=\"data\">").expect("data") + "id=\"data\">".len();
        let inside = &page[start..start + page[start..].find("</script>").expect("its end")];
        let marks = ['<', '>', '&', '\u{202e}', '\u{200b}', '\n'];
        assert!(!inside.contains(marks), "{evil}");
        // No text contains invisible characters.
        let texts = data.to_string();
        assert!(
            !texts.contains(homogen_codegen::wording::is_hidden),
            "{evil}"
        );
        let shown = homogen_codegen::wording::visible(evil);
        let robot = data["report"]["robot"].as_str().expect("a name");
        assert!(robot.starts_with(&*shown), "{robot}");
        let link = data["skeleton"]["links"][1]["name"]
            .as_str()
            .expect("a name");
        assert!(link.starts_with(&*shown), "{link}");
    }
}

#[test]
fn every_function_is_there_as_it_is_printed() {
    let (_, data) = page("--tip tool", SCARA);
    let functions = data["functions"].as_array().expect("a list");
    let left_out = data["left_out"].as_array().expect("a list");
    let names: Vec<&str> = functions
        .iter()
        .filter_map(|own| own["name"].as_str())
        .collect();
    let missing = left_out
        .iter()
        .flat_map(|left| left["functions"].as_array().expect("names"));
    let missing: Vec<&str> = missing.filter_map(Value::as_str).collect();
    for function in Function::ALL {
        let name = function.name();
        assert!(names.contains(&name) != missing.contains(&name), "{name}");
    }
    for own in functions {
        let name = own["name"].as_str().expect("a name");
        let text = unpacked(own["code"].as_str().expect("text"));
        let inspected = [
            "homogen",
            "inspect",
            "-",
            "--tip",
            "tool",
            "--function",
            name,
        ];
        let inspected = answer(inspected.map(OsString::from), &mut SCARA.as_bytes());
        assert_eq!(text, inspected.output, "{name}");
        assert_eq!(own["lines"], text.lines().count());
        let mul = own["count"]["mul"].as_u64().expect("a number");
        assert!(text.contains(&format!("\n/// {mul} mul, ")), "{name}");
    }
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let options = "--tip tool --functions inverse_dynamics,mass_matrix+bias --floating";
    let [first, second] = [show(options, SCARA), show(options, SCARA)];
    assert_eq!(first.code, 0, "{}", first.remarks);
    assert_eq!(first, second);
}

#[test]
fn options_of_other_commands_hold() {
    let options = "--floating --lock lift=-0.05 --functions gravity --scalar f32";
    let (_, data) = page(options, SCARA);
    assert_eq!(data["report"]["locked"][0]["q"], -0.05);
    assert_eq!(data["skeleton"]["bodies"][0]["by"]["manifold"], "floating");
    let code = unpacked(data["functions"][0]["code"].as_str().expect("text"));
    assert!(code.contains("f32; 10]"), "{code}");
    let refused = show("--lock nothing", SCARA);
    assert_eq!((refused.output.as_str(), refused.code), ("", 1));
}

#[test]
fn a_coordinate_is_of_its_joint_whatever_that_is_called() {
    let text = include_str!("../../../tests/show/joints.urdf");
    let (_, data) = page("--tip thumb --functions forward_kinematics", text);
    let of = |data: &Value| -> Vec<(String, String)> {
        let coordinates = data["skeleton"]["coordinates"].as_array().expect("a list");
        let text = |value: &Value| value.as_str().expect("a name").to_owned();
        let coordinates = coordinates.iter();
        coordinates
            .map(|entry| (text(&entry["name"]), text(&entry["joint"])))
            .collect()
    };
    for (name, joint) in of(&data) {
        let part = name.strip_prefix(&joint).expect("it begins as the joint");
        assert!(part.is_empty() || part.starts_with('.'), "{name}");
    }
    // A joint with the name of a coordinate of another.
    let arm = SCARA.replace("\"elbow\"", "\"shoulder.x\"");
    let (_, data) = page("--tip tool --functions gravity", &arm);
    let [first, second] = [0, 1].map(|k| of(&data)[k].clone());
    let name = |name: &str| (name.to_owned(), name.to_owned());
    assert_eq!([first, second], ["shoulder", "shoulder.x"].map(name));
}
