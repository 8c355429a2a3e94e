// Formats that the tasks do not write, asked of a run and of a coordinator.
#include <gmock/gmock.h>

#include "tests/system/daemon_farm.h"
#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::contents;
using test::Ended;
using test::run_program;
using test::TemporaryFolder;

using test::Daemon;

std::vector<std::string> with_formats(std::vector<std::string> words, const std::string& formats) {
  words.insert(words.end(), {"--format", formats});
  return words;
}

TEST(RunWithFormats, writes_what_export_writes) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "out";
  const auto words = with_formats(
      test::run_words(test::sphere_in_box(folder.path(), 4, 1), "out", 2, 2), "su2,openfoam,pvtu");
  const Ended ended = run_program(words, folder.path());
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(test::result_of(ended)["files"].size(), 4U) << ended.out;
  ASSERT_EQ(run_program({"export", "out", "-o", "again.su2"}, folder.path()).code, 0);
  EXPECT_EQ(contents(out / "sphere_in_box.su2"), contents(folder.path() / "again.su2"));
  ASSERT_EQ(
      run_program({"export", "out", "-o", "foam", "--format", "openfoam"}, folder.path()).code, 0);
  const char* faces = "constant/polyMesh/faces";
  EXPECT_EQ(contents(out / "sphere_in_box.openfoam" / faces),
            contents(folder.path() / "foam" / faces));
  EXPECT_TRUE(std::filesystem::exists(out / "sphere_in_box.pvtu/sphere_in_box.pvtu"));

  test::write_contents(out / "sphere_in_box.openfoam/mine", "a result");
  std::filesystem::remove(out / "sphere_in_box.su2");
  ASSERT_EQ(run_program(words, folder.path()).code, 0);
  EXPECT_EQ(contents(out / "sphere_in_box.su2"), contents(folder.path() / "again.su2"));
  EXPECT_TRUE(std::filesystem::exists(out / "sphere_in_box.openfoam/mine")) << "it is up to date";
}

TEST_F(Daemon, converts_the_mesh_of_a_job_for_who_waits) {
  const auto worker = start_worker();
  const Ended submitted = ask(with_formats(
      {"submit", test::sphere_in_box(folder_.path(), 4, 1), "--store", "store"}, "meshb"));
  ASSERT_EQ(submitted.code, 0) << submitted.err;
  const std::string job = submitted.out.substr(0, submitted.out.find('\n'));
  for (const bool shares_store : {true, false}) {
    const std::string out = shares_store ? "near" : "far";
    std::vector<std::string> words = {"wait", job, "-o", out, "--progress", "none"};
    if (shares_store) words.insert(words.end(), {"--store", "store"});
    const Ended ended = ask(words);
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_FALSE(contents(folder_.path() / out / "sphere_in_box.meshb").empty());
  }
  EXPECT_EQ(contents(folder_.path() / "near/sphere_in_box.meshb"),
            contents(folder_.path() / "far/sphere_in_box.meshb"));
}

}  // namespace
}  // namespace tetfarm
