#include "cli/fetch_files.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "base/file_system.h"
#include "base/hash.h"
#include "proto/file_chunks.h"
#include "store/folder_lock.h"
#include "tests/cli/fake_coordinator.h"

namespace tetfarm {
namespace {

TEST(FetchFiles, leaves_out_what_has_no_checksum_or_no_name) {
  const TempFolder folder;
  wire::JobStatus status;
  status.set_job("job-1");
  const auto add = [&](const char* name, const std::string& hash) {
    wire::Artifact& file = *status.add_files();
    file.set_name(name);
    file.set_hash(hash);
    file.set_size(1);
  };
  add("wing.vtkhdf", "../../escaped");
  add("wing.stl", "");
  add("..", std::string(32, 'a'));
  add("folder/", std::string(32, 'a'));
  // Nobody is there: whoever asked for one of them would hear nothing.
  CoordinatorConnection nobody("ipc://" + (folder.path() / "nobody").string());
  EXPECT_THAT(fetch_files(nobody, status, folder.path() / "out", {100, ProgressStyle::none}),
              testing::IsEmpty());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path() / "out"));
}

/// A coordinator that has one file.
class FileServer {
 public:
  explicit FileServer(std::string bytes)
      : bytes_(std::move(bytes)), coordinator_([this](const wire::Envelope& said) {
          std::vector<wire::Envelope> answers;
          if (!said.has_fetch_file()) return answers;
          ++asked;
          const wire::FetchFile& fetch = said.fetch_file();
          wire::FileChunk& chunk = *answers.emplace_back().mutable_file_chunk();
          chunk.set_hash(fetch.hash());
          chunk.set_offset(fetch.offset());
          chunk.set_missing(is_missing);
          if (!is_missing) {
            fill_chunk(chunk,
                       bytes_.substr(fetch.offset(), chunk_size(bytes_.size(), fetch.offset())));
          }
          return answers;
        }) {}

  /// A job whose only result has these bytes, or says so.
  wire::JobStatus job_with(const std::string& name, const std::string& bytes) const {
    wire::JobStatus status;
    status.set_job("job-7");
    wire::Artifact& file = *status.add_files();
    file.set_name(name);
    file.set_hash(hash128(bytes).hex());
    file.set_size(bytes.size());
    return status;
  }
  std::string endpoint() const { return coordinator_.endpoint(); }
  std::vector<wire::Envelope> heard() const { return coordinator_.heard(); }

  bool is_missing = false;
  int asked = 0;

 private:
  std::string bytes_;
  FakeCoordinator coordinator_;
};

/// Three chunks, the last one short.
std::string some_bytes() {
  std::string bytes(2 * chunk_bytes + 1000, ' ');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * i % 251);
  return bytes;
}

const FetchOptions quietly{5'000, ProgressStyle::none};

class Fetched : public ::testing::Test {
 protected:
  std::vector<std::filesystem::path> fetch(const wire::JobStatus& status) {
    return fetch_files(connection_, status, out_, quietly);
  }
  /// What is wrong when it is fetched.
  std::string trouble_with(const wire::JobStatus& status, ExitCode code) {
    try {
      fetch(status);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), code);
      return error.what();
    }
    return "";
  }

  const TempFolder folder_;
  const std::filesystem::path out_ = folder_.path() / "out";
  FileServer server_{some_bytes()};
  CoordinatorConnection connection_{server_.endpoint()};
};

TEST_F(Fetched, a_file_comes_chunk_by_chunk_under_its_name_alone) {
  const wire::JobStatus status = server_.job_with("../../some/wing.vtkhdf", some_bytes());
  EXPECT_THAT(fetch(status), testing::ElementsAre(out_ / "wing.vtkhdf"));
  EXPECT_EQ(read_file(out_ / "wing.vtkhdf"), some_bytes());
  EXPECT_EQ(count_files(out_), 1U) << "nothing is left of the file that grew";
  EXPECT_EQ(server_.asked, 3);
  EXPECT_EQ(server_.heard()[0].fetch_file().task(), 7U) << "the number of the job";
  EXPECT_EQ(server_.heard()[0].fetch_file().attempt(), 0U);
}

