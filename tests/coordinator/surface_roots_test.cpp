#include "coordinator/surface_roots.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "base/file_system.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

class Roots : public testing::Test {
 protected:
  Roots()
      : store_(folder_.path() / "store"),
        roots_({folder_with_files() / "open"}, closed()),
        all_({folder_.path()}, closed()) {}

  ClosedPlaces closed() const {
    return {folder_.path() / "store",
            folder_.path() / "state",
            {folder_.path() / "keys"},
            {folder_.path() / "token"}};
  }

  fs::path folder_with_files() const {
    for (const char* name : {"open/deep", "open too", "secret"}) {
      fs::create_directories(folder_.path() / name);
    }
    write("open/deep/wing.stl", "solid wing");
    write("open too/wing.stl", "solid wing too");
    write("secret/key", "secret");
    return folder_.path();
  }
  fs::path at(const std::string& name) const { return fs::canonical(folder_.path()) / name; }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_.path() / name) << bytes;
  }
  void expect_outside(const fs::path& path) const {
    EXPECT_THROW(roots_.take(path, store_), OutsideRoots) << path;
    EXPECT_TRUE(fs::is_empty(store_.folder() / "artifacts")) << "something was taken";
  }
  /// Though all of the folder is open to jobs.
  void expect_closed(const fs::path& path) const {
    const auto before = count(store_.folder());
    EXPECT_THROW(all_.take(path, store_), OutsideRoots) << path;
    EXPECT_EQ(count(store_.folder()), before) << "something was taken or left behind";
  }
  static std::ptrdiff_t count(const fs::path& folder) {
    return std::distance(fs::recursive_directory_iterator(folder), {});
  }

  TempFolder folder_;
  ArtifactStore store_;
  SurfaceRoots roots_;
  SurfaceRoots all_;  ///< the folder in which everything lies
};

TEST_F(Roots, a_file_inside_is_copied_into_the_store) {
  const StoredArtifact taken = roots_.take(at("open/deep/wing.stl"), store_);
  EXPECT_EQ(store_.read(taken.hash, taken.size), "solid wing");
  write("open/deep/wing.stl", "solid changed");
  EXPECT_EQ(store_.read(taken.hash, taken.size), "solid wing") << "a link, not a copy";
  EXPECT_TRUE(fs::is_empty(store_.scratch_folder()));
}

TEST_F(Roots, what_lies_outside_is_refused_with_the_path_and_the_roots) {
  EXPECT_THAT([&] { roots_.take(at("secret/key"), store_); },
              ThrowsMessage<OutsideRoots>(
                  AllOf(HasSubstr(at("secret/key").string()), HasSubstr(at("open").string()))));
  expect_outside("/etc/passwd");
  expect_outside("/");
}

TEST_F(Roots, dots_do_not_lead_out) {
  expect_outside(at("open") / "../secret/key");
  expect_outside(at("open") / "deep/../../secret/key");
  EXPECT_NO_THROW(roots_.take(at("open") / "deep/../deep/wing.stl", store_));
}

TEST_F(Roots, a_folder_whose_name_begins_alike_is_outside) {
  expect_outside(at("open too/wing.stl"));
}

TEST_F(Roots, links_count_where_they_lead) {
  fs::create_symlink(at("secret/key"), at("open/file"));
  fs::create_directory_symlink(at("secret"), at("open/folder"));
  fs::create_symlink(at("open/deep/wing.stl"), at("secret/back"));
  expect_outside(at("open/file"));
  expect_outside(at("open/folder/key"));
  EXPECT_NO_THROW(roots_.take(at("secret/back"), store_)) << "leads inside";
}

TEST_F(Roots, a_root_may_itself_be_reached_by_a_link) {
  fs::create_directory_symlink(at("open"), at("alias"));
  const SurfaceRoots roots({at("alias")}, {});
  EXPECT_NO_THROW(roots.take(at("open/deep/wing.stl"), store_));
  EXPECT_NO_THROW(roots.take(at("alias/deep/wing.stl"), store_));
}

TEST_F(Roots, a_missing_file_outside_is_not_told_from_one_that_is_there) {
  expect_outside(at("secret/none"));
  EXPECT_THROW(roots_.take(at("open/none"), store_), IoError);
}

