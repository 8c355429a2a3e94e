// Small angles from outside: what is remarked, what ends a job with 4, and what a plan learns.
#include <gmock/gmock.h>

#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::run_program;
using test::TemporaryFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// A box on the top of which a vertex has come near to its neighbour.
SurfaceMesh box_with_needles() {
  SurfaceMesh box = shapes::box({0, 0, 0}, {6, 6, 6}, 6);
  for (Vec3& v : box.vertices) {
    if (v == Vec3{3, 3, 6}) v.x = 4 - 1e-5;
  }
  return box;
}

class SmallAnglesOfAJob : public ::testing::Test {
 protected:
  SmallAnglesOfAJob() {
    test::write_contents(folder_.path() / "needles.off", test::off_of(box_with_needles()));
    test::write_contents(folder_.path() / "good.off",
                         test::off_of(shapes::box({0, 0, 0}, {6, 6, 6}, 6)));
  }
  Ended run(const std::vector<std::string>& words) { return run_program(words, folder_.path()); }
  Ended run_job(const std::string& quality) {
    test::write_contents(folder_.path() / "job.toml",
                         "[geometry]\nsurface = \"needles.off\"\n[quality]\n" + quality + "\n");
    return run({"run", "job.toml", "-j", "1", "-o", "out", "--json", "--progress", "none"});
  }
  const TemporaryFolder folder_;
};

TEST_F(SmallAnglesOfAJob, check_says_how_many_where_and_what_they_force) {
  const Ended text = run({"check", "needles.off"});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("triangles have an angle below 5 deg"));
  EXPECT_THAT(text.out, HasSubstr("of them below 1 deg; the smallest: triangle "));
  EXPECT_THAT(text.out, HasSubstr("remesh the surface near (3.99999"));
  EXPECT_THAT(text.out, HasSubstr("smallest angle  0.000"));
  const nlohmann::json json = test::result_of(run({"check", "needles.off", "--json"}));
  EXPECT_GE(json["angles"]["triangles_below_1_deg"], 2);
  EXPECT_LT(json["angles"]["smallest_angle_deg"], 0.001);
  EXPECT_GT(json["angles"]["worst"].size(), 0U);
  EXPECT_GT(json["remarks"].size(), 0U);
  const Ended good = run({"check", "good.off"});
  EXPECT_THAT(good.out, Not(HasSubstr("remark")));
}

TEST_F(SmallAnglesOfAJob, run_says_it_with_the_result_and_in_digits_that_tell) {
  const Ended text = run({"run", "needles.off", "-j", "1", "-o", "out", "--progress", "none"});
  EXPECT_EQ(text.code, 0) << "the surface forces the small angles\n" << text.err;
  EXPECT_THAT(text.err, AllOf(Not(HasSubstr("dihedral 0.00 to")), HasSubstr("dihedral 0.")));
  EXPECT_THAT(text.err, HasSubstr("triangles have an angle below 5 deg"));
  EXPECT_THAT(text.err, HasSubstr("remesh the surface near (3.99999"));
  EXPECT_THAT(text.err, HasSubstr("where the surface forces no small angles: smallest dihedral "));
  EXPECT_THAT(text.err, Not(HasSubstr("\033"))) << "colour, where there is no terminal";
  const nlohmann::json result = test::result_of(
      run({"run", "needles.off", "-j", "1", "-o", "out", "--json", "--progress", "none"}));
  EXPECT_LT(result["min_dihedral_deg"], 1);
  EXPECT_GT(result["unforced"]["min_dihedral_deg"], 5);
  EXPECT_LT(result["unforced"]["elements"], result["elements"]);
  EXPECT_GE(result["surface"]["triangles_below_5_deg"], 2);
  EXPECT_EQ(result["surface"]["worst"][0]["patch"], "surface");
  EXPECT_GT(result["remarks"].size(), 0U);
  ASSERT_EQ(result["gates"].size(), 2U);
  EXPECT_EQ(result["gates"][1]["key"], "min_unforced_dihedral");
  EXPECT_EQ(result["gates"][1]["limit_deg"], 0.1);
  EXPECT_EQ(result["gates"][1]["passed"], true);
}

