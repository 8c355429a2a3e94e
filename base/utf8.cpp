#include "base/utf8.h"

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr std::size_t longest = 4;

unsigned byte_at(std::string_view text, std::size_t at) {
  return static_cast<unsigned char>(text[at]);
}

bool continues(unsigned byte) { return (byte & 0xC0U) == 0x80U; }

}  // namespace

CodePoint code_point_at(std::string_view text, std::size_t at) {
  TF_CHECK(at < text.size());
  const unsigned first = byte_at(text, at);
  if (first < 0x80U) return {first, 1};
  std::size_t bytes = 0;
  char32_t value = 0;
  char32_t least = 0;
  if (first >= 0xC2U && first <= 0xDFU) {
    bytes = 2;
    value = first & 0x1FU;
    least = 0x80;
  } else if ((first & 0xF0U) == 0xE0U) {
    bytes = 3;
    value = first & 0x0FU;
    least = 0x800;
  } else if (first >= 0xF0U && first <= 0xF4U) {
    bytes = longest;
    value = first & 0x07U;
    least = 0x10000;
  }
  if (bytes == 0 || text.size() - at < bytes) return {};
  for (std::size_t i = 1; i < bytes; ++i) {
    const unsigned next = byte_at(text, at + i);
    if (!continues(next)) return {};
    value = (value << 6U) | (next & 0x3FU);
  }
  const bool is_surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (value < least || value > 0x10FFFF || is_surrogate) return {};
  return {value, bytes};
}

bool is_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint found = code_point_at(text, at);
    if (found.bytes == 0) return false;
    at += found.bytes;
  }
  return true;
}

bool is_control(char32_t value) {
  const auto is_within = [value](char32_t first, char32_t last) {
    return value >= first && value <= last;
  };
  return value < 0x20 || is_within(0x7F, 0x9F) || value == 0x061C || is_within(0x200E, 0x200F) ||
         is_within(0x2028, 0x202E) || is_within(0x2066, 0x2069);
}

std::string_view cut_utf8(std::string_view text, std::size_t most_bytes) {
  if (text.size() <= most_bytes) return text;
  std::size_t end = most_bytes;
  for (std::size_t back = 0; back < longest && end > 0 && continues(byte_at(text, end)); ++back) {
    --end;
  }
  return text.substr(0, continues(byte_at(text, end)) ? most_bytes : end);
}

}  // namespace tetfarm
