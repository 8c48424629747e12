//! Tables that the functions of the interface share, and the functions that read them.
//!
//! In: sparsity patterns and places, each of which is printed once. Out: their names, and their definitions.

use std::fmt::Write;

use crate::print::review::filled;

/// Tables and functions in use.
pub(super) struct Tables {
    /// Beginning of all names.
    prefix: String,
    patterns: Vec<Vec<String>>,
    places: Vec<Vec<String>>,
    /// Length of the array of zeros.
    zeros: usize,
    has_spread: bool,
    has_adjoint: bool,
}

impl Tables {
    pub fn new(prefix: String) -> Self {
        Self {
            prefix,
            patterns: Vec::new(),
            places: Vec::new(),
            zeros: 0,
            has_spread: false,
            has_adjoint: false,
        }
    }

    /// A name of the file.
    fn own(&self, name: &str) -> String {
        format!("{}_{name}", self.prefix)
    }

    /// Name of the table of a sparsity pattern.
    pub fn pattern(&mut self, pattern: Vec<String>) -> String {
        let index = index(&mut self.patterns, pattern);
        self.own(&format!("sparsity_{index}"))
    }

    /// Name of the table of places in an array.
    pub fn places(&mut self, places: Vec<String>) -> String {
        let index = index(&mut self.places, places);
        self.own(&format!("places_{index}"))
    }

    /// Name of an array of so many zeros.
    pub fn zeros(&mut self, count: usize) -> String {
        self.zeros = self.zeros.max(count);
        self.own("zeros")
    }

    /// Name of the function that stores entries.
    pub fn put(&self) -> String {
        self.own("put")
    }

    /// Name of the function that reads a sparse vector.
    pub fn spread(&mut self) -> String {
        self.has_spread = true;
        self.own("spread")
    }

    /// Name of the function that multiplies a transposed matrix with a vector.
    pub fn adjoint(&mut self) -> String {
        self.has_adjoint = true;
        self.own("adjoint")
    }

    /// Definitions.
    pub fn text(&self) -> String {
        let mut text = String::new();
        let mut table = |kind: &str, name: String, numbers: &[String]| {
            let start = format!("static const {kind} {name}[{}] = {{", numbers.len().max(1));
            let zero = ["0".to_owned()];
            let numbers = if numbers.is_empty() { &zero } else { numbers };
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{}", filled((&start, "    "), numbers, "};"));
        };
        for (k, pattern) in self.patterns.iter().enumerate() {
            table("casadi_int", self.own(&format!("sparsity_{k}")), pattern);
        }
        for (k, places) in self.places.iter().enumerate() {
            table("int", self.own(&format!("places_{k}")), places);
        }
        if self.zeros > 0 {
            let name = self.own("zeros");
            let _ = writeln!(
                text,
                "static const double {name}[{}] = {{0.0}};",
                self.zeros
            );
        }
        let name = self.put();
        let _ = write!(
            text,
            "
/* Stores the entries of a sparse matrix, from their places in an array; place -1 is the number 1. */
static void {name}(double *to, const double *from, const int *places, int count)
{{
    for (int k = 0; k < count; k++) {{
        to[k] = places[k] < 0 ? 1.0 : from[places[k]];
    }}
}}
"
        );
        if self.has_spread {
            let name = self.own("spread");
            let _ = write!(
                text,
                "
/* Stores the entries of a sparse vector at their places; null stores nothing. */
static void {name}(double *to, const double *from, const int *places, int count)
{{
    for (int k = 0; from && k < count; k++) {{
        to[places[k]] = from[k];
    }}
}}
"
            );
        }
        if self.has_adjoint {
            let name = self.own("adjoint");
            let _ = write!(
                text,
                "
/* The product of a transposed matrix with weights. Entry (i, j) is at `i * row + j * column`. */
static void {name}(double *to, const double *weights, const double *matrix, const int *shape)
{{
    const int rows = shape[0], columns = shape[1], row = shape[2], column = shape[3];
    for (int j = 0; j < columns; j++) {{
        double sum = 0.0;
        for (int i = 0; i < rows; i++) {{
            sum += weights[i] * matrix[i * row + j * column];
        }}
        to[j] = sum;
    }}
}}
"
            );
        }
        text
    }
}

/// Index of an item, which is appended if it is new.
fn index(items: &mut Vec<Vec<String>>, item: Vec<String>) -> usize {
    let found = items.iter().position(|other| *other == item);
    found.unwrap_or_else(|| {
        items.push(item);
        items.len() - 1
    })
}
