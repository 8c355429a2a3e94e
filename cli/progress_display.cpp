#include "cli/progress_display.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "base/clock.h"

namespace tetfarm {
namespace {

constexpr std::int64_t between_lines_ms = 5'000;
constexpr int bar_width = 24;

template <class... Arguments>
std::string format(const char* pattern, Arguments... arguments) {
  char text[160];
  std::snprintf(text, sizeof text, pattern, arguments...);
  return text;
}

double share_done(const wire::JobStatus& status) {
  if (status.stage() == "mesh" && status.estimated_elements() > 0) {
    return std::min(1.0, static_cast<double>(status.elements()) / status.estimated_elements());
  }
  const bool is_mending =
      status.stage() == "order" || status.stage() == "extract" || status.stage() == "cosmetic";
  if (is_mending || status.stage() == "number" || status.stage() == "write" ||
      status.stage() == "assemble")
    return 1;
  return 0;
}

}  // namespace

std::string short_count(double count) {
  if (count < 1e4) return format("%.0f", count);
  if (count < 1e6) return format("%.1fk", count / 1e3);
  if (count < 1e9) return format("%.1fM", count / 1e6);
  return format("%.2fG", count / 1e9);
}

std::string clock_text(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole < 3600) return format("%02ld:%02ld", whole / 60, whole % 60);
  return format("%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string progress_text(const wire::JobStatus& status, double tets_per_second) {
  std::string text = format("%-10s", status.stage().c_str());
  if (status.leaves_made() > 0) {
    text += format(" %u/%u sub-domains", status.leaves_meshed(), status.leaves_made());
  }
  if (status.leaves_mended() > 0) text += format("  %u mended", status.leaves_mended());
  if (status.elements() > 0) {
    text += "  " + short_count(static_cast<double>(status.elements())) + " tets";
  }
  if (tets_per_second > 0) text += "  " + short_count(tets_per_second) + " tets/s";
  const double left = status.estimated_elements() - static_cast<double>(status.elements());
  if (status.stage() == "mesh" && tets_per_second > 0 && left > 0) {
    text += "  eta " + clock_text(left / tets_per_second);
  }
  if (status.attempts_lost() > 0) {
    text += format("  %llu lost", static_cast<unsigned long long>(status.attempts_lost()));
  }
  return text;
}

ProgressDisplay::ProgressDisplay(ProgressStyle style)
    : style_(style), is_bar_(style == ProgressStyle::automatic && ::isatty(STDERR_FILENO) == 1) {}

void ProgressDisplay::show(const wire::JobStatus& status) {
  if (style_ == ProgressStyle::none) return;
  const std::int64_t now = steady_ms();
  if (first_ms_ == 0) {
    first_ms_ = now;
    first_elements_ = status.elements();
  }
  const double seconds = static_cast<double>(now - first_ms_) / 1000;
  const double made = static_cast<double>(status.elements() - first_elements_);
  const std::string text = progress_text(status, seconds > 0 ? std::max(0.0, made / seconds) : 0);
  if (is_bar_) return draw_bar(status, text);
  if (status.stage() == last_stage_ && now - last_line_ms_ < between_lines_ms) return;
  last_stage_ = status.stage();
  last_line_ms_ = now;
  std::fprintf(stderr, "%s\n", text.c_str());
}

void ProgressDisplay::draw_bar(const wire::JobStatus& status, const std::string& text) {
  const int full = static_cast<int>(share_done(status) * bar_width);
  std::string bar;
  for (int i = 0; i < bar_width; ++i) bar += i < full ? "█" : "─";
  std::fprintf(stderr, "\r\033[K%s %s", bar.c_str(), text.c_str());
  std::fflush(stderr);
  bar_is_drawn_ = true;
}

void ProgressDisplay::end() {
  if (bar_is_drawn_) std::fprintf(stderr, "\r\033[K");
  bar_is_drawn_ = false;
}

}  // namespace tetfarm
