/// What the jobs of all batch systems have in common: their name, and the worker's command.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pool/batch_system.h"

namespace tetfarm {

/// In mebibytes, rounded down.
std::uint64_t whole_mebibytes(std::uint64_t bytes);

/// "tetfarm-POOL-4096M".
std::string job_name_of(const PoolSettings& settings, std::uint64_t bytes);
/// The size that a job's name tells; nothing when it is none of this pool. What follows the name
/// in brackets, an array's index, is passed over.
std::optional<std::uint64_t> bytes_of_job_name(const PoolSettings& settings, std::string_view name);

/// The worker's words, without its tag.
std::vector<std::string> worker_words(const PoolSettings& settings, std::uint64_t bytes);

/// `word` as a shell reads it back: as it is when it is plain, else in single quotes.
std::string quoted(const std::string& word);
/// Of words; the tag, POOL/JOB, last, with `job` as it is, so that the shell fills it in.
std::string shell_line(const std::vector<std::string>& words, const PoolSettings& settings,
                       const std::string& job);

/// The part of a script for sh below the directives: becomes the worker.
std::string script_end(const PoolSettings& settings, std::uint64_t bytes, const std::string& job);

/// "08:00:00".
std::string hours_minutes_seconds(std::int64_t seconds);

/// "12_3" … for an array of `count`, with what stands before and after each index.
std::vector<std::string> array_ids(const std::string& before, std::size_t count,
                                   const std::string& after);

std::vector<std::string> lines_of(const std::string& text);
std::vector<std::string> split(const std::string& line, char separator);
bool is_number(const std::string& text);

}  // namespace tetfarm
