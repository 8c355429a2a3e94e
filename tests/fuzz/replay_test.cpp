// The inputs that fuzzing found worth keeping, and those that once did harm.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "base/file_system.h"
#include "tests/fuzz/fuzz_targets.h"

namespace tetfarm {
namespace {

std::vector<std::filesystem::path> kept(const char* target) {
  std::vector<std::filesystem::path> files;
  const std::filesystem::path folder = std::filesystem::path(TETFARM_FUZZ_CORPUS) / target;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  EXPECT_FALSE(files.empty()) << "the corpus of " << target << " is missing";
  return files;
}

void replay(const char* target, void (*run)(std::string_view)) {
  for (const auto& file : kept(target)) {
    SCOPED_TRACE(file.string());
    EXPECT_NO_THROW(run(read_file(file)));
  }
}

TEST(FuzzCorpus, messages_do_not_end_the_coordinator_nor_break_its_invariants) {
  replay("wire", fuzz::wire);
}

TEST(FuzzCorpus, job_files_are_refused_or_keep_their_meaning) {
  replay("job_file", fuzz::job_file);
}

TEST(FuzzCorpus, surfaces_are_refused_or_read) { replay("surface", fuzz::surface); }

TEST(FuzzCorpus, bodies_are_mended_once_and_remeshed_or_what_is_left_is_told) {
  replay("bodies", fuzz::bodies);
}

TEST(FuzzCorpus, meshes_are_refused_or_read_and_judged) { replay("mesh", fuzz::mesh); }

TEST(FuzzCorpus, meshes_of_the_plane_are_refused_or_read) { replay("plane", fuzz::plane); }

TEST(FuzzCorpus, flite_sources_are_refused_or_may_stand_in_a_job_file) {
  replay("flite_sources", fuzz::flite_sources);
}

TEST(FuzzCorpus, files_that_tasks_read_are_refused_or_read) { replay("artifact", fuzz::artifact); }

}  // namespace
}  // namespace tetfarm
