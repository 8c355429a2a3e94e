/// The little of HDF5's C interface that the mesh files need: handles that close themselves, and
/// errors that throw.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetfarm {

/// What an HDF5 file begins with; without it, it is none.
inline constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";

/// Whether the library was built so that several threads may call it.
bool hdf5_takes_threads();

/// An HDF5 object with the function that closes it.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(other.release()), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    if (id_ >= 0) close_(id_);
    close_ = other.close_;
    id_ = other.release();
    return *this;
  }
  ~Hdf5Handle() {
    if (id_ >= 0) close_(id_);
  }

  hid_t get() const { return id_; }
  bool is_open() const { return id_ >= 0; }
  hid_t release() {
    const hid_t id = id_;
    id_ = -1;
    return id;
  }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// Numbers as they lie in memory and in the file, which is little endian.
template <class T>
hid_t hdf5_type();
template <>
inline hid_t hdf5_type<double>() {
  return H5T_IEEE_F64LE;
}
template <>
inline hid_t hdf5_type<std::int64_t>() {
  return H5T_STD_I64LE;
}
template <>
inline hid_t hdf5_type<std::int32_t>() {
  return H5T_STD_I32LE;
}
template <>
inline hid_t hdf5_type<std::uint8_t>() {
  return H5T_STD_U8LE;
}

/// How hard packed arrays are compressed: little, as they are alike from row to row.
inline constexpr int hdf5_deflate_level = 1;

/// An array in chunks of so many rows, the last filled up, each to be written packed
/// (packed_rows.h).
class Hdf5Chunks {
 public:
  std::int64_t chunk_rows() const { return chunk_rows_; }
  /// Chunk `number`. @throws IoError
  void write(std::int64_t number, const std::string& packed);

 private:
  friend class Hdf5Output;
  Hdf5Chunks(std::string path, Hdf5Handle dataset, std::int64_t chunk_rows)
      : path_(std::move(path)), dataset_(std::move(dataset)), chunk_rows_(chunk_rows) {}

  std::string path_;
  Hdf5Handle dataset_;
  std::int64_t chunk_rows_;
};

/// A file being written. Nothing in it depends on time or on what the memory held before.
class Hdf5Output {
 public:
  /// Truncates. @throws IoError
  explicit Hdf5Output(std::string path);

  void make_group(const std::string& name);
  void add_text_attribute(const std::string& group, const std::string& name,
                          const std::string& text);
  void add_attribute(const std::string& group, const std::string& name,
                     const std::vector<std::int64_t>& values);
  void add_texts(const std::string& name, const std::vector<std::string>& texts);
  /// A whole list.
  template <class T>
  void add_array(const std::string& name, const std::vector<T>& numbers) {
    add_array(name, hdf5_type<T>(), numbers.data(), numbers.size());
  }
  /// An array to be filled later, by whoever writes into the file: where in it the first number
  /// comes, the others follow. With `columns` > 1 its rows have that many numbers. What is not
  /// filled is zero. Places depend on names and sizes of what was added before, on nothing else.
  template <class T>
  std::int64_t room_for(const std::string& name, std::int64_t rows, int columns = 1) {
    return room_for(name, hdf5_type<T>(), rows, columns);
  }
  /// An array in chunks that are shuffled and deflated. It must not outlive the file.
  template <class T>
  Hdf5Chunks packed_array(const std::string& name, std::int64_t rows) {
    return packed_array(name, hdf5_type<T>(), rows);
  }
  /// Writes everything to the file. @throws IoError
  void close();

 private:
  void add_array(const std::string& name, hid_t type, const void* numbers, std::size_t count);
  std::int64_t room_for(const std::string& name, hid_t type, std::int64_t rows, int columns);
  Hdf5Chunks packed_array(const std::string& name, hid_t type, std::int64_t rows);
  hid_t checked(hid_t result) const;

  std::string path_;
  Hdf5Handle file_;
};

class Hdf5Input;

/// One array of a file being read, opened once to be read piece by piece, one after the other.
/// Pieces go from the file to where they are wanted, through no cache but one for the chunk that a
/// piece ends in.
class Hdf5Rows {
 public:
  /// `count` numbers of a one-dimensional array, or rows of `columns`, from `first` on.
  /// @throws InvalidInput also when the array ends before.
  template <class T>
  void read(std::int64_t first, std::int64_t count, T* numbers) const {
    read(hdf5_type<T>(), first, count, numbers);
  }

  /// Bytes that a number has in the file.
  std::size_t number_size() const;
  /// @throws InvalidInput when they are not all there.
  void check(std::int64_t first, std::int64_t count) const;

 private:
  friend class Hdf5Input;
  Hdf5Rows(const Hdf5Input& file, std::string name, int columns);
  void read(hid_t type, std::int64_t first, std::int64_t count, void* numbers) const;

  const Hdf5Input& file_;
  std::string name_;
  Hdf5Handle dataset_;
  std::int64_t rows_ = 0;
  int columns_ = 1;
};

/// A file being read. Missing and unfit things throw InvalidInput naming the file.
class Hdf5Input {
 public:
  /// @throws IoError when there is no such file, InvalidInput when it is not HDF5, or so damaged
  /// that the library cannot go through it.
  explicit Hdf5Input(std::string path);

  bool has(const std::string& name) const;
  std::string text_attribute(const std::string& group, const std::string& name) const;
  std::vector<std::string> texts(const std::string& name) const;
  /// A whole list: what there is one of for each part, not for each element.
  /// @throws InvalidInput when the array has another shape, or is longer than any such list.
  template <class T>
  std::vector<T> list(const std::string& name) const {
    std::vector<T> numbers(rows_of_list(name));
    read(name, hdf5_type<T>(), numbers.data());
    return numbers;
  }
  /// `count` numbers of a one-dimensional array, or rows of three, from `first` on.
  template <class T>
  std::vector<T> slice(const std::string& name, std::int64_t first, std::int64_t count,
                       int columns = 1) const {
    const Hdf5Rows there = rows(name, columns);
    there.check(first, count);
    std::vector<T> numbers(static_cast<std::size_t>(count * columns));
    there.read(first, count, numbers.data());
    return numbers;
  }
  /// @throws InvalidInput when the array has another shape. It must not outlive the file.
  Hdf5Rows rows(const std::string& name, int columns = 1) const { return {*this, name, columns}; }
  [[noreturn]] void fail(const std::string& what) const;

 private:
  friend class Hdf5Rows;
  std::size_t rows_of(const std::string& name, int columns) const;
  std::size_t rows_of_list(const std::string& name) const;
  void read(const std::string& name, hid_t type, void* numbers) const;
  Hdf5Handle open(const std::string& name) const;

  std::string path_;
  Hdf5Handle file_;
};

}  // namespace tetfarm
