/// A line of the log is a line: what others wrote, a job's name or a worker's message, can neither
/// begin another one nor steer the terminal that shows it.
#pragma once

#include <spdlog/formatter.h>

#include <memory>

namespace tetfarm {

/// spdlog's usual lines, with what is said made printable (base/printable_text.h). For the logs of
/// the coordinator, the worker and the pool.
std::unique_ptr<spdlog::formatter> one_line_formatter();

}  // namespace tetfarm
