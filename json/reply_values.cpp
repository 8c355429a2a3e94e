#include "json/reply_values.h"

#include <map>

#include "base/check.h"
#include "base/clock.h"
#include "mesh/core/subdomain.h"

namespace tetfarm {

double number_of(const wire::JobStatus& status, const std::string& name) {
  const auto found = status.numbers().find(name);
  return found == status.numbers().end() ? 0 : found->second;
}

std::string text_of(const wire::JobStatus& status, const std::string& name) {
  const auto found = status.texts().find(name);
  return found == status.texts().end() ? "" : found->second;
}

std::array<double, 3> place_of(const wire::JobStatus& status, const std::string& what) {
  return {number_of(status, what + "_x"), number_of(status, what + "_y"),
          number_of(status, what + "_z")};
}

std::string region_prefix(int region) {
  TF_CHECK(region >= 1);
  return "region_" + std::to_string(region) + "_";
}

std::vector<std::pair<std::string, std::string>> said_of_subdomains(const wire::JobStatus& status,
                                                                    std::string_view mark) {
  std::map<std::uint64_t, std::string> by_heap;
  for (const auto& [name, text] : status.texts()) {
    if (name.starts_with(mark)) by_heap[std::stoull(name.substr(mark.size()))] = text;
  }
  std::vector<std::pair<std::string, std::string>> said;
  for (const auto& [heap, reason] : by_heap) said.emplace_back(TreePath{heap}.text(), reason);
  return said;
}

std::string worker_name(std::uint64_t worker) {
  return worker == 0 ? "" : "worker-" + std::to_string(worker);
}

std::string subdomain_name(std::uint64_t path) { return path == 0 ? "" : TreePath{path}.text(); }

double seconds_of(const wire::AttemptLine& attempt) {
  const std::int64_t end = attempt.ended_ms() == 0 ? wall_ms() : attempt.ended_ms();
  return static_cast<double>(end - attempt.started_ms()) / 1000;
}

}  // namespace tetfarm
