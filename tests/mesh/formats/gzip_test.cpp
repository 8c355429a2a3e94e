#include "mesh/formats/gzip.h"

#include <gmock/gmock.h>

#include <random>

#include "base/error.h"
#include "tests/mesh/formats/surface_texts.h"

namespace tetfarm {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr std::size_t mib = std::size_t{1} << 20U;

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(Gzip, that_unpacks_to_far_more_than_surfaces_do_is_refused_with_limit_and_remedy) {
  const std::string bomb = repeated(texts::gzip(std::string(32 * mib, '0')), 10);
  ASSERT_LT(bomb.size(), mib / 2) << "320 MiB in less than half a MiB";
  EXPECT_THAT([&] { unpack_gzip(bomb, "wing.stl.gz"); },
              ThrowsMessage<InvalidInput>(
                  AllOf(HasSubstr("wing.stl.gz: unpacks to more than 64 MiB"),
                        HasSubstr("from " + std::to_string(bomb.size()) + " bytes of gzip"),
                        HasSubstr("unpack it with gunzip and give the unpacked file"))));
}

TEST(Gzip, is_limited_by_ratio_and_by_size) {
  EXPECT_EQ(most_unpacked(10), 64 * mib) << "small files may be as regular as they like";
  EXPECT_EQ(most_unpacked(mib), 200 * mib);
  EXPECT_EQ(most_unpacked(std::uint64_t{1} << 60U), std::uint64_t{32} << 30U);
}

TEST(Gzip, that_packs_well_but_not_unreasonably_is_unpacked_as_it_was) {
  std::mt19937 random(1);
  std::string bytes(mib, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random());
  bytes += repeated("  vertex 0.000000e+00 0.000000e+00 1.000000e+00\n", 2'000'000);
  const std::string packed = texts::gzip(bytes);
  ASSERT_GT(bytes.size(), 64 * mib);
  ASSERT_GT(bytes.size(), 60 * packed.size());
  EXPECT_TRUE(unpack_gzip(packed, "a.stl.gz") == bytes);
}

TEST(Gzip, of_small_surfaces_may_be_as_regular_as_it_likes) {
  const std::string bytes(8 * mib, ' ');
  const std::string packed = texts::gzip(bytes);
  ASSERT_GT(bytes.size(), 500 * packed.size());
  EXPECT_TRUE(unpack_gzip(packed, "a.stl.gz") == bytes);
}

std::string said_of(const std::string& packed) {
  try {
    unpack_gzip(packed, "a.stl.gz");
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(Gzip, of_several_members_is_all_of_them_and_may_end_in_zeros) {
  const std::string packed = texts::gzip("one ") + texts::gzip("") + texts::gzip("two");
  EXPECT_EQ(unpack_gzip(packed, "a"), "one two");
  EXPECT_EQ(unpack_gzip(packed + std::string(600, '\0'), "a"), "one two");
  EXPECT_EQ(said_of(packed + std::string(600, '\0') + "x"),
            "a.stl.gz: has more bytes after the gzip data");
  EXPECT_EQ(said_of(packed + "\x1f"), "a.stl.gz: has more bytes after the gzip data");
  EXPECT_EQ(unpack_gzip(texts::gzip(""), "a"), "");
}

TEST(Gzip, that_is_cut_short_is_called_that_wherever_it_ends) {
  const std::string packed = texts::gzip("one ") + texts::gzip("two and a half");
  const std::size_t first = texts::gzip("one ").size();
  for (std::size_t size = 2; size < packed.size(); ++size) {
    const std::string said = size == first       ? ""
                             : size == first + 1 ? "a.stl.gz: has more bytes after the gzip data"
                                                 : "a.stl.gz: the gzip data are cut short";
    EXPECT_EQ(said_of(packed.substr(0, size)), said) << size;
  }
}

TEST(Gzip, that_is_damaged_names_the_byte) {
  std::string packed = texts::gzip("one two three");
  packed[2] = 9;  // no known way to pack
  EXPECT_THAT(said_of(packed),
              testing::MatchesRegex("a.stl.gz: byte [0-9]+: the gzip data are damaged"));
  packed[2] = 8;
  packed.at(packed.size() - 8) ^= 1;  // of the checksum
  EXPECT_EQ(said_of(packed),
            "a.stl.gz: byte " + std::to_string(packed.size() - 4) + ": the gzip data are damaged");
}

}  // namespace
}  // namespace tetfarm
