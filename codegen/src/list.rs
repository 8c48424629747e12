//! Typed lists and matrices: each kind of list has an index type of its own, so that an index of a body can't be used
//! in a list of velocities.
//!
//! A [`List`] is a slice with such indices, a [`Square`] a matrix over two of them. Index types are declared next to
//! their lists.

use std::fmt::Debug;
use std::marker::PhantomData;
use std::ops::{Deref, DerefMut, Index, IndexMut};

/// Index of an entry in one kind of list.
pub trait Id: Copy + Ord + Debug {
    /// Index from an offset.
    fn new(index: usize) -> Self;

    /// Offset in the list.
    fn index(self) -> usize;

    /// Number that counts from 1, as in the paper and in names.
    fn number(self) -> usize {
        self.index() + 1
    }

    /// Index of a later entry.
    #[must_use]
    fn plus(self, count: usize) -> Self {
        Self::new(self.index() + count)
    }
}

/// Declares an index type.
macro_rules! id {
    ($(#[$about:meta])* $name:ident) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(usize);

        impl $crate::list::Id for $name {
            fn new(index: usize) -> Self {
                Self(index)
            }

            fn index(self) -> usize {
                self.0
            }
        }

        impl From<u16> for $name {
            fn from(index: u16) -> Self {
                Self(index.into())
            }
        }
    };
}
pub(crate) use id;

/// List with its own index type.
#[derive(Clone, Debug, PartialEq)]
pub struct List<I, T> {
    entries: Vec<T>,
    numbers: PhantomData<I>,
}

/// The first `count` indices, in order.
pub fn ids<I: Id>(
    count: usize,
) -> impl DoubleEndedIterator<Item = I> + ExactSizeIterator + Clone + use<I> {
    (0..count).map(I::new)
}

impl<I: Id, T> List<I, T> {
    /// An empty list.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            entries: Vec::new(),
            numbers: PhantomData,
        }
    }

    /// `count` copies of an entry.
    #[must_use]
    pub fn filled(entry: T, count: usize) -> Self
    where
        T: Clone,
    {
        vec![entry; count].into()
    }

    /// Adds an entry and returns its index.
    pub fn push(&mut self, entry: T) -> I {
        self.entries.push(entry);
        I::new(self.entries.len() - 1)
    }

    /// Index of the next entry to be added.
    #[must_use]
    pub fn next(&self) -> I {
        I::new(self.entries.len())
    }

    /// Indices of all entries, in order.
    #[must_use]
    pub fn ids(
        &self,
    ) -> impl DoubleEndedIterator<Item = I> + ExactSizeIterator + Clone + use<I, T> {
        ids(self.entries.len())
    }

    /// All entries with their indices.
    #[must_use]
    pub fn numbered(&self) -> impl DoubleEndedIterator<Item = (I, &T)> + ExactSizeIterator {
        self.ids().zip(&self.entries)
    }

    /// Index of the first entry with a property.
    pub fn find(&self, is: impl FnMut(&T) -> bool) -> Option<I> {
        self.entries.iter().position(is).map(I::new)
    }

    /// Entry with this index, if there is one.
    #[must_use]
    pub fn get(&self, id: I) -> Option<&T> {
        self.entries.get(id.index())
    }

    /// The same list with another index type, for lists that correspond entry by entry.
    #[must_use]
    pub fn renumbered<J>(self) -> List<J, T> {
        self.entries.into()
    }

    /// List of the mapped entries.
    #[must_use]
    pub fn map<U>(&self, of: impl FnMut(&T) -> U) -> List<I, U> {
        self.entries.iter().map(of).collect()
    }
}

impl<I: Id, T> Default for List<I, T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<I, T> From<Vec<T>> for List<I, T> {
    fn from(entries: Vec<T>) -> Self {
        Self {
            entries,
            numbers: PhantomData,
        }
    }
}

impl<I, T> From<List<I, T>> for Vec<T> {
    fn from(list: List<I, T>) -> Self {
        list.entries
    }
}

impl<I, T> FromIterator<T> for List<I, T> {
    fn from_iter<E: IntoIterator<Item = T>>(entries: E) -> Self {
        Vec::from_iter(entries).into()
    }
}

impl<I, T> Extend<T> for List<I, T> {
    fn extend<E: IntoIterator<Item = T>>(&mut self, entries: E) {
        self.entries.extend(entries);
    }
}

impl<I, T> IntoIterator for List<I, T> {
    type Item = T;
    type IntoIter = std::vec::IntoIter<T>;

