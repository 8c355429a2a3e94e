#include "mesh/artifacts/checked_bytes.h"

#include <gmock/gmock.h>

#include "base/error.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr std::string_view magic = "TFTEST\r\n";
constexpr std::uint32_t version = 7;

std::string seven_letters() {
  ByteWriter writer = begin_checked(magic, version);
  writer.text("letters");
  return finish_checked(std::move(writer));
}

auto complains(const std::string& what) {
  return ThrowsMessage<CorruptFile>(HasSubstr("some/file: " + what));
}

std::string read(std::string_view bytes, std::uint32_t wanted = version) {
  const std::string name = "some/file";
  ByteReader reader = read_checked(bytes, magic, wanted, name);
  std::string text = reader.text(7);
  reader.expect_end();
  return text;
}

TEST(CheckedBytes, end_with_the_hash_of_all_before_its_low_half_first) {
  const std::string bytes = seven_letters();
  const std::string before = std::string(magic) + std::string("\7\0\0\0letters", 11);
  ASSERT_EQ(bytes.substr(0, bytes.size() - checksum_size), before);
  const Hash128 hash = hash128(before);
  ByteWriter end;
  end.number(hash.low);
  end.number(hash.high);
  EXPECT_EQ(bytes.substr(before.size()), end.bytes());
  EXPECT_EQ(read(bytes), "letters");
}

TEST(CheckedBytes, each_changed_bit_is_noticed) {
  const std::string bytes = seven_letters();
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string changed = bytes;
    changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << (bit % 8)));
    EXPECT_THROW(read(changed), CorruptFile) << bit;
  }
}

TEST(CheckedBytes, a_file_of_each_smaller_length_is_refused) {
  const std::string bytes = seven_letters();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(read(std::string_view(bytes).substr(0, size)), CorruptFile) << size;
  }
  EXPECT_THAT([&] { read(std::string_view(bytes).substr(0, magic.size())); },
              complains("is cut short"));
}

TEST(CheckedBytes, another_kind_and_another_version_are_told_from_damage) {
  std::string bytes = seven_letters();
  EXPECT_THAT([&] { read(bytes, 8); }, complains("has the format version 7, not 8"));
  bytes.back() = static_cast<char>(bytes.back() ^ 1);
  EXPECT_THAT([&] { read(bytes); }, complains("has a wrong checksum"));
  bytes.front() = 'X';
  EXPECT_THAT([&] { read(bytes); }, complains("does not begin like the expected kind of file"));
}

}  // namespace
}  // namespace tetfarm
