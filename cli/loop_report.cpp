#include "cli/loop_report.h"

#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/printable_text.h"
#include "json/json_line.h"
#include "json/reply_values.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

void tell_loop_json(const wire::JobStatus& status, const std::vector<fs::path>& files,
                    double seconds) {
  nlohmann::ordered_json json = {
      {"type", "loop"},
      {"job", status.job()},
      {"name", status.name()},
      {"state", status.state()},
      {"cycles", static_cast<std::uint64_t>(number_of(status, "cycles"))},
      {"vertices", static_cast<std::uint64_t>(number_of(status, "vertices"))},
      {"triangles", static_cast<std::uint64_t>(number_of(status, "triangles"))},
      {"solver_seconds", number_of(status, "task_solve_seconds")},
      {"adapt_seconds", number_of(status, "task_adapt_seconds")},
      {"attempts_lost", status.attempts_lost()},
      {"seconds", seconds},
      {"digest", text_of(status, "digest")},
      {"files", nlohmann::ordered_json::array()}};
  for (const fs::path& file : files) json["files"].push_back(file.string());
  std::printf("%s\n", json_line(json).c_str());
}

void tell_loop(const wire::JobStatus& status, const std::vector<fs::path>& files, double seconds) {
  std::printf("%s: %.0f cycles, %.0f vertices, %.0f triangles, %.1f s\n",
              printable(status.name()).c_str(), number_of(status, "cycles"),
              number_of(status, "vertices"), number_of(status, "triangles"), seconds);
  std::printf("solver          %.2f s, adaptation %.2f s\n",
              number_of(status, "task_solve_seconds"), number_of(status, "task_adapt_seconds"));
  std::printf("digest          %s\n", text_of(status, "digest").c_str());
  if (files.empty()) return;
  std::printf("meshes, solutions and cycles.csv lie in %s\n",
              printable(files.front().parent_path().string()).c_str());
}

}  // namespace

bool is_of_loop(const wire::JobStatus& status) {
  return status.state() == "done" && number_of(status, "cycles") > 0;
}

void report_loop(const wire::JobStatus& status, const std::vector<fs::path>& files, double seconds,
                 bool json) {
  if (json) {
    tell_loop_json(status, files, seconds);
  } else {
    tell_loop(status, files, seconds);
  }
}

}  // namespace tetfarm
