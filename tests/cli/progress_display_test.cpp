#include "cli/progress_display.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "proto/doing.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(ProgressText, says_stage_subdomains_rate_and_time_left) {
  wire::JobStatus status;
  status.set_stage("mesh");
  status.set_leaves_made(63);
  status.set_leaves_meshed(41);
  status.set_elements(2'000'000);
  status.set_estimated_elements(5e6);
  const std::string text = progress_text(status, 1e5);
  EXPECT_THAT(text, HasSubstr("mesh"));
  EXPECT_THAT(text, HasSubstr("41/63 sub-domains"));
  EXPECT_THAT(text, HasSubstr("2.0M tets"));
  EXPECT_THAT(text, HasSubstr("100.0k tets/s"));
  EXPECT_THAT(text, HasSubstr("eta 00:30"));
}

TEST(ProgressText, says_how_many_subdomains_were_improved_at_their_cuts) {
  wire::JobStatus status;
  status.set_stage("cosmetic");
  status.set_leaves_made(4);
  status.set_leaves_meshed(4);
  status.set_leaves_mended(3);
  EXPECT_THAT(progress_text(status, 0), HasSubstr("4/4 sub-domains  3 improved at cuts"));
}

TEST(ProgressText, leaves_out_what_is_not_known) {
  wire::JobStatus status;
  status.set_stage("inspect");
  const std::string text = progress_text(status, 0);
  EXPECT_THAT(text, Not(HasSubstr("sub-domains")));
  EXPECT_THAT(text, Not(HasSubstr("eta")));
}

TEST(ProgressText, time_left_counts_what_running_tasks_have_done) {
  wire::JobStatus status;
  status.set_stage("mesh");
  status.set_leaves_made(1);
  status.set_estimated_elements(4e6);
  status.set_elements_under_way(1e6);
  const std::string text = progress_text(status, 1e5);
  EXPECT_THAT(text, HasSubstr("0/1 sub-domains"));
  EXPECT_THAT(text, Not(HasSubstr(" tets ")));
  EXPECT_THAT(text, HasSubstr("eta 00:30"));
}

TEST(RunningText, says_what_the_longest_running_task_does_that_has_said_something) {
  wire::JobStatus status;
  status.set_stage("mesh");
  status.set_tasks_running(1);
  EXPECT_EQ(running_text(status), "");
  status.add_running()->set_kind("decompose");
  wire::RunningTask& task = *status.add_running();
  task.set_kind("mesh");
  *task.mutable_doing() = doing_message({WorkStage::edges, 3, 312, 1204});
  EXPECT_EQ(running_text(status), "recovery pass 3: 312 of 1,204 edges");
  status.set_tasks_running(2);
  EXPECT_EQ(running_text(status), "recovery pass 3: 312 of 1,204 edges (+1 task)");
  status.set_tasks_running(4);
  status.set_stage("decompose");
  EXPECT_EQ(running_text(status), "mesh recovery pass 3: 312 of 1,204 edges (+3 tasks)");
}

TEST(RunningText, a_coordinator_cannot_steer_the_terminal) {
  wire::JobStatus status;
  wire::RunningTask& task = *status.add_running();
  task.set_kind("a\033[2J");
  task.mutable_doing()->set_stage("\033[31m\nred");
  EXPECT_EQ(running_text(status).find_first_of("\033\n"), std::string::npos);
}

/// Columns of a text whose characters take one each.
std::size_t columns_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

TEST(BarLine, is_no_longer_than_the_terminal_and_says_the_first_text_that_has_room) {
  const std::string whole(70, 'w');
  const std::string part(50, 'p');
  for (const std::size_t columns : {7U, 20U, 60U, 80U, 100U, 200U}) {
    const std::string line = bar_line(0.5, {whole, part}, columns);
    EXPECT_LT(columns_of(line), columns);
    EXPECT_THAT(line, HasSubstr(columns >= 80 ? "ww" : "p")) << columns;
  }
  EXPECT_EQ(columns_of(bar_line(0.5, {whole, part}, 0)), 24U + 1 + 70) << "not known";
}

TEST(BarLine, is_full_by_its_share) {
  EXPECT_EQ(bar_line(0, {"x"}, 7), "──── x");
  EXPECT_EQ(bar_line(0.5, {"x"}, 7), "██── x");
  EXPECT_EQ(bar_line(1, {"x"}, 7), "████ x");
}

TEST(ForecastText, is_there_once_the_surface_is_inspected) {
  wire::JobStatus status;
  EXPECT_EQ(forecast_text(status), "");
  status.set_estimated_elements(2e6);
  for (const auto& [name, value] :
       {std::pair{"parts", 8.0}, std::pair{"forecast_bytes", 1e8},
        std::pair{"forecast_disk_bytes", 2e8}, std::pair{"forecast_seconds", 12.0}}) {
    (*status.mutable_numbers())[name] = value;
  }
  EXPECT_EQ(forecast_text(status),
            "about 2.0 M elements in 8 sub-domains, 100 MB of memory per task, 200 MB of disk, "
            "12 s on one core");
}

