/// Which of many numbered things to look at, when not more than so many can be.
///
/// Source: systematic sampling (W. G. Cochran, "Sampling techniques", 1977, ch. 8), with a random
/// start in each interval.
#pragma once

#include <cstddef>
#include <vector>

namespace tetfarm {

/// One number of each `stride`, ascending, anywhere among them: always the first would be the same
/// corner of every block of cells, and blind to what lies beside it.
struct SystematicSample {
  std::vector<std::size_t> numbers;
  std::size_t stride = 1;
};

/// Of the numbers below `count`, at most `most` (but for two): the stride is a power of two, and no
/// larger than that takes. Depends on the two alone. Cost: O(most * log(count / most)).
SystematicSample systematic_sample(std::size_t count, std::size_t most);

}  // namespace tetfarm
