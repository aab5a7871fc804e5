//! The page that shows the pictures.

use std::fmt::Write;

use crate::picture::Picture;

const HEAD: &str = r#"<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<style>
body { margin: 2rem auto; padding: 0 1.5rem; max-width: 96rem; color: #222; background: #fff;
  font: 16px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.8rem; margin: 0 0 .5rem; }
h2 { font-size: 1.3rem; margin: 2.5rem 0 1rem; border-bottom: 1px solid #ccc; }
nav a { margin-right: 1rem; }
.figures { display: flex; flex-wrap: wrap; gap: 1.5rem; align-items: flex-start; }
figure { margin: 0; width: min-content; min-width: min(16rem, 100%); }
img { display: block; max-width: min(93rem, calc(100vw - 3rem)); height: auto; }
figcaption { font-size: .875rem; margin-top: .4rem; }
figcaption b { display: block; font-size: 1rem; }
</style>
"#;

/// A page to which another leads.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// Its file, from the page with the link.
    pub page: &'static str,
    /// What is on it.
    pub title: &'static str,
    /// The command that makes it.
    pub made_by: &'static str,
}

/// The page of the gallery, from those of the folders in it.
#[allow(dead_code, reason = "the gallery does not lead to itself")]
pub const GALLERY: Link = Link {
    page: "../index.html",
    title: "Gallery",
    made_by: "cargo run --release --example gallery",
};

/// A page of all pictures; those of one section follow each other, sections keep their order.
pub fn page(title: &str, introduction: &str, links: &[Link], pictures: &[Picture]) -> String {
    let mut sections: Vec<&str> = Vec::new();
    for picture in pictures {
        if !sections.contains(&picture.section) {
            sections.push(picture.section);
        }
    }
    let mut html = String::from(HEAD);
    let mut line = |text: std::fmt::Arguments| {
        // Writing to a string cannot fail.
        let _ = html.write_fmt(text);
        html.push('\n');
    };
    let title = escape(title);
    line(format_args!("<title>brdf: {title}</title>\n</head>\n<body>\n<h1>{title}</h1>"));
    line(format_args!("<p>{}</p>", escape(introduction)));
    for Link { page, title, made_by } in links {
        let (page, title, made_by) = (escape(page), escape(title), escape(made_by));
        line(format_args!("<p><a href=\"{page}\">{title}</a>, made by <code>{made_by}</code></p>"));
    }
    line(format_args!("<nav>"));
    for (number, section) in sections.iter().enumerate() {
        line(format_args!("<a href=\"#section-{number}\">{}</a>", escape(section)));
    }
    line(format_args!("</nav>"));
    for (number, section) in sections.iter().enumerate() {
        line(format_args!("<h2 id=\"section-{number}\">{}</h2>", escape(section)));
        line(format_args!("<div class=\"figures\">"));
        for picture in pictures.iter().filter(|picture| picture.section == *section) {
            let (file, title) = (escape(&picture.file), escape(&picture.title));
            line(format_args!("<figure><img loading=\"lazy\" src=\"{file}\" alt=\"{title}\">"));
            let caption = escape(&picture.caption);
            line(format_args!("<figcaption><b>{title}</b> {caption}</figcaption></figure>"));
        }
        line(format_args!("</div>"));
    }
    html + "</body>\n</html>\n"
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
