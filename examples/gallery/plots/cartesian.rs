//! Plots over two axes.

use std::error::Error;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

use super::figure::{Area, Curve, LETTERS};
use super::style::{DOTS, GRID, GUIDE, INK, Pen, anchored, draw_line, letters, px, stroke};

/// How values become lengths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scale {
    Linear,
    /// Decades: bounds and step of the axis are exponents of ten.
    Log10,
}

/// An axis with its ticks.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    pub(super) label: &'static str,
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) step: f64,
    pub(super) scale: Scale,
}

impl Axis {
    pub(super) const fn new(label: &'static str, from: f64, to: f64, step: f64) -> Self {
        Self { label, from, to, step, scale: Scale::Linear }
    }

    /// Powers of ten between two exponents.
    pub(super) const fn decades(label: &'static str, from: f64, to: f64, step: f64) -> Self {
        Self { label, from, to, step, scale: Scale::Log10 }
    }

    /// Angle from the normal, in degrees.
    pub(super) const fn degrees(label: &'static str) -> Self {
        Self::new(label, 0.0, 90.0, 15.0)
    }

    fn position(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => value,
            // The logarithm of zero lies below every axis, but at a finite place.
            Scale::Log10 => value.max(f64::MIN_POSITIVE).log10(),
        }
    }

    fn ticks(&self) -> impl Iterator<Item = f64> {
        let tick = |index: u8| self.from + self.step * f64::from(index);
        (0..50).map(tick).take_while(|tick| *tick < self.to + 1e-6 * self.step)
    }

    fn tick_label(&self, tick: f64) -> String {
        // As many decimals as the step has.
        let decimals = (0..4).find(|&d| {
            let scaled = self.step * 10_f64.powi(d);
            (scaled - scaled.round()).abs() < 1e-6
        });
        let decimals = usize::try_from(decimals.unwrap_or(4)).unwrap_or(4);
        match self.scale {
            Scale::Linear => format!("{:.decimals$}", tick + 0.0).replace('-', "−"),
            Scale::Log10 => format!("10{}", superscript(&format!("{tick:.0}"))),
        }
    }
}

fn superscript(digits: &str) -> String {
    let raised = |c: char| match c {
        '-' => '⁻',
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        other => other,
    };
    digits.chars().map(raised).collect()
}

/// Something to point out, in the units of the axes.
pub(super) enum Mark {
    /// A dotted line across the plot at `x`, with its name at the height `y`, to the left or right.
    Vertical { x: f64, y: f64, label: String, side: HPos },
    /// A dotted line across the plot at `y`.
    Horizontal { y: f64 },
    /// A dot with its name.
    Point { at: (f64, f64), label: String, side: (HPos, VPos) },
    /// A tinted range of abscissas.
    Columns { from: f64, to: f64, label: &'static str },
}

/// A plot over two axes.
pub(super) struct Plot {
    pub(super) heading: String,
    pub(super) x: Axis,
    pub(super) y: Axis,
    pub(super) curves: Vec<Curve>,
    pub(super) marks: Vec<Mark>,
}

impl Plot {
    pub(super) fn draw(&self, area: &Area<'_>) -> Result<(), Box<dyn Error>> {
        let (width, height) = area.dim_in_pixel();
        let (left, right) = (px(76.0), i32::try_from(width)? - px(18.0));
        let (top, bottom) = (px(30.0), i32::try_from(height)? - px(60.0));
        let frame = Frame { plot: self, left, right, top, bottom };
        let style = anchored(letters(18.0, INK), HPos::Center, VPos::Center);
        let heading = ((left + right) / 2, px(13.0));
        area.draw(&Text::new(self.heading.as_str(), heading, style))?;
        for mark in &self.marks {
            frame.draw_tint(area, mark)?;
        }
        frame.draw_axes(area)?;
        for curve in &self.curves {
            for piece in frame.visible_pieces(&curve.points) {
                draw_line(area, piece, curve.pen, 2.4)?;
            }
        }
        for mark in &self.marks {
            frame.draw_mark(area, mark)?;
        }
        Ok(())
    }
}

/// A plot in its place on the canvas.
struct Frame<'a> {
    plot: &'a Plot,
    left: i32,
    right: i32,
    top: i32,
    bottom: i32,
}

