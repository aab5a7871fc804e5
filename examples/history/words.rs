//! What is said of each step: the sections of `docs/history.md` whose headings begin with a year.

const PAGE: &str = include_str!("../../docs/history.md");

/// A section of the page.
pub struct Chapter {
    /// A year, and who.
    pub heading: &'static str,
    /// All that is below, as one line.
    pub text: String,
}

/// The sections of the steps, of which there must be so many.
///
/// # Errors
/// If there are not.
pub fn chapters(count: usize) -> Result<Vec<Chapter>, String> {
    let sections = PAGE.split("\n## ").skip(1).filter_map(|section| section.split_once('\n'));
    let of_a_year = |heading: &str| heading.starts_with(|letter: char| letter.is_ascii_digit());
    let chapters: Vec<Chapter> = sections
        .filter(|(heading, _)| of_a_year(heading))
        .map(|(heading, text)| Chapter { heading, text: plain(text) })
        .collect();
    if chapters.len() == count {
        Ok(chapters)
    } else {
        Err(format!("docs/history.md has {} sections with a year, not {count}", chapters.len()))
    }
}

/// The words without marks of code and emphasis.
fn plain(markdown: &str) -> String {
    let words: Vec<&str> = markdown.split_whitespace().collect();
    words.join(" ").replace(['`', '*'], "")
}
