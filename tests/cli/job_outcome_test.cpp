#include "cli/job_outcome.h"

#include <gmock/gmock.h>

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

}  // namespace
}  // namespace tetfarm
