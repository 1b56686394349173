//! Thins a long curve to what a plot can show, while the curve is still arriving.
//!
//! In go the points of a recording, one at a time; out comes a curve that looks the same when it is
//! drawn `columns` pixels wide. Memory is constant: time is cut into buckets of equal width, each
//! keeps only its lowest and its highest point, and when the time range outgrows the buckets they
//! become twice as wide and neighbours merge. From the second point on, the time range holds between
//! `columns` and `2 * columns` buckets, so that a bucket is never wider than a pixel column.

use super::svg::Point;

/// The lowest and the highest point of every pixel column seen so far.
#[derive(Clone, Debug)]
pub struct Thin {
    columns: u32,
    /// Time per bucket; zero until two different times are known.
    width: f64,
    first: Option<Point>,
    last: Option<Point>,
    /// By increasing index; buckets without any point are absent.
    buckets: Vec<Bucket>,
}

/// The points of one stretch of time.
#[derive(Clone, Copy, Debug)]
struct Bucket {
    index: u32,
    /// In the order in which they occurred; twice the same point when there is only one, and a NaN
    /// value when every sample of the bucket is missing.
    earlier: Point,
    later: Point,
}

impl Thin {
    /// A curve to be drawn `columns` pixels wide (at least one).
    pub fn new(columns: usize) -> Self {
        let columns = u32::try_from(columns).map_or(MOST_COLUMNS, |n| n.clamp(1, MOST_COLUMNS));
        Self { columns, width: 0.0, first: None, last: None, buckets: Vec::new() }
    }

    /// Takes the next point; times must not decrease.
    ///
    /// A value that is not finite is a missing sample. It leaves a gap in the line unless a sample in
    /// the same pixel column fills it. A point at a time that is not finite is dropped.
    pub fn push(&mut self, t: f64, y: f64) {
        if !t.is_finite() {
            return;
        }
        let point = (t, if y.is_finite() { y } else { f64::NAN });
        let start = self.first.get_or_insert(point).0;
        self.last = Some(point);

        let elapsed = t - start;
        if self.width == 0.0 && elapsed > 0.0 {
            self.width = (elapsed / f64::from(self.columns)).max(f64::MIN_POSITIVE);
        }
        while elapsed / self.width >= f64::from(2 * self.columns) {
            self.widen();
        }
        self.put(Bucket { index: index(elapsed, self.width), earlier: point, later: point });
    }

    /// The thinned curve in the order of time, with a NaN value where the line is to be interrupted;
    /// the first and the last point are the ones that were pushed.
    pub fn points(&self) -> Vec<Point> {
        let mut points = Vec::with_capacity(2 * self.buckets.len() + 2);
        points.extend(self.first);
        for bucket in &self.buckets {
            points.extend([bucket.earlier, bucket.later]);
        }
        points.extend(self.last);
        points.dedup_by(|a, b| same(*a, *b));
        points
    }

    /// Adds a bucket at the end, merging it with the last one when that has the same index.
    fn put(&mut self, bucket: Bucket) {
        match self.buckets.last_mut() {
            Some(last) if bucket.index <= last.index => last.merge(bucket),
            _ => self.buckets.push(bucket),
        }
    }

    /// Makes the buckets twice as wide.
    fn widen(&mut self) {
        self.width *= 2.0;
        self.buckets.dedup_by(|later, kept| {
            let merges = later.index / 2 == kept.index / 2;
            if merges {
                kept.merge(*later);
            }
            merges
        });
        for bucket in &mut self.buckets {
            bucket.index /= 2;
        }
    }
}

/// Wider than any plot, and far from overflow when doubled.
const MOST_COLUMNS: u32 = 1 << 20;

impl Bucket {
    /// Takes in the points of a bucket that follows this one.
    fn merge(&mut self, later: Self) {
        if self.earlier.1.is_nan() {
            (self.earlier, self.later) = (later.earlier, later.later);
        } else if !later.earlier.1.is_nan() {
            let points = [self.earlier, self.later, later.earlier, later.later];
            let lowest = best(&points, |a, b| a < b);
            let highest = best(&points, |a, b| a > b);
            self.earlier = points[lowest.min(highest)];
            self.later = points[lowest.max(highest)];
        }
    }
}

/// The position of the first point whose value is better than all before it.
fn best(points: &[Point; 4], better: impl Fn(f64, f64) -> bool) -> usize {
    (1..points.len()).fold(0, |kept, i| if better(points[i].1, points[kept].1) { i } else { kept })
}

