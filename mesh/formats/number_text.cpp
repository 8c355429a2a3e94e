#include "mesh/formats/number_text.h"

#include <array>
#include <bit>
#include <charconv>

#include "base/check.h"

namespace tetfarm {
namespace {

static_assert(std::endian::native == std::endian::little);

template <class T>
std::string_view digits_of(T value, std::array<char, 32>& buffer) {
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), static_cast<std::size_t>(end - buffer.data())};
}

template <class T>
void append_raw(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

NumberText NumberText::text(std::int64_t largest) {
  TF_CHECK(largest >= 0);
  std::array<char, 32> buffer;
  NumberText result;
  result.integer_width_ = static_cast<int>(digits_of(largest, buffer).size()) + 1;
  return result;
}

void NumberText::pad(std::string_view digits, int width) {
  const auto wanted = static_cast<std::size_t>(width);
  TF_CHECK(digits.size() < wanted);
  bytes_.append(wanted - digits.size(), ' ');
  bytes_ += digits;
}

void NumberText::integer(std::int64_t value) {
  std::array<char, 32> buffer;
  if (is_text()) {
    pad(digits_of(value, buffer), integer_width_);
  } else {
    append_raw(bytes_, value);
  }
}

void NumberText::small(std::int32_t value) {
  if (is_text()) {
    integer(value);
  } else {
    append_raw(bytes_, value);
  }
}

void NumberText::real(double value) {
  std::array<char, 32> buffer;
  if (is_text()) {
    pad(digits_of(value, buffer), real_width);
  } else {
    append_raw(bytes_, value);
  }
}

void NumberText::end_record() {
  if (is_text()) bytes_ += '\n';
}

std::int64_t NumberText::record_bytes(int integers, int reals) const {
  return is_text() ? integers * integer_width_ + reals * real_width + 1 : 8 * (integers + reals);
}

}  // namespace tetfarm
