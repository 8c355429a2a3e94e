#include "base/program_identity.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

namespace tetfarm {
namespace {

/// As it lies in an executable: three numbers, a name and a content, each filled up to four bytes.
std::string note(std::uint32_t type, const std::string& name, const std::string& content) {
  const std::uint32_t sizes[] = {static_cast<std::uint32_t>(name.size() + 1),
                                 static_cast<std::uint32_t>(content.size()), type};
  std::string bytes(sizeof sizes, '\0');
  std::memcpy(bytes.data(), sizes, sizeof sizes);
  bytes += name;
  bytes.append(4 - name.size() % 4, '\0');
  bytes += content;
  bytes.append((4 - content.size() % 4) % 4, '\0');
  return bytes;
}

constexpr std::uint32_t build_id = 3;

TEST(ProgramIdentity, is_the_linkers_hash_among_other_notes) {
  const std::string notes = note(1, "GNU", "version") + note(build_id, "Go", "other") +
                            note(build_id, "GNU", "\x01\xaf\x10") + note(build_id, "GNU", "late");
  EXPECT_EQ(build_id_among(notes), "01af10");
}

TEST(ProgramIdentity, is_not_read_from_notes_that_have_none_or_are_cut_off) {
  EXPECT_EQ(build_id_among({}), "");
  EXPECT_EQ(build_id_among(note(1, "GNU", "version")), "");
  const std::string whole = note(build_id, "GNU", "12345678");
  EXPECT_EQ(build_id_among(whole), "3132333435363738");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_EQ(build_id_among(std::string_view(whole).substr(0, size)), "") << size;
  }
}

TEST(ProgramIdentity, of_this_program_is_a_hash_and_stays_the_same) {
  const std::string identity = program_identity();
  EXPECT_GE(identity.size(), 32U);
  EXPECT_EQ(identity.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(program_identity(), identity);
}

}  // namespace
}  // namespace tetfarm
