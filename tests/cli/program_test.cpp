// The built program from outside: exit codes, where messages go, and what they say.
#include <gmock/gmock.h>

#include "tests/support/program.h"

namespace tetfarm {
namespace {

using test::contents;
using test::Ended;
using test::run_program;
using test::TemporaryFolder;
using test::write_contents;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

/// The unit cube in OFF, its eight corners numbered as x + 2 y + 4 z.
std::string cube_off(const std::string& last_triangle) {
  std::string text = "OFF\n8 12 0\n";
  for (int i = 0; i < 8; ++i) {
    text += std::to_string(i & 1) + " " + std::to_string(i >> 1 & 1) + " " +
            std::to_string(i >> 2 & 1) + "\n";
  }
  text += "3 0 2 3\n3 0 3 1\n3 4 5 7\n3 4 7 6\n3 0 1 5\n3 0 5 4\n3 2 6 7\n3 2 7 3\n";
  text += "3 0 4 6\n3 0 6 2\n3 1 3 7\n" + last_triangle;
  return text;
}

const char* const cube_end = "3 1 7 5\n";

TEST(TetfarmProgram, makes_a_shape_that_it_finds_sound_itself) {
  const TemporaryFolder folder;
  for (const char* file : {"a.stl", "b.stl"}) {
    const Ended made =
        run_program({"shape", "duct", "-o", file, "--spacing", "0.25"}, folder.path());
    EXPECT_EQ(made.code, 0) << made.err;
    EXPECT_THAT(made.err, HasSubstr("triangles"));
    EXPECT_THAT(made.out, IsEmpty());
  }
  EXPECT_EQ(contents(folder.path() / "a.stl"), contents(folder.path() / "b.stl"));
  const Ended checked = run_program({"check", "a.stl", "--json"}, folder.path());
  EXPECT_EQ(checked.code, 0);
  EXPECT_THAT(checked.out, HasSubstr("\"patches\":[\"inlet\",\"wall\",\"outlet\"]"));
}

TEST(TetfarmProgram, refuses_a_shape_that_it_does_not_know_or_cannot_write) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_program({"shape", "teapot", "-o", "a.stl"}, folder.path()).code, 2);
  EXPECT_EQ(run_program({"shape", "duct", "-o", "a.obj"}, folder.path()).code, 2);
  EXPECT_EQ(run_program({"shape", "duct"}, folder.path()).code, 2);
  EXPECT_EQ(run_program({"shape", "wing", "-o", "a.off", "--spacing", "9"}, folder.path()).code, 2);
}

TEST(TetfarmProgram, mistakes_on_the_command_line_end_with_2_and_a_hint) {
  const TemporaryFolder folder;
  const Ended ended = run_program({"run"}, folder.path());
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, StartsWith("error: "));
  EXPECT_THAT(ended.err, HasSubstr("help: "));
  EXPECT_THAT(ended.out, IsEmpty());
}

TEST(TetfarmProgram, help_of_each_command_has_an_example) {
  const TemporaryFolder folder;
  for (const char* name : {"run", "check", "quality", "export", "convert", "submit", "status",
                           "wait", "cancel", "coordinator", "worker"}) {
    const Ended ended = run_program({name, "--help"}, folder.path());
    EXPECT_EQ(ended.code, 0) << name;
    EXPECT_THAT(ended.out, HasSubstr("Example: tetfarm ")) << name;
  }
}

TEST(TetfarmProgram, sources_of_a_flite_file_make_the_mesh_finer) {
  const TemporaryFolder folder;
  write_contents(folder.path() / "cube.off", cube_off(cube_end));
  const std::string job = "[geometry]\nsurface = \"cube.off\"\n";
  write_contents(folder.path() / "plain.toml", job);
  write_contents(folder.path() / "fine.toml", job + "[spacing]\nsources = \"s.ba3\"\n");
  write_contents(folder.path() / "s.ba3", "t\n0 0 1 0 0\n*\n1\n0.5 0.5 0.5 0.05 0.2 0.4\n");
  const auto elements = [&](const char* file) {
    const Ended plan = run_program({"plan", file, "--json"}, folder.path());
    EXPECT_EQ(plan.code, 0) << plan.err;
    const std::string key = "\"estimated_elements\":";
    const std::size_t at = plan.out.find(key);
    return at == std::string::npos ? 0 : std::stod(plan.out.substr(at + key.size()));
  };
  EXPECT_GT(elements("fine.toml"), 2 * elements("plain.toml"));
  write_contents(folder.path() / "s.ba3", "t\n0 0 1 0 0\n*\n1\n0.5 0.5 0.5 0 0.2 0.4\n");
  const Ended refused = run_program({"plan", "fine.toml"}, folder.path());
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, HasSubstr("s.ba3:5: a spacing must be more than 0"));
}

