/// Pages of docs/ as manual pages (man(7)): what is in them of Markdown becomes what roff has for
/// it.
///
/// Known are headings, paragraphs, fenced lines, tables, code, emphasis and links, of which only
/// the words stay. A row of a table becomes an entry with its first cell as its head.
#pragma once

#include <string>
#include <string_view>

namespace tetfarm {

/// What stands below the title of a page, "# Title", or all where it has none.
/// Cost: O(size).
std::string roff_of_markdown(std::string_view markdown);

/// The part of a page below a heading, "## Heading", up to the next one of that kind; without the
/// heading. @pre there is one.
std::string_view markdown_section(std::string_view markdown, std::string_view heading);

}  // namespace tetfarm
