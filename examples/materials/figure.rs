//! A figure: panels above each other, curves with their names at the end.

use std::error::Error;
use std::fs;
use std::ops::Range;
use std::path::Path;

use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::colors::{GREY, GRID, INK, rainbow};

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// All lengths are in pixels.
const WIDTH: f64 = 840.0;
const TITLE_HEIGHT: f64 = 84.0;
const PANEL_HEIGHT: f64 = 300.0;
/// Room for the names of the curves.
const RIGHT_MARGIN: f64 = 150.0;
const LEFT_MARGIN: f64 = 16.0;
const TOP_MARGIN: f64 = 14.0;
const BOTTOM_MARGIN: f64 = 12.0;
const X_LABELS: f64 = 44.0;
const Y_LABELS: f64 = 66.0;
/// Between the names of two curves.
const LINE_HEIGHT: f64 = 17.0;

/// Coordinates per pixel. The backend rounds coordinates to integers; on a canvas this many times
/// as large, shown at its nominal size, curves are smooth.
const SCALE: f64 = 8.0;

/// Pixels into coordinates of the canvas.
#[allow(clippy::cast_possible_truncation, reason = "the backend counts in integers")]
fn px(pixels: f64) -> i32 {
    (pixels * SCALE).round() as i32
}

fn length(pixels: f64) -> u32 {
    px(pixels).unsigned_abs()
}

/// Letters of the given height; the backend divides the size of a font by 1.24.
fn letters(size: f64, color: RGBColor) -> TextStyle<'static> {
    ("sans-serif", size * 1.24 * SCALE).into_font().color(&color)
}

fn stroke(color: impl Color, width: f64) -> ShapeStyle {
    color.stroke_width(length(width))
}

/// A line through points, with its name at the right end.
pub struct Curve {
    pub points: Vec<(f64, f64)>,
    pub color: RGBColor,
    pub name: String,
    pub dashed: bool,
    /// Whether each point is marked, because it was measured.
    pub marked: bool,
    /// Whether the points are joined.
    pub joined: bool,
}

impl Curve {
    pub fn new(name: impl Into<String>, color: RGBColor, points: Vec<(f64, f64)>) -> Self {
        Self { points, color, name: name.into(), dashed: false, marked: false, joined: true }
    }

    fn pen(&self) -> ShapeStyle {
        stroke(self.color, 1.8)
    }

    pub fn dashed(self) -> Self {
        Self { dashed: true, ..self }
    }

    pub fn marked(self) -> Self {
        Self { marked: true, ..self }
    }

    /// Marks without a line.
    pub fn dots(self) -> Self {
        Self { joined: false, ..self.marked() }
    }
}

/// Axes with curves.
#[derive(Default)]
pub struct Panel {
    /// Above the upper left corner.
    pub heading: String,
    pub x_name: &'static str,
    pub y_name: &'static str,
    pub x: Range<f64>,
    pub y: Range<f64>,
    /// Whether y is a decimal logarithm.
    pub decades: bool,
    /// Whether x is a wavelength, and the visible ones are shown.
    pub wavelengths: bool,
    /// Whether the names are a list, because the curves end in one point.
    pub list: bool,
    pub curves: Vec<Curve>,
}

/// What goes into one file.
pub struct Figure {
    pub name: String,
    pub title: String,
    pub subtitle: String,
    /// A colour to show beside the title.
    pub swatch: Option<RGBColor>,
    pub panels: Vec<Panel>,
}

impl Figure {
    pub fn draw(&self, folder: &Path) -> Result<(), Box<dyn Error>> {
        let height = TITLE_HEIGHT + PANEL_HEIGHT * self.panels.len() as f64;
        let mut svg = String::new();
        let size = (length(WIDTH), length(height));
        {
            let root = SVGBackend::with_string(&mut svg, size).into_drawing_area();
            root.fill(&WHITE)?;
            let (head, body) = root.split_vertically(px(TITLE_HEIGHT));
            self.draw_head(&head)?;
            for (panel, area) in self.panels.iter().zip(body.split_evenly((self.panels.len(), 1))) {
                panel.draw(&area)?;
            }
            root.present()?;
        }
        let canvas = format!("<svg width=\"{}\" height=\"{}\"", size.0, size.1);
        let shown = format!("<svg width=\"{WIDTH}\" height=\"{height}\"");
        let path = folder.join(format!("{}.svg", self.name));
        Ok(fs::write(path, svg.replacen(&canvas, &shown, 1))?)
    }