    fn into_iter(self) -> Self::IntoIter {
        self.entries.into_iter()
    }
}

impl<'l, I, T> IntoIterator for &'l List<I, T> {
    type Item = &'l T;
    type IntoIter = std::slice::Iter<'l, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.entries.iter()
    }
}

impl<'l, I, T> IntoIterator for &'l mut List<I, T> {
    type Item = &'l mut T;
    type IntoIter = std::slice::IterMut<'l, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.entries.iter_mut()
    }
}

impl<I, T> Deref for List<I, T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.entries
    }
}

impl<I, T> DerefMut for List<I, T> {
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.entries
    }
}

impl<I: Id, T> Index<I> for List<I, T> {
    type Output = T;

    fn index(&self, id: I) -> &T {
        &self.entries[id.index()]
    }
}

impl<I: Id, T> IndexMut<I> for List<I, T> {
    fn index_mut(&mut self, id: I) -> &mut T {
        &mut self.entries[id.index()]
    }
}

/// Square matrix with a row and a column for each entry of a list.
#[derive(Clone, Debug)]
pub struct Square<I, T> {
    count: usize,
    entries: Vec<T>,
    numbers: PhantomData<I>,
}

impl<I: Id, T: Copy> Square<I, T> {
    /// Matrix of equal entries with `count` rows.
    #[must_use]
    pub fn filled(entry: T, count: usize) -> Self {
        Self {
            count,
            entries: vec![entry; count * count],
            numbers: PhantomData,
        }
    }

    /// Matrix from its entries, row by row.
    #[must_use]
    pub fn of_rows(entries: &[T]) -> Self {
        Self {
            count: entries.len().isqrt(),
            entries: entries.to_vec(),
            numbers: PhantomData,
        }
    }

    /// Matrix from its columns.
    #[must_use]
    pub fn of_columns(columns: &List<I, List<I, T>>) -> Self {
        let row = |row: I| columns.iter().map(move |column| column[row]);
        Self {
            count: columns.len(),
            entries: columns.ids().flat_map(row).collect(),
            numbers: PhantomData,
        }
    }

    /// Indices of its rows, which are those of its columns.
    #[must_use]
    pub fn ids(
        &self,
    ) -> impl DoubleEndedIterator<Item = I> + ExactSizeIterator + Clone + use<I, T> {
        ids(self.count)
    }

    /// Indices of its entries, row by row.
    pub fn places(&self) -> impl Iterator<Item = (I, I)> + use<I, T> {
        let columns = self.ids();
        let row = move |row: I| columns.clone().map(move |column| (row, column));
        self.ids().flat_map(row)
    }

    /// Entry of the first row and column.
    ///
    /// # Panics
    /// If the matrix is empty.
    #[must_use]
    pub fn first(&self) -> T {
        self.entries[0]
    }

    /// Rows.
    pub fn rows(&self) -> impl Iterator<Item = List<I, T>> {
        self.ids().map(|row| self.row(row).collect())
    }

    /// Row.
    pub fn row(&self, row: I) -> impl Iterator<Item = T> {
        self.ids().map(move |column| self[(row, column)])
    }

    /// Column.
    pub fn column(&self, column: I) -> List<I, T> {
        self.ids().map(|row| self[(row, column)]).collect()
    }

    /// Diagonal.
    pub fn diagonal(&self) -> impl Iterator<Item = T> {
        self.ids().map(|k| self[(k, k)])
    }

    /// The same matrix with another index type, for lists that correspond entry by entry.
    #[must_use]
    pub fn renumbered<J>(self) -> Square<J, T> {
        Square {
            count: self.count,
            entries: self.entries,
            numbers: PhantomData,
        }
    }

    /// Sets an entry and its mirror image.
    pub fn set_both(&mut self, (row, column): (I, I), entry: T) {
        self[(row, column)] = entry;
        self[(column, row)] = entry;
    }
}

impl<I, T> From<Square<I, T>> for Vec<T> {
    /// Entries, row by row.
    fn from(square: Square<I, T>) -> Self {
        square.entries
    }
}

impl<I: Id, T> Index<(I, I)> for Square<I, T> {
    type Output = T;

    fn index(&self, (row, column): (I, I)) -> &T {
        &self.entries[row.index() * self.count + column.index()]
    }
}

impl<I: Id, T> IndexMut<(I, I)> for Square<I, T> {
    fn index_mut(&mut self, (row, column): (I, I)) -> &mut T {
        &mut self.entries[row.index() * self.count + column.index()]
    }
}
