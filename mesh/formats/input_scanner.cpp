#include "mesh/formats/input_scanner.h"

#include <charconv>
#include <cmath>

#include "base/error.h"

namespace tetfarm {
namespace {

std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

}  // namespace

InputScanner::InputScanner(std::string_view bytes, const std::string& name, char comment)
    : begin_(bytes.data()),
      end_(bytes.data() + bytes.size()),
      cursor_(begin_),
      last_(begin_),
      name_(name),
      comment_(comment) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (bytes.starts_with(byte_order_mark)) cursor_ += byte_order_mark.size();
}

void InputScanner::skip_blanks() {
  while (cursor_ != end_) {
    if (*cursor_ == '\\') {
      const char* next = cursor_ + 1;
      if (next != end_ && *next == '\r') ++next;
      if (next == end_ || *next != '\n') return;
      cursor_ = next + 1;
    } else if (comment_ != '\0' && *cursor_ == comment_) {
      skip_comment();
    } else if (*cursor_ != '\n' && is_space(*cursor_)) {
      ++cursor_;
    } else {
      return;
    }
  }
}

std::string_view InputScanner::rest_of_line() {
  skip_blanks();
  last_ = cursor_;
  cursor_ = std::find(cursor_, end_, '\n');
  std::string_view rest(last_, static_cast<std::size_t>(cursor_ - last_));
  while (!rest.empty() && is_space(rest.back())) rest.remove_suffix(1);
  if (cursor_ != end_) ++cursor_;
  return rest;
}

void InputScanner::expect(std::string_view expected) {
  const std::string_view found = word();
  if (found != expected) fail("expected " + std::string(expected) + ", found " + quoted(found));
}

double InputScanner::to_coordinate(std::string_view word) const {
  const std::string_view number = without_plus(word);
  double value = 0;
  const auto [stop, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error == std::errc::invalid_argument || stop != number.data() + number.size()) {
    fail("expected a coordinate, found " + quoted(word));
  }
  if (error == std::errc::result_out_of_range) {
    // Too small for a double is as good as zero; too large is not a place.
    if (number.find("e-") == number.npos && number.find("E-") == number.npos) {
      fail("the coordinate " + quoted(word) + " is too large");
    }
    value = 0;
  }
  return finite(value);
}

double InputScanner::finite(double value) const {
  if (!std::isfinite(value)) fail("a coordinate is " + std::to_string(value));
  return value;
}

std::int64_t InputScanner::to_integer(std::string_view word, std::string_view what) const {
  const std::string_view number = without_plus(word);
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error != std::errc{} || stop != number.data() + number.size()) {
    fail("expected " + std::string(what) + ", found " + quoted(word));
  }
  return value;
}

std::size_t InputScanner::to_count(std::int64_t value, std::size_t bytes_each) const {
  // A negative value is a huge one here.
  if (static_cast<std::uint64_t>(value) > bytes_left() / bytes_each) {
    fail("a count of " + std::to_string(value) + ", but only " + std::to_string(bytes_left()) +
         " bytes left in the file");
  }
  return static_cast<std::size_t>(value);
}

bool InputScanner::skip_past(std::string_view text) {
  const std::string_view left(cursor_, bytes_left());
  const std::size_t found = left.find(text);
  if (found == left.npos) return false;
  cursor_ += found + text.size();
  return true;
}

void InputScanner::fail(const std::string& what) const {
  const std::string where = is_binary_
                                ? name_ + ": byte " + std::to_string(last_ - begin_)
                                : name_ + ":" + std::to_string(1 + std::count(begin_, last_, '\n'));
  throw InvalidInput(what, where);
}

std::string quoted(std::string_view text) {
  if (text.empty()) return "nothing";
  constexpr std::size_t limit = 40;
  std::string shown;
  for (const char c : text.substr(0, limit)) shown += c >= ' ' && c <= '~' ? c : '?';
  return "\"" + shown + (text.size() > limit ? "…\"" : "\"");
}

}  // namespace tetfarm
