#include "worker/task_program.h"

#include <gmock/gmock.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <array>

#include "base/error.h"
#include "mesh/artifacts/artifact_file.h"
#include "mesh/decompose/planar_cut.h"
#include "proto/messages.pb.h"
#include "store/artifact_store.h"
#include "tasks/failure_cause.h"
#include "tests/base/temp_folder.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

/// A file in memory, read from its beginning.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& bytes) : fd_(::memfd_create("test", 0)) {
    EXPECT_EQ(::write(fd_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    ::lseek(fd_, 0, SEEK_SET);
  }
  ~MemoryFile() { ::close(fd_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  int fd() const { return fd_; }
  std::string bytes() const {
    std::string text(static_cast<std::size_t>(::lseek(fd_, 0, SEEK_END)), '\0');
    EXPECT_EQ(::pread(fd_, text.data(), text.size(), 0), static_cast<ssize_t>(text.size()));
    return text;
  }

 private:
  int fd_;
};

class TaskProgram : public testing::Test {
 protected:
  TaskProgram() { ::prctl(PR_GET_NAME, name_.data()); }
  ~TaskProgram() override { ::prctl(PR_SET_NAME, name_.data()); }

  wire::Artifact& give(const std::string& name, const std::string& bytes) {
    const StoredArtifact stored = store_.publish(bytes);
    wire::Artifact& input = *start_.mutable_assign()->add_inputs();
    input.set_name(name);
    input.set_hash(stored.hash);
    input.set_size(stored.size);
    return input;
  }
  std::vector<wire::Envelope> run() {
    const MemoryFile in(start_.SerializeAsString());
    const MemoryFile out("");
    run_task_program(folder_.path(), in.fd(), out.fd());
    const std::string bytes = out.bytes();
    std::vector<wire::Envelope> envelopes;
    for (std::size_t at = 0; at + 4 <= bytes.size();) {
      std::size_t length = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        length |= std::size_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
      }
      EXPECT_TRUE(envelopes.emplace_back().ParseFromString(bytes.substr(at + 4, length)));
      at += 4 + length;
    }
    return envelopes;
  }

  std::array<char, 16> name_{};
  TempFolder folder_;
  ArtifactStore store_{folder_.path()};
  wire::TaskStart start_;
};

TEST_F(TaskProgram, does_the_task_of_its_number_and_says_what_it_does_on_the_way) {
  start_.mutable_assign()->set_kind(7);
  for (const char* heap : {"4", "5"}) {
    Subdomain leaf = root_subdomain(shapes::unit_cube());
    leaf.path = {static_cast<std::uint64_t>(*heap - '0')};
    leaf.region = 1;
    give(std::string("subdomain:") + heap, subdomain_to_bytes(leaf));
  }
  const std::vector<wire::Envelope> said = run();
  ASSERT_GE(said.size(), 2U);
  EXPECT_EQ(said[0].heartbeat().doing().stage(), "order");
  ASSERT_TRUE(said.back().has_done()) << said.back().failed().message();
  EXPECT_EQ(said.back().done().texts().at("order"), "4 0\n5 0\n");
}

TEST_F(TaskProgram, has_a_body_for_each_kind_and_for_no_other_number) {
  using testing::StartsWith;
  const std::array<const char*, 16> names = {
      "",        "inspect",  "decompose", "mesh", "number", "assemble", "assimilate", "order",
      "extract", "cosmetic", "write",     "grow", "solve",  "adapt",    "collect",    "remesh"};
  for (std::uint32_t kind = 1; kind < names.size(); ++kind) {
    start_.mutable_assign()->set_kind(kind);
    if (kind == 7) continue;   // it may be given nothing
    if (kind == 12) continue;  // it may not be allowed here
    const std::vector<wire::Envelope> said = run();
    ASSERT_EQ(said.size(), 1U) << names[kind];
    EXPECT_EQ(said[0].failed().cause(), on_wire(FailureCause::for_good)) << names[kind];
    EXPECT_THAT(said[0].failed().message(), StartsWith("the task to " + std::string(names[kind]) +
                                                       " cannot be done: the file '"));
  }
  start_.mutable_assign()->set_kind(12);
  EXPECT_EQ(run().at(0).failed().message(),
            "the loop: this worker runs no solvers: start workers for loops with `tetfarm worker "
            "--solvers`");
  start_.mutable_assign()->set_kind(16);
  EXPECT_EQ(run().at(0).failed().message(), "this worker cannot run tasks of kind 16");
  start_.mutable_assign()->set_kind(0);
  EXPECT_EQ(run().at(0).failed().message(), "this worker cannot run tasks of kind 0");
}

TEST_F(TaskProgram, cannot_do_what_it_cannot_read) {
  const MemoryFile in("\xff\xff\xff");
  const MemoryFile out("");
  try {
    run_task_program(folder_.path(), in.fd(), out.fd());
    ADD_FAILURE() << "it is garbage";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "the assignment cannot be read");
  }
  EXPECT_EQ(out.bytes(), "");
  try {
    run_task_program(folder_.path(), -1, out.fd());
    ADD_FAILURE() << "there is nothing to read";
  } catch (const IoError& error) {
    EXPECT_STREQ(error.what(), "standard input: cannot read the task: Bad file descriptor");
  }
  const MemoryFile good(start_.SerializeAsString());
  EXPECT_THROW(run_task_program(folder_.path(), good.fd(), -1), IoError);
}

}  // namespace
}  // namespace tetfarm
