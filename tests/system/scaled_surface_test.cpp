// Surfaces in other units than their jobs, through the whole program to the mesh.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/support/shapes.h"
#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::digest_of;
using test::Ended;
using test::run_program;
using test::TemporaryFolder;
using ::testing::HasSubstr;

class RunOfAScaledSurface : public ::testing::Test {
 protected:
  RunOfAScaledSurface() {
    test::write_contents(folder_.path() / "ball.off",
                         test::off_of(shapes::sphere({0, 0, 0}, 100, 2)));
    test::write_contents(folder_.path() / "job.toml",
                         "name = \"ball\"\n[geometry]\nsurface = \"ball.off\"\nunit = \"cm\"\n"
                         "[spacing]\ndefault = 0.2\n");
  }
  Ended done(const std::vector<std::string>& words) {
    const Ended ended = run_program(words, folder_.path(), 60);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended;
  }

  TemporaryFolder folder_;
};

TEST_F(RunOfAScaledSurface, is_that_of_the_converted_surface) {
  done({"convert", "ball.off", "small.off", "--scale", "0.01"});
  const Ended small = done({"run", "small.off", "--size", "0.2", "-o", "small", "--json"});
  const Ended scaled =
      done({"run", "ball.off", "--scale", "0.01", "--size", "0.2", "-o", "scaled", "--json"});
  const Ended in_cm = done({"run", "job.toml", "-o", "in_cm", "--json"});
  EXPECT_EQ(digest_of(scaled), digest_of(small));
  EXPECT_EQ(digest_of(in_cm), digest_of(small));
  EXPECT_THAT(in_cm.err, HasSubstr("lengths    m, of a surface in cm\n"));
}

TEST_F(RunOfAScaledSurface, is_what_other_commands_tell_of_it) {
  EXPECT_THAT(done({"check", "job.toml"}).out,
              testing::AllOf(HasSubstr("lengths         m, of a surface in cm\n"),
                             HasSubstr(" m^3\n"), HasSubstr(" m shortest, ")));
  const auto plan = nlohmann::json::parse(done({"plan", "job.toml", "--json"}).out);
  EXPECT_EQ(plan.at("unit"), "m");
  EXPECT_EQ(plan.at("scale"), 0.01);
  const auto scaled = nlohmann::json::parse(
      done({"plan", "ball.off", "--scale", "0.01", "--size", "0.2", "--json"}).out);
  EXPECT_EQ(scaled.at("estimated_elements"), plan.at("estimated_elements"));
  EXPECT_EQ(scaled.count("unit"), 0U);
}

TEST_F(RunOfAScaledSurface, begins_with_a_job_file_in_its_unit) {
  const std::string text = done({"init", "ball.off", "--unit", "cm", "-o", "-"}).out;
  EXPECT_THAT(text, HasSubstr("\nunit = \"cm\"\n"));
  EXPECT_THAT(text, HasSubstr("box 2 x 2 x 2"));
  EXPECT_THAT(text, HasSubstr("surface's file is in"));
}

TEST_F(RunOfAScaledSurface, is_remeshed_in_the_lengths_of_its_job) {
  done({"surface", "job.toml", "--size", "0.1", "-o", "fine.off"});
  const auto check = nlohmann::json::parse(done({"check", "fine.off", "--json"}).out);
  EXPECT_NEAR(check.at("median_edge").get<double>(), 0.1, 0.02);
  const Ended run =
      done({"run", "job.toml", "--remesh", "--size-on-body", "0.3", "-o", "out", "--json"});
  EXPECT_NEAR(nlohmann::json::parse(run.out).at("volume").get<double>(), 4.1, 0.3);
}

}  // namespace
}  // namespace tetfarm
