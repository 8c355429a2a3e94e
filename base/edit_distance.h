/// "Did you mean": the known word nearest to one that is not known.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace tetfarm {

/// The fewest insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`.
/// Cost: O(|a| |b|).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The first of the nearest `words`; empty when none is within a third of its length (two at
/// least).
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> words);

}  // namespace tetfarm
