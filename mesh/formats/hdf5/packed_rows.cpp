#include "mesh/formats/hdf5/packed_rows.h"

#include <zlib.h>

#include "base/check.h"

namespace tetfarm {
namespace {

/// The first bytes of all numbers, then the second ones, as HDF5's filter has them.
std::vector<std::byte> shuffled(std::span<const std::byte> numbers, std::size_t size) {
  const std::size_t count = numbers.size() / size;
  std::vector<std::byte> bytes(numbers.size());
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t i = 0; i < count; ++i) bytes[k * count + i] = numbers[i * size + k];
  }
  return bytes;
}

}  // namespace

std::string packed_chunk(std::span<const std::byte> numbers, std::size_t size) {
  TF_CHECK(size > 0 && numbers.size() % size == 0);
  const std::vector<std::byte> bytes = shuffled(numbers, size);
  uLongf length = compressBound(bytes.size());
  std::string packed(length, '\0');
  const int result =
      compress2(reinterpret_cast<Bytef*>(packed.data()), &length,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), hdf5_deflate_level);
  TF_CHECK(result == Z_OK);
  packed.resize(length);
  return packed;
}

}  // namespace tetfarm
