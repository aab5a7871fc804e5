//! A figure: a title and panels side by side, each with its legend below.

use std::error::Error;
use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

use super::cartesian::Plot;
use super::polar::Lobes;
use super::style::{INK, Pen, anchored, draw_line, length, letters, px};
use crate::picture::Picture;

/// Where plots are drawn on.
pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Nominal size in pixels, for letters that are 14 pixels high when shown 800 pixels wide.
const WIDTH: f64 = 960.0;
const TITLE: f64 = 44.0;
const LEGEND_ROW: f64 = 25.0;
pub(super) const LETTERS: f64 = 17.0;

/// One line in a plot.
#[derive(Clone, Debug)]
pub(super) struct Curve {
    pub(super) label: String,
    pub(super) pen: Pen,
    /// Abscissa and ordinate, or angle in degrees and radius.
    pub(super) points: Vec<(f64, f64)>,
}

impl Curve {
    /// The graph of a function between two abscissas.
    pub(super) fn new(
        label: impl Into<String>,
        pen: Pen,
        (from, to): (f64, f64),
        function: impl Fn(f64) -> f64,
    ) -> Self {
        let steps = 1440_u16;
        let point = |step: u16| {
            let x = from + (to - from) * f64::from(step) / f64::from(steps);
            (x, function(x))
        };
        Self { label: label.into(), pen, points: (0..=steps).map(point).collect() }
    }

    /// The point with the largest ordinate.
    pub(super) fn highest(&self) -> (f64, f64) {
        let first = (0.0, f64::NEG_INFINITY);
        self.points.iter().copied().fold(first, |best, p| if p.1 > best.1 { p } else { best })
    }

    /// The point with the least ordinate.
    pub(super) fn lowest(&self) -> (f64, f64) {
        let first = (0.0, f64::INFINITY);
        self.points.iter().copied().fold(first, |best, p| if p.1 < best.1 { p } else { best })
    }
}

/// One coordinate system of a figure.
pub(super) enum Panel {
    Plot(Plot),
    Lobes(Lobes),
}

impl Panel {
    fn curves(&self) -> &[Curve] {
        match self {
            Self::Plot(plot) => &plot.curves,
            Self::Lobes(lobes) => &lobes.curves,
        }
    }

    fn draw(&self, area: &Area<'_>) -> Result<(), Box<dyn Error>> {
        match self {
            Self::Plot(plot) => plot.draw(area),
            Self::Lobes(lobes) => lobes.draw(area),
        }
    }
}

/// A picture of panels side by side.
pub(super) struct Figure {
    /// Name of the file without its ending.
    pub(super) name: String,
    pub(super) section: &'static str,
    pub(super) title: String,
    pub(super) caption: String,
    /// Height of the panels in pixels, without legend.
    pub(super) height: f64,
    /// Columns of a legend. Panels whose curves are called alike share one.
    pub(super) columns: usize,
    pub(super) panels: Vec<Panel>,
}

impl Figure {
    /// Writes the figure into the folder.
    pub(super) fn write(self, folder: &Path) -> Result<Picture, Box<dyn Error>> {
        let legends = self.legends();
        let most = legends.iter().map(Vec::len).max().unwrap_or(0).div_ceil(self.columns);
        #[allow(clippy::cast_precision_loss, reason = "a legend has few rows")]
        let height = TITLE + self.height + most as f64 * LEGEND_ROW + 10.0;
        let mut svg = String::new();
        {
            let size = (length(WIDTH), length(height));
            let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
            area.fill(&WHITE)?;
            let center = (px(WIDTH / 2.0), px(TITLE / 2.0));
            let style = anchored(letters(21.0, INK), HPos::Center, VPos::Center);
            area.draw(&Text::new(self.title.as_str(), center, style))?;
            let (_, body) = area.split_vertically(px(TITLE));
            let (upper, lower) = body.split_vertically(px(self.height));
            let places = upper.split_evenly((1, self.panels.len()));
            for (panel, place) in self.panels.iter().zip(places) {
                panel.draw(&place)?;
            }
            for (legend, place) in legends.iter().zip(lower.split_evenly((1, legends.len()))) {
                draw_legend(legend, self.columns, &place)?;
            }
            area.present()?;
        }
        let file = format!("{}.svg", self.name);
        std::fs::write(folder.join(&file), shown_at(&svg, WIDTH, height))?;
        Ok(Picture { file, title: self.title, caption: self.caption, section: self.section })
    }

    /// The named curves of every panel; those of the first alone if all panels call theirs alike.
    fn legends(&self) -> Vec<Vec<&Curve>> {
        let mut legends: Vec<Vec<&Curve>> = Vec::new();
        for panel in &self.panels {
            legends.push(panel.curves().iter().filter(|curve| !curve.label.is_empty()).collect());
        }
        let alike = |(a, b): (&&Curve, &&Curve)| a.label == b.label && a.pen == b.pen;
        let same = |pair: &[Vec<&Curve>]| {
            pair[0].len() == pair[1].len() && pair[0].iter().zip(&pair[1]).all(alike)
        };
        if legends.windows(2).all(same) {
            legends.truncate(1);
        }
        legends
    }
}

/// The document shown at its nominal size: the canvas stays its coordinate system, the `viewBox`.
fn shown_at(svg: &str, width: f64, height: f64) -> String {
    let canvas = format!("<svg width=\"{}\" height=\"{}\"", length(width), length(height));
    svg.replacen(&canvas, &format!("<svg width=\"{width}\" height=\"{height}\""), 1)
}

/// Draws the names of the curves in columns.
fn draw_legend(curves: &[&Curve], columns: usize, area: &Area<'_>) -> Result<(), Box<dyn Error>> {
    let (width, _) = area.dim_in_pixel();
    let left = px(62.0);
    let column_width = (i32::try_from(width)? - left) / i32::try_from(columns)?;
    for (index, curve) in curves.iter().enumerate() {
        let (row, column) = (i32::try_from(index / columns)?, i32::try_from(index % columns)?);
        let x = left + column * column_width;
        let y = px(LEGEND_ROW / 2.0) + row * px(LEGEND_ROW);
        draw_line(area, vec![(x, y), (x + px(38.0), y)], curve.pen, 2.4)?;
        let style = anchored(letters(LETTERS, INK), HPos::Left, VPos::Center);
        area.draw(&Text::new(curve.label.as_str(), (x + px(46.0), y), style))?;
    }
    Ok(())
}