impl Frame<'_> {
    /// Fractions of the axes into the canvas.
    #[allow(clippy::cast_possible_truncation, reason = "the backend counts in integers")]
    fn place(&self, (x, y): (f64, f64)) -> (i32, i32) {
        let across = |from: i32, to: i32, part: f64| {
            (f64::from(from) + f64::from(to - from) * part).round() as i32
        };
        (across(self.left, self.right, x), across(self.bottom, self.top, y))
    }

    /// Values into fractions of the axes.
    fn fraction(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let part =
            |axis: &Axis, value: f64| (axis.position(value) - axis.from) / (axis.to - axis.from);
        (part(&self.plot.x, x), part(&self.plot.y, y))
    }

    fn map(&self, point: (f64, f64)) -> (i32, i32) {
        self.place(self.fraction(point))
    }

    /// The parts of a curve between the lower and the upper end of the plot.
    fn visible_pieces(&self, points: &[(f64, f64)]) -> Vec<Vec<(i32, i32)>> {
        // What rounding puts beyond an end lies on it.
        let inside = |y: f64| (-1e-9..=1.0 + 1e-9).contains(&y);
        let mut pieces = vec![Vec::new()];
        let fractions: Vec<_> = points.iter().map(|&point| self.fraction(point)).collect();
        for (index, &here) in fractions.iter().enumerate() {
            if let Some(&before) = index.checked_sub(1).and_then(|i| fractions.get(i))
                && inside(before.1) != inside(here.1)
            {
                let outer = if inside(here.1) { before.1 } else { here.1 };
                let edge = outer.clamp(0.0, 1.0);
                let part = (edge - before.1) / (here.1 - before.1);
                let crossing = (before.0 + (here.0 - before.0) * part, edge);
                pieces.last_mut().into_iter().for_each(|p| p.push(self.place(crossing)));
                if !inside(here.1) {
                    pieces.push(Vec::new());
                }
            }
            if inside(here.1) {
                pieces.last_mut().into_iter().for_each(|p| p.push(self.place(here)));
            }
        }
        pieces.retain(|piece| piece.len() > 1);
        pieces
    }

    fn draw_axes(&self, area: &Area<'_>) -> Result<(), Box<dyn Error>> {
        let Self { plot, left, right, top, bottom } = *self;
        let text = |horizontal, vertical| anchored(letters(LETTERS, INK), horizontal, vertical);
        for tick in plot.x.ticks() {
            let (x, _) = self.place(((tick - plot.x.from) / (plot.x.to - plot.x.from), 0.0));
            area.draw(&PathElement::new(vec![(x, top), (x, bottom)], stroke(GRID, 1.0)))?;
            let at = (x, bottom + px(17.0));
            area.draw(&Text::new(plot.x.tick_label(tick), at, text(HPos::Center, VPos::Center)))?;
        }
        for tick in plot.y.ticks() {
            let (_, y) = self.place((0.0, (tick - plot.y.from) / (plot.y.to - plot.y.from)));
            area.draw(&PathElement::new(vec![(left, y), (right, y)], stroke(GRID, 1.0)))?;
            let at = (left - px(8.0), y);
            area.draw(&Text::new(plot.y.tick_label(tick), at, text(HPos::Right, VPos::Center)))?;
        }
        // The SVG backend draws rectangles with hairlines.
        let frame = vec![(left, top), (right, top), (right, bottom), (left, bottom), (left, top)];
        area.draw(&PathElement::new(frame, stroke(INK, 1.2)))?;
        let below = ((left + right) / 2, bottom + px(44.0));
        area.draw(&Text::new(plot.x.label, below, text(HPos::Center, VPos::Center)))?;
        let upwards = letters(LETTERS, INK).transform(FontTransform::Rotate270);
        let upwards = anchored(upwards, HPos::Center, VPos::Center);
        area.draw(&Text::new(plot.y.label, (px(15.0), (top + bottom) / 2), upwards))?;
        Ok(())
    }

    fn draw_tint(&self, area: &Area<'_>, mark: &Mark) -> Result<(), Box<dyn Error>> {
        if let Mark::Columns { from, to, label } = mark {
            let (x0, _) = self.map((*from, 0.0));
            let (x1, _) = self.map((*to, 0.0));
            let tint = RGBColor(240, 240, 240).filled();
            area.draw(&Rectangle::new([(x0, self.top), (x1, self.bottom)], tint))?;
            let style = anchored(letters(LETTERS, GUIDE), HPos::Center, VPos::Center);
            let at = ((x0 + x1) / 2, (self.top + self.bottom) / 2);
            area.draw(&Text::new(*label, at, style))?;
        }
        Ok(())
    }

    fn draw_mark(&self, area: &Area<'_>, mark: &Mark) -> Result<(), Box<dyn Error>> {
        let Self { left, right, top, bottom, .. } = *self;
        let pen = Pen { color: GUIDE, dash: DOTS };
        let beside = |side: HPos| match side {
            HPos::Left => px(7.0),
            HPos::Right => px(-7.0),
            HPos::Center => 0,
        };
        match mark {
            Mark::Vertical { x, y, label, side } => {
                let (x, y) = self.map((*x, *y));
                draw_line(area, vec![(x, top), (x, bottom)], pen, 1.4)?;
                let style = anchored(letters(LETTERS, INK), *side, VPos::Center);
                area.draw(&Text::new(label.as_str(), (x + beside(*side), y), style))?;
            }
            Mark::Horizontal { y } => {
                let (_, y) = self.map((0.0, *y));
                draw_line(area, vec![(left, y), (right, y)], pen, 1.4)?;
            }
            Mark::Point { at, label, side } => {
                let (x, y) = self.map(*at);
                area.draw(&Circle::new((x, y), px(4.0), INK.filled()))?;
                let style = anchored(letters(LETTERS, INK), side.0, side.1);
                let lift = match side.1 {
                    VPos::Top => px(8.0),
                    VPos::Center => 0,
                    VPos::Bottom => px(-8.0),
                };
                let place = (x + beside(side.0), y + lift);
                area.draw(&Text::new(label.as_str(), place, style))?;
            }
            Mark::Columns { .. } => {}
        }
        Ok(())
    }
}
