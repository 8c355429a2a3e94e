/// Adaptation loops by the built program, with solvers that are shell scripts.
#include <gmock/gmock.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "tests/support/program.h"

namespace tetfarm::test {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

/// A field with a shock, computed by awk; it waits when it is told to.
constexpr const char* solver = R"(
test -f wait && sleep 0.4
awk 'function tanh(z) { return z > 20 ? 1 : z < -20 ? -1 : (exp(2 * z) - 1) / (exp(2 * z) + 1) }
  $1 == "Vertices" { getline; left = $1; n = $1; print "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n" n "\n1 1"; next }
  left > 0 { print tanh(20 * ($1 - 0.5 - 0.1 * $2)); --left }
  END { print "End" }' "$TETFARM_MESH" > "$TETFARM_SOLUTION"
echo "cycle $TETFARM_CYCLE of $TETFARM_CYCLES starts from '$TETFARM_START'"
echo "kept $TETFARM_CYCLE" > figures.txt
)";

class Loop : public testing::Test {
 protected:
  Loop() {
    write("square.xy", "0 0\n1 0\n1 1\n0 1\n");
    write("solve.sh", solver);
    EXPECT_EQ(run({"plane", "square.xy", "--size", "0.2", "-o", "first.mesh"}).code, 0);
  }

  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  void write(const std::string& name, const std::string& text) const {
    write_contents(folder_.path() / name, text);
  }
  void write_job(const std::string& command, const std::string& more = "") const {
    write("job.toml", "mesh = \"first.mesh\"\ncycles = 3\n[solver]\ncommand = \"" + command +
                          "\"\nfiles = [\"solve.sh\"" +
                          (fs::exists(folder_.path() / "wait") ? ", \"wait\"" : "") +
                          "]\nkeep = [\"figures.txt\"]\n" + more + "[adapt]\nvertices = 150\n");
  }
  Ended run(const std::vector<std::string>& words) const {
    return run_program(words, folder_.path());
  }
  static std::vector<std::string> words_for(const std::string& output) {
    return {"loop", "job.toml", "-o", output, "--json", "--progress", "none"};
  }
  Ended loop(const std::string& output) const { return run(words_for(output)); }
  static std::string digest(const Ended& ended) {
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended.code == 0 ? nlohmann::json::parse(ended.out).at("digest") : "";
  }

  TemporaryFolder folder_;
};

TEST_F(Loop, delivers_meshes_solutions_logs_and_kept_files_of_all_cycles) {
  write_job("sh solve.sh");
  const Ended ended = loop("out");
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto result = nlohmann::json::parse(ended.out);
  EXPECT_EQ(result["cycles"], 3);
  EXPECT_NEAR(result["vertices"].get<double>(), 150, 15);
  for (const char* name : {"cycle_01.mesh", "cycle_02.sol", "cycle_03.mesh", "cycles.csv"}) {
    EXPECT_TRUE(fs::exists(folder_.path() / "out" / name)) << name;
  }
  EXPECT_EQ(contents(path("out/cycle_01.log")), "cycle 1 of 3 starts from ''\n");
  EXPECT_EQ(contents(path("out/cycle_03.log")), "cycle 3 of 3 starts from 'start.sol'\n");
  EXPECT_EQ(contents(path("out/cycle_02_figures.txt")), "kept 2\n");
  EXPECT_THAT(contents(path("out/cycles.csv")), testing::StartsWith("cycle,vertices,triangles"));
}

TEST_F(Loop, killed_wherever_it_is_goes_on_to_the_same_bytes) {
  write_job("sh solve.sh");
  const std::string undisturbed = digest(loop("undisturbed"));
  write("wait", "");
  write_job("sh solve.sh");
  for (const int pause_ms : {150, 500, 900}) {
    Program program(words_for("killed"), folder_.path());
    std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
    program.signal(SIGKILL);
    program.wait();
  }
  EXPECT_EQ(digest(loop("killed")), undisturbed);
}