TEST_F(Roots, only_regular_files_are_taken) {
  ASSERT_EQ(::mkfifo(at("open/pipe").c_str(), 0600), 0);
  EXPECT_THROW(roots_.take(at("open/pipe"), store_), UsageError);
  EXPECT_THROW(roots_.take(at("open/deep"), store_), UsageError);
  EXPECT_THROW(roots_.take("open/deep/wing.stl", store_), UsageError) << "relative to what?";
}

TEST_F(Roots, a_file_too_large_to_copy_is_refused) {
  write("open/large", "");
  fs::resize_file(at("open/large"), max_taken_bytes + 1);
  EXPECT_THAT([&] { roots_.take(at("open/large"), store_); },
              ThrowsMessage<UsageError>(HasSubstr("--store")));
}

TEST_F(Roots, none_let_nothing_in) {
  const SurfaceRoots none({}, {});
  EXPECT_THAT([&] { none.take(at("open/deep/wing.stl"), store_); },
              ThrowsMessage<OutsideRoots>(HasSubstr("--allow-root")));
  EXPECT_THROW(SurfaceRoots({at("nowhere")}, {}), UsageError);
}

TEST_F(Roots, keys_database_token_and_log_are_closed_whatever_the_path) {
  const std::string hash = store_.publish("solid").hash;
  std::vector<std::string> names = {"keys/coordinator.key",
                                    "keys/authorized_keys",
                                    "state/tetfarm.db",
                                    "state/tetfarm.db-wal",
                                    "token",
                                    "store/coordinator.log",
                                    "store/tetfarm.db",
                                    "store/scratch/upload",
                                    "store/damaged/file"};
  for (const std::string& name : names) {
    fs::create_directories(at(name).parent_path());
    write(name, "solid secret");
  }
  names.push_back("store/store_id");
  names.push_back("store/artifacts/" + hash.substr(0, 2) + "/" + hash);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string other = "open/" + std::to_string(i);
    expect_closed(at(names[i]));
    expect_closed(at("open") / ".." / names[i]);
    fs::create_symlink(at(names[i]), at(other + ".symbolic"));
    expect_closed(at(other + ".symbolic"));
    fs::create_hard_link(at(names[i]), at(other + ".hard"));
    expect_closed(at(other + ".hard"));
  }
  EXPECT_NO_THROW(all_.take(at("secret/key"), store_)) << "nothing but the farm's own is closed";
}

TEST_F(Roots, a_surface_of_several_names_is_taken) {
  fs::create_hard_link(at("open/deep/wing.stl"), at("open/again.stl"));
  EXPECT_NO_THROW(roots_.take(at("open/again.stl"), store_));
}

TEST_F(Roots, a_folder_above_the_store_does_not_open_it_but_one_in_it_may_be_named) {
  fs::create_directories(at("store/intake"));
  write("store/intake/wing.stl", "solid wing");
  expect_closed(at("store/intake/wing.stl"));
  const SurfaceRoots intake({at("store/intake")}, closed());
  EXPECT_NO_THROW(intake.take(at("store/intake/wing.stl"), store_));
  fs::create_directories(at("keys"));
  for (const char* folder : {"store", "store/artifacts", "store/scratch", "keys"}) {
    EXPECT_THROW(SurfaceRoots({at(folder)}, closed()), UsageError) << folder;
  }
}

TEST_F(Roots, a_key_or_a_database_of_another_farm_is_known_by_its_content) {
  write("open/other", "tetfarm secret key 0123");
  expect_outside(at("open/other"));
  write("open/other.db", std::string("SQLite format 3\0", 16));
  expect_outside(at("open/other.db"));
  EXPECT_TRUE(fs::is_empty(store_.scratch_folder()));
}

TEST_F(Roots, links_of_processes_are_closed) {
  std::ifstream held(at("open/deep/wing.stl"));
  for (const auto& entry : fs::directory_iterator("/proc/self/fd")) expect_outside(entry.path());
  expect_outside("/proc/self/root" + at("open/deep/wing.stl").string());
}

TEST_F(Roots, a_path_with_a_nul_is_refused) {
  const std::string path = at("open/deep/wing.stl").string() + std::string("\0.stl", 5);
  EXPECT_THAT([&] { roots_.take(path, store_); },
              ThrowsMessage<UsageError>(HasSubstr("wing.stl\\0.stl")));
}

}  // namespace
}  // namespace tetfarm
