/// The files of the dashboard's page, which are part of the program, and which of them a path asks
/// for. A program that was built without them has one small page that says so.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tetfarm {

struct WebFile {
  std::string_view name;  ///< "index.html", "fonts/text.woff2"
  std::string_view bytes;
};

/// Those that were built in; empty: none were (cmake/web_pages.cmake makes it).
std::span<const WebFile> built_in_web_files();

/// "text/html; charset=utf-8"; of an ending that is not known, bytes.
std::string_view content_type_of(std::string_view name);

/// What GET `target` shows, which is nothing below /api: the file of that name, and index.html for
/// every path that has no ending, as those are places within the page. Nothing for a file that is
/// not there.
std::optional<WebFile> web_page(std::string_view target, std::span<const WebFile> files);

}  // namespace tetfarm
