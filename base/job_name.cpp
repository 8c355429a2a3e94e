#include "base/job_name.h"

#include "base/check.h"
#include "base/utf8.h"

namespace tetfarm {
namespace {

constexpr std::size_t longest_file_name = 255;  // NAME_MAX

bool has_control(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); at += code_point_at(text, at).bytes) {
    if (is_control(code_point_at(text, at).value)) return true;
  }
  return false;
}

}  // namespace

std::string problem_with_job_name(std::string_view name) {
  if (name.empty()) return "must not be empty";
  if (name.size() > longest_job_name) {
    return "must have at most " + std::to_string(longest_job_name) + " bytes, not " +
           std::to_string(name.size());
  }
  if (!is_utf8(name)) return "must be valid UTF-8";
  if (has_control(name)) return "must not contain control characters";
  if (name.find('/') != std::string_view::npos) return "must be a plain name, without `/`";
  if (name == "." || name == "..") return "must not be `.` or `..`, which are folders";
  return "";
}

std::string file_name_of_job(std::string_view name, std::string_view ending) {
  TF_CHECK(ending.size() < longest_file_name);
  return std::string(cut_utf8(name, longest_file_name - ending.size())).append(ending);
}

}  // namespace tetfarm
