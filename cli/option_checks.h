/// What an option's value must be, told in words that a person would use: CLI11's own ranges print
/// the bounds of a double with all their 309 digits.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <span>
#include <string_view>

namespace tetfarm {

/// "must be a number above 0, not -1": finite numbers only.
CLI::Validator positive_number();
/// "must be a number, 0 or above, not -1": finite numbers only.
CLI::Validator not_negative_number();
/// "must be a number from 0.1 to 3600, not 0".
CLI::Validator number_between(double least, double most);
/// "must be a whole number from 1 to 4096, not 5000".
CLI::Validator whole_number(std::int64_t least, std::int64_t most);
/// "must be a whole number above 0, not 0".
CLI::Validator counting_number();
/// "must be off or a number above 1, at most 100, not 1".
CLI::Validator off_or_number_above(double bound, double most);
/// "must be a frequency such as 1.2GHz, 300MHz or 20000, not 1.2ghz".
CLI::Validator frequency();
/// "as-meshed", which becomes 0, or a whole number from 1 to `most`.
CLI::Validator number_of_parts(std::int64_t most);
/// Any text: whoever reads it later refuses what it does not know, in better words. These are what
/// completion and the manual name.
CLI::Validator suggested(std::span<const std::string_view> words);
/// "must not be empty".
CLI::Validator not_empty();

/// Every positional and every -o of a command and of those below it must not be empty; `-o=out` is
/// `-o out`.
void refuse_empty_paths(CLI::App& app);

}  // namespace tetfarm
