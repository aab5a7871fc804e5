//! A figure: panels above each other, curves with their names at the end.

use std::error::Error;
use std::ops::Range;
use std::path::Path;

use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::colors::rainbow;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

const WIDTH: u32 = 840;
const TITLE_HEIGHT: u32 = 84;
const PANEL_HEIGHT: u32 = 300;
/// Room for the names of the curves.
const RIGHT_MARGIN: u32 = 150;
/// Between the names of two curves, in pixels.
const LINE_HEIGHT: f64 = 17.0;
const FONT: &str = "sans-serif";

/// A line through points, with its name at the right end.
pub struct Curve {
    pub points: Vec<(f64, f64)>,
    pub color: RGBColor,
    pub name: String,
    pub dashed: bool,
    /// Whether each point is marked, because it was measured.
    pub marked: bool,
}

impl Curve {
    pub fn new(name: impl Into<String>, color: RGBColor, points: Vec<(f64, f64)>) -> Self {
        Self { points, color, name: name.into(), dashed: false, marked: false }
    }

    pub fn dashed(self) -> Self {
        Self { dashed: true, ..self }
    }

    pub fn marked(self) -> Self {
        Self { marked: true, ..self }
    }
}

/// Axes with curves.
pub struct Panel {
    pub x_name: &'static str,
    pub y_name: &'static str,
    pub x: Range<f64>,
    pub y: Range<f64>,
    /// Whether x is a wavelength, and the visible ones are shown.
    pub wavelengths: bool,
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
        let path = folder.join(format!("{}.svg", self.name));
        let panels = self.panels.len();
        let height = TITLE_HEIGHT + PANEL_HEIGHT * u32::try_from(panels)?;
        let root = SVGBackend::new(&path, (WIDTH, height)).into_drawing_area();
        root.fill(&WHITE)?;
        let (head, body) = root.split_vertically(TITLE_HEIGHT);
        self.draw_head(&head)?;
        for (panel, area) in self.panels.iter().zip(body.split_evenly((panels, 1))) {
            panel.draw(&area)?;
        }
        root.present()?;
        Ok(())
    }

    fn draw_head(&self, area: &Area<'_>) -> Result<(), Box<dyn Error>> {
        area.draw(&Text::new(self.title.clone(), (24, 14), (FONT, 22)))?;
        for (line, text) in (0..).zip(wrap(&self.subtitle, 118)) {
            let style = (FONT, 12).into_font().color(&BLACK.mix(0.7));
            area.draw(&Text::new(text, (24, 44 + 16 * line), style))?;
        }
        if let Some(color) = self.swatch {
            let corners = [(760, 12), (816, 40)];
            area.draw(&Rectangle::new(corners, color.filled()))?;
            area.draw(&Rectangle::new(corners, BLACK.mix(0.5)))?;
        }
        Ok(())
    }
}

impl Panel {
    fn draw(&self, area: &Area<'_>) -> Result<(), Box<dyn Error>> {
        let mut chart = ChartBuilder::on(area)
            .margin_left(16)
            .margin_right(RIGHT_MARGIN)
            .margin_top(8)
            .margin_bottom(12)
            .x_label_area_size(44)
            .y_label_area_size(62)
            .build_cartesian_2d(self.x.clone(), self.y.clone())?;
        if self.wavelengths {
            self.draw_rainbow(&mut chart)?;
        }
        let decimals = decimals(&self.y);
        chart
            .configure_mesh()
            .x_desc(self.x_name)
            .y_desc(self.y_name)
            .y_label_formatter(&|y| minus(format!("{y:.decimals$}")))
            .x_label_formatter(&|x| format!("{x:.0}"))
            .x_labels(9)
            .y_labels(6)
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.12))
            .axis_style(BLACK.mix(0.8))
            .label_style((FONT, 13))
            .axis_desc_style((FONT, 14))
            .draw()?;
        for curve in &self.curves {
            draw_curve(&mut chart, curve)?;
        }
        self.draw_names(&mut chart)
    }

    /// A strip of the visible colours along the lower edge.
    fn draw_rainbow(&self, chart: &mut Chart<'_, '_>) -> Result<(), Box<dyn Error>> {
        let top = self.y.start + 0.03 * (self.y.end - self.y.start);
        let inside = |x: f64| x.clamp(self.x.start, self.x.end);
        chart.draw_series(rainbow().map(|(wavelength, color)| {
            let (left, right) = (inside(wavelength - 2.5), inside(wavelength + 2.5));
            Rectangle::new([(left, self.y.start), (right, top)], color.filled())
        }))?;
        Ok(())
    }

    /// The names beside the ends of their curves, moved apart where they would overlap.
    fn draw_names(&self, chart: &mut Chart<'_, '_>) -> Result<(), Box<dyn Error>> {
        let pixel = f64::from(PANEL_HEIGHT - 64) / (self.y.end - self.y.start);
        let mut names: Vec<(&Curve, (f64, f64))> = self
            .curves
            .iter()
            .filter_map(|curve| curve.points.last().map(|end| (curve, *end)))
            .filter(|(curve, _)| !curve.name.is_empty())
            .collect();
        names.sort_by(|(_, a), (_, b)| b.1.total_cmp(&a.1));
        let mut shifts = vec![0.0; names.len()];
        // Twice as often as there are names, each pair that is too close is moved apart.
        for _ in 0..2 * names.len() {
            for lower in 1..names.len() {
                let gap = pixel * (names[lower - 1].1.1 - names[lower].1.1) + shifts[lower]
                    - shifts[lower - 1];
                let missing = (LINE_HEIGHT - gap).max(0.0);
                shifts[lower - 1] -= 0.5 * missing;
                shifts[lower] += 0.5 * missing;
            }
        }
        for ((curve, end), shift) in names.into_iter().zip(shifts) {
            let style =
                (FONT, 14).into_font().color(&curve.color).pos(Pos::new(HPos::Left, VPos::Center));
            #[allow(clippy::cast_possible_truncation, reason = "pixels")]
            let offset = (8, shift as i32);
            chart
                .plotting_area()
                .draw(&(EmptyElement::at(end) + Text::new(curve.name.clone(), offset, style)))?;
        }
        Ok(())
    }
}

fn draw_curve(chart: &mut Chart<'_, '_>, curve: &Curve) -> Result<(), Box<dyn Error>> {
    let style = curve.color.stroke_width(2);
    let points = || curve.points.iter().copied();
    if curve.dashed {
        chart.draw_series(DashedLineSeries::new(points(), 6, 4, style))?;
    } else {
        chart.draw_series(LineSeries::new(points(), style))?;
    }
    if curve.marked {
        chart.draw_series(points().map(|point| Circle::new(point, 3, curve.color.filled())))?;
    }
    Ok(())
}

/// As many decimals as six labels in the range need.
fn decimals(range: &Range<f64>) -> usize {
    let step = (range.end - range.start) / 6.0;
    [1.0, 0.1, 0.01].iter().filter(|unit| step < **unit).count()
}

/// A minus sign instead of a hyphen, and none before zero.
fn minus(text: String) -> String {
    let zero = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
    text.replace('-', if zero { "" } else { "−" })
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
