//! The tree of an expression.

use std::rc::Rc;

use super::value::Value;

/// An expression.
#[derive(Clone, Debug)]
pub(in crate::description::xacro) enum Expression {
    Constant(Value),
    Name(Rc<str>),
    Unary(Unary, Box<Expression>),
    Binary(Binary, Box<[Expression; 2]>),
    And(Box<[Expression; 2]>),
    Or(Box<[Expression; 2]>),
    Compare(Box<Expression>, Vec<(Comparison, Expression)>),
    /// Test, value if it is true, value if not.
    If(Box<[Expression; 3]>),
    /// Items; true for a tuple.
    List(Vec<Expression>, bool),
    /// A list by comprehension.
    Each(Box<Expression>, Vec<Each>),
    Member(Box<Expression>, Rc<str>),
    Index(Box<[Expression; 2]>),
    Slice(Box<Expression>, Box<[Option<Expression>; 3]>),
    /// Function, arguments, arguments with names.
    Call(Box<Expression>, Vec<Expression>, Vec<(Rc<str>, Expression)>),
}

/// `for names in values if tests`.
#[derive(Clone, Debug)]
pub(in crate::description::xacro) struct Each {
    pub(super) names: Vec<Rc<str>>,
    pub(super) values: Expression,
    pub(super) tests: Vec<Expression>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::description::xacro) enum Unary {
    Plus,
    Minus,
    Not,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::description::xacro) enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    FloorDivide,
    Remainder,
    Power,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::description::xacro) enum Comparison {
    Equal,
    Different,
    Less,
    AtMost,
    Greater,
    AtLeast,
    In,
    NotIn,
    Is,
    IsNot,
}
