#include "cli/converted_meshes.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <sstream>
#include <system_error>
#include <utility>

#include "base/file_system.h"
#include "base/printable_text.h"
#include "base/undo_unless_done.h"
#include "cli/mesh_input.h"
#include "cli/read_ahead.h"
#include "mesh/formats/list/format.h"
#include "mesh/formats/registry/export_mesh.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> wanted_formats(const wire::JobStatus& status) {
  const auto found = status.texts().find("formats_to_convert");
  std::vector<std::string> formats;
  std::istringstream words(found == status.texts().end() ? "" : found->second);
  for (std::string format; std::getline(words, format, ',');) formats.push_back(format);
  return formats;
}

/// What a format of several files is told to write in its folder.
fs::path file_in_folder(const fs::path& folder, const Format& format, const fs::path& stem) {
  if (format.layout == FormatLayout::folder) return folder;
  return folder / (stem.string() + std::string(format.written_ending()));
}

/// A folder that is half written has another name.
void write_folder(const MeshSource& source, const Format& format, const fs::path& target,
                  const fs::path& stem) {
  const fs::path growing = target.parent_path() / unique_temp_name(target.filename().string());
  UndoUnlessDone writing([&growing] {
    std::error_code ignored;
    fs::remove_all(growing, ignored);
  });
  make_folders(growing);
  export_mesh(source, format, file_in_folder(growing, format, stem));
  fs::remove_all(target);
  fs::rename(growing, target);
  writing.done();
}

bool is_newer(const fs::path& file, const fs::path& than) {
  return fs::exists(file) && fs::last_write_time(file) >= fs::last_write_time(than);
}

}  // namespace

fs::path converted_file(const fs::path& vtkhdf, const std::string& format) {
  const Format& wanted = find_mesh_format(format, vtkhdf);
  const std::string stem = vtkhdf.stem().string();
  if (wanted.layout != FormatLayout::one_file) return vtkhdf.parent_path() / (stem + "." + format);
  const std::string ending(wanted.written_ending());
  const bool is_told_by_ending = !wanted.endings[0].empty();
  return vtkhdf.parent_path() / (stem + (is_told_by_ending ? "" : "." + format) + ending);
}

void convert_mesh(const wire::JobStatus& status, ProgressStyle progress,
                  std::vector<fs::path>& files) {
  const std::vector<std::string> formats = wanted_formats(status);
  const auto mesh = std::find_if(files.begin(), files.end(), [](const fs::path& file) {
    return file.extension() == ".vtkhdf";
  });
  if (status.state() != "done" || formats.empty() || mesh == files.end()) return;
  const fs::path vtkhdf = *mesh;
  std::unique_ptr<MeshSource> source;
  for (const std::string& format : formats) {
    const fs::path target = converted_file(vtkhdf, format);
    files.push_back(target);
    if (is_newer(target, vtkhdf)) continue;
    if (progress != ProgressStyle::none) {
      std::fprintf(stderr, "export     %s\n", printable(target.filename().string()).c_str());
    }
    if (!source) {
      source = open_mesh({.file = vtkhdf, .name = vtkhdf.string(), .job = "", .store = ""},
                         vtkhdf.parent_path());
      if (source->takes_threads()) source = std::make_unique<ReadAhead>(std::move(source));
    }
    const Format& wanted = find_mesh_format(format, target);
    if (wanted.layout == FormatLayout::one_file) {
      export_mesh(*source, wanted, target);
    } else {
      write_folder(*source, wanted, target, vtkhdf.stem());
    }
  }
}

}  // namespace tetfarm