    fn draw_head(&self, area: &Area<'_>) -> Result<(), Box<dyn Error>> {
        let title = Text::new(self.title.clone(), (px(24.0), px(14.0)), letters(18.0, INK));
        area.draw(&title)?;
        for (line, text) in wrap(&self.subtitle, 125).into_iter().enumerate() {
            let corner = (px(24.0), px(44.0 + 16.0 * line as f64));
            area.draw(&Text::new(text, corner, letters(11.0, GREY)))?;
        }
        if let Some(color) = self.swatch {
            let corners = [(px(760.0), px(12.0)), (px(816.0), px(40.0))];
            area.draw(&Rectangle::new(corners, color.filled()))?;
            area.draw(&Rectangle::new(corners, stroke(GREY, 1.0)))?;
        }
        Ok(())
    }
}

impl Panel {
    fn draw(&self, area: &Area<'_>) -> Result<(), Box<dyn Error>> {
        let mut chart = ChartBuilder::on(area)
            .margin_left(length(LEFT_MARGIN))
            .margin_right(length(RIGHT_MARGIN))
            .margin_top(length(TOP_MARGIN))
            .margin_bottom(length(BOTTOM_MARGIN))
            .x_label_area_size(length(X_LABELS))
            .y_label_area_size(length(Y_LABELS))
            .build_cartesian_2d(self.x.clone(), self.y.clone())?;
        let y_label = |y: &f64| self.y_label(*y);
        chart
            .configure_mesh()
            .x_desc(self.x_name)
            .y_desc(self.y_name)
            .y_label_formatter(&y_label)
            .x_label_formatter(&|x| minus(&format!("{x:.0}")))
            .x_labels(9)
            .y_labels(self.y_labels())
            .light_line_style(TRANSPARENT)
            .bold_line_style(stroke(GRID, 1.0))
            .axis_style(stroke(INK, 1.0))
            .set_all_tick_mark_size(length(5.0))
            .label_style(letters(11.0, INK))
            .axis_desc_style(letters(12.0, INK))
            .draw()?;
        let corner = (px(LEFT_MARGIN + Y_LABELS), 0);
        area.draw(&Text::new(self.heading.clone(), corner, letters(12.0, INK)))?;
        if self.wavelengths {
            self.draw_rainbow(area)?;
        }
        for curve in &self.curves {
            draw_curve(&mut chart, curve)?;
        }
        if self.list { self.draw_list(&chart) } else { self.draw_names(&chart) }
    }

    fn y_label(&self, y: f64) -> String {
        if self.decades {
            return format!("10{}", superscript(&format!("{y:.0}")));
        }
        let decimals = decimals(&self.y);
        minus(&format!("{y:.decimals$}"))
    }

    /// How many labels there may be: one for each decade.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "few decades")]
    fn y_labels(&self) -> usize {
        if self.decades { (self.y.end - self.y.start).round() as usize + 1 } else { 6 }
    }

    /// The unit of y in pixels.
    fn unit(&self) -> f64 {
        (PANEL_HEIGHT - TOP_MARGIN - BOTTOM_MARGIN - X_LABELS) / (self.y.end - self.y.start)
    }

    /// A strip of the visible colours above the upper edge.
    fn draw_rainbow(&self, area: &Area<'_>) -> Result<(), Box<dyn Error>> {
        let start = LEFT_MARGIN + Y_LABELS;
        let nanometre = (WIDTH - RIGHT_MARGIN - start) / (self.x.end - self.x.start);
        for (wavelength, color) in rainbow().filter(|(wavelength, _)| self.x.contains(wavelength)) {
            let x = |wavelength: f64| {
                let inside = wavelength.clamp(self.x.start, self.x.end);
                px(start + (inside - self.x.start) * nanometre)
            };
            // Into the next colour, which covers it, so that no seam shows.
            let corners = [(x(wavelength - 2.5), px(3.0)), (x(wavelength + 4.0), px(9.0))];
            area.draw(&Rectangle::new(corners, color.filled()))?;
        }
        Ok(())
    }

