#include "base/tree_path.h"

#include <bit>

#include "base/check.h"

namespace tetfarm {

std::string tree_path(std::uint64_t heap) {
  TF_CHECK(heap != 0);
  if (heap == 1) return "root";
  std::string way;
  for (std::uint64_t bit = std::bit_floor(heap) >> 1U; bit != 0; bit >>= 1U) {
    way += (heap & bit) != 0 ? 'R' : 'L';
  }
  return way;
}

}  // namespace tetfarm