TEST(TetfarmProgram, quality_of_a_mesh_of_hexes_tells_nothing_of_tets) {
  const TemporaryFolder folder;
  write_contents(folder.path() / "box.msh",
                 "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n1 0 0 0\n2 2 0 0\n3 2 1 0\n"
                 "4 0 1 0\n5 0 0 1\n6 2 0 1\n7 2 1 1\n8 0 1 1\n$EndNodes\n$Elements\n7\n"
                 "1 3 2 1 1 1 4 3 2\n2 3 2 1 1 5 6 7 8\n3 3 2 1 1 1 2 6 5\n4 3 2 1 1 2 3 7 6\n"
                 "5 3 2 1 1 3 4 8 7\n6 3 2 1 1 4 1 5 8\n7 5 2 1 1 1 2 3 4 5 6 7 8\n"
                 "$EndElements\n");
  const Ended ended = run_program({"quality", "box.msh"}, folder.path());
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("hexes           1, volume 2, scaled Jacobian 1.0000 mean"));
  for (const char* of_tets : {"dihedral", "radius ratio", "time step", "worst tets"}) {
    EXPECT_THAT(ended.out, Not(HasSubstr(of_tets)));
  }
  const Ended report = run_program({"report", "box.msh", "-o", "box.html"}, folder.path());
  EXPECT_EQ(report.code, 0) << report.err;
  EXPECT_THAT(report.err, HasSubstr("box.html: 1 hex\n"));
}

TEST(TetfarmProgram, a_surface_that_is_not_there_is_not_found) {
  const TemporaryFolder folder;
  for (const char* name : {"run", "check"}) {
    const Ended ended = run_program({name, "nowhere.stl"}, folder.path());
    EXPECT_EQ(ended.code, 5) << name;
    EXPECT_THAT(ended.err, HasSubstr("nowhere.stl")) << name;
  }
}

TEST(TetfarmProgram, a_wrong_job_file_is_a_usage_error_with_its_line) {
  const TemporaryFolder folder;
  write_contents(folder.path() / "job.toml", "version = 1\n[geometry]\nsurfface = \"a.stl\"\n");
  const Ended ended = run_program({"check", "job.toml"}, folder.path());
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("job.toml:3"));
}

TEST(TetfarmProgram, a_broken_surface_file_is_bad_geometry_with_its_line) {
  const TemporaryFolder folder;
  write_contents(folder.path() / "bad.off", "OFF\n3 1 0\n0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n");
  const Ended ended = run_program({"check", "bad.off"}, folder.path());
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("bad.off:4"));
}

TEST(TetfarmProgram, check_says_that_a_cube_can_be_meshed) {
  const TemporaryFolder folder;
  write_contents(folder.path() / "cube.off", cube_off(cube_end));
  const Ended ended = run_program({"check", "cube.off"}, folder.path());
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("triangles       12"));
  const Ended json = run_program({"check", "--json", "cube.off"}, folder.path());
  EXPECT_THAT(json.out, StartsWith("{\"type\":\"check\",\"can_be_meshed\":true"));
}

TEST(TetfarmProgram, a_size_that_is_far_too_small_is_refused_with_one_that_would_do) {
  const TemporaryFolder folder;
  write_contents(folder.path() / "cube.off", cube_off(cube_end));
  for (const char* size : {"0.001", "1e-5", "1e-7", "1e-300"}) {
    const Ended planned = run_program(
        {"plan", "cube.off", "--size", size, "--max-elements", "1000000"}, folder.path(), 60);
    EXPECT_EQ(planned.code, 2) << size;
    EXPECT_THAT(planned.err, HasSubstr("more than the 1.0 M that it may have")) << size;
    EXPECT_THAT(planned.err, HasSubstr("`--size 0.02")) << size;
  }
  write_contents(folder.path() / "job.toml",
                 "[geometry]\nsurface = \"cube.off\"\n[spacing]\ndefault = 1e-7\n");
  const Ended checked = run_program({"check", "job.toml"}, folder.path(), 60);
  EXPECT_EQ(checked.code, 2);
  EXPECT_THAT(checked.err, HasSubstr("`--size 0.0017` would give"));
}

TEST(TetfarmProgram, run_refuses_too_many_elements_before_it_meshes) {
  const TemporaryFolder folder;
  write_contents(folder.path() / "cube.off", cube_off(cube_end));
  const Ended ended =
      run_program({"run", "cube.off", "-o", "out", "-j", "1", "--size", "1e-7"}, folder.path(), 60);
  EXPECT_EQ(ended.code, 2) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("`--size 0.0017` would give about 1.9 G"));
}

