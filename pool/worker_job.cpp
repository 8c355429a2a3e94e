#include "pool/worker_job.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <sstream>

#include "base/check.h"

namespace tetfarm {

std::uint64_t whole_mebibytes(std::uint64_t bytes) { return bytes >> 20U; }

std::string job_name_of(const PoolSettings& settings, std::uint64_t bytes) {
  return "tetfarm-" + settings.name + "-" + std::to_string(whole_mebibytes(bytes)) + "M";
}

std::optional<std::uint64_t> bytes_of_job_name(const PoolSettings& settings,
                                               std::string_view name) {
  const std::string prefix = "tetfarm-" + settings.name + "-";
  name = name.substr(0, name.find('['));
  if (!name.starts_with(prefix) || !name.ends_with('M')) return std::nullopt;
  std::uint64_t size = 0;
  const char* end = name.data() + name.size() - 1;
  const auto [stopped, error] = std::from_chars(name.data() + prefix.size(), end, size);
  if (error != std::errc{} || stopped != end || size >> 44U != 0) return std::nullopt;
  return size << 20U;
}

std::vector<std::string> worker_words(const PoolSettings& settings, std::uint64_t bytes) {
  const auto size = [](std::uint64_t job) {
    return std::to_string(whole_mebibytes(task_bytes(job))) + "MB";
  };
  std::vector<std::string> words = {settings.program, "worker", "--connect", settings.coordinator};
  if (settings.store.empty()) {
    words.emplace_back("--no-shared-store");
  } else {
    words.insert(words.end(), {"--store", settings.store});
  }
  if (!settings.cache.empty()) words.insert(words.end(), {"--cache", settings.cache});
  if (!settings.key.empty()) words.insert(words.end(), {"--key", settings.key});
  if (!settings.coordinator_key.empty()) {
    words.insert(words.end(), {"--coordinator-key", settings.coordinator_key});
  }
  if (settings.runs_solvers) words.emplace_back("--solvers");
  words.insert(words.end(),
               {"--memory", size(bytes), "--pool-memory", size(settings.most_bytes), "--walltime",
                std::to_string(settings.walltime_s), "--grace", std::to_string(settings.grace_s)});
  return words;
}

std::string quoted(const std::string& word) {
  constexpr const char* plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char letter : word) {
    if (letter == '\'') {
      text += "'\\''";
    } else {
      text += letter;
    }
  }
  return text + "'";
}

std::string shell_line(const std::vector<std::string>& words, const PoolSettings& settings,
                       const std::string& job) {
  std::string line;
  for (const std::string& word : words) line += quoted(word) + " ";
  return line + "--tag \"" + settings.name + "/" + job + "\"";
}

std::string script_end(const PoolSettings& settings, std::uint64_t bytes, const std::string& job) {
  std::string text = "# exec: signals have to reach the worker, not a shell that waits for it.\n";
  return text + "exec " + shell_line(worker_words(settings, bytes), settings, job) + "\n";
}

std::string hours_minutes_seconds(std::int64_t seconds) {
  TF_CHECK(seconds >= 0);
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%02lld:%02lld:%02lld",
                static_cast<long long>(seconds / 3600), static_cast<long long>(seconds / 60 % 60),
                static_cast<long long>(seconds % 60));
  return text.data();
}

std::vector<std::string> array_ids(const std::string& before, std::size_t count,
                                   const std::string& after) {
  TF_CHECK(!before.empty());
  std::vector<std::string> ids;
  for (std::size_t i = 1; i <= count; ++i) ids.push_back(before + std::to_string(i) + after);
  return ids;
}

std::vector<std::string> lines_of(const std::string& text) { return split(text, '\n'); }

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(line);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

bool is_number(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(),
                                      [](char letter) { return letter >= '0' && letter <= '9'; });
}

}  // namespace tetfarm
