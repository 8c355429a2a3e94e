/// Walks over the bytes of a surface file: words and numbers of its text, raw numbers of its binary
/// parts. Every failure throws InvalidInput with the file and the line, or the byte in a binary
/// part.
///
/// Numbers are read by from_chars: the same in every locale. Lines are counted only when a message
/// needs one. Cost: O(bytes).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace tetfarm {

class InputScanner {
 public:
  /// `comment` starts a comment that lasts to the end of its line; 0: there are none.
  /// Both arguments must outlive the scanner.
  InputScanner(std::string_view bytes, const std::string& name, char comment = '\0');

  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - cursor_); }
  /// True when only white space and comments are left.
  bool at_end() {
    skip_space();
    return cursor_ == end_;
  }

  /// The next word, on whatever line; empty at the end of the file.
  std::string_view word() {
    skip_space();
    return cut_word();
  }
  /// The next word of this line; empty at its end. A `\` before the end of a line joins the next
  /// one.
  std::string_view word_in_line() {
    skip_blanks();
    return cut_word();
  }
  /// What is left of this line without the blanks round it; the next line comes next.
  std::string_view rest_of_line();
  /// Fails unless the next word is `expected`.
  void expect(std::string_view expected);

  double coordinate() { return to_coordinate(word()); }
  double coordinate_in_line() { return to_coordinate(word_in_line()); }
  /// `what` is for the message: "a node number".
  std::int64_t integer(std::string_view what) { return to_integer(word(), what); }
  double to_coordinate(std::string_view word) const;
  std::int64_t to_integer(std::string_view word, std::string_view what) const;
  /// `value`, unless it is infinite or not a number.
  double finite(double value) const;
  /// A count of things that take at least `bytes_each`: fails when more than the file can hold.
  std::size_t to_count(std::int64_t value, std::size_t bytes_each) const;

  /// A number as it lies in memory; from now on messages give bytes, until `text_again`.
  template <class T>
  T raw() {
    is_binary_ = true;
    last_ = cursor_;
    if (bytes_left() < sizeof(T)) fail("the file ends too early");
    T value;
    std::memcpy(&value, cursor_, sizeof value);
    cursor_ += sizeof value;
    return value;
  }
  /// As raw, of a machine with the other order of bytes.
  template <class T>
  T raw_turned() {
    const T value = raw<T>();
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), &value, sizeof value);
    std::reverse(bytes.begin(), bytes.end());
    T turned;
    std::memcpy(&turned, bytes.data(), sizeof turned);
    return turned;
  }
  void skip_bytes(std::size_t count) {
    last_ = cursor_;
    if (bytes_left() < count) fail("the file ends too early");
    cursor_ += count;
  }
  void text_again() { is_binary_ = false; }
  /// Moves behind the next occurrence of `text`; false when there is none.
  bool skip_past(std::string_view text);

  /// Throws InvalidInput for the place of the last word or number.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  void skip_comment() { cursor_ = std::find(cursor_, end_, '\n'); }
  void skip_space() {
    for (;;) {
      while (cursor_ != end_ && is_space(*cursor_)) ++cursor_;
      if (cursor_ == end_ || comment_ == '\0' || *cursor_ != comment_) return;
      skip_comment();
    }
  }
  void skip_blanks();
  std::string_view cut_word() {
    last_ = cursor_;
    while (cursor_ != end_ && !is_space(*cursor_)) ++cursor_;
    return {last_, static_cast<std::size_t>(cursor_ - last_)};
  }

  const char* begin_;
  const char* end_;
  const char* cursor_;
  const char* last_;
  const std::string& name_;
  char comment_;
  bool is_binary_ = false;
};

/// `text` in quotes for a message: at most 40 characters, unprintable ones as '?'.
std::string quoted(std::string_view text);

}  // namespace tetfarm
