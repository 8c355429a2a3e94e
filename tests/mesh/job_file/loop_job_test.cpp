#include "mesh/job_file/loop_job.h"

#include <gmock/gmock.h>

#include "base/error.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;

constexpr const char* whole = R"(version = 1
name = "wing"
mesh = "first.msh"
cycles = 4
patch_names = ["1 upper side", "7 far"]

[solver]
command = "sh run.sh \"$TETFARM_MESH\""
files = ["run.sh", "system"]
mesh = "case/"
solution = "out/mach.sol"
start = "before.sol"
time_limit = 90
memory = "2GiB"
keep = ["cp.csv"]

[adapt]
vertices = 5000
fields = [2, 1]
mode = "hessian"
norm = 4
h_min = 1e-4
h_max = 2
aspect = 100
gradation = "off"
corner_angle = 45
curves = ["1=naca0012"]
transfer = "linear"
)";

std::string refusal(const std::string& text) {
  try {
    parse_loop_job(text, "loop.toml");
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(LoopJob, has_what_is_written_and_defaults_for_the_rest) {
  const LoopJob job = parse_loop_job(whole, "runs/loop.toml");
  EXPECT_EQ(job.name, "wing");
  EXPECT_EQ(job.mesh, "runs/first.msh") << "beside the job file";
  EXPECT_EQ(job.cycles, 4);
  EXPECT_EQ(job.patch_names.at(1), "upper side");
  EXPECT_EQ(job.solver.command, "sh run.sh \"$TETFARM_MESH\"");
  EXPECT_THAT(job.solver.files, ElementsAre("run.sh", "system"));
  EXPECT_EQ(job.solver.mesh, "case/");
  EXPECT_EQ(job.solver.solution, "out/mach.sol");
  EXPECT_EQ(job.solver.time_limit_s, 90);
  EXPECT_EQ(job.solver.memory_bytes, std::int64_t{1} << 31U);
  EXPECT_THAT(job.solver.keep, ElementsAre("cp.csv"));
  EXPECT_EQ(job.adapt.vertices, 5000);
  EXPECT_THAT(job.adapt.fields, ElementsAre(2, 1));
  EXPECT_EQ(job.adapt.mode, "hessian");
  EXPECT_EQ(job.adapt.gradation, 0);
  EXPECT_THAT(job.adapt.curves, ElementsAre("1=naca0012"));
  EXPECT_EQ(job.adapt.transfer, "linear");
  const LoopJob least =
      parse_loop_job("mesh = \"m.mesh\"\n[solver]\ncommand = \"solve\"\n", "runs/shock.toml");
  EXPECT_EQ(least.name, "shock");
  EXPECT_EQ(least.cycles, 6);
  EXPECT_EQ(least.solver.mesh, "mesh.mesh");
  EXPECT_EQ(least.solver.solution, "solution.sol");
  EXPECT_EQ(least.adapt.vertices, std::nullopt);
  EXPECT_EQ(least.adapt.gradation, 1.4);
  EXPECT_EQ(least.adapt.transfer, "conservative");
}

TEST(LoopJob, is_the_same_after_it_was_written_and_read) {
  for (const char* text : {whole, "mesh = \"m.mesh\"\n[solver]\ncommand = \"solve\"\n"}) {
    const std::string once = to_toml(parse_loop_job(text, "loop.toml"));
    EXPECT_EQ(to_toml(parse_loop_job(once, "loop.toml")), once);
  }
}

TEST(LoopJob, has_point_and_line_sources_beside_the_solution) {
  const std::string text = std::string(whole) +
                           "[[line]]\nfrom = [0, 0]\nto = [1, 0]\nsizes = [1, 0.1]\nradius = 2\n"
                           "[[point]]\nat = [3, 4]\nsizes = [1, 1]\nradius = 2\n";
  const LoopJob job = parse_loop_job(to_toml(parse_loop_job(text, "loop.toml")), "loop.toml");
  ASSERT_EQ(job.adapt.sources.size(), 2U);
  EXPECT_TRUE(job.adapt.sources[0].is_line);
  EXPECT_EQ(job.adapt.sources[0].sizes[1], 0.1);
  EXPECT_EQ(job.adapt.sources[1].from[1], 4);
  EXPECT_THAT(refusal(text + "[[point]]\nat = [3, 4]\nsizes = [1, -1]\nradius = 2\n"),
              testing::HasSubstr("`sizes` must be positive"));
}

TEST(LoopJob, is_told_from_a_job_of_a_surface_by_its_solver) {
  EXPECT_TRUE(is_loop_job(whole, "loop.toml"));
  EXPECT_FALSE(is_loop_job("[geometry]\nsurface = \"a.stl\"\n", "job.toml"));
  EXPECT_THROW(is_loop_job("[solver", "job.toml"), UsageError);
}

TEST(LoopJob, says_what_is_wrong_and_where) {
  const std::string start = "mesh = \"m.mesh\"\n[solver]\ncommand = \"solve\"\n";
  EXPECT_EQ(refusal("mesh = \"m.mesh\"\n"), "loop.toml:1:1: `solver` is missing");
  EXPECT_THAT(refusal(start + "comand = \"x\"\n"), testing::HasSubstr("did you mean"));
  EXPECT_THAT(refusal(start + "solution = \"../u.sol\"\n"),
              testing::HasSubstr("loop.toml:4:12: `solution`"));
  EXPECT_THAT(refusal(start + "keep = [\"/etc/passwd\"]\n"),
              testing::HasSubstr("must name a file in the solver's own folder"));
  EXPECT_THAT(refusal(start + "time_limit = 0\n"), testing::HasSubstr("`time_limit`"));
  EXPECT_THAT(refusal(start + "[adapt]\ngradation = 0.9\n"), testing::HasSubstr("`gradation`"));
  EXPECT_THAT(refusal(start + "[adapt]\nh_min = 2\nh_max = 1\n"),
              testing::HasSubstr("must not be less than `h_min`"));
  EXPECT_THAT(refusal(start + "[adapt]\nfields = [0]\n"), testing::HasSubstr("`fields`"));
  EXPECT_THAT(refusal("cycles = 1000\n" + start), testing::HasSubstr("`cycles`"));
  EXPECT_THAT(refusal("patch_names = [\"one\"]\n" + start), testing::HasSubstr("`patch_names`"));
}

}  // namespace
}  // namespace tetfarm
