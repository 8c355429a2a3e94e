#include "mesh/formats/ugrid/mapbc.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

#include "mesh/formats/patch_boxes.h"

namespace tetfarm {
namespace {

constexpr int slip_code = 3000;
constexpr std::array<int, 3> symmetry_codes = {6661, 6662, 6663};

constexpr std::array<std::pair<PatchType, int>, 4> codes_of_types = {{{PatchType::wall, 4000},
                                                                      {PatchType::farfield, 5000},
                                                                      {PatchType::inflow, 7011},
                                                                      {PatchType::outflow, 7012}}};

}  // namespace

int mapbc_code(PatchType type, const Box3& box) {
  if (type == PatchType::symmetry) {
    const std::optional<int> axis = constant_axis(box);
    return axis ? symmetry_codes.at(static_cast<std::size_t>(*axis)) : slip_code;
  }
  for (const auto& [known, code] : codes_of_types) {
    if (known == type) return code;
  }
  return slip_code;
}

PatchType type_of_mapbc_code(long code) {
  for (const int symmetry : symmetry_codes) {
    if (code == symmetry) return PatchType::symmetry;
  }
  for (const auto& [type, known] : codes_of_types) {
    if (code == known) return type;
  }
  return PatchType::unspecified;
}

bool wants_boxes(std::span<const PatchType> types) {
  return std::find(types.begin(), types.end(), PatchType::symmetry) != types.end();
}

std::string mapbc_text(std::span<const std::string> patch_names, std::span<const PatchType> types,
                       std::span<const Box3> boxes) {
  std::string text = std::to_string(patch_names.size()) + '\n';
  for (std::size_t i = 0; i < patch_names.size(); ++i) {
    const int code = mapbc_code(type_of_patch(types, i), i < boxes.size() ? boxes[i] : Box3());
    text += std::to_string(i + 1) + ' ' + std::to_string(code) + ' ' + patch_names[i] + '\n';
  }
  return text;
}

Mapbc read_mapbc(const std::filesystem::path& path) {
  Mapbc mapbc;
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream words(line);
    long number = 0;
    long code = 0;
    std::string name;
    if (words >> number >> code && std::getline(words >> std::ws, name)) {
      mapbc.names.push_back(name);
      mapbc.types.push_back(type_of_mapbc_code(code));
    }
  }
  return mapbc;
}

}  // namespace tetfarm
