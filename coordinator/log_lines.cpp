#include "coordinator/log_lines.h"

#include <spdlog/pattern_formatter.h>

#include <string>

#include "base/printable_text.h"

namespace tetfarm {
namespace {

class OneLineFormatter : public spdlog::formatter {
 public:
  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& line) override {
    const std::string said =
        printable(std::string_view(message.payload.data(), message.payload.size()));
    spdlog::details::log_msg harmless = message;
    harmless.payload = said;
    usual_.format(harmless, line);
  }
  std::unique_ptr<spdlog::formatter> clone() const override {
    return std::make_unique<OneLineFormatter>();
  }

 private:
  spdlog::pattern_formatter usual_;
};

}  // namespace

std::unique_ptr<spdlog::formatter> one_line_formatter() {
  return std::make_unique<OneLineFormatter>();
}

}  // namespace tetfarm