    /// The names beside the ends of their curves, moved apart where they would overlap.
    fn draw_names(&self, chart: &Chart<'_, '_>) -> Result<(), Box<dyn Error>> {
        let mut names: Vec<(&Curve, (f64, f64))> = self
            .curves
            .iter()
            .filter(|curve| !curve.name.is_empty())
            .filter_map(|curve| curve.points.last().map(|end| (curve, *end)))
            .collect();
        names.sort_by(|(_, a), (_, b)| b.1.total_cmp(&a.1));
        // Heights in pixels from the top, each below the one before and all above the x axis.
        let height = |y: f64| (self.y.end - y) * self.unit();
        let mut heights: Vec<f64> = names.iter().map(|(_, (_, y))| height(*y)).collect();
        let mut bottom = height(self.y.start) - 4.0;
        for height in heights.iter_mut().rev() {
            *height = height.min(bottom);
            bottom = *height - LINE_HEIGHT;
        }
        let mut top = 0.0;
        for height in &mut heights {
            *height = height.max(top);
            top = *height + LINE_HEIGHT;
        }
        for ((curve, end), place) in names.into_iter().zip(heights) {
            let style = letters(12.0, curve.color).pos(Pos::new(HPos::Left, VPos::Center));
            let offset = (px(8.0), px(place - height(end.1)));
            let name = EmptyElement::at(end) + Text::new(curve.name.clone(), offset, style);
            chart.plotting_area().draw(&name)?;
        }
        Ok(())
    }

    /// The names as a list beside the upper end, each with a piece of its line.
    fn draw_list(&self, chart: &Chart<'_, '_>) -> Result<(), Box<dyn Error>> {
        let named = self.curves.iter().filter(|curve| !curve.name.is_empty());
        for (row, curve) in named.enumerate() {
            let corner = (self.x.end, self.y.end - (1.0 + row as f64) * LINE_HEIGHT / self.unit());
            let (left, right) = ((px(12.0), 0), (px(36.0), 0));
            let style = letters(12.0, curve.color).pos(Pos::new(HPos::Left, VPos::Center));
            let text = Text::new(curve.name.clone(), (px(42.0), 0), style);
            let area = chart.plotting_area();
            if !curve.joined {
                let mark = Circle::new((px(24.0), 0), length(2.6), curve.color.filled());
                area.draw(&(EmptyElement::at(corner) + mark + text))?;
            } else if curve.dashed {
                let points = [left, right].into_iter();
                let line =
                    DashedPathElement::new(points, length(DASH.0), length(DASH.1), curve.pen());
                area.draw(&(EmptyElement::at(corner) + line + text))?;
            } else {
                let line = PathElement::new([left, right], curve.pen());
                area.draw(&(EmptyElement::at(corner) + line + text))?;
            }
        }
        Ok(())
    }
}

/// Length of a dash and of a gap.
const DASH: (f64, f64) = (6.0, 4.0);

fn draw_curve(chart: &mut Chart<'_, '_>, curve: &Curve) -> Result<(), Box<dyn Error>> {
    let points = || curve.points.iter().copied();
    if curve.dashed {
        let (dash, gap) = (length(DASH.0), length(DASH.1));
        chart.draw_series(DashedLineSeries::new(points(), dash, gap, curve.pen()))?;
    } else if curve.joined {
        chart.draw_series(LineSeries::new(points(), curve.pen()))?;
    }
    if curve.marked {
        let mark = |point| Circle::new(point, length(2.6), curve.color.filled());
        chart.draw_series(points().map(mark))?;
    }
    Ok(())
}

/// As many decimals as six labels in the range need.
fn decimals(range: &Range<f64>) -> usize {
    let step = (range.end - range.start) / 6.0;
    [1.0, 0.1, 0.01].iter().filter(|unit| step < **unit).count()
}

/// A minus sign instead of a hyphen, and none before zero.
fn minus(text: &str) -> String {
    let zero = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
    text.replace('-', if zero { "" } else { "−" })
}

fn superscript(digits: &str) -> String {
    let raised = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => {
            digit.to_digit(10).and_then(|value| char::from_u32(0x2070 + value)).unwrap_or(digit)
        }
    };
    digits.chars().map(raised).collect()
}

/// At most two lines of words.
fn wrap(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let full = lines.last().is_some_and(|line| line.chars().count() + word.len() > width);
        if full && lines.len() == 2 {
            lines[1].push_str(" …");
            break;
        }
        if full {
            lines.push(String::new());
        }
        if let Some(line) = lines.last_mut() {
            line.push_str(if line.is_empty() { "" } else { " " });
            line.push_str(word);
        }
    }
    lines
}
