#include "cli/transfer_display.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <utility>

#include "base/clock.h"
#include "cli/terminal.h"
#include "json/progress_json.h"

namespace tetfarm {
namespace {

constexpr std::int64_t between_lines_ms = 5'000;
constexpr std::int64_t between_bars_ms = 100;
constexpr std::int64_t between_json_ms = 1'000;
constexpr std::uint64_t bar_width = 24;

std::int64_t between_lines(ProgressStyle style) {
  return style == ProgressStyle::json ? between_json_ms : between_lines_ms;
}

}  // namespace

std::string bytes_text(std::uint64_t bytes) {
  constexpr std::array<std::pair<double, const char*>, 3> units = {
      {{1e9, "%.2f GB"}, {1e6, "%.1f MB"}, {1e3, "%.0f kB"}}};
  std::array<char, 40> text{};
  for (const auto& [unit, pattern] : units) {
    if (static_cast<double>(bytes) < unit) continue;
    std::snprintf(text.data(), text.size(), pattern, static_cast<double>(bytes) / unit);
    return text.data();
  }
  return std::to_string(bytes) + " B";
}

std::string transfer_text(const std::string& what, std::uint64_t there, std::uint64_t size,
                          std::uint64_t begun_at, std::int64_t passed_ms) {
  const std::string text = what + "  " + bytes_text(there) + " of " + bytes_text(size);
  if (passed_ms <= 0) return text;
  return text + "  " +
         bytes_text((there - begun_at) * 1000 / static_cast<std::uint64_t>(passed_ms)) + "/s";
}

std::string transfer_bar(std::uint64_t there, std::uint64_t size) {
  std::string bar;
  for (std::uint64_t i = 0; i < bar_width; ++i) bar += i * size < there * bar_width ? "█" : "─";
  return bar;
}

TransferDisplay::TransferDisplay(ProgressStyle style)
    : style_(style), is_bar_(style == ProgressStyle::automatic && ::isatty(STDERR_FILENO) == 1) {}

void TransferDisplay::show(const std::string& what, std::uint64_t there, std::uint64_t size) {
  if (style_ == ProgressStyle::none) return;
  const std::int64_t now = steady_ms();
  if (what != what_) {
    what_ = what;
    begun_ms_ = now;
    shown_ms_ = now;
    begun_at_ = there;
  }
  if (now - shown_ms_ < (is_bar_ ? between_bars_ms : between_lines(style_))) return;
  shown_ms_ = now;
  if (style_ == ProgressStyle::json) {
    write_error_line(transfer_json(what, {wall_ms(), there, size}));
    return;
  }
  const std::string text = transfer_text(what, there, size, begun_at_, now - begun_ms_);
  if (!is_bar_) {
    std::fprintf(stderr, "%s\n", text.c_str());
    return;
  }
  std::fprintf(stderr, "\r\033[K%s %s", transfer_bar(there, size).c_str(), text.c_str());
  std::fflush(stderr);
  bar_is_drawn_ = true;
}

void TransferDisplay::end() {
  if (bar_is_drawn_) std::fprintf(stderr, "\r\033[K");
  bar_is_drawn_ = false;
}

}  // namespace tetfarm