TEST(TetfarmProgram, run_says_what_is_to_be_expected) {
  const TemporaryFolder folder;
  write_contents(folder.path() / "cube.off", cube_off(cube_end));
  const std::vector<std::string> words = {"run", "cube.off", "-o",  "out",        "-j",
                                          "1",   "--size",   "0.2", "--progress", "plain"};
  std::vector<std::string> limited = words;
  limited.insert(limited.end(), {"--max-elements", "100"});
  EXPECT_EQ(run_program(limited, folder.path(), 60).code, 2);
  const Ended ended = run_program(words, folder.path(), 60);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("of memory per task, "));
  EXPECT_THAT(ended.err, HasSubstr("of disk, "));
  std::vector<std::string> forced = words;
  forced.push_back("--force");
  EXPECT_EQ(run_program(forced, folder.path(), 60).code, 0);
}

TEST(TetfarmProgram, plan_says_memory_disk_and_time) {
  const TemporaryFolder folder;
  write_contents(folder.path() / "cube.off", cube_off(cube_end));
  const Ended planned = run_program({"plan", "cube.off", "--size", "0.05"}, folder.path(), 60);
  EXPECT_EQ(planned.code, 0) << planned.err;
  EXPECT_THAT(planned.out, HasSubstr("of memory per task, "));
  EXPECT_THAT(planned.out, HasSubstr("of disk, "));
  EXPECT_THAT(planned.out, HasSubstr("on one core"));
}

TEST(TetfarmProgram, plan_says_how_many_sub_domains_it_does_not_show) {
  const TemporaryFolder folder;
  write_contents(folder.path() / "cube.off", cube_off(cube_end));
  const Ended planned =
      run_program({"plan", "cube.off", "--size", "0.1", "--subdomains", "120"}, folder.path(), 60);
  EXPECT_EQ(planned.code, 0) << planned.err;
  EXPECT_THAT(planned.out, HasSubstr("\n... and 39 more (")) << "120 leaves have 119 cuts";
}

TEST(TetfarmProgram, the_outer_boundary_has_a_size_of_its_own) {
  const TemporaryFolder folder;
  write_contents(folder.path() / "cube.off", cube_off(cube_end));
  const auto triangles = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words = {"plan", "cube.off", "--json", "--outer", "box:2"};
    words.insert(words.end(), options.begin(), options.end());
    const Ended planned = run_program(words, folder.path(), 60);
    EXPECT_EQ(planned.code, 0) << planned.err;
    const std::string before = "\"triangles\":";
    const std::size_t at = planned.out.find(before);
    return at == std::string::npos ? 0 : std::stod(planned.out.substr(at + before.size()));
  };
  EXPECT_EQ(triangles({"--subdomains", "1", "--outer-size", "0.1"}), 12 + 12 * 20 * 20);
  EXPECT_EQ(triangles({"--subdomains", "1", "--size", "0.125"}), 12 + 12 * 16 * 16)
      << "sizes hold on the boundary too";
  const Ended refused = run_program({"plan", "cube.off", "--outer-size", "0.1"}, folder.path());
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--outer-size: there is no outer boundary"));
}

TEST(TetfarmProgram, check_shows_where_a_surface_is_open) {
  const TemporaryFolder folder;
  std::string open = cube_off("");
  open.replace(open.find("8 12 0"), 6, "8 11 0");
  write_contents(folder.path() / "open.off", open);
  const Ended ended = run_program({"check", "open.off"}, folder.path());
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("open edge"));
  EXPECT_THAT(contents(folder.path() / "open.defects.vtp"), HasSubstr("PolyData"));
  std::filesystem::create_directory(folder.path() / "shown");
  EXPECT_EQ(run_program({"check", "open.off", "-o", "shown"}, folder.path()).code, 3);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "shown" / "open.defects.vtp"));
}

TEST(TetfarmProgram, a_coordinator_that_is_not_there_is_unreachable) {
  const TemporaryFolder folder;
  const std::string endpoint = "ipc://" + (folder.path() / "none").string();
  for (const std::string name : {"status", "wait", "cancel"}) {
    const Ended ended =
        run_program({name, "job-1", "--connect", endpoint, "--timeout", "0.2"}, folder.path());
    EXPECT_EQ(ended.code, 5) << name;
    EXPECT_THAT(ended.err, HasSubstr("no coordinator answers")) << name;
  }
}

TEST(TetfarmProgram, a_malformed_endpoint_is_a_usage_error) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_program({"status", "--connect", "nonsense"}, folder.path()).code, 2);
}

TEST(TetfarmProgram, errors_are_also_told_to_programs) {
  const TemporaryFolder folder;
  const Ended ended = run_program({"run", "nowhere.stl", "--json"}, folder.path());
  EXPECT_THAT(ended.out, HasSubstr("\"type\":\"error\""));
  EXPECT_THAT(ended.out, HasSubstr("\"exit_code\":5"));
}

}  // namespace
}  // namespace tetfarm
