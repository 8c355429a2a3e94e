#include "mesh/formats/list/known_formats.h"

#include <array>
#include <cstddef>

#include "mesh/formats/list/all_formats.h"

namespace tetfarm {
namespace {

/// Worked out by the compiler: nothing of the functions is left that would have to be linked.
constexpr auto known = [] {
  std::array<KnownFormat, all_formats.size()> facts;
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const Format& format = all_formats[i];
    facts[i] = {format, format.read_surface != nullptr, format.write_surface != nullptr,
                format.open_mesh != nullptr, format.write_mesh != nullptr};
  }
  return facts;
}();

}  // namespace

std::span<const KnownFormat> known_formats() { return known; }

}  // namespace tetfarm
