/// All that a mesh that was read says of itself, as lines of text: for comparing it as a whole.
#pragma once

#include <charconv>
#include <string>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

inline std::string digits_of(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

template <class Numbers>
std::string numbers_of(const Numbers& numbers) {
  std::string text;
  for (const auto number : numbers) text += " " + std::to_string(number);
  return text;
}

/// Nodes with their numbers in the whole mesh, elements with their local nodes, region and patch.
inline std::string part_listing(const NumberedPart& part) {
  std::string text =
      "part " + std::to_string(part.number) + " region " + std::to_string(part.region) + "\n";
  for (std::size_t v = 0; v < part.nodes.size(); ++v) {
    const Vec3& p = part.nodes[v];
    text += " node " + std::to_string(part.local2global.at(v)) + " at " + digits_of(p.x) + " " +
            digits_of(p.y) + " " + digits_of(p.z) + "\n";
  }
  for (std::size_t t = 0; t < part.tets.size(); ++t) {
    text +=
        " tet" + numbers_of(part.tets[t]) + " region " + std::to_string(part.region_of(t)) + "\n";
  }
  for_each_block_cell(part.blocks, [&](ElementType type, auto nodes, std::int32_t region) {
    text += " " + std::string(element(type).name) + numbers_of(nodes) + " region " +
            std::to_string(region) + "\n";
  });
  for (std::size_t f = 0; f < part.faces.size(); ++f) {
    text += " triangle" + numbers_of(part.faces[f]) + " patch " +
            std::to_string(part.patch_of_face.at(f)) + " region " +
            std::to_string(part.region_of_boundary(f)) + "\n";
  }
  for_each_block_face(
      part.blocks, [&](ElementType type, auto nodes, std::int32_t region, std::int32_t patch) {
        text += " " + std::string(element(type).name) + numbers_of(nodes) + " patch " +
                std::to_string(patch) + " region " + std::to_string(region) + "\n";
      });
  // That of one region is said once.
  text += " lists of regions:" + numbers_of(part.region_of_tet) + ";" +
          numbers_of(part.region_of_face) + "\n";
  return text;
}

inline std::string mesh_listing(const MeshSource& source) {
  std::string text = source.knows_subdomains() ? "sub-domains\n" : "pieces\n";
  for (const std::string& name : source.patch_names()) text += "patch \"" + name + "\"\n";
  for (const std::string& name : source.region_names()) text += "region \"" + name + "\"\n";
  for (const std::string& complaint : source.complaints()) text += "complaint: " + complaint + "\n";
  for (std::size_t i = 0; i < source.size(); ++i) text += part_listing(source.part(i));
  return text;
}

}  // namespace tetfarm