/// The bucket of a time; 0 as long as the width is unknown, or when time runs backwards.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the quotient is below 2 * MOST_COLUMNS; the cast maps NaN and negative numbers to 0"
)]
fn index(elapsed: f64, width: f64) -> u32 {
    (elapsed / width) as u32
}

/// Equality under which NaN equals NaN.
#[allow(clippy::float_cmp, reason = "asks whether it is the very same point")]
fn same(a: Point, b: Point) -> bool {
    a.0 == b.0 && (a.1 == b.1 || (a.1.is_nan() && b.1.is_nan()))
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "points are kept, not computed")]
mod tests {
    use super::*;

    fn thin(columns: usize, points: impl IntoIterator<Item = Point>) -> Vec<Point> {
        let mut thin = Thin::new(columns);
        for (t, y) in points {
            thin.push(t, y);
        }
        thin.points()
    }

    #[test]
    fn a_short_curve_is_kept_whole() {
        let curve: Vec<Point> = (0..50).map(|k| (f64::from(k), f64::from(k * k % 7))).collect();
        assert_eq!(thin(100, curve.clone()), curve);
    }

    #[test]
    fn nothing_gives_nothing() {
        assert!(thin(100, []).is_empty());
        assert!(thin(100, [(f64::NAN, 1.0), (f64::INFINITY, 2.0)]).is_empty());
    }

    #[test]
    fn memory_is_constant_and_spikes_survive() {
        let mut thin = Thin::new(300);
        for k in 0..1_000_000 {
            let y = if k == 123_457 { 9.0 } else { f64::from(k % 10) / 10.0 };
            thin.push(f64::from(k) * 1e-3, y);
            assert!(thin.buckets.len() <= 600);
        }
        let points = thin.points();
        assert!(thin.buckets.len() >= 300 && points.len() <= 1202);
        assert!(points.contains(&(123_457.0 * 1e-3, 9.0)));
        assert_eq!(points[0], (0.0, 0.0));
        assert_eq!(points[points.len() - 1], (999_999.0 * 1e-3, 0.9));
        assert!(points.is_sorted_by_key(|p| p.0));
    }

    #[test]
    fn every_bucket_keeps_its_extremes() {
        let curve: Vec<Point> = (0..10_000).map(|k| (f64::from(k), f64::from(k * 7919 % 10_007))).collect();
        let mut kept = Thin::new(40);
        for &(t, y) in &curve {
            kept.push(t, y);
        }
        for bucket in &kept.buckets {
            let inside = curve.iter().filter(|p| index(p.0, kept.width) == bucket.index).map(|p| p.1);
            let (low, high) = (bucket.earlier.1.min(bucket.later.1), bucket.earlier.1.max(bucket.later.1));
            assert_eq!(inside.clone().fold(f64::INFINITY, f64::min), low);
            assert_eq!(inside.fold(f64::NEG_INFINITY, f64::max), high);
        }
    }

    #[test]
    fn a_long_gap_stays_and_a_gap_narrower_than_a_pixel_goes() {
        let gap = |from: i32, to: i32| {
            thin(100, (0..100_000).map(|k| (f64::from(k), if (from..to).contains(&k) { f64::NAN } else { 1.0 })))
        };
        assert!(gap(40_000, 60_000).iter().any(|p| p.1.is_nan()));
        assert!(gap(40_001, 40_002).iter().all(|p| p.1.is_finite()));
    }

    #[test]
    fn the_first_and_the_last_point_are_exact_even_when_missing() {
        let points = thin(10, (0..1000).map(|k| (f64::from(k), if k % 999 == 0 { f64::NAN } else { 1.0 })));
        assert!(points[0].0 == 0.0 && points[0].1.is_nan());
        assert!(points[points.len() - 1].0 == 999.0 && points[points.len() - 1].1.is_nan());
    }

    #[test]
    fn a_late_burst_is_resolved_after_a_pause() {
        let burst = (0..1000).map(|k| (1000.0 + f64::from(k), f64::from(k % 2)));
        assert!(thin(200, std::iter::once((0.0, 0.0)).chain(burst)).len() > 200);
    }

    #[test]
    fn extreme_times_end_and_do_not_panic() {
        let times = [-1e308, -1e308, 0.0, 5e-324, 1.0, 1e300, 1e308, 1.0];
        assert!(!thin(100, times.map(|t| (t, f64::INFINITY))).is_empty());
        assert!(!thin(0, [(0.0, 1.0), (5e-324, 2.0), (1e308, 3.0)]).is_empty());
    }
}
