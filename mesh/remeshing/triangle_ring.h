/// The triangles round a vertex: without an allocation where there are no more than eight, as there
/// are nearly always. In the order in which they came; one that goes leaves the order of the
/// others.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetfarm {

class TriangleRing {
 public:
  void add(std::int32_t triangle) {
    if (count_ < most_here) {
      here_[count_] = triangle;
    } else {
      if (count_ == most_here) elsewhere_.assign(here_.begin(), here_.end());
      elsewhere_.push_back(triangle);
    }
    ++count_;
  }

  /// @pre it is one of them.
  void remove(std::int32_t triangle) {
    const std::span<std::int32_t> all = places();
    std::shift_left(std::ranges::find(all, triangle), all.end(), 1);
    --count_;
    if (count_ == most_here) {
      std::copy_n(elsewhere_.begin(), most_here, here_.begin());
      elsewhere_.clear();
    } else if (count_ > most_here) {
      elsewhere_.pop_back();
    }
  }

  std::span<const std::int32_t> triangles() const {
    return {count_ <= most_here ? here_.data() : elsewhere_.data(), count_};
  }

 private:
  static constexpr std::uint32_t most_here = 8;

  std::span<std::int32_t> places() {
    return {count_ <= most_here ? here_.data() : elsewhere_.data(), count_};
  }

  std::uint32_t count_ = 0;
  std::array<std::int32_t, most_here> here_{};
  std::vector<std::int32_t> elsewhere_;  ///< all of them, where they are more
};

}  // namespace tetfarm
