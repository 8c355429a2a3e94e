/// Squares beside each other, each two triangles, with prisms on them up to some height.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "mesh/formats/mesh_source.h"

namespace tetfarm::test {

class PrismStacks : public MeshSource {
 public:
  /// n x n squares, each with two columns of so many prisms.
  PrismStacks(int n, int layers) {
    for (int k = 0; k <= layers; ++k) {
      for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
          part_.nodes.push_back({1.0 * i, 1.0 * j, 0.1 * k});
          part_.local2global.push_back(std::ssize(part_.local2global));
        }
      }
    }
    const auto node = [n](int i, int j, int k) { return ((k * (n + 1)) + j) * (n + 1) + i; };
    ElementBlock& prisms = part_.blocks[ElementType::prism];
    for (int k = 0; k < layers; ++k) {
      for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
          for (const int half : {0, 1}) {
            for (const int level : {k, k + 1}) {
              prisms.nodes.push_back(node(i, j, level));
              prisms.nodes.push_back(node(i + 1, j + half, level));
              prisms.nodes.push_back(half == 0 ? node(i + 1, j + 1, level) : node(i, j + 1, level));
            }
            prisms.regions.push_back(1);
          }
        }
      }
    }
  }

  std::size_t size() const override { return 1; }
  NumberedPart part(std::size_t) const override { return part_; }
  std::vector<std::string> patch_names() const override { return {}; }
  std::vector<std::string> region_names() const override { return {"domain"}; }

 private:
  NumberedPart part_;
};

}  // namespace tetfarm::test
