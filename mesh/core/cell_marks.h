/// Whole numbers that tell the cells of layers apart, for who reads the mesh: a solver, or a person
/// who looks at it.
///
/// Source: none in the thesis. A mesh without layers has none of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetfarm {

enum class CellMark : std::uint8_t {
  layer,      ///< of boundary layers, from the wall, which the first is on; 0: beyond them
  pml_depth,  ///< of absorbing layers, from the inside, where the first is; 0: within them
  pml_axes,   ///< of absorbing layers, along which axes: the sum of 1 for x, 2 for y, 4 for z
};
inline constexpr std::array all_cell_marks = {CellMark::layer, CellMark::pml_depth,
                                              CellMark::pml_axes};

/// As files have it.
constexpr const char* name_of(CellMark mark) {
  constexpr std::array<const char*, all_cell_marks.size()> names = {"layer", "pml_depth",
                                                                    "pml_axes"};
  return names[static_cast<std::size_t>(mark)];
}

/// Of each cell of a part, tets and then those in blocks, type after type; none: 0 of all.
class CellMarks {
 public:
  std::vector<std::int32_t>& operator[](CellMark mark) {
    return of_[static_cast<std::size_t>(mark)];
  }
  const std::vector<std::int32_t>& operator[](CellMark mark) const {
    return of_[static_cast<std::size_t>(mark)];
  }
  bool empty() const {
    for (const auto& values : of_) {
      if (!values.empty()) return false;
    }
    return true;
  }
  friend bool operator==(const CellMarks&, const CellMarks&) = default;

 private:
  std::array<std::vector<std::int32_t>, all_cell_marks.size()> of_;
};

}  // namespace tetfarm