/// A ring of points beside the job file, which is elsewhere than where the loop is started.
TEST_F(Loop, keeps_the_nodes_on_the_spline_of_a_file_that_goes_along) {
  fs::create_directory(path("case"));
  std::string ring;
  for (int i = 0; i < 20; ++i) {
    ring += std::to_string(0.5 + 0.5 * std::cos(i * std::acos(-1) / 10)) + " " +
            std::to_string(0.3 * std::sin(i * std::acos(-1) / 10)) + "\n";
  }
  write("case/ring.xy", ring);
  ASSERT_EQ(run({"plane", "case/ring.xy", "-o", "case/first.mesh"}).code, 0);
  write_job("sh solve.sh");
  const std::string job = contents(path("job.toml"));
  write("case/job.toml", job + "curves = [\"1=spline:ring.xy\"]\n");
  fs::rename(path("solve.sh"), path("case/solve.sh"));
  const Ended ended = run({"loop", "case/job.toml", "-o", "out", "--json", "--progress", "none"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Ended last = run({"adapt", "out/cycle_03.mesh", "--solution", "out/cycle_03.sol", "--curve",
                          "1=spline:case/ring.xy", "-o", "next.mesh"});
  ASSERT_EQ(last.code, 0) << last.err;
  EXPECT_THAT(last.out, testing::ContainsRegex("all [0-9]+ nodes lay on it"));
  fs::remove(path("case/ring.xy"));
  EXPECT_THAT(run({"loop", "case/job.toml", "-o", "again"}).err, HasSubstr("ring.xy"));
}

TEST_F(Loop, counts_the_sources_of_its_job_beside_the_solution) {
  write_job("sh solve.sh");
  const auto vertices_near_source = [this](const std::string& output) {
    EXPECT_EQ(loop(output).code, 0);
    std::istringstream words(contents(path(output + "/cycle_03.mesh")));
    std::string word;
    while (words >> word && word != "Vertices") continue;
    int count = 0;
    int near = 0;
    words >> count;
    for (double x = 0, y = 0, mark = 0; count > 0 && words >> x >> y >> mark; --count) {
      near += std::hypot(x - 0.1, y - 0.9) < 0.05 ? 1 : 0;
    }
    return near;
  };
  EXPECT_LT(vertices_near_source("without"), 6);
  write("job.toml", contents(path("job.toml")) +
                        "[[point]]\nat = [0.1, 0.9]\nsizes = [0.02, 0.02]\nradius = 0.04\n");
  EXPECT_GT(vertices_near_source("with"), 12);
}

TEST_F(Loop, with_a_solver_that_fails_says_what_it_said_and_in_which_cycle) {
  write_job("echo no such fluid; exit 3");
  const Ended failed = loop("out");
  EXPECT_NE(failed.code, 0);
  EXPECT_THAT(failed.err, HasSubstr("cycle 1: the solver ended with exit code 3"));
  EXPECT_THAT(failed.err, HasSubstr("no such fluid"));
  write_job("sleep 60", "time_limit = 1\n");
  EXPECT_THAT(loop("out").err, HasSubstr("did not end within its `time_limit` of 1 second"));
  write_job("true");
  EXPECT_THAT(loop("out").err, HasSubstr("left no file 'solution.sol'"));
  write_job("echo nonsense > solution.sol");
  EXPECT_THAT(loop("out").err, HasSubstr("cycle 1: solution.sol:1"));
}

TEST_F(Loop, is_no_job_of_a_surface_and_says_what_runs_it) {
  write_job("sh solve.sh");
  EXPECT_THAT(run({"run", "job.toml"}).err, HasSubstr("tetfarm loop job.toml -o DIR"));
}

TEST_F(Loop, is_refused_at_once_where_its_files_are_missing) {
  fs::remove(path("solve.sh"));
  write_job("sh solve.sh");
  EXPECT_THAT(loop("out").err, HasSubstr("no such file or folder"));
  write("job.toml", "mesh = \"none.mesh\"\n[solver]\ncommand = \"true\"\n");
  EXPECT_THAT(loop("out").err, HasSubstr("none.mesh"));
}

}  // namespace
}  // namespace tetfarm::test
