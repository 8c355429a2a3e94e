#include "coordinator/views/refusals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tetfarm {
namespace {

using testing::HasSubstr;

TEST(Refusals, a_flood_is_counted_but_hardly_told) {
  Refusals refusals;
  for (int i = 0; i < 100'000; ++i) refusals.count(Refusal::garbage, "x", 1000);
  EXPECT_EQ(refusals.of(Refusal::garbage), 100'000U);
  EXPECT_EQ(refusals.take_complaints().size(), 17U) << "1, 2, 4 … 65536";
  EXPECT_TRUE(refusals.take_complaints().empty());
}

TEST(Refusals, after_a_quiet_minute_one_is_told_again) {
  Refusals refusals;
  for (int i = 0; i < 3; ++i) refusals.count(Refusal::stale, "x", 1000);
  refusals.take_complaints();
  for (int i = 0; i < 4; ++i) refusals.count(Refusal::stale, "x", 2000);
  refusals.take_complaints();
  refusals.count(Refusal::stale, "x", 62'000 + 1'000);
  refusals.take_complaints();
  refusals.count(Refusal::stale, "late", 200'000);
  const auto lines = refusals.take_complaints();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_THAT(lines[0], HasSubstr("stale (9 so far): late"));
}

TEST(Refusals, a_kind_does_not_hide_another) {
  Refusals refusals;
  for (int i = 0; i < 3; ++i) refusals.count(Refusal::garbage, "x", 1000);
  refusals.take_complaints();
  refusals.count(Refusal::unknown_key, "y", 1000);
  EXPECT_EQ(refusals.take_complaints().size(), 1U);
  EXPECT_EQ(refusals.total(), 4U);
}

TEST(Refusals, what_a_stranger_sent_cannot_forge_a_line_of_the_log) {
  Refusals refusals;
  refusals.count(Refusal::wrong_role, "a\n[info] all is well\x1b[2J" + std::string(9999, 'x'), 0);
  const std::string line = refusals.take_complaints().at(0);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_EQ(line.find('\x1b'), std::string::npos);
  EXPECT_LT(line.size(), 400U);
}

TEST(Refusals, are_told_with_their_kind_their_number_and_what_came) {
  Refusals refusals;
  refusals.count(Refusal::too_large, "1 GiB from peer 5", 1000);
  refusals.count(Refusal::too_large, "2 GiB from peer 6", 1000);
  EXPECT_THAT(refusals.take_complaints(),
              testing::ElementsAre("refused: too_large (1 so far): 1 GiB from peer 5",
                                   "refused: too_large (2 so far): 2 GiB from peer 6"));
  refusals.count(Refusal::too_large, "third", 60'999);
  EXPECT_THAT(refusals.take_complaints(), testing::IsEmpty()) << "a minute is not over";
  refusals.count(Refusal::too_large, std::string(301, 'x'), 121'000);
  EXPECT_THAT(refusals.take_complaints(),
              testing::ElementsAre("refused: too_large (4 so far): " + std::string(300, 'x')));
  refusals.count(Refusal::too_large, "fifth", 181'000);
  EXPECT_THAT(refusals.take_complaints(),
              testing::ElementsAre("refused: too_large (5 so far): fifth"))
      << "a minute after what was told last";
  refusals.count(Refusal::too_large, "sixth", 181'001);
  EXPECT_THAT(refusals.take_complaints(), testing::IsEmpty());
}

TEST(Refusals, have_the_names_that_monitoring_knows) {
  std::vector<std::string> names;
  for (std::size_t kind = 0; kind < refusal_kinds; ++kind) {
    names.emplace_back(name_of(static_cast<Refusal>(kind)));
  }
  EXPECT_THAT(names,
              testing::ElementsAre("unknown_key", "revoked_key", "wrong_role", "broken_handshake",
                                   "too_many_connections", "too_many_workers", "foreign_connection",
                                   "garbage", "too_large", "wrong_version", "senseless", "stale",
                                   "outside_roots", "no_result"));
  EXPECT_STREQ(name_of(Refusal::no_result), "no_result");
  EXPECT_STREQ(name_of(Refusal::senseless), "senseless");
}

}  // namespace
}  // namespace tetfarm
