#include "json/reply_values.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

TEST(ReplyValues, of_what_was_not_told_are_0_and_empty) {
  wire::JobStatus status;
  (*status.mutable_numbers())["elements"] = 7;
  (*status.mutable_texts())["digest"] = "abc";
  EXPECT_EQ(number_of(status, "elements"), 7);
  EXPECT_EQ(number_of(status, "nodes"), 0);
  EXPECT_EQ(text_of(status, "digest"), "abc");
  EXPECT_EQ(text_of(status, "elements"), "");
}

TEST(ReplyValues, of_a_place_are_its_three_numbers) {
  wire::JobStatus status;
  for (const auto& [name, value] :
       {std::pair{"worst_x", 1.0}, {"worst_y", 2.0}, {"worst_z", 3.0}}) {
    (*status.mutable_numbers())[name] = value;
  }
  EXPECT_THAT(place_of(status, "worst"), ElementsAre(1, 2, 3));
}

TEST(ReplyValues, of_sub_domains_come_by_their_places_in_the_tree) {
  wire::JobStatus status;
  auto& texts = *status.mutable_texts();
  texts["uncut:10"] = "tenth";
  texts["uncut:5"] = "fifth";
  texts["uncut:9"] = "ninth";
  texts["cut_further:6"] = "sixth";
  EXPECT_THAT(said_of_subdomains(status, "uncut:"),
              ElementsAre(Pair("LR", "fifth"), Pair("LLR", "ninth"), Pair("LRL", "tenth")));
  EXPECT_THAT(said_of_subdomains(status, "cut_further:"), ElementsAre(Pair("RL", "sixth")));
}

TEST(ReplyValues, of_names_are_none_for_0) {
  EXPECT_EQ(worker_name(3), "worker-3");
  EXPECT_EQ(worker_name(0), "");
  EXPECT_EQ(subdomain_name(5), "LR");
  EXPECT_EQ(subdomain_name(1), "root");
  EXPECT_EQ(subdomain_name(0), "");
  EXPECT_EQ(region_prefix(2), "region_2_");
}

TEST(ReplyValues, of_an_attempt_are_its_seconds_until_its_end_or_now) {
  wire::AttemptLine attempt;
  attempt.set_started_ms(1000);
  attempt.set_ended_ms(3500);
  EXPECT_EQ(seconds_of(attempt), 2.5);
  attempt.set_ended_ms(0);
  EXPECT_GT(seconds_of(attempt), 1e9) << "since 1970";
}

}  // namespace
}  // namespace tetfarm
