//! What the project claims, a module for each claim, in one program: the crate is linked once, and what several claims
//! look at is designed and compiled once.
//!
//! `cargo test --test suite contract::` runs one of them. None changes the environment, the current folder or anything
//! else that the process has once; a claim that must is a test program of its own.

mod house;
mod support;

/// What the steps compute: each method against its theory, other programs and recordings.
mod methods {
    mod after_the_prescribed_time;
    mod baselines;
    mod baselines_shipped;
    mod certificate;
    mod comparison;
    mod constants;
    mod correctors;
    mod differentiator;
    mod implicit_euler;
    mod impulsive;
    mod impulsive_promises;
    mod parameters;
    mod parameters_theorem;
    mod prescribed_time;
    mod real_data;
    mod realizations;
    mod recordings;
    mod reference;
    mod robust_exact;
    mod several_windows;
    mod single_delay;
    mod single_delay_condition;
    mod single_delay_irregular;
    mod single_delay_order;
    mod single_delay_theorem;
    mod single_delay_trajectories;
    mod single_precision;
    mod slow;
    mod theorem;
}

/// What sensors are like: late, rare, lost, wrong, wrapped; and what is asked of an answer.
mod sensors {
    mod ages;
    mod ahead;
    mod coasted;
    mod corrector_missing;
    mod counters;
    mod feedthrough;
    mod gate;
    mod gate_correctors;
    mod init_at;
    mod irregular;
    mod left_out;
    mod losses;
    mod lost;
    mod missing;
    mod rates;
    mod several_rates;
    mod several_rates_kalman;
    mod vouched;
    mod wrap;
    mod wrap_correctors;
    mod wrap_resets;
}

/// What is generated: the same bytes, equal bits in every language, the contract.
mod files {
    mod contract;
    mod endurance;
    mod equal_corpus;
    mod equal_functions;
    mod equal_random;
    mod golden;
    mod interpreter;
}

/// How people meet it: the command line, build scripts, macros, messages.
mod tool {
    mod builder;
    mod cli;
    mod compare;
    mod diagnostics;
    mod doors;
    mod features;
    mod limits;
    mod names;
    mod options;
    mod readme;
    mod replay;
    mod replay_library;
}
