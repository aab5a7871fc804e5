//! The fits as text.

use std::fmt::Write;

use super::Row;
use super::family::Family;
use super::solve::Fit;

/// Three tables in Markdown: the relative residuals at a glance, all residuals, the parameters.
pub fn text(rows: &[Row]) -> String {
    format!("{}\n{}\n{}", overview(rows), residuals(rows), parameters(rows))
}

fn overview(rows: &[Row]) -> String {
    let names = Family::ALL.map(Family::name).join(" | ");
    let mut text = format!("| relative | {names} |\n|---{}|\n", "|--:".repeat(Family::ALL.len()));
    for row in rows {
        let cells = row.fits.iter().map(|fit| format!("{:.1} %", 100.0 * fit.residuals.relative));
        let cells = cells.collect::<Vec<_>>().join(" | ");
        writeln!(text, "| {} | {cells} |", row.material.title).expect("a string takes all text");
    }
    text
}

fn residuals(rows: &[Row]) -> String {
    let mut text =
        "| material | model | cube root | relative | plain |\n|---|---|--:|--:|--:|\n".to_owned();
    for row in rows {
        for fit in &row.fits {
            writeln!(
                text,
                "| {} | {} | {:.4} | {:.1} % | {:.4} |",
                row.material.title,
                fit.family.name(),
                fit.residuals.cube_root,
                100.0 * fit.residuals.relative,
                fit.residuals.plain
            )
            .expect("a string takes all text");
        }
    }
    text
}

fn parameters(rows: &[Row]) -> String {
    let mut text =
        "| material | model | diffuse R, G, B | specular or F₀ R, G, B | shape |\n|---|---|---|---|---|\n"
            .to_owned();
    for row in rows {
        for fit in &row.fits {
            let (diffuse, specular, shape) = columns(fit);
            writeln!(
                text,
                "| {} | {} | {diffuse} | {specular} | {shape} |",
                row.material.title,
                fit.family.name()
            )
            .expect("a string takes all text");
        }
    }
    text
}

fn color(values: &[f64]) -> String {
    values.iter().map(|value| format!("{value:.3}")).collect::<Vec<_>>().join(", ")
}

/// The diffuse colour, the specular colour and the shape.
fn columns(fit: &Fit) -> (String, String, String) {
    let values = fit.values();
    let specular = values.get(3..6).map(color).unwrap_or_default();
    let shape = fit.family.shape().map_or_else(String::new, |shape| {
        let value = values[values.len() - 1];
        let decimals = if value < 10.0 { 3 } else { 0 };
        format!("{} {value:.decimals$}", shape.name)
    });
    (color(&values[..3]), specular, shape)
}
