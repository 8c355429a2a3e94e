/// What a patch of the boundary is to a solver: a job file says it, and the formats of solvers that
/// have a place for it write it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace tetfarm {

enum class PatchType : std::uint8_t {
  unspecified,
  wall,      ///< the flow sticks to it
  slip,      ///< the flow slides along it
  symmetry,  ///< what lies behind it is a mirror image
  farfield,  ///< undisturbed flow
  inflow,
  outflow,
  pec,        ///< a perfect electric conductor
  pmc,        ///< a perfect magnetic conductor
  absorbing,  ///< waves leave through it
  coupled     ///< "interface": another domain goes on behind it
};

/// As people write them, in the order of PatchType without the first.
inline constexpr std::array<std::string_view, 10> patch_type_words = {
    "wall",    "slip", "symmetry", "farfield",  "inflow",
    "outflow", "pec",  "pmc",      "absorbing", "interface"};

/// "" of one that is not specified.
constexpr std::string_view word_of(PatchType type) {
  return type == PatchType::unspecified ? std::string_view()
                                        : patch_type_words.at(static_cast<std::size_t>(type) - 1);
}

/// Nothing for a word that is none; unspecified for "".
constexpr std::optional<PatchType> patch_type_of(std::string_view word) {
  if (word.empty()) return PatchType::unspecified;
  for (std::size_t i = 0; i < patch_type_words.size(); ++i) {
    if (patch_type_words.at(i) == word) return static_cast<PatchType>(i + 1);
  }
  return std::nullopt;
}

/// Of patch i, where there is a list that may be empty.
inline PatchType type_of_patch(std::span<const PatchType> types, std::size_t patch) {
  return patch < types.size() ? types[patch] : PatchType::unspecified;
}

/// Whether one of them is specified.
inline bool has_types(std::span<const PatchType> types) {
  for (const PatchType type : types) {
    if (type != PatchType::unspecified) return true;
  }
  return false;
}

}  // namespace tetfarm
