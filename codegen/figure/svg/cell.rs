//! What stands in a cell: curves with their names, a marked instant, a shaded band.

#![allow(clippy::cast_precision_loss, reason = "counts of things in a figure are small")]

use std::fmt::{self, Formatter};

use super::axis::Range;
use super::frame::Frame;
use super::pen::Pen;
use super::text::{Px, spread, text};
use super::{Cell, Curve, DOT_DISTANCE, LABEL_DISTANCE, MUTED, Marker, Point, Role};

impl Cell {
    /// The range of everything that is visible; errors and bands are seen against zero.
    pub(super) fn y_range(&self, x: Range) -> Range {
        let curves = self.curves.iter().flat_map(|curve| &curve.points);
        let values = curves.filter(|point| x.contains(point.0)).map(|point| point.1);
        let band = self.band.into_iter().flat_map(|bound| [-bound, bound]);
        let errors = self.curves.iter().any(|curve| curve.role.is_error());
        let zero = errors.then_some(0.0);
        Range::of(values.chain(band).chain(zero)).unwrap_or(Range { low: 0.0, high: 1.0 })
    }

    pub(super) fn draw(&self, f: &mut Formatter<'_>, frame: &Frame) -> fmt::Result {
        frame.draw_grid(f)?;
        let (x, y, width, height) = (Px(frame.left), Px(frame.top), Px(frame.width), Px(frame.height));
        // A nested document clips what it holds, without an id that could clash with another figure.
        writeln!(
            f,
            r#"<svg x="{x}" y="{y}" width="{width}" height="{height}" fill="none" stroke-linecap="round" stroke-linejoin="round">"#
        )?;
        if let Some(bound) = self.band.filter(|bound| bound.is_finite()) {
            let (top, bottom) = (frame.y_at(bound.abs()), frame.y_at(-bound.abs()));
            let (y, height) = (Px(top), Px(bottom - top));
            writeln!(f, r##"<rect y="{y}" width="{width}" height="{height}" fill="#000000" fill-opacity="0.06"/>"##)?;
        }
        let mut curves: Vec<&Curve> = self.curves.iter().collect();
        curves.sort_by_key(|curve| curve.role.layer());
        for curve in &curves {
            curve.draw(f, frame)?;
        }
        if let Some(marker) = &self.marker {
            marker.draw(f, frame)?;
        }
        writeln!(f, "</svg>")?;
        if curves.iter().all(|curve| curve.end(frame).is_none()) {
            let attributes = r#" text-anchor="middle""#;
            text(f, frame.left + frame.width / 2.0, frame.top + frame.height / 2.0, attributes, MUTED, "no data")?;
        }
        self.draw_labels(f, frame)
    }

    /// Writes the name of each curve at its end, in its colour.
    fn draw_labels(&self, f: &mut Formatter<'_>, frame: &Frame) -> fmt::Result {
        let named = self.curves.iter().filter(|curve| !curve.label.is_empty());
        let mut ends: Vec<(f64, &Curve)> = named.filter_map(|curve| Some((curve.end(frame)?, curve))).collect();
        ends.sort_by(|a, b| a.0.total_cmp(&b.0));
        let wanted: Vec<f64> = ends.iter().map(|end| end.0).collect();
        for (y, (_, curve)) in spread(&wanted, LABEL_DISTANCE, frame.height).into_iter().zip(ends) {
            text(f, frame.right() + 6.0, frame.top + y + 4.0, "", curve.role.pen().text, &curve.label)?;
        }
        Ok(())
    }
}

impl Curve {
    /// The points in the frame, with one neighbour on either side for the line to come from and go to.
    fn visible(&self, x: Range) -> &[Point] {
        let first = self.points.partition_point(|point| point.0 < x.low).saturating_sub(1);
        let end = self.points.partition_point(|point| point.0 <= x.high) + 1;
        self.points.get(first..end.min(self.points.len())).unwrap_or_default()
    }

    /// The height in the frame at which the curve ends.
    fn end(&self, frame: &Frame) -> Option<f64> {
        let visible = self.visible(frame.x.range).iter().rev();
        let last = visible.copied().find(|point| frame.x.range.contains(point.0) && point.1.is_finite())?;
        Some(frame.y_at(last.1))
    }

    fn draw(&self, f: &mut Formatter<'_>, frame: &Frame) -> fmt::Result {
        let points = self.visible(frame.x.range);
        let pen = self.role.pen();
        let (dash, Pen { colour, width, opacity, .. }) = (pen.dash(), pen);
        let dots = self.role == Role::Measured && points.len() as f64 * DOT_DISTANCE < frame.width;
        let width = Px(if dots { width + 0.5 } else { width });
        write!(f, r#"<path stroke="{colour}" stroke-width="{width}"{dash}"#)?;
        if opacity < 1.0 {
            write!(f, r#" stroke-opacity="{opacity}""#)?;
        }
        f.write_str(r#" d=""#)?;
        let mut pen_down = false;
        for (k, &(t, y)) in points.iter().enumerate() {
            let drawable = t.is_finite() && y.is_finite();
            let alone = !points.get(k + 1).is_some_and(|next| next.0.is_finite() && next.1.is_finite());
            if drawable {
                let command = if pen_down { 'L' } else { 'M' };
                write!(f, "{command}{} {}", Px(frame.x_at(t)), Px(frame.y_at(y)))?;
                if dots || (!pen_down && alone) {
                    f.write_str("h0")?;
                }
            }
            pen_down = drawable && !dots;
        }
        writeln!(f, r#""/>"#)
    }
}

impl Marker {
    /// Draws the line and writes the name beside it, where there is more room.
    fn draw(&self, f: &mut Formatter<'_>, frame: &Frame) -> fmt::Result {
        if !frame.x.range.contains(self.x) {
            return Ok(());
        }
        let at = frame.x_at(self.x);
        let (x, height) = (Px(at), Px(frame.height));
        writeln!(f, r#"<path stroke="{MUTED}" stroke-dasharray="2 3" stroke-linecap="butt" d="M{x} 0V{height}"/>"#)?;
        let (offset, anchor) = if at < frame.width / 2.0 { (5.0, "start") } else { (-5.0, "end") };
        let halo = format!(r##" text-anchor="{anchor}" stroke="#ffffff" stroke-width="3" paint-order="stroke""##);
        text(f, at + offset, 11.0, &halo, MUTED, &self.label)
    }
}
