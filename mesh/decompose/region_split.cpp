#include "mesh/decompose/region_split.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "base/check.h"
#include "mesh/core/subdomain_regions.h"
#include "mesh/decompose/planar_cut.h"

namespace tetfarm {
namespace {

/// One each, and each of the rest to the region whose parts are the largest; ties to the first.
std::vector<std::int64_t> shares_of(const std::vector<double>& work, std::int64_t parts) {
  TF_CHECK(!work.empty());
  std::vector<std::int64_t> shares(work.size(), 1);
  for (std::int64_t rest = parts - std::ssize(work); rest > 0; --rest) {
    std::size_t largest = 0;
    const auto size = [&](std::size_t i) { return work[i] / static_cast<double>(shares[i]); };
    for (std::size_t i = 1; i < work.size(); ++i) {
      if (size(i) > size(largest)) largest = i;
    }
    ++shares[largest];
  }
  return shares;
}

}  // namespace

RegionSplit split_regions(const Subdomain& subdomain, const SpacingField& spacing,
                          std::int64_t parts) {
  const std::vector<std::int32_t> regions = regions_of(subdomain);
  TF_CHECK(subdomain.region == 0 && regions.size() > 1 && parts >= std::ssize(regions));
  std::vector<double> work;
  for (const std::int32_t region : regions) {
    work.push_back(
        estimated_elements(part_of_regions(subdomain, {region}, subdomain.path), spacing));
  }
  const std::vector<std::int64_t> shares = shares_of(work, parts);
  const auto [left, right] = halves_of(regions);
  RegionSplit split;
  split.left = part_of_regions(subdomain, left, subdomain.path.left());
  split.right = part_of_regions(subdomain, right, subdomain.path.right());
  split.left_parts =
      std::accumulate(shares.begin(), shares.begin() + std::ssize(left), std::int64_t{0});
  split.right_parts = parts - split.left_parts;
  TF_CHECK(split.left_parts >= 1 && split.right_parts >= 1);
  return split;
}

}  // namespace tetfarm