TEST_F(SmallAnglesOfAJob, a_gate_on_all_angles_counts_forced_ones) {
  const Ended ended = run_job("min_dihedral = 5");
  EXPECT_EQ(ended.code, 4) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("the smallest dihedral angle is 0."));
  EXPECT_THAT(ended.err, HasSubstr("the job's gate is 5.00 deg"));
}

TEST_F(SmallAnglesOfAJob, the_gate_on_unforced_angles_does_not) {
  EXPECT_EQ(run_job("min_unforced_dihedral = 5").code, 0);
  const Ended ended = run_job("min_unforced_dihedral = 60");
  EXPECT_EQ(ended.code, 4) << ended.err;
  EXPECT_THAT(ended.err,
              HasSubstr("error: where the surface forces no small angles, the smallest dihedral"));
  EXPECT_THAT(ended.err, HasSubstr("the job's gate is 60.00 deg"));
  EXPECT_THAT(ended.err, HasSubstr("help: the mesh is complete"));
  EXPECT_EQ(test::result_of(ended)["gates"][1]["passed"], false);
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / "job.vtkhdf"));
}

TEST_F(SmallAnglesOfAJob, do_not_depend_on_how_it_was_cut) {
  std::vector<nlohmann::json> results;
  for (const char* subdomains : {"1", "3"}) {
    results.push_back(
        test::result_of(run({"run", "needles.off", "-j", "2", "-o", subdomains, "--subdomains",
                             subdomains, "--json", "--progress", "none"})));
    EXPECT_GT(results.back()["unforced"]["min_dihedral_deg"], 5);
    EXPECT_LT(results.back()["min_dihedral_deg"], 5);
  }
  EXPECT_EQ(results[0]["surface"], results[1]["surface"]);
}

TEST_F(SmallAnglesOfAJob, a_plan_counts_needles_and_says_how_sure_it_is) {
  const Ended text = run({"plan", "needles.off"});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr(" s on one core, most likely "));
  EXPECT_THAT(text.out, HasSubstr("triangles have an angle below 15 deg, which may take most"));
  const nlohmann::json good = test::result_of(run({"plan", "good.off", "--json"}));
  const nlohmann::json bad = test::result_of(run({"plan", "needles.off", "--json"}));
  EXPECT_EQ(good["needles"], 0);
  EXPECT_GE(bad["needles"], 2);
  EXPECT_GT(bad["tasks"]["mesh"]["seconds"], good["tasks"]["mesh"]["seconds"]);
  for (const nlohmann::json& plan : {good, bad}) {
    EXPECT_LT(plan["seconds_low"], plan["seconds"]);
    EXPECT_GT(plan["seconds_high"], plan["seconds"]);
    EXPECT_EQ(plan["learnt_from_tasks"], 0);
  }
}

TEST_F(SmallAnglesOfAJob, a_plan_learns_from_what_a_run_took) {
  const std::vector<std::string> words = {"run",    "good.off",   "-j",           "1",
                                          "-o",     "out",        "--subdomains", "4",
                                          "--json", "--progress", "none"};
  ASSERT_EQ(run(words).code, 0);
  const nlohmann::json before =
      test::result_of(run({"plan", "good.off", "--subdomains", "4", "--json"}));
  const nlohmann::json after =
      test::result_of(run({"plan", "good.off", "--subdomains", "4", "--json", "--store", "out"}));
  EXPECT_GT(after["learnt_from_tasks"], 10);
  EXPECT_NE(after["seconds"], before["seconds"]);
  EXPECT_EQ(after["estimated_elements"], before["estimated_elements"]);
  const Ended text = run({"plan", "good.off", "--store", "out"});
  EXPECT_THAT(text.out, HasSubstr("times from "));
  const Ended nowhere = run({"plan", "good.off", "--store", "."});
  EXPECT_EQ(nowhere.code, 5);
  EXPECT_THAT(nowhere.err, HasSubstr("is neither a store nor the output folder of a run"));
}

}  // namespace
}  // namespace tetfarm
