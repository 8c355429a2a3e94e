#include "cli/job_report.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::Not;

wire::JobStatus status_of_leaf_left_whole() {
  wire::JobStatus status;
  (*status.mutable_texts())["digest"] = "d";
  (*status.mutable_texts())["uncut:5"] = "36 candidates refused: angle 30, intersection 6";
  return status;
}

TEST(JobReport, says_which_subdomain_could_not_be_cut_and_why) {
  const std::string text = result_text(status_of_leaf_left_whole(), 1, {});
  EXPECT_THAT(text, HasSubstr("sub-domain LR is larger than wanted"));
  EXPECT_THAT(text, HasSubstr("36 candidates refused: angle 30, intersection 6"));
  EXPECT_THAT(result_json(status_of_leaf_left_whole(), 1, {}),
              HasSubstr(R"("uncut_subdomains":{"LR":"36 candidates refused)"));
}

TEST(JobReport, says_which_subdomain_was_cut_further_and_why) {
  wire::JobStatus status;
  (*status.mutable_texts())["cut_further:5"] = "mesh of sub-domain 5 was out of memory";
  EXPECT_THAT(result_text(status, 1, {}),
              HasSubstr("sub-domain LR was cut further than planned: mesh of sub-domain 5 was"));
  const std::string json = R"("cut_further":{"LR":"mesh of sub-domain 5 was out of memory"})";
  EXPECT_THAT(result_json(status, 1, {}), HasSubstr(json));
  EXPECT_THAT(status_json(status), HasSubstr(json));
}

TEST(JobReport, is_silent_when_all_were_cut) {
  EXPECT_THAT(result_text(wire::JobStatus(), 1, {}), Not(HasSubstr("larger than wanted")));
}

}  // namespace
}  // namespace tetfarm
