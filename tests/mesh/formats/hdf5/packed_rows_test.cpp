#include "mesh/formats/hdf5/packed_rows.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <numeric>
#include <thread>

#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

constexpr std::int64_t rows_of_chunk = 65536;

class PackedArray : public testing::Test {
 protected:
  /// A file with an array of `rows` that `give` has filled.
  template <class T, class Give>
  void write(std::int64_t rows, const Give& give) {
    Hdf5Output file(path_);
    {
      PackedRows<T> array(file, "a", rows);
      give(array);
      array.finish();
    }
    file.close();
  }
  template <class T>
  std::vector<T> read(std::int64_t rows) const {
    return Hdf5Input(path_).slice<T>("a", 0, rows);
  }

  TempFolder folder_;
  std::string path_ = (folder_.path() / "a.h5").string();
};

TEST_F(PackedArray, gives_back_numbers_that_were_given_one_by_one) {
  for (const std::int64_t count :
       {std::int64_t{1}, rows_of_chunk - 1, rows_of_chunk, rows_of_chunk + 1, 3 * rows_of_chunk}) {
    std::vector<std::int64_t> numbers(static_cast<std::size_t>(count));
    std::iota(numbers.begin(), numbers.end(), std::int64_t{1} << 40U);
    write<std::int64_t>(count, [&](auto& array) {
      for (const std::int64_t number : numbers) array.add(number);
    });
    EXPECT_EQ(read<std::int64_t>(count), numbers) << count;
  }
}

TEST_F(PackedArray, gives_back_runs_of_equal_numbers_wherever_they_begin) {
  const std::vector<std::pair<std::size_t, std::int32_t>> runs = {
      {3, 7}, {2 * rows_of_chunk, -1}, {rows_of_chunk - 3, 5}, {rows_of_chunk, 5}, {70'000, 0}};
  std::vector<std::int32_t> numbers;
  for (const auto& [count, number] : runs) numbers.insert(numbers.end(), count, number);
  write<std::int32_t>(std::ssize(numbers), [&](auto& array) {
    for (const auto& [count, number] : runs) array.add(count, number);
  });
  EXPECT_EQ(read<std::int32_t>(std::ssize(numbers)), numbers);
}

TEST_F(PackedArray, rows_that_are_passed_over_are_zero) {
  const std::int64_t rows = 5 * rows_of_chunk + 10;
  std::vector<std::uint8_t> numbers(rows);
  write<std::uint8_t>(rows, [&](auto& array) {
    for (const std::int64_t row : {5L, 9L, 3 * rows_of_chunk + 2, rows - 1}) {
      array.go_to(row);
      array.add(200);
      numbers[static_cast<std::size_t>(row)] = 200;
    }
  });
  EXPECT_EQ(read<std::uint8_t>(rows), numbers);
}

TEST_F(PackedArray, may_be_empty) {
  write<std::int32_t>(0, [](auto& array) { array.add(0, 4); });
  EXPECT_EQ(read<std::int32_t>(0), std::vector<std::int32_t>());
}

TEST_F(PackedArray, is_small_where_rows_are_alike) {
  constexpr std::int64_t rows = 16 * rows_of_chunk;
  write<std::int32_t>(rows, [](auto& array) {
    for (std::int32_t i = 0; i < rows; ++i) array.add(4 * i);
  });
  EXPECT_LT(std::filesystem::file_size(path_), rows / 10);
  write<std::int32_t>(rows, [](auto& array) { array.add(rows, 3); });
  EXPECT_LT(std::filesystem::file_size(path_), rows / 20);
}

TEST_F(PackedArray, is_read_in_pieces_that_share_chunks) {
  constexpr std::int64_t rows = 2 * rows_of_chunk + 100;
  write<std::int32_t>(rows, [](auto& array) {
    for (std::int32_t i = 0; i < rows; ++i) array.add(i);
  });
  const Hdf5Input file(path_);
  const Hdf5Rows array = file.rows("a");
  EXPECT_EQ(array.number_size(), 4U);
  std::vector<std::int32_t> piece(1000);
  for (std::int64_t first = 0; first + 1000 <= rows; first += 999) {
    array.read(first, 1000, piece.data());
    ASSERT_EQ(piece.front(), first);
    ASSERT_EQ(piece.back(), first + 999);
  }
}

/// HDF5 tells each thread anew of its errors.
TEST_F(PackedArray, and_one_in_one_piece_are_read_by_another_thread_without_a_word_of_hdf5) {
  Hdf5Output output(path_);
  output.add_array("whole", std::vector<std::int32_t>{1, 2, 3});
  {
    PackedRows<std::int32_t> array(output, "a", 3);
    array.add(3, 7);
    array.finish();
  }
  output.close();
  const Hdf5Input file(path_);
  testing::internal::CaptureStderr();
  std::vector<std::int32_t> numbers;
  std::thread([&] {
    for (const char* name : {"whole", "a"}) {
      for (const std::int32_t n : file.slice<std::int32_t>(name, 0, 3)) numbers.push_back(n);
    }
  }).join();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(numbers, (std::vector<std::int32_t>{1, 2, 3, 7, 7, 7}));
}

}  // namespace
}  // namespace tetfarm