TEST(ShortCount, keeps_a_number_short) {
  EXPECT_EQ(short_count(9999), "9999");
  EXPECT_EQ(short_count(12'345), "12.3k");
  EXPECT_EQ(short_count(312.7e6), "312.7M");
  EXPECT_EQ(short_count(1.5e9), "1.50G");
}

TEST(ClockText, shows_hours_only_when_there_are_any) {
  EXPECT_EQ(clock_text(72), "01:12");
  EXPECT_EQ(clock_text(3599), "59:59");
  EXPECT_EQ(clock_text(3600), "1:00:00");
  EXPECT_EQ(clock_text(3723), "1:02:03");
}

TEST(ProgressText, is_a_line_with_columns) {
  wire::JobStatus status;
  status.set_stage("mesh");
  status.set_leaves_made(63);
  status.set_leaves_meshed(41);
  status.set_leaves_mended(2);
  status.set_elements(2'000'000);
  status.set_estimated_elements(5e6);
  status.set_attempts_lost(3);
  EXPECT_EQ(progress_text(status, 1e5),
            "mesh       41/63 sub-domains  2 improved at cuts  2.0M tets  100.0k tets/s  eta 00:30"
            "  3 lost");
  EXPECT_EQ(progress_text(status, 1e5, false),
            "mesh       41/63 sub-domains  2 improved at cuts  2.0M tets  eta 00:30  3 lost");
  status.set_estimated_elements(2e6);
  EXPECT_THAT(progress_text(status, 1e5), Not(HasSubstr("eta"))) << "nothing is left";
  status.set_estimated_elements(5e6);
  status.set_stage("cosmetic");
  EXPECT_THAT(progress_text(status, 1e5), Not(HasSubstr("eta"))) << "no more is meshed";
}

TEST(BarLine, has_a_bar_of_four_to_two_dozen) {
  EXPECT_EQ(columns_of(bar_line(0.5, {"12345"}, 200)), 24U + 1 + 5);
  EXPECT_EQ(columns_of(bar_line(0.5, {"12345"}, 24)), 23U);
  EXPECT_EQ(columns_of(bar_line(0.5, {"12345"}, 11)), 4U + 1 + 5);
  EXPECT_EQ(bar_line(0.5, {"12345"}, 10), "██── 1234");
}

TEST(ShortCount, changes_its_unit_at_its_limits) {
  EXPECT_EQ(short_count(0), "0");
  EXPECT_EQ(short_count(1e4), "10.0k");
  EXPECT_EQ(short_count(1e6), "1.0M");
  EXPECT_EQ(short_count(1e9), "1.00G");
}

/// What a display says of one status after the other.
std::string shown(const std::vector<wire::JobStatus>& statuses, ProgressStyle style) {
  ::testing::internal::CaptureStderr();
  ProgressDisplay display(style);
  for (const wire::JobStatus& status : statuses) display.show(status, 1);
  display.end();
  return ::testing::internal::GetCapturedStderr();
}

TEST(ProgressDisplay, says_a_line_for_each_stage_and_what_is_expected_once) {
  wire::JobStatus inspect;
  inspect.set_stage("inspect");
  wire::JobStatus mesh;
  mesh.set_stage("mesh");
  mesh.set_leaves_made(2);
  mesh.set_estimated_elements(2e6);
  (*mesh.mutable_numbers())["forecast_seconds"] = 12;
  wire::JobStatus later = mesh;
  later.set_leaves_meshed(1);
  const std::string expected =
      "inspect   \n"
      "expected   about 2.0 M elements, 0 B of memory per task, 0 B of disk, 12 s on one core\n"
      "mesh       0/2 sub-domains\n";
  for (const ProgressStyle style : {ProgressStyle::plain, ProgressStyle::automatic}) {
    EXPECT_EQ(shown({inspect, inspect, mesh, later}, style), expected) << "no terminal is there";
  }
  EXPECT_EQ(shown({inspect, mesh}, ProgressStyle::none), "");
}

TEST(ProgressDisplay, says_what_the_longest_task_does) {
  wire::JobStatus status;
  status.set_stage("mesh");
  wire::RunningTask& task = *status.add_running();
  task.set_kind("mesh");
  task.set_attempt(1);
  *task.mutable_doing() = doing_message({WorkStage::edges, 3, 312, 1204});
  wire::JobStatus other_stage = status;
  *other_stage.mutable_running(0)->mutable_doing() = doing_message({WorkStage::faces, 1, 2, 3});
  EXPECT_EQ(shown({status, other_stage}, ProgressStyle::plain),
            "mesh        recovery pass 3: 312 of 1,204 edges\n")
      << "the next line is not due in the same second";
}

TEST(ShareDone, is_that_of_meshing_while_leaves_are_meshed) {
  wire::JobStatus status;
  status.set_stage("mesh");
  status.set_estimated_elements(100);
  status.set_elements(25);
  MeshingRate rate;
  rate.note(status, 0);
  EXPECT_EQ(share_done(status, rate), 0.25);
  for (const char* stage : {"", "inspect", "decompose", "assimilate"}) {
    status.set_stage(stage);
    EXPECT_EQ(share_done(status, rate), 0) << stage;
  }
  for (const char* stage : {"cosmetic", "write", "assemble"}) {
    status.set_stage(stage);
    EXPECT_EQ(share_done(status, rate), 1) << stage;
  }
}

}  // namespace
}  // namespace tetfarm
