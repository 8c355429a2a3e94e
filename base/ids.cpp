#include "base/ids.h"

#include <sys/random.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <string_view>

#include "base/check.h"
#include "base/error.h"
#include "base/hex_text.h"

namespace tetfarm {
namespace {

constexpr std::string_view job_prefix = "job-";

}  // namespace

std::string job_name(JobId id) { return std::string(job_prefix) + std::to_string(id.value); }

JobId parse_job_name(const std::string& text) {
  if (!text.starts_with(job_prefix)) return {};
  JobId id;
  const char* first = text.data() + job_prefix.size();
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(first, last, id.value);
  if (error != std::errc() || end != last || job_name(id) != text) return {};
  return id;
}

std::string random_hex(std::size_t bytes) {
  std::array<char, 64> raw{};
  TF_CHECK(bytes <= raw.size());
  const ssize_t got = getrandom(raw.data(), bytes, 0);
  if (got != static_cast<ssize_t>(bytes)) throw IoError("cannot read", "getrandom", errno);
  return hex_of_bytes({raw.data(), bytes});
}

}  // namespace tetfarm
