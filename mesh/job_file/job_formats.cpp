#include "mesh/job_file/job_formats.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "base/check.h"

namespace tetfarm {
namespace {

/// Those of the tasks first.
constexpr std::array<std::string_view, 19> formats = {
    "vtkhdf", "lb8.ugrid",  "lb8l.ugrid",          "b8l.ugrid",    "b8.ugrid", "cgns", "pvtu",
    "msh41",  "msh41-text", "msh41-split",         "msh41-ghosts", "msh22",    "su2",  "meshb",
    "tetgen", "openfoam",   "openfoam-decomposed", "comm",         "comm-text"};

bool is_written_by_tasks(const std::string& format) {
  return format == formats[0] || format == formats[1];
}

bool has(const std::vector<std::string>& list, std::string_view format) {
  return std::find(list.begin(), list.end(), format) != list.end();
}

}  // namespace

std::span<const std::string_view> job_output_formats() { return formats; }

std::vector<std::string> formats_of_tasks(const std::vector<std::string>& wanted) {
  std::vector<std::string> written;
  std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(written), is_written_by_tasks);
  if (written.size() < wanted.size() && !has(written, formats[0])) {
    written.emplace_back(formats[0]);
  }
  TF_CHECK(written.empty() == wanted.empty());
  return written;
}

std::vector<std::string> formats_to_convert(const std::vector<std::string>& wanted) {
  std::vector<std::string> converted;
  std::remove_copy_if(wanted.begin(), wanted.end(), std::back_inserter(converted),
                      is_written_by_tasks);
  return converted;
}

}  // namespace tetfarm
