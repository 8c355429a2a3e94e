#include "cli/job_outcome.h"

#include <gmock/gmock.h>

#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Property;
using ::testing::Throws;
using ::testing::ThrowsMessage;

wire::JobStatus ended_as(const std::string& state) {
  wire::JobStatus status;
  status.set_state(state);
  status.set_message("open edge");
  status.set_exit_code(3);
  return status;
}

/// Of a job with a gate of 10 degrees.
ExitCode code_of_mesh_with(double smallest_deg) {
  wire::JobStatus status = ended_as("done");
  (*status.mutable_numbers())["min_dihedral_deg"] = smallest_deg;
  (*status.mutable_numbers())["min_dihedral_gate_deg"] = 10;
  ::testing::internal::CaptureStderr();
  const ExitCode code = report_outcome(status, {});
  ::testing::internal::GetCapturedStderr();
  return code;
}

TEST(JobOutcome, an_angle_at_the_gate_passes_and_one_below_does_not) {
  EXPECT_EQ(code_of_mesh_with(10.5), ExitCode::ok);
  EXPECT_EQ(code_of_mesh_with(10), ExitCode::ok);
  EXPECT_EQ(code_of_mesh_with(9.99), ExitCode::gate);
}

TEST(JobOutcome, of_a_failed_job_is_its_exit_code_with_the_files_that_show_why) {
  OutcomeOptions options;
  options.files = {std::filesystem::current_path() / "wing.defects.vtp"};
  EXPECT_THAT([&] { report_outcome(ended_as("failed"), options); },
              AllOf(Throws<Error>(Property(&Error::code, ExitCode::bad_geometry)),
                    ThrowsMessage<Error>(HasSubstr("open edge\n  see wing.defects.vtp"))));
}

TEST(JobOutcome, of_a_cancelled_job_is_an_error) {
  EXPECT_THAT([&] { report_outcome(ended_as("cancelled"), {}); },
              Throws<Error>(Property(&Error::code, ExitCode::failed)));
}

TEST(JobOutcome, a_job_that_waits_for_room_has_not_ended) {
  for (const char* state : {"done", "failed", "cancelled"}) {
    EXPECT_TRUE(has_ended(ended_as(state))) << state;
  }
  for (const char* state : {"running", "stuck", ""}) EXPECT_FALSE(has_ended(ended_as(state)));
}

TEST(JobOutcome, of_a_mesh_below_its_gates_says_which_and_ends_with_a_code_of_its_own) {
  wire::JobStatus status = ended_as("done");
  auto& numbers = *status.mutable_numbers();
  numbers["min_dihedral_deg"] = 3;
  numbers["min_dihedral_gate_deg"] = 5;
  numbers["unforced_elements"] = 7;
  numbers["unforced_min_dihedral_deg"] = 3;
  numbers["min_unforced_dihedral_gate_deg"] = 4;
  OutcomeOptions options;
  options.json = true;
  const Said said = said_by([&] { return report_outcome(status, options); });
  EXPECT_EQ(said.code, ExitCode::gate);
  const std::size_t first = said.err.find("error: the smallest dihedral angle is 3.00 deg");
  const std::size_t second = said.err.find("error: where the surface forces no small angles");
  EXPECT_EQ(first, 0U);
  EXPECT_LT(first, second);
  EXPECT_NE(second, std::string::npos);
  numbers["min_dihedral_gate_deg"] = 0;
  EXPECT_EQ(said_by([&] { return report_outcome(status, options); }).code, ExitCode::gate)
      << "one of them is enough";
}

TEST(JobOutcome, is_told_to_people_on_standard_error_and_to_programs_on_standard_output) {
  OutcomeOptions options;
  options.seconds = 72;
  options.files = {"/elsewhere/wing.vtkhdf"};
  const Said text = said_by([&] { return report_outcome(ended_as("done"), options); });
  EXPECT_EQ(text.code, ExitCode::ok);
  EXPECT_EQ(text.out, "");
  EXPECT_THAT(text.err, HasSubstr("   01:12\n"));
  EXPECT_THAT(text.err, HasSubstr("           /elsewhere/wing.vtkhdf\n"));
  options.json = true;
  const Said json = said_by([&] { return report_outcome(ended_as("done"), options); });
  EXPECT_EQ(json.err, "");
  EXPECT_THAT(json.out, HasSubstr("\"seconds\":72.0,"));
  EXPECT_THAT(json.out, HasSubstr("\"files\":[\"/elsewhere/wing.vtkhdf\"]}\n"));
}

TEST(JobOutcome, of_a_failure_names_all_files_those_elsewhere_by_their_whole_paths) {
  OutcomeOptions options;
  options.files = {std::filesystem::current_path() / "out" / "a.vtp", "/elsewhere/b\n.vtp"};
  const Said said = said_by([&] { return report_outcome(ended_as("failed"), options); });
  EXPECT_EQ(said.error, "open edge\n  see out/a.vtp\n  see /elsewhere/b\\n.vtp");
  EXPECT_EQ(said_by([&] { return report_outcome(ended_as("cancelled"), {}); }).error,
            "the job was cancelled: open edge");
}

}  // namespace
}  // namespace tetfarm