TEST_F(Fetched, what_is_whole_is_not_fetched_again_and_what_differs_is) {
  const wire::JobStatus status = server_.job_with("wing.vtkhdf", some_bytes());
  fetch(status);
  EXPECT_THAT(fetch(status), testing::ElementsAre(out_ / "wing.vtkhdf"));
  EXPECT_EQ(server_.asked, 3);
  std::string other = some_bytes();
  other[5] ^= 1;
  write_file_atomically(out_ / "wing.vtkhdf", other);
  fetch(status);
  EXPECT_EQ(read_file(out_ / "wing.vtkhdf"), some_bytes());
  EXPECT_EQ(server_.asked, 6);
}

TEST_F(Fetched, what_came_before_is_gone_on_from) {
  const wire::JobStatus status = server_.job_with("wing.vtkhdf", some_bytes());
  make_folders(out_);
  const std::filesystem::path growing = out_ / ("." + status.files(0).hash() + ".part");
  write_file_atomically(growing, some_bytes().substr(0, chunk_bytes));
  fetch(status);
  EXPECT_EQ(server_.asked, 2);
  EXPECT_EQ(read_file(out_ / "wing.vtkhdf"), some_bytes());
}

TEST_F(Fetched, what_came_before_and_is_damaged_comes_anew) {
  const wire::JobStatus status = server_.job_with("wing.vtkhdf", some_bytes());
  make_folders(out_);
  const std::filesystem::path growing = out_ / ("." + status.files(0).hash() + ".part");
  write_file_atomically(growing, std::string(chunk_bytes, 'x'));
  fetch(status);
  EXPECT_EQ(server_.asked, 2 + 3);
  EXPECT_EQ(read_file(out_ / "wing.vtkhdf"), some_bytes());
}

TEST_F(Fetched, what_the_coordinator_has_lost_is_not_found) {
  server_.is_missing = true;
  EXPECT_EQ(trouble_with(server_.job_with("wing.vtkhdf", some_bytes()), ExitCode::not_found),
            "wing.vtkhdf of job-7 is no longer in the coordinator's store");
  EXPECT_EQ(count_files(out_), 0U);
}

TEST_F(Fetched, what_is_damaged_there_is_an_error_and_stays_nowhere) {
  std::string other = some_bytes();
  other[5] ^= 1;
  const wire::JobStatus status = server_.job_with("wing.vtkhdf", other);
  EXPECT_EQ(trouble_with(status, ExitCode::failed),
            "wing.vtkhdf of job-7: is damaged in the coordinator's store: its checksum is not " +
                status.files(0).hash() + " (`tetfarm check --store DIR` on its machine says more)");
  EXPECT_EQ(count_files(out_), 0U);
}

TEST_F(Fetched, what_another_process_fetches_is_left_to_it) {
  const wire::JobStatus status = server_.job_with("wing.vtkhdf", some_bytes());
  make_folders(out_);
  const auto lock = FolderLock::take_unsigned(out_ / ("." + status.files(0).hash() + ".part"));
  ASSERT_TRUE(lock);
  EXPECT_EQ(trouble_with(status, ExitCode::failed),
            (out_ / "wing.vtkhdf").string() +
                ": another process is fetching it; wait until that has ended");
}

TEST_F(Fetched, what_no_disk_holds_is_not_begun) {
  wire::JobStatus status = server_.job_with("wing.vtkhdf", some_bytes());
  status.mutable_files(0)->set_size(std::uint64_t{1} << 60U);
  EXPECT_THAT(trouble_with(status, ExitCode::out_of_resources),
              testing::StartsWith(out_.string() + ": the files of job-7 need 1152921504.61 GB, "
                                                  "but the disk has only "));
  EXPECT_EQ(server_.asked, 0);
}

TEST_F(Fetched, a_file_for_a_while_is_gone_with_its_object) {
  const wire::JobStatus status = server_.job_with("wing.vtkhdf", some_bytes());
  std::filesystem::path place;
  {
    const PassingFile file =
        fetch_for_a_while(connection_, status, status.files(0), folder_.path(), quietly);
    place = file.path();
    EXPECT_EQ(place.parent_path(), folder_.path());
    EXPECT_EQ(read_file(place), some_bytes());
  }
  EXPECT_FALSE(std::filesystem::exists(place));
}

}  // namespace
}  // namespace tetfarm
