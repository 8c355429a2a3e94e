#include "store/network_file_system.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/statfs.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file_system.h"
#include "store/job_database.h"
#include "tests/base/temp_folder.h"

namespace {

/// What this folder pretends to be; statfs below takes the place of libc's in this program.
std::string pretender;
long pretended_magic = 0;

}  // namespace

extern "C" int statfs(const char* path, struct statfs* result) noexcept {
  const auto answer = static_cast<int>(::syscall(SYS_statfs, path, result));
  if (answer == 0 && !pretender.empty() && pretender == path) result->f_type = pretended_magic;
  return answer;
}

namespace tetfarm {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

class Database : public testing::Test {
 protected:
  ~Database() override { pretender.clear(); }
  void put_on(long magic) const {
    pretender = folder_.path().string();
    pretended_magic = magic;
  }
  TempFolder folder_;
};

TEST_F(Database, on_a_network_file_system_is_refused_with_the_reason) {
  for (const long magic :
       {0x6969L, 0xFF534D42L, 0xFE534D42L, 0x0BD00BD0L, 0x47504653L, 0x19830326L}) {
    put_on(magic);
    EXPECT_THAT([&] { JobDatabase(folder_.path() / "tetfarm.db"); },
                ThrowsMessage<UsageError>(AllOf(HasSubstr("network file system"),
                                                HasSubstr(folder_.path().string()),
                                                HasSubstr("--database"))))
        << magic;
    EXPECT_FALSE(size_of_file(folder_.path() / "tetfarm.db"));
  }
}

TEST_F(Database, on_a_local_file_system_is_opened) {
  EXPECT_NO_THROW(JobDatabase(folder_.path() / "tetfarm.db"));
  put_on(0x794C7630);  // overlay, as in containers
  EXPECT_NO_THROW(JobDatabase(folder_.path() / "tetfarm.db"));
}

TEST(NetworkFileSystem, are_known_by_their_numbers) {
  EXPECT_EQ(network_file_system_named(0x6969, "nfs4"), "nfs");
  EXPECT_EQ(network_file_system_named(0xFF534D42, "cifs"), "cifs");
  EXPECT_EQ(network_file_system_named(0x0BD00BD0, ""), "lustre");
  for (const std::uint32_t local : {0xEF53U, 0x58465342U, 0x9123683EU, 0x01021994U, 0x794C7630U}) {
    EXPECT_EQ(network_file_system_named(local, ""), "") << local;
  }
}

TEST(NetworkFileSystem, of_fuse_the_name_decides) {
  EXPECT_EQ(network_file_system_named(0x65735546, "fuse.sshfs"), "fuse.sshfs");
  EXPECT_EQ(network_file_system_named(0x65735546, "fuse.glusterfs"), "fuse.glusterfs");
  EXPECT_EQ(network_file_system_named(0x65735546, "fuseblk"), "");
  EXPECT_EQ(network_file_system_named(0xEF53, "fuse.sshfs"), "") << "no FUSE at all";
}

TEST(NetworkFileSystem, the_kind_is_read_from_the_table_of_mounts) {
  const char* const mounts =
      "22 27 0:21 / /proc rw,relatime - proc proc rw\n"
      "27 1 254:0 / / rw,relatime shared:1 master:2 - ext4 /dev/vda rw\n"
      "90 27 0:55 / /home/anna/with\\040space rw - fuse.sshfs anna@host:/ rw\n";
  EXPECT_EQ(mounted_kind(mounts, "254:0"), "ext4");
  EXPECT_EQ(mounted_kind(mounts, "0:55"), "fuse.sshfs");
  EXPECT_EQ(mounted_kind(mounts, "0:99"), "");
  EXPECT_EQ(mounted_kind("nonsense\n\n", "0:55"), "");
}

TEST(NetworkFileSystem, are_all_that_clusters_use) {
  const std::vector<std::pair<std::uint32_t, std::string>> kinds = {
      {0x00006969, "nfs"},    {0xFF534D42, "cifs"},  {0xFE534D42, "smb3"},    {0x0000517B, "smbfs"},
      {0x0BD00BD0, "lustre"}, {0x47504653, "gpfs"},  {0x19830326, "beegfs"},  {0x00C36400, "ceph"},
      {0x5346414F, "afs"},    {0x6B414653, "afs"},   {0x73757245, "coda"},    {0x0000564C, "ncp"},
      {0x01161970, "gfs2"},   {0x7461636F, "ocfs2"}, {0x20030528, "orangefs"}};
  for (const auto& [magic, kind] : kinds) EXPECT_EQ(network_file_system_named(magic, ""), kind);
  for (const char* kind :
       {"sshfs",   "glusterfs", "ceph",          "ceph-fuse", "beegfs",     "beeond",
        "moosefs", "mfs",       "lizardfs",      "saunafs",   "juicefs",    "seaweedfs",
        "s3fs",    "goofys",    "mountpoint-s3", "gcsfuse",   "blobfuse2",  "rclone",
        "davfs",   "curlftpfs", "smbnetfs",      "hdfs",      "gvfsd-fuse", "nfs"}) {
    const std::string name = std::string("fuse.") + kind;
    EXPECT_EQ(network_file_system_named(0x65735546, name), name);
    EXPECT_EQ(network_file_system_named(0x65735546, kind), "");
  }
}

}  // namespace
}  // namespace tetfarm
