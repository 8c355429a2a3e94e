#include "worker/spacing_input.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

class SpacingInput : public testing::Test {
 protected:
  SpacingInput() {
    const StoredArtifact stored = store_.publish(SpacingField(0.7).to_bytes());
    file_ = {stored.hash, stored.size};
    wire::Artifact& input = *assign_.add_inputs();
    input.set_name("spacing");
    input.set_hash(stored.hash);
    input.set_size(stored.size);
  }
  SpacingField read() const {
    return spacing_input(TaskIo(store_, assign_, [](const wire::Doing&) {}), file_);
  }

  TempFolder folder_;
  ArtifactStore store_{folder_.path()};
  wire::Assign assign_;
  TaskFile file_;
};

TEST_F(SpacingInput, is_the_field_that_was_stored) { EXPECT_EQ(read().at({1, 2, 3}), 0.7); }

TEST_F(SpacingInput, that_is_damaged_or_missing_is_made_again) {
  const std::filesystem::path path = store_.path_of(file_.hash);
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(90).put('x');
  }
  EXPECT_THROW(read(), DamagedInput);
  std::filesystem::remove(path);
  try {
    read();
    ADD_FAILURE() << "it is not there";
  } catch (const DamagedInput& error) {
    EXPECT_EQ(error.hash(), file_.hash);
  }
}

}  // namespace
}  // namespace tetfarm
