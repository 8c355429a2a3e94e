#include "worker/task_io.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/base/temp_folder.h"
#include "worker/shared_mesh_file.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::Pair;

class TaskIoTest : public testing::Test {
 protected:
  TaskIoTest() {
    assign_.set_job("job-3");
    assign_.set_attempt(12);
  }
  TaskFile give(const std::string& name, const std::string& bytes) {
    const StoredArtifact stored = store_.publish(bytes);
    wire::Artifact& input = *assign_.add_inputs();
    input.set_name(name);
    input.set_hash(stored.hash);
    input.set_size(stored.size);
    return {stored.hash, stored.size};
  }
  TaskIo::Say hear() {
    return [this](const wire::Doing& doing) { said_.push_back(doing.ShortDebugString()); };
  }

  TempFolder folder_;
  ArtifactStore store_{folder_.path()};
  wire::Assign assign_;
  std::vector<std::string> said_;
};

TEST_F(TaskIoTest, gives_the_words_that_travelled) {
  const TaskFile one = give("mesh:4", "one");
  const TaskFile two = give("job", "two");
  (*assign_.mutable_parameters())["work"] = "17";
  const TaskWords words = given_words(assign_);
  EXPECT_THAT(words.files, ElementsAre(Pair("mesh:4", one), Pair("job", two)));
  EXPECT_THAT(words.texts, ElementsAre(Pair("work", "17")));
  EXPECT_TRUE(words.numbers.empty());
}

TEST_F(TaskIoTest, names_an_input_and_says_where_it_lies) {
  const TaskFile one = give("first", "one");
  const TaskFile two = give("second", "two");
  const TaskIo io(store_, assign_, hear());
  EXPECT_EQ(io.name_of(one), "first");
  EXPECT_EQ(io.name_of(two), "second");
  EXPECT_EQ(io.path(two), store_.path_of(two.hash));
  EXPECT_EQ(io.read(two), "two");
  EXPECT_EQ(io.read(one, [](const std::string& bytes,
                            const std::string& name) { return name + ": " + bytes; }),
            "first: one");
  EXPECT_EQ(io.look_into(two, [](const auto& path) { return path; }), store_.path_of(two.hash));
}

TEST_F(TaskIoTest, publishes_files_under_the_names_that_they_are_given) {
  TaskIo io(store_, assign_, hear());
  const TaskFile without_name = io.publish("bytes");
  EXPECT_EQ(store_.read(without_name.hash, without_name.size), "bytes");
  EXPECT_EQ(io.done().outputs_size(), 0) << "its contract names it";
  const std::filesystem::path made = io.scratch_path("made");
  std::ofstream(made) << "a file";
  io.publish_file("wing.ugrid", made);
  EXPECT_FALSE(std::filesystem::exists(made));
  const std::filesystem::path checked = io.scratch_path("checked");
  std::ofstream(checked) << "another";
  const StoredArtifact known = checksum_of_file(checked);
  io.publish_checked_file("wing.vtkhdf", checked, known);
  EXPECT_FALSE(std::filesystem::exists(checked));
  ASSERT_EQ(io.done().outputs_size(), 2);
  EXPECT_EQ(io.done().outputs(0).name(), "wing.ugrid");
  EXPECT_EQ(store_.read(io.done().outputs(0).hash(), io.done().outputs(0).size()), "a file");
  EXPECT_EQ(io.done().outputs(1).name(), "wing.vtkhdf");
  EXPECT_EQ(store_.read(io.done().outputs(1).hash(), 7), "another");
  EXPECT_EQ(io.done().outputs(1).size(), 7U);
}

TEST_F(TaskIoTest, has_a_place_of_its_attempt_for_files_in_the_making) {
  const TaskIo io(store_, assign_, hear());
  const std::filesystem::path path = io.scratch_path("mesh");
  EXPECT_EQ(path, store_.scratch_folder() / "attempt-12" / "mesh");
  EXPECT_TRUE(std::filesystem::is_directory(path.parent_path()));
  std::filesystem::remove_all(store_.scratch_folder());
  try {
    io.scratch_path("mesh");
    ADD_FAILURE() << "there is no folder for it";
  } catch (const IoError& error) {
    EXPECT_EQ(error.what(), path.parent_path().string() +
                                ": cannot create the folder: No such file or directory");
  }
}

TEST_F(TaskIoTest, tells_each_stage_at_once_and_counts_only_now_and_then) {
  const TaskIo io(store_, assign_, hear());
  io.progress().begin(WorkStage::edges, 10);
  for (int i = 0; i < 10; ++i) io.progress().add();
  io.progress().begin(WorkStage::faces, 4);
  ASSERT_GE(said_.size(), 2U);
  EXPECT_THAT(said_.front(), testing::StartsWith("stage: \"edges\""));
  EXPECT_THAT(said_.back(), testing::StartsWith("stage: \"faces\""));
  EXPECT_LT(said_.size(), 12U) << "not each of ten counts";
}

TEST(FileOfLeaf, is_the_leafs_or_an_error_that_names_it) {
  const LeafFiles files = {{4, {"four", 4}}, {5, {"five", 5}}};
  EXPECT_EQ(file_of_leaf(files, 5).hash, "five");
  try {
    file_of_leaf(files, 6);
    ADD_FAILURE() << "it has none";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "a file of sub-domain 6 is missing");
    EXPECT_EQ(error.code(), ExitCode::failed);
  }
}

TEST_F(TaskIoTest, has_one_mesh_file_with_the_tasks_of_the_same_job_surface_and_numbering) {
  const TaskIo io(store_, assign_, hear());
  const TaskFile a{std::string(32, 'a'), 1};
  const TaskFile b{std::string(32, 'b'), 1};
  const SharedFile file = shared_mesh_file(io, a, b);
  EXPECT_EQ(file.path.parent_path(), store_.scratch_folder());
  EXPECT_THAT(file.path.filename().string(), testing::MatchesRegex("mesh\\.[0-9a-f]*\\.vtkhdf"));
  EXPECT_EQ(shared_mesh_file(io, a, b).path, file.path);
  EXPECT_NE(shared_mesh_file(io, b, a).path, file.path);
  EXPECT_NE(shared_mesh_file(io, a, a).path, file.path);
  EXPECT_NE(shared_mesh_file(io, b, b).path, file.path);
  wire::Assign later = assign_;
  later.set_attempt(13);
  EXPECT_EQ(shared_mesh_file(TaskIo(store_, later, hear()), a, b).path, file.path);
  wire::Assign other = assign_;
  other.set_job("job-4");
  EXPECT_NE(shared_mesh_file(TaskIo(store_, other, hear()), a, b).path, file.path);
  const TaskIo apart(store_, assign_, hear(), true);
  EXPECT_EQ(shared_mesh_file(apart, a, b).path.parent_path(),
            store_.scratch_folder() / "attempt-12")
      << "nobody else sees it, and it goes with the attempt";
}

}  // namespace
}  // namespace tetfarm
