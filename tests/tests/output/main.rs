//! Output for users: messages and results of the command line, descriptions of robots, names in generated code; damaged
//! descriptions.

mod command_line;
mod described;
mod fire;
mod names;
