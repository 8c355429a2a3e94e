#include "cli/deliver_files.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "base/file_system.h"
#include "store/artifact_store.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using ::testing::ElementsAre;

class Delivered : public ::testing::Test {
 protected:
  wire::Artifact& add(const std::string& name, const StoredArtifact& stored) {
    wire::Artifact& file = *status_.add_files();
    file.set_name(name);
    file.set_hash(stored.hash);
    file.set_size(stored.size);
    return file;
  }
  std::vector<std::filesystem::path> deliver() const {
    return deliver_files(status_, store_.folder(), out_);
  }

  const TempFolder folder_;
  const std::filesystem::path out_ = folder_.path() / "new" / "out";
  ArtifactStore store_{folder_.path() / "farm"};
  wire::JobStatus status_;
};

TEST_F(Delivered, files_come_into_the_folder_under_their_names_alone) {
  add("wing.vtkhdf", store_.publish("a mesh"));
  add("../../escaped/wing.lb8.ugrid", store_.publish("another"));
  for (const char* none : {"..", ".", "folder/", ""}) add(none, store_.publish("nothing"));
  EXPECT_THAT(deliver(), ElementsAre(out_ / "wing.vtkhdf", out_ / "wing.lb8.ugrid"));
  EXPECT_EQ(read_file(out_ / "wing.vtkhdf"), "a mesh");
  EXPECT_EQ(read_file(out_ / "wing.lb8.ugrid"), "another");
  EXPECT_EQ(count_files(out_), 2U);
}

TEST_F(Delivered, a_file_takes_the_place_of_the_one_before) {
  make_folders(out_);
  write_file_atomically(out_ / "wing.vtkhdf", "of an earlier run");
  add("wing.vtkhdf", store_.publish("a mesh"));
  deliver();
  EXPECT_EQ(read_file(out_ / "wing.vtkhdf"), "a mesh");
}

TEST_F(Delivered, a_damaged_file_is_not_delivered) {
  const StoredArtifact stored = store_.publish("a mesh");
  add("wing.vtkhdf", stored);
  std::filesystem::remove(store_.path_of(stored.hash));
  write_file_atomically(store_.path_of(stored.hash), "a mess");
  EXPECT_THROW(deliver(), CorruptFile);
  EXPECT_EQ(count_files(out_), 0U);
}

TEST_F(Delivered, a_folder_that_is_no_store_has_no_files) {
  EXPECT_THROW(deliver_files(status_, folder_.path(), out_), IoError);
}

TEST_F(Delivered, only_damaged_files_are_set_aside) {
  const StoredArtifact sound = store_.publish("a mesh");
  const StoredArtifact damaged = store_.publish("another");
  add("wing.vtkhdf", sound);
  EXPECT_FALSE(set_damaged_aside(status_, store_));
  add("wing.lb8.ugrid", damaged);
  std::filesystem::remove(store_.path_of(damaged.hash));
  write_file_atomically(store_.path_of(damaged.hash), "anothes");
  EXPECT_TRUE(set_damaged_aside(status_, store_));
  EXPECT_TRUE(store_.has(sound.hash, sound.size));
  EXPECT_FALSE(std::filesystem::exists(store_.path_of(damaged.hash)));
}

}  // namespace
}  // namespace tetfarm
