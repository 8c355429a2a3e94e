#include "mesh/job_file/job_formats.h"

#include <algorithm>
#include <iterator>

#include "mesh/formats/list/known_formats.h"

namespace tetfarm {
namespace {

/// What all others are converted from.
constexpr std::string_view converted_from = "vtkhdf";

bool is_written_by_tasks(const std::string& name) {
  const auto known = known_formats();
  return std::any_of(known.begin(), known.end(), [&](const KnownFormat& format) {
    return format.name == name && format.is_of_tasks;
  });
}

bool has(const std::vector<std::string>& list, std::string_view format) {
  return std::find(list.begin(), list.end(), format) != list.end();
}

}  // namespace

std::span<const std::string_view> job_output_formats() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> written;
    for (const KnownFormat& format : known_formats()) {
      if (format.writes_meshes) written.push_back(format.name);
    }
    return written;
  }();
  return names;
}

std::vector<std::string> formats_of_tasks(const std::vector<std::string>& wanted) {
  std::vector<std::string> written;
  std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(written), is_written_by_tasks);
  if (written.size() < wanted.size() && !has(written, converted_from)) {
    written.emplace_back(converted_from);
  }
  return written;
}

std::vector<std::string> formats_to_convert(const std::vector<std::string>& wanted) {
  std::vector<std::string> converted;
  std::remove_copy_if(wanted.begin(), wanted.end(), std::back_inserter(converted),
                      is_written_by_tasks);
  return converted;
}

}  // namespace tetfarm
