/// An array of numbers in an HDF5 file that is given row after row and kept in compressed chunks:
/// for arrays that say nearly the same of each row, of which little is left so.
///
/// The filters are HDF5's own (shuffle, then deflate), which every reader has. A chunk that is
/// filled with one number is compressed once for all that are like it, so such rows cost no time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/check.h"
#include "mesh/formats/hdf5/hdf5_file.h"

namespace tetfarm {

/// A chunk of numbers of `size` bytes each, as HDF5 keeps it. Cost: about 12 ms a million numbers
/// of four bytes that ascend in equal steps.
std::string packed_chunk(std::span<const std::byte> numbers, std::size_t size);

template <class T>
class PackedRows {
 public:
  /// The array is made in the file, all rows zero. @throws IoError
  PackedRows(Hdf5Output& file, const std::string& name, std::int64_t rows)
      : array_(file.packed_array<T>(name, rows)), rows_(rows) {
    values_.reserve(static_cast<std::size_t>(array_.chunk_rows()));
  }

  /// What is passed over stays zero. @pre no row was given that is not before `row`.
  void go_to(std::int64_t row) {
    TF_CHECK(row >= next() && row <= rows_);
    if (row == next()) return;
    const std::int64_t chunk = row / array_.chunk_rows();
    if (chunk != chunk_) {
      store();
      chunk_ = chunk;
    }
    values_.resize(static_cast<std::size_t>(row - chunk_ * array_.chunk_rows()), T{});
  }

  void add(T value) {
    values_.push_back(value);
    if (values_.size() == chunk_size()) store();
  }
  void add(std::size_t count, T value) {
    while (count > 0) {
      if (values_.empty() && count >= chunk_size()) {
        store_filled_with(value);
        count -= chunk_size();
        continue;
      }
      const std::size_t here = std::min(count, chunk_size() - values_.size());
      values_.resize(values_.size() + here, value);
      if (values_.size() == chunk_size()) store();
      count -= here;
    }
  }

  /// Writes what was given last. @throws IoError
  void finish() {
    TF_CHECK(next() <= rows_);
    store();
  }

 private:
  std::int64_t next() const { return chunk_ * array_.chunk_rows() + std::ssize(values_); }
  std::size_t chunk_size() const { return static_cast<std::size_t>(array_.chunk_rows()); }
  static std::string packed(const std::vector<T>& values) {
    return packed_chunk(std::as_bytes(std::span(values)), sizeof(T));
  }

  void store() {
    if (values_.empty()) return;
    values_.resize(chunk_size(), T{});
    array_.write(chunk_++, packed(values_));
    values_.clear();
  }
  void store_filled_with(T value) {
    if (filled_.empty() || value != filled_with_) {
      filled_ = packed(std::vector<T>(chunk_size(), value));
      filled_with_ = value;
    }
    array_.write(chunk_++, filled_);
  }

  Hdf5Chunks array_;
  std::int64_t rows_;
  std::int64_t chunk_ = 0;  ///< that `values_` are the first of
  std::vector<T> values_;
  T filled_with_{};
  std::string filled_;  ///< a chunk of that value, packed
};

}  // namespace tetfarm
