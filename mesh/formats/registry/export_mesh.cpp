#include "mesh/formats/registry/export_mesh.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <system_error>
#include <vector>

#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"
#include "base/undo_unless_done.h"
#include "mesh/formats/list/all_formats.h"
#include "mesh/formats/list/format_by_ending.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

bool is_written(const Format& format) { return format.write_mesh != nullptr; }

void write_single_file(const MeshSource& source, const MeshOutline& outline, const Format& format,
                       const fs::path& output) {
  const fs::path growing = output.parent_path() / (unique_temp_name(output.filename().string()) +
                                                   std::string(format.written_ending()));
  UndoUnlessDone writing([&growing] {
    std::error_code ignored;
    fs::remove(growing, ignored);
  });
  format.write_mesh(source, outline, growing);
  publish_by_rename(growing, output);
  writing.done();
}

std::string all_names() {
  std::string names;
  for (const Format& format : written_formats()) {
    names += (names.empty() ? "" : ", ") + std::string(format.name);
  }
  return names;
}

}  // namespace

std::span<const Format> written_formats() {
  static const std::vector<Format> formats = [] {
    std::vector<Format> written;
    std::ranges::copy_if(all_formats, std::back_inserter(written), is_written);
    return written;
  }();
  return formats;
}

std::string written_formats_text() {
  std::string text;
  for (const Format& format : written_formats()) {
    std::array<char, 120> line;
    std::snprintf(line.data(), line.size(), "  %-20s%-12s %s\n", std::string(format.name).c_str(),
                  std::string(format.endings[0]).c_str(), std::string(format.what).c_str());
    text += line.data();
  }
  return text;
}

const Format& find_mesh_format(std::string_view name, const fs::path& output) {
  const std::span<const Format> formats = written_formats();
  if (name.empty()) {
    const std::string file = output.filename().string();
    if (const Format* format = format_by_ending(formats, file, is_written)) return *format;
  } else {
    const auto found = std::ranges::find(formats, name, &Format::name);
    if (found != formats.end()) return *found;
  }
  throw UsageError("unknown format; the formats are " + all_names(),
                   name.empty() ? output.string() : "--format " + std::string(name));
}

void require_name_of_a_file(const Format& format, const fs::path& output) {
  if (format.layout == FormatLayout::folder || !fs::is_directory(output)) return;
  throw UsageError("this is a folder; " + std::string(format.name) + " needs the name of a file",
                   output.string());
}

ExportCounts export_mesh(const MeshSource& source, const Format& format, const fs::path& output) {
  TF_CHECK(is_written(format));
  require_name_of_a_file(format, output);
  const MeshOutline outline = outline_of(source);
  TF_CHECK(outline.parts.size() == source.size());
  if (format.layout == FormatLayout::one_file) {
    write_single_file(source, outline, format, output);
  } else {
    format.write_mesh(source, outline, output);
  }
  if (format.write_beside != nullptr) format.write_beside(source, outline, output);
  return {outline.nodes, outline.elements(), outline.parts.size()};
}

}  // namespace tetfarm
