#include "cli/typed_names.h"

#include "base/error.h"

namespace tetfarm {
namespace {

/// Whether `text` began with `start`, which is taken away then.
bool take_away(std::string& text, const std::string& start) {
  if (!text.starts_with(start)) return false;
  text.erase(0, start.size());
  return true;
}

}  // namespace

void name_as_typed(wire::JobStatus& end, const RunOptions& options, const JobInput& input) {
  std::string message = end.message();
  if (end.state() != "failed") return;
  if (!take_away(message, "inspect: ") && !take_away(message, "remesh: ")) return;
  if (end.exit_code() == static_cast<int>(ExitCode::bad_geometry)) {
    take_away(message, input.job.surface + ": ");
    message = input.path + ": " + message;
  } else if (!options.max_memory.empty() && take_away(message, "[decompose] max_memory: ")) {
    message = "--max-memory " + options.max_memory + ": " + message;
  } else if (!options.layers.empty() && take_away(message, "[[layers]]")) {
    message = "--layers" + message;
  } else if (!options.pml.empty() && take_away(message, "[[pml]]")) {
    message = "--pml" + message;
  }
  end.set_message(message);
}

}  // namespace tetfarm
