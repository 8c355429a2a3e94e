#include "json/progress_json.h"

#include <nlohmann/json.hpp>

#include "base/check.h"
#include "json/json_line.h"

namespace tetfarm {
namespace {

using Json = nlohmann::ordered_json;

/// What all lines begin with.
Json line_of(const char* type, std::int64_t wall_ms) {
  return {{"type", type}, {"version", progress_version}, {"time_ms", wall_ms}};
}

Json tasks_of(const wire::JobStatus& status) {
  const auto failed = static_cast<std::uint64_t>(status.quarantine_size());
  return {{"done", status.tasks_done()},
          {"total", status.tasks_done() + status.tasks_running() + status.tasks_ready() + failed},
          {"running", status.tasks_running()},
          {"waiting", status.tasks_ready()},
          {"failed", failed}};
}

}  // namespace

std::string progress_json(const wire::JobStatus& status, const JobFigures& figures) {
  TF_CHECK(figures.share >= 0 && figures.share <= 1);
  Json json = line_of("progress", figures.wall_ms);
  json["job"] = status.job();
  json["name"] = status.name();
  json["state"] = status.state();
  json["stage"] = status.stage();
  json["share"] = figures.share;
  json["tasks"] = tasks_of(status);
  json["subdomains"] = status.leaves_made();
  json["subdomains_meshed"] = status.leaves_meshed();
  json["elements"] = status.elements();
  json["estimated_elements"] = status.estimated_elements();
  json["workers"] = figures.workers;
  json["eta_seconds"] = nullptr;
  if (figures.eta_seconds) json["eta_seconds"] = *figures.eta_seconds;
  json["attempts_lost"] = status.attempts_lost();
  return json_line(json);
}

std::string transfer_json(const std::string& what, const TransferFigures& figures) {
  Json json = line_of("transfer", figures.wall_ms);
  json["what"] = what;
  json["there_bytes"] = figures.there_bytes;
  json["size_bytes"] = figures.size_bytes;
  return json_line(json);
}

std::string message_json(std::string_view text, std::int64_t wall_ms) {
  Json json = line_of("message", wall_ms);
  json["text"] = text;
  return json_line(json);
}

std::string end_json(const CommandEnd& end) {
  TF_CHECK(!end.state.empty());
  Json json = line_of("end", end.wall_ms);
  json["state"] = end.state;
  json["job"] = end.job;
  json["exit_code"] = end.exit_code;
  json["message"] = end.message;
  json["help"] = end.help;
  json["files"] = Json::array();
  for (const std::filesystem::path& file : end.files) json["files"].push_back(file.string());
  return json_line(json);
}

}  // namespace tetfarm
