//! What is known of a quantity at some times, with straight lines between them.

use std::io::Read;

use super::super::clock::TimeUnit;
use super::super::columns::time_of_references;
use super::super::interface::fold;
use super::super::recording::{Recording, RecordingError};
use super::super::selection::{Selection, Source};

/// A reference over time.
#[derive(Clone, Debug, Default)]
pub struct Track {
    /// Rising, s.
    pub times: Vec<f64>,
    /// NaN where it is not known.
    pub values: Vec<f64>,
}

impl Track {
    /// Reads references from a recording of their own, a track for each column; its times, found as
    /// those of any recording and in this unit where it is given, have to rise.
    ///
    /// # Errors
    /// When the recording is wrong, lacks a column, or its time does not rise.
    pub fn read<R: Read>(
        mut recording: Recording<R>,
        columns: &[&str],
        unit: Option<TimeUnit>,
    ) -> Result<Vec<Self>, RecordingError> {
        let mut selection = Selection::default();
        let header = recording.header().clone();
        let clock = time_of_references(&header, unit);
        let name = clock.column.clone();
        let time = selection.place(clock);
        let columns = columns.iter().map(|column| selection.place(Source::named(column, &header.columns)));
        let columns: Vec<usize> = columns.collect();
        let mut cells = vec![0.0; selection.apply(&mut recording)?];
        let mut tracks = vec![Self::default(); columns.len()];
        let mut before = f64::NEG_INFINITY;
        while recording.next_row(&mut cells)? {
            let now = cells[time];
            if now.is_nan() || now <= before {
                let message = format!("the time does not rise: {now} s behind {before} s");
                return Err(RecordingError { help: None, ..recording.complaint(&name, message, "") });
            }
            before = now;
            for (track, place) in tracks.iter_mut().zip(&columns) {
                track.times.push(now);
                track.values.push(cells[*place]);
            }
        }
        Ok(tracks)
    }

    /// First and last time.
    pub fn span(&self) -> Option<(f64, f64)> {
        self.times.first().copied().zip(self.times.last().copied())
    }

    /// The value at a time; NaN outside, and beside what is not known. Whole turns are no difference, so that a line
    /// between two values goes the shorter way round. `from` is where the search begins and where it ended: times that
    /// rise from call to call are found in a few steps.
    pub fn at(&self, time: f64, turns: &[f64], from: &mut usize) -> f64 {
        while *from > 0 && self.times[*from] > time {
            *from -= 1;
        }
        while self.times.get(*from + 1).is_some_and(|next| *next <= time) {
            *from += 1;
        }
        let here = self.times.get(*from).copied().unwrap_or(f64::NAN);
        if here == time {
            return self.values[*from];
        }
        match self.times.get(*from + 1) {
            Some(next) if here < time => {
                let share = (time - here) / (next - here);
                self.values[*from] + share * fold(self.values[*from + 1] - self.values[*from], turns)
            }
            _ => f64::NAN,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(time: f64) -> f64 {
        let track = Track { times: vec![0.0, 1.0, 3.0, 4.0], values: vec![0.0, 3.0, -3.0, f64::NAN] };
        track.at(time, &[8.0], &mut 2)
    }

    #[test]
    fn values_run_straight_and_the_shorter_way_round() {
        assert_eq!([at(0.0), at(0.5), at(1.0), at(3.0)], [0.0, 1.5, 3.0, -3.0]);
        assert_eq!(at(2.0), 4.0, "half way from 3 to -3 by a turn of 8");
    }

    #[test]
    fn nothing_is_known_outside_and_beside_gaps() {
        assert!([-0.1, 3.5, 4.0, 4.1].iter().all(|time| at(*time).is_nan()));
        assert!(Track::default().at(0.0, &[], &mut 0).is_nan());
    }
}
