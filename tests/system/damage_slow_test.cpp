// Files of the store that are flipped, cut or gone, half-way and at the end: the same command makes
// them again, and the mesh is the same.
#include <gmock/gmock.h>

#include <array>
#include <csignal>
#include <map>
#include <set>
#include <thread>

#include "store/job_database.h"
#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

using test::Ended;
using test::Program;
using test::run_program;
using test::TemporaryFolder;
using ::testing::HasSubstr;

enum class Harm { flip, cut, remove };

void harm(const fs::path& file, Harm how) {
  if (how == Harm::remove) {
    fs::remove(file);
    return;
  }
  std::string bytes = test::contents(file);
  ASSERT_FALSE(bytes.empty()) << file;
  if (how == Harm::flip) bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
  if (how == Harm::cut) bytes.resize(bytes.size() / 2);
  // A new file: results that were delivered are links to the old one.
  fs::remove(file);
  test::write_contents(file, bytes);
}

class Damage : public ::testing::TestWithParam<Harm> {
 protected:
  Damage() : input_(test::sphere_in_box(folder_.path(), 4, 1)) {
    test::write_contents(folder_.path() / "job.toml", "[geometry]\nsurface = \"" + input_ +
                                                          "\"\n[cosmetics]\nacross_cuts = true\n");
  }
  std::vector<std::string> words(const std::string& output) const {
    return test::run_words("job.toml", output, 2, 3);
  }
  std::string run(const std::string& output) const {
    const Ended ended = run_program(words(output), folder_.path());
    EXPECT_EQ(ended.code, 0) << ended.err;
    return test::digest_of(ended);
  }
  fs::path store() const { return folder_.path() / "out/.tetfarm"; }
  /// One artifact of each kind, by its maker and name there, but what comes from outside.
  std::map<std::string, std::string> kinds() const {
    std::map<std::string, std::string> kinds;
    const DurableState rows = JobDatabase::open_to_read(store() / "tetfarm.db").load();
    for (const auto& [id, task] : rows.tasks) {
      for (const ArtifactRef& file : task.outputs) {
        const std::string part = file.name.substr(0, file.name.find(':'));
        if (file.size > 0) kinds[std::string(name_of(task.kind)) + " " + part] = file.hash;
      }
    }
    return kinds;
  }
  fs::path path_of(const std::string& hash) const {
    return store() / "artifacts" / hash.substr(0, 2) / hash;
  }
  Ended check() const { return run_program({"check", "--store", "out"}, folder_.path()); }

  TemporaryFolder folder_;
  std::string input_;
};

TEST_P(Damage, of_every_kind_of_file_of_a_finished_job) {
  const std::string digest = run("out");
  EXPECT_EQ(digest.size(), 32U);
  EXPECT_EQ(check().code, 0);
  const auto all = kinds();
  EXPECT_GE(all.size(), 9U);
  for (const auto& [kind, hash] : all) {
    harm(path_of(hash), GetParam());
    EXPECT_EQ(check().code, 1) << kind;
    EXPECT_EQ(run("out"), digest) << kind;
  }
  for (const auto& [kind, hash] : kinds()) harm(path_of(hash), GetParam());
  const Ended found = check();
  EXPECT_EQ(found.code, 1);
  EXPECT_THAT(found.out, HasSubstr("would run again"));
  EXPECT_EQ(run("out"), digest) << "all at once";
}

TEST_P(Damage, of_every_kind_of_file_half_way) {
  test::sphere_in_box(folder_.path(), 24, 4);  // in place of the small one: it has to last
  const std::string digest = run("reference");
  std::set<std::string> harmed;
  int stops = 0;
  for (int after_ms = 120;; after_ms += 50 + after_ms / 4) {
    Program half(words("out"), folder_.path());
    std::this_thread::sleep_for(std::chrono::milliseconds(after_ms));
    half.signal(SIGTERM);
    const Ended ended = half.wait();
    if (ended.code == 0) {
      EXPECT_EQ(test::digest_of(ended), digest);
      break;
    }
    // Before it listens to signals it just ends.
    ASSERT_TRUE(ended.code == 75 || ended.code == 128 + SIGTERM) << ended.err;
    ++stops;
    if (!fs::exists(store() / "tetfarm.db")) continue;
    for (const auto& [kind, hash] : kinds()) {
      if (fs::exists(path_of(hash)) && harmed.insert(kind).second) harm(path_of(hash), GetParam());
    }
  }
  EXPECT_GT(stops, 0);
  EXPECT_GE(harmed.size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(Harms, Damage, ::testing::Values(Harm::flip, Harm::cut, Harm::remove),
                         [](const auto& harm_of) {
                           return std::string(std::array{"flip", "cut", "remove"}.at(
                               static_cast<std::size_t>(harm_of.param)));
                         });

class Garbage : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
};

TEST_F(Garbage, after_gc_nothing_is_left_but_what_makes_the_job_again) {
  const std::string input = test::sphere_in_box(folder_.path(), 4, 1);
  const Ended first = run_program(test::run_words(input, "out", 2, 3), folder_.path());
  const Ended second = run_program(test::run_words(input, "out", 2, 2), folder_.path());
  ASSERT_EQ(second.code, 0) << second.err;
  test::write_contents(folder_.path() / "out/.tetfarm/scratch/left", "over");
  const Ended dry = run_program({"gc", "out", "--dry-run"}, folder_.path());
  EXPECT_THAT(dry.out, HasSubstr("scratch/left"));
  EXPECT_THAT(dry.out, HasSubstr("1 file, 4 bytes would be removed"));
  const Ended gc = run_program({"gc", "out", "--all-finished", "--json"}, folder_.path());
  EXPECT_EQ(gc.code, 0) << gc.err;
  EXPECT_GT(test::result_of(gc)["files"], 10);
  EXPECT_THAT(run_program({"gc", "out", "--all-finished"}, folder_.path()).out,
              HasSubstr("0 files, 0 bytes removed"));
  const Ended again = run_program(test::run_words(input, "out", 2, 3), folder_.path());
  EXPECT_EQ(test::digest_of(again), test::digest_of(first));
  fs::remove_all(folder_.path() / "out/.tetfarm/artifacts");
  const Ended remade = run_program(test::run_words(input, "out", 2, 3), folder_.path());
  EXPECT_EQ(remade.code, 0) << remade.err;
  EXPECT_EQ(test::digest_of(remade), test::digest_of(first));
}

TEST_F(Garbage, gc_wants_no_coordinator_on_the_store) {
  Program coordinator({"coordinator", "--store", "store", "--listen", "tcp://127.0.0.1:*"},
                      folder_.path());
  ASSERT_NE(test::endpoint_of(coordinator), "");
  const Ended gc = run_program({"gc", "store"}, folder_.path());
  EXPECT_EQ(gc.code, 2);
  EXPECT_THAT(gc.err, HasSubstr("another coordinator"));
}

}  // namespace
}  // namespace tetfarm
