/// Numbers for mesh files, as text of a fixed width or as raw bytes: with records of equal length
/// the place of each is known beforehand, so that parts are written where they belong, in one pass,
/// whatever the order of the numbers. Text loses nothing: the shortest digits that read back the
/// same.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace tetfarm {

class NumberText {
 public:
  static constexpr int real_width = 25;  ///< "-1.2345678901234567e-300" and a blank

  /// Text: integers take the digits of `largest` and a blank. @pre largest >= 0
  static NumberText text(std::int64_t largest);
  /// Little endian: integers of 8 bytes, those that are `small` of 4.
  static NumberText raw() { return {}; }

  bool is_text() const { return integer_width_ > 0; }
  void integer(std::int64_t value);
  void small(std::int32_t value);
  void real(double value);
  void end_record();  ///< a line's end, or nothing
  /// Of characters, as they are.
  void words(std::string_view text) { bytes_ += text; }

  /// The bytes of a record of so many numbers.
  std::int64_t record_bytes(int integers, int reals) const;
  const std::string& bytes() const { return bytes_; }
  std::int64_t size() const { return static_cast<std::int64_t>(bytes_.size()); }
  std::string take() { return std::exchange(bytes_, {}); }

 private:
  void pad(std::string_view digits, int width);

  int integer_width_ = 0;
  std::string bytes_;
};

}  // namespace tetfarm
