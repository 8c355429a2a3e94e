#include "cli/typed_names.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace tetfarm {
namespace {

/// What a job that failed says to who typed "in/wing.stl.gz", and a limit of memory or none.
std::string said(const std::string& message, ExitCode code, const std::string& max_memory = "",
                 const std::string& state = "failed") {
  JobInput input;
  input.job.surface = "wing.stl";
  input.path = "in/wing.stl.gz";
  RunOptions options;
  options.max_memory = max_memory;
  wire::JobStatus end;
  end.set_state(state);
  end.set_exit_code(static_cast<int>(code));
  end.set_message(message);
  name_as_typed(end, options, input);
  return end.message();
}

TEST(TypedNames, of_a_surface_have_its_path) {
  EXPECT_EQ(said("inspect: wing.stl: open edge", ExitCode::bad_geometry),
            "in/wing.stl.gz: open edge");
  EXPECT_EQ(said("remesh: wing.stl: open edge", ExitCode::bad_geometry),
            "in/wing.stl.gz: open edge");
  EXPECT_EQ(said("inspect: open edge", ExitCode::bad_geometry), "in/wing.stl.gz: open edge");
}

TEST(TypedNames, of_a_limit_of_memory_are_those_of_the_command_line_where_it_was_given_there) {
  const std::string message = "inspect: [decompose] max_memory: too small";
  EXPECT_EQ(said(message, ExitCode::usage, "1MB"), "--max-memory 1MB: too small");
  EXPECT_EQ(said(message, ExitCode::usage), "[decompose] max_memory: too small");
  EXPECT_EQ(said("inspect: spacing: too many", ExitCode::usage, "1MB"), "spacing: too many");
}

TEST(TypedNames, of_layers_are_those_of_the_command_line_where_they_were_given_there) {
  JobInput input;
  RunOptions options;
  wire::JobStatus end;
  const auto said_of_layers = [&] {
    end.set_state("failed");
    end.set_exit_code(static_cast<int>(ExitCode::usage));
    end.set_message("inspect: [[layers]] of \"a\": too high");
    name_as_typed(end, options, input);
    return end.message();
  };
  EXPECT_EQ(said_of_layers(), "[[layers]] of \"a\": too high");
  options.layers = {"a:first=1"};
  EXPECT_EQ(said_of_layers(), "--layers of \"a\": too high");
}

TEST(TypedNames, are_left_to_other_tasks_and_other_ends) {
  const std::string message = "mesh: wing.stl: lost";
  EXPECT_EQ(said(message, ExitCode::bad_geometry), message);
  const std::string inspect = "inspect: wing.stl: open edge";
  EXPECT_EQ(said(inspect, ExitCode::bad_geometry, "", "cancelled"), inspect);
}

}  // namespace
}  // namespace tetfarm
