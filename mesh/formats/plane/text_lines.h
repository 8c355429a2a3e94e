/// Text made line by line, with numbers of as few digits as tell them.
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <utility>

namespace tetfarm {

class TextLines {
 public:
  /// `bytes`: about how many there will be.
  explicit TextLines(std::size_t bytes = 0) { text_.reserve(bytes); }

  /// The number and a blank.
  template <class Number>
  TextLines& number(Number value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    text_.append(buffer.data(), end);
    text_ += ' ';
    return *this;
  }
  TextLines& words(std::string_view words) {
    text_ += words;
    return *this;
  }
  /// Ends the line. @pre its last character is a blank.
  void end() { text_.back() = '\n'; }
  const std::string& text() const { return text_; }
  /// The same, for good.
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace tetfarm
