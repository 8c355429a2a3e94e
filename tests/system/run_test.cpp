// One small run of the whole program, end to end.
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::Program;
using test::run_program;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::SizeIs;

TEST(Run, meshes_a_sphere_in_a_box_and_says_so_in_one_line) {
  const TemporaryFolder folder;
  const std::string input = test::sphere_in_box(folder.path(), 4, 1);
  const Ended ended = run_program(test::run_words(input, "out", 2, 2), folder.path());
  ASSERT_EQ(ended.code, 0) << ended.err;
  const nlohmann::json result = test::result_of(ended);
  ASSERT_TRUE(result.is_object()) << ended.out;
  EXPECT_EQ(result["type"], "result");
  EXPECT_GT(result["elements"], 100);
  EXPECT_EQ(result["subdomains"], 2);
  EXPECT_EQ(result["boundary_triangles"], 4 * 4 * 2 * 6 + 80);
  EXPECT_GT(result["min_dihedral_deg"], 0);
  EXPECT_GT(result["peak_rss_bytes_worker"], 0);
  EXPECT_THAT(result["digest"].get<std::string>(), SizeIs(32));
  ASSERT_FALSE(result["files"].empty());
  for (const auto& file : result["files"]) {
    EXPECT_TRUE(std::filesystem::exists(file.get<std::string>())) << file;
  }

  const Ended again = run_program(test::run_words(input, "out", 1, 2), folder.path());
  EXPECT_EQ(test::digest_of(again), result["digest"]);
  const Ended quality =
      run_program({"quality", result["files"][0].get<std::string>(), "--json"}, folder.path());
  EXPECT_EQ(quality.code, 0) << quality.err;
}

TEST(Run, elements_at_cuts_are_no_worse_for_cosmetics_across_them) {
  const TemporaryFolder folder;
  const std::string input = test::sphere_in_box(folder.path(), 6, 2);
  std::vector<nlohmann::json> results;
  for (const char* across : {"false", "true"}) {
    test::write_contents(
        folder.path() / "job.toml",
        "version = 1\n[geometry]\nsurface = \"" + input +
            "\"\n[decompose]\nsubdomains = 6\n[cosmetics]\nacross_cuts = " + across + "\n");
    const Ended ended =
        run_program({"run", "job.toml", "-j", "2", "-o", across, "--json", "--progress", "none"},
                    folder.path());
    ASSERT_EQ(ended.code, 0) << ended.err;
    results.push_back(test::result_of(ended));
    const Ended quality = run_program(
        {"quality", results.back()["files"][0].get<std::string>(), "--json"}, folder.path());
    EXPECT_EQ(quality.code, 0) << quality.err;
  }
  EXPECT_NE(results[0]["digest"], results[1]["digest"]);
  EXPECT_EQ(results[1]["subdomains"], 6);
  // Cosmetics judge by the smallest sine, so the angle nearest to 0 or 180 is what may not get
  // worse.
  const auto worst_angle = [](const nlohmann::json& result) {
    return std::min(result["min_dihedral_deg"].get<double>(),
                    180 - result["max_dihedral_deg"].get<double>());
  };
  EXPECT_GE(worst_angle(results[1]), worst_angle(results[0]));
  EXPECT_GE(results[1]["min_dihedral_deg"], results[0]["min_dihedral_deg"]);
  EXPECT_GT(results[1]["mean_radius_ratio"], results[0]["mean_radius_ratio"]);
}

TEST(Run, a_mesh_below_the_gate_is_delivered_and_ends_with_4) {
  const TemporaryFolder folder;
  const std::string input = test::sphere_in_box(folder.path(), 3, 1);
  test::write_contents(folder.path() / "job.toml", "version = 1\n[geometry]\nsurface = \"" + input +
                                                       "\"\n[quality]\nmin_dihedral = 60.0\n");
  const Ended ended = run_program({"run", "job.toml", "-j", "1"}, folder.path());
  EXPECT_EQ(ended.code, 4) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("gate is 60"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "job.vtkhdf"));
}

TEST(Run, a_result_that_was_damaged_in_the_store_is_made_again) {
  const TemporaryFolder folder;
  const std::string input = test::sphere_in_box(folder.path(), 3, 1);
  const Ended first = run_program(test::run_words(input, "out", 1, 1), folder.path());
  ASSERT_EQ(first.code, 0) << first.err;
  const std::filesystem::path mesh = test::result_of(first)["files"][0].get<std::string>();
  const std::string sound = test::contents(mesh);
  // What was delivered may be the same file.
  std::string damaged = sound;
  damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 4);
  int harmed = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(
           folder.path() / "out" / ".tetfarm" / "artifacts")) {
    if (!entry.is_regular_file() || test::contents(entry.path()) != sound) continue;
    std::filesystem::remove(entry.path());
    test::write_contents(entry.path(), damaged);
    ++harmed;
  }
  ASSERT_EQ(harmed, 1);
  std::filesystem::remove(mesh);
  const Ended again = run_program(test::run_words(input, "out", 1, 1), folder.path());
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(test::contents(mesh), sound);
}

TEST(Run, a_file_that_does_not_fit_ends_with_6_and_the_same_command_goes_on_with_room) {
  const TemporaryFolder folder;
  std::vector<std::string> words =
      test::run_words(test::sphere_in_box(folder.path(), 3, 1), "out", 1, 1);
  words.insert(words.end(), {"--size", "0.2"});
  // As on a full disk, for files of more than half a megabyte.
  const Ended full = Program(words, folder.path(),
                             {"/bin/sh", "-c", "trap '' XFSZ; ulimit -f 1000; exec \"$0\" \"$@\"",
                              test::built_program()})
                         .wait();
  EXPECT_EQ(full.code, 6) << full.err;
  EXPECT_THAT(full.err, HasSubstr("cannot write"));
  const Ended with_room = run_program(words, folder.path());
  EXPECT_EQ(with_room.code, 0) << with_room.err;
}

TEST(Run, uses_no_keys_whichever_the_shell_has_for_other_farms) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program({"keys", "new", "anna"}, folder.path()).code, 0);
  const Ended ended =
      Program(test::run_words(test::sphere_in_box(folder.path(), 3, 1), "out", 1), folder.path(),
              {"/usr/bin/env", "TETFARM_KEY=anna.key", "TETFARM_COORDINATOR_KEY=anna.pub",
               test::built_program()})
          .wait();
  EXPECT_EQ(ended.code, 0) << ended.err;
}

TEST(Run, a_surface_with_a_hole_ends_with_3_and_shows_where) {
  const TemporaryFolder folder;
  SurfaceMesh open = shapes::sphere({0, 0, 0}, 1, 1);
  open.triangles.pop_back();
  test::write_contents(folder.path() / "open.off", test::off_of(open));
  const Ended ended = run_program(test::run_words("open.off", "out", 1), folder.path());
  EXPECT_EQ(ended.code, 3) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("open edge"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "open.defects.vtp"));
}

}  // namespace
}  // namespace tetfarm
