#include "mesh/spacing/systematic_sample.h"

#include <cstdint>

namespace tetfarm {
namespace {

std::uint64_t scattered(std::uint64_t x) {
  x = (x ^ x >> 30U) * 0xbf58476d1ce4e5b9U;
  x = (x ^ x >> 27U) * 0x94d049bb133111ebU;
  return x ^ x >> 31U;
}

/// @pre there is an even number of them, one for each stride.
void drop_one_of_each_two(SystematicSample& choice) {
  const std::size_t kept = choice.numbers.size() / 2;
  for (std::size_t i = 0; i < kept; ++i) {
    choice.numbers[i] = choice.numbers[2 * i + (scattered(choice.stride * kept + i) & 1U)];
  }
  choice.numbers.resize(kept);
  choice.stride *= 2;
}

}  // namespace

SystematicSample systematic_sample(std::size_t count, std::size_t most) {
  SystematicSample choice;
  for (std::size_t first = 0; first < count; first += choice.stride) {
    const bool ends_a_pair = (first & (2 * choice.stride - 1)) == 0;
    if (ends_a_pair && choice.numbers.size() >= 2 && choice.numbers.size() + 2 > most) {
      drop_one_of_each_two(choice);
    }
    const std::size_t chosen = first + (scattered(first) & (choice.stride - 1));
    if (chosen < count) choice.numbers.push_back(chosen);
  }
  return choice;
}

}  // namespace tetfarm
