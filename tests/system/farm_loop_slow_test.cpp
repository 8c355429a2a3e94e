/// Adaptation loops on a farm: submitted by clients, some of whom see no store.
#include "base/error.h"
#include "tests/system/daemon_farm.h"

namespace tetfarm::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* solver = R"(
test -f slow && sleep 1
awk '$1 == "Vertices" { getline; left = $1; print "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n" $1 "\n1 1"; next }
  left > 0 { d = $1 - 0.3; print 1 / (0.01 + d * d); --left }
  END { print "End" }' "$TETFARM_MESH" > "$TETFARM_SOLUTION"
)";

class FarmLoop : public Daemon {
 protected:
  FarmLoop() {
    write("square.xy", "0 0\n1 0\n1 1\n0 1\n");
    write("solve.sh", solver);
    EXPECT_EQ(
        run_program({"plane", "square.xy", "--size", "0.2", "-o", "first.mesh"}, folder_.path())
            .code,
        0);
    write_job("a", 120);
  }

  void write(const std::string& name, const std::string& text) const {
    write_contents(folder_.path() / name, text);
  }
  void write_job(const std::string& name, int vertices) const {
    const bool is_slow = fs::exists(folder_.path() / "slow");
    write(name + ".toml", std::string("mesh = \"first.mesh\"\ncycles = 3\n[solver]\n"
                                      "command = \"sh solve.sh\"\nfiles = [\"solve.sh\"") +
                              (is_slow ? ", \"slow\"" : "") +
                              "]\n[adapt]\nvertices = " + std::to_string(vertices) + "\n");
  }
  std::string digest_of_local_run(const std::string& name) const {
    const Ended ended =
        run_program({"loop", name + ".toml", "-o", "local_" + name, "--json", "--progress", "none"},
                    folder_.path());
    EXPECT_EQ(ended.code, 0) << ended.err;
    return digest_of(ended);
  }
  std::string submit_loop(const std::string& name, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"submit", name + ".toml"};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = ask(words);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended.out.substr(0, ended.out.find('\n'));
  }
  Ended fetch(const std::string& job, const std::string& folder) {
    return ask({"wait", job, "-o", folder, "--json", "--progress", "none", "--timeout", "60"});
  }
};

TEST_F(FarmLoop, gives_the_bytes_of_a_local_loop_to_a_client_and_workers_that_see_no_store) {
  const std::string local = digest_of_local_run("a");
  const std::string job = submit_loop("a");
  EXPECT_EQ(submit_loop("a", {"--store", "store"}), job) << "the same loop is the same job";
  const auto surfaces_only = start_worker();
  pause_ms(500);
  EXPECT_THAT(ask({"explain", "1"}).out, HasSubstr("started without --solvers"));
  const Program worker({"worker", "--connect", endpoint_, "--no-shared-store", "--solvers"},
                       folder_.path());
  const Ended ended = fetch(job, "fetched");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(digest_of(ended), local);
  EXPECT_TRUE(fs::exists(folder_.path() / "fetched" / "cycle_03.mesh"));
  EXPECT_EQ(contents(folder_.path() / "fetched" / "cycles.csv"),
            contents(folder_.path() / "local_a" / "cycles.csv"));
}

TEST_F(FarmLoop, several_run_side_by_side_and_outlive_killed_workers) {
  write_job("b", 200);
  const std::string local_a = digest_of_local_run("a");
  const std::string local_b = digest_of_local_run("b");
  write("slow", "");
  write_job("a", 120);
  write_job("b", 200);
  const std::string a = submit_loop("a");
  const std::string b = submit_loop("b");
  auto victim = start_worker({"--solvers"});
  const auto other = start_worker({"--solvers"});
  EXPECT_TRUE(comes_true([](const std::vector<AttemptRow>& all) { return all.size() > 1; }));
  victim->signal(SIGKILL);
  victim->wait();
  const auto third = start_worker({"--solvers"});
  EXPECT_EQ(digest_of(fetch(a, "a")), local_a);
  EXPECT_EQ(digest_of(fetch(b, "b")), local_b);
}

TEST_F(FarmLoop, is_refused_with_options_for_surfaces) {
  const Ended ended = ask({"submit", "a.toml", "--size", "0.1"});
  EXPECT_EQ(ended.code, static_cast<int>(ExitCode::usage));
  EXPECT_THAT(ended.err, HasSubstr("--size"));
  EXPECT_THAT(ended.err, HasSubstr("adaptation loop"));
}

}  // namespace
}  // namespace tetfarm::test
