//! Tables for terminals and for Markdown.

/// Rows under a heading, all of the same number of cells.
pub(crate) struct Table<const N: usize> {
    rows: Vec<[String; N]>,
}

impl<const N: usize> Table<N> {
    /// A table without rows.
    pub(crate) fn new(heading: [&str; N]) -> Self {
        Self {
            rows: vec![heading.map(str::to_owned)],
        }
    }

    /// Adds a row at the end.
    pub(crate) fn push(&mut self, row: [String; N]) {
        self.rows.push(row);
    }

    /// The table with its columns aligned, numbers to the right.
    pub(crate) fn text(&self, markdown: bool) -> String {
        let widths: [usize; N] = std::array::from_fn(|column| {
            let cells = self.rows.iter().map(|row| row[column].chars().count());
            cells.max().unwrap_or(0).max(3)
        });
        let right: [bool; N] = std::array::from_fn(|column| self.is_numeric(column));
        let mut text = String::new();
        for (index, row) in self.rows.iter().enumerate() {
            let cells: [String; N] = std::array::from_fn(|c| pad(&row[c], widths[c], right[c]));
            push_line(&mut text, &cells, markdown);
            if index == 0 {
                let rule: [String; N] =
                    std::array::from_fn(|c| rule(widths[c], right[c] && markdown));
                push_line(&mut text, &rule, markdown);
            }
        }
        text
    }

    fn is_numeric(&self, column: usize) -> bool {
        let cells = self.rows[1..].iter().map(|row| row[column].as_str());
        let mut written = cells.filter(|cell| !cell.is_empty()).peekable();
        let number =
            |cell: &str| cell.starts_with(|c: char| c.is_ascii_digit() || "+-−".contains(c));
        written.peek().is_some() && written.all(number)
    }
}

fn pad(cell: &str, width: usize, right: bool) -> String {
    let space = " ".repeat(width - cell.chars().count());
    if right {
        space + cell
    } else {
        cell.to_owned() + &space
    }
}

fn rule(width: usize, right: bool) -> String {
    if right {
        "-".repeat(width - 1) + ":"
    } else {
        "-".repeat(width)
    }
}

fn push_line<const N: usize>(text: &mut String, cells: &[String; N], markdown: bool) {
    if markdown {
        text.push_str("| ");
        text.push_str(&cells.join(" | "));
        text.push_str(" |\n");
    } else {
        text.push_str(cells.join("  ").trim_end());
        text.push('\n');
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_align() {
        let mut table = Table::new(["name", "Hz"]);
        table.push(["α".to_owned(), "1.5".to_owned()]);
        table.push(["beta".to_owned(), "10.5".to_owned()]);
        assert_eq!(
            table.text(true),
            "| name |   Hz |\n| ---- | ---: |\n| α    |  1.5 |\n| beta | 10.5 |\n"
        );
        assert_eq!(
            table.text(false),
            "name    Hz\n----  ----\nα      1.5\nbeta  10.5\n"
        );
    }
}
