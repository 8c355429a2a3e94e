#include "store/artifact_store.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "base/error.h"
#include "base/file_system.h"
#include "base/hash.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

void overwrite(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

TEST(ArtifactStore, names_a_file_by_its_checksum) {
  const TempFolder folder;
  const ArtifactStore store(folder.path());
  const StoredArtifact artifact = store.publish("hello");
  EXPECT_EQ(artifact.hash, hash128("hello").hex());
  EXPECT_EQ(artifact.size, 5U);
  EXPECT_EQ(store.read(artifact.hash, artifact.size), "hello");
  EXPECT_TRUE(store.has(artifact.hash, artifact.size));
  EXPECT_FALSE(store.has(artifact.hash, 4));
  EXPECT_FALSE(store.has("../../etc/passwd", 4));
}

TEST(ArtifactStore, takes_a_finished_file_and_leaves_nothing_in_scratch) {
  const TempFolder folder;
  const ArtifactStore store(folder.path());
  const auto path = store.scratch_path("mesh");
  overwrite(path, std::string(200000, 'x'));
  const StoredArtifact artifact = store.publish_file(path);
  EXPECT_EQ(artifact, store.publish(std::string(200000, 'x')));
  EXPECT_EQ(count_files(store.scratch_folder()), 0U);
  store.verify(artifact.hash, artifact.size);
}

TEST(ArtifactStore, takes_a_file_of_another_file_system) {
  const TempFolder folder;
  const ArtifactStore store(folder.path());
  const std::filesystem::path path = "/dev/shm/tetfarm_test." + unique_temp_name("x");
  overwrite(path, "elsewhere");
  if (!size_of_file(path)) GTEST_SKIP() << "no /dev/shm";
  const StoredArtifact artifact = store.publish_file(path);
  EXPECT_EQ(store.read(artifact.hash, artifact.size), "elsewhere");
  EXPECT_FALSE(size_of_file(path));
}

TEST(ArtifactStore, finds_truncated_flipped_and_missing_files) {
  const TempFolder folder;
  const ArtifactStore store(folder.path());
  const StoredArtifact artifact = store.publish("hello");
  for (const char* bytes : {"hell", "hellp", ""}) {
    overwrite(store.path_of(artifact.hash), bytes);
    EXPECT_THROW(store.read(artifact.hash, artifact.size), CorruptFile);
    EXPECT_THROW(store.verify(artifact.hash, artifact.size), CorruptFile);
  }
  store.publish("hello");
  EXPECT_EQ(store.read(artifact.hash, artifact.size), "hello");
  remove_file(store.path_of(artifact.hash));
  EXPECT_THROW(store.read(artifact.hash, artifact.size), IoError);
  EXPECT_THROW(store.verify(artifact.hash, artifact.size), IoError);
  EXPECT_THROW(store.read("nonsense", 1), CorruptFile);
}

TEST(ArtifactStore, sets_a_damaged_file_aside) {
  const TempFolder folder;
  const ArtifactStore store(folder.path());
  const StoredArtifact artifact = store.publish("hello");
  store.set_aside(artifact.hash);
  store.set_aside(artifact.hash);
  EXPECT_FALSE(store.has(artifact.hash, artifact.size));
  EXPECT_EQ(count_files(folder.path() / "damaged"), 1U);
}

TEST(ArtifactStore, everybody_reads_the_same_probe) {
  const TempFolder folder;
  EXPECT_THROW(ArtifactStore::open_existing(folder.path()), IoError);
  const ArtifactStore first(folder.path());
  EXPECT_EQ(ArtifactStore(folder.path()).probe(), first.probe());
  EXPECT_EQ(ArtifactStore::open_existing(folder.path()).probe(), first.probe());
  const TempFolder other;
  EXPECT_NE(ArtifactStore(other.path()).probe(), first.probe());
}

TEST(ArtifactStore, sweeps_only_what_is_old) {
  const TempFolder folder;
  const ArtifactStore store(folder.path());
  const auto old = store.scratch_path("old");
  overwrite(old, "x");
  std::filesystem::last_write_time(
      old, std::filesystem::file_time_type::clock::now() - std::chrono::hours(2));
  overwrite(store.scratch_path("new"), "x");
  store.sweep_scratch(3600 * 1000);
  EXPECT_FALSE(size_of_file(old));
  EXPECT_EQ(count_files(store.scratch_folder()), 1U);
}

TEST(ArtifactStore, many_processes_publish_the_same_bytes_at_once) {
  const TempFolder folder;
  const ArtifactStore store(folder.path());
  const std::string bytes(50000, 'y');
  std::vector<pid_t> children;
  for (int i = 0; i < 4; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      for (int j = 0; j < 10; ++j) store.publish(bytes);
      _exit(0);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(store.read(hash128(bytes).hex(), bytes.size()), bytes);
  EXPECT_EQ(count_files(folder.path() / "artifacts"), 1U);
}

TEST(ArtifactStore, says_what_is_wrong_with_a_file) {
  const TempFolder folder;
  const ArtifactStore store(folder.path());
  const StoredArtifact artifact = store.publish("hello");
  const std::string path = store.path_of(artifact.hash).string();
  const auto told = [](const auto& action) -> std::string {
    try {
      action();
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const auto both = [&](std::uint64_t size) {
    const std::string read = told([&] { store.read(artifact.hash, size); });
    EXPECT_EQ(told([&] { store.verify(artifact.hash, size); }), read);
    return read;
  };
  EXPECT_EQ(both(5), "");
  EXPECT_EQ(both(6), path + ": has 5 bytes instead of 6");
  EXPECT_FALSE(store.has(artifact.hash, 6));
  overwrite(path, "hellp");
  EXPECT_EQ(both(5), path + ": its checksum is wrong");
  EXPECT_TRUE(store.has(artifact.hash, 5)) << "that is not looked at";
  remove_file(path);
  EXPECT_EQ(both(5), path + ": cannot open: No such file or directory");
  EXPECT_EQ(told([&] { store.verify("nonsense", 1); }), "nonsense: is not the name of an artifact");
  EXPECT_EQ(told([&] { store.read("nonsense", 1); }), "nonsense: is not the name of an artifact");
  const auto coming = store.scratch_path("coming");
  overwrite(coming, "hello");
  EXPECT_EQ(told([&] {
              store.adopt_file(coming, {artifact.hash, 6});
            }),
            coming.string() + ": does not match the announced checksum " + artifact.hash);
  EXPECT_FALSE(std::filesystem::exists(coming)) << "it is removed";
}

TEST(ArtifactStore, has_names_of_32_small_hexadecimal_digits) {
  const std::string good = "0123456789abcdef0123456789abcdef";
  EXPECT_TRUE(ArtifactStore::is_hash(good));
  for (const std::string& bad : {good.substr(1), good + "0", "0123456789ABCDEF" + good.substr(16),
                                 "g" + good.substr(1), good.substr(1) + "/", std::string()}) {
    EXPECT_FALSE(ArtifactStore::is_hash(bad)) << bad;
  }
  const TempFolder folder;
  EXPECT_EQ(ArtifactStore(folder.path()).path_of(good), folder.path() / "artifacts/01" / good);
}

}  // namespace
}  // namespace tetfarm
