#include "cli/member_life.h"

#include <algorithm>

#include "base/check.h"
#include "base/file_system.h"

namespace tetfarm {
namespace {

constexpr std::int64_t short_life_ms = 2'000;
constexpr std::int64_t first_pause_ms = 50;
constexpr int most_doublings = 5;
constexpr std::size_t kept_log = 4'000;

}  // namespace

void MemberLife::note_death(bool by_itself, std::int64_t now_ms) {
  TF_CHECK(now_ms >= started_ms);
  short_lives = by_itself && now_ms - started_ms < short_life_ms ? short_lives + 1 : 0;
  start_again_ms = now_ms + (first_pause_ms << std::min(short_lives, most_doublings));
}

std::string last_error(const std::filesystem::path& log) {
  if (!size_of_file(log)) return {};
  std::string text = read_file(log);
  if (text.size() > kept_log) text.erase(0, text.size() - kept_log);
  const std::size_t at = text.rfind("error: ");
  if (at == std::string::npos) return {};
  return text.substr(at + 7, text.find('\n', at) - at - 7);
}

}  // namespace tetfarm
