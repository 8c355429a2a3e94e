#include "dashboard/web_pages.h"

#include <array>
#include <utility>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr std::string_view page_without_files =
    "<!doctype html>\n<html lang=\"en\">\n<head><meta "
    "charset=\"utf-8\"><title>Tetfarm</title></head>\n"
    "<body>\n<h1>Tetfarm</h1>\n<p>This program was built without its dashboard.</p>\n"
    "<p>What it would show is at <a href=\"/api/v1\">/api/v1</a> as JSON. Build with "
    "-DTETFARM_DASHBOARD=ON, where npm is installed, to have the pages.</p>\n</body>\n</html>\n";

constexpr std::array<std::pair<std::string_view, std::string_view>, 10> content_types = {{
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".ico", "image/x-icon"},
    {".json", "application/json; charset=utf-8"},
    {".txt", "text/plain; charset=utf-8"},
    {".woff2", "font/woff2"},
    {".webmanifest", "application/manifest+json"},
}};

std::optional<WebFile> file_named(std::string_view name, std::span<const WebFile> files) {
  for (const WebFile& file : files) {
    if (file.name == name) return file;
  }
  return std::nullopt;
}

}  // namespace

std::string_view content_type_of(std::string_view name) {
  for (const auto& entry : content_types) {
    if (name.ends_with(entry.first)) return entry.second;
  }
  return "application/octet-stream";
}

std::optional<WebFile> web_page(std::string_view target, std::span<const WebFile> files) {
  TF_CHECK(target.starts_with("/"));
  const std::string_view name = target.substr(1, target.find('?') - 1);
  const bool is_place = name.find('.', name.rfind('/') + 1) == std::string_view::npos;
  if (files.empty() && (is_place || name == "index.html")) {
    return WebFile{"index.html", page_without_files};
  }
  return file_named(is_place ? "index.html" : name, files);
}

}  // namespace tetfarm
