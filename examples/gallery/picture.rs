//! What the page shows.

/// One file in the output folder, and what to say about it.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Name in the output folder.
    pub file: String,
    /// Heading.
    pub title: String,
    /// Below the picture: what to see, parameters, and for a series its parts from left to right.
    pub caption: String,
    /// Heading of the group; pictures of one group follow each other.
    pub section: &'static str,
}
