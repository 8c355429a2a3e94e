#include "mesh/formats/openfoam/foam_text.h"

#include "mesh/formats/count_limit.h"

namespace tetfarm {
namespace {

constexpr std::string_view marks = "(){};";

}  // namespace

FoamText::FoamText(const std::filesystem::path& path) : text_(path), in_(text_.scanner()) {
  expect("FoamFile");
  bool is_text = false;
  read_dictionary([&](std::string_view key, std::string_view value) {
    if (key != "format") return false;
    if (value != "ascii") fail("only text (format ascii) is read");
    is_text = true;
    return false;
  });
  if (!is_text) fail("the header has no format");
}

std::string_view FoamText::token() {
  do {
    if (rest_.empty()) rest_ = in_.word();
  } while (skip_comment());
  if (rest_.empty()) fail("the file ends too early");
  if (rest_.front() == '"') return quotation();
  std::size_t length = rest_.find_first_of(marks);
  if (length == 0) length = 1;
  const std::string_view token = rest_.substr(0, length);
  rest_.remove_prefix(token.size());
  return token;
}

bool FoamText::skip_comment() {
  if (rest_.starts_with("//")) {
    in_.rest_of_line();
    rest_ = {};
    return true;
  }
  if (!rest_.starts_with("/*")) return false;
  const std::size_t end = rest_.find("*/", 2);
  if (end == rest_.npos && !in_.skip_past("*/")) fail("a comment has no end");
  rest_ = end == rest_.npos ? std::string_view() : rest_.substr(end + 2);
  return true;
}

/// From one quote to the next, over words.
std::string_view FoamText::quotation() {
  const char* begin = rest_.data();
  std::size_t from = 1;
  for (;;) {
    const std::size_t end = rest_.find('"', from);
    if (end != rest_.npos) {
      const std::string_view text(begin, static_cast<std::size_t>(rest_.data() - begin) + end + 1);
      rest_.remove_prefix(end + 1);
      return text;
    }
    rest_ = in_.word();
    from = 0;
    if (rest_.empty()) fail("a text has no end");
  }
}

void FoamText::expect(std::string_view expected) {
  const std::string_view found = token();
  if (found != expected) fail("expected " + std::string(expected) + ", found " + quoted(found));
}

std::int64_t FoamText::begin_list(std::int64_t least_bytes_each) {
  const std::int64_t count = in_.to_integer(token(), "a count");
  const auto left = static_cast<std::int64_t>(in_.bytes_left() + rest_.size());
  if (count < 0 || count > left / least_bytes_each) {
    fail("a count of " + std::to_string(count) + ", but only " + std::to_string(left) +
         " bytes left in the file");
  }
  if (count > most_of_32_bits) fail("a count of more than 32 bits");
  expect("(");
  return count;
}

std::int32_t FoamText::label(std::int64_t end) {
  const std::int64_t value = integer();
  if (value < 0 || value >= end) {
    fail("the number " + std::to_string(value) + " is not below " + std::to_string(end));
  }
  return static_cast<std::int32_t>(value);
}

void FoamText::read_dictionary(
    const std::function<bool(std::string_view, std::string_view)>& read) {
  expect("{");
  for (std::string_view key = token(); key != "}"; key = token()) {
    const std::string_view value = token();
    if (!read(key, value)) skip_value(value);
  }
}

void FoamText::skip_value(std::string_view token_of_value) {
  int depth = 0;
  for (std::string_view next = token_of_value;; next = token()) {
    if (next == "{") ++depth;
    if (next == "}" && --depth == 0) return;
    if (depth < 0) fail("expected ;, found }");
    if (next == ";" && depth == 0) return;
  }
}

}  // namespace tetfarm
