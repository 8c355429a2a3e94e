#include "store/network_file_system.h"

#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/vfs.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <sstream>

#include "base/error.h"

namespace tetfarm {
namespace {

struct Known {
  std::uint32_t magic;
  const char* kind;
};

// The numbers of linux/magic.h, and of those that are built apart from the kernel.
constexpr std::array<Known, 15> network_kinds = {{
    {0x00006969, "nfs"},
    {0xFF534D42, "cifs"},
    {0xFE534D42, "smb3"},
    {0x0000517B, "smbfs"},
    {0x0BD00BD0, "lustre"},
    {0x47504653, "gpfs"},
    {0x19830326, "beegfs"},
    {0x00C36400, "ceph"},
    {0x5346414F, "afs"},
    {0x6B414653, "afs"},
    {0x73757245, "coda"},
    {0x0000564C, "ncp"},
    {0x01161970, "gfs2"},
    {0x7461636F, "ocfs2"},
    {0x20030528, "orangefs"},
}};

// What lies behind FUSE only its name in the table of mounts tells.
constexpr std::uint32_t fuse_magic = 0x65735546;
constexpr std::array<std::string_view, 24> network_fuse = {
    "fuse.sshfs",    "fuse.glusterfs", "fuse.ceph",       "fuse.ceph-fuse", "fuse.beegfs",
    "fuse.beeond",   "fuse.moosefs",   "fuse.mfs",        "fuse.lizardfs",  "fuse.saunafs",
    "fuse.juicefs",  "fuse.seaweedfs", "fuse.s3fs",       "fuse.goofys",    "fuse.mountpoint-s3",
    "fuse.gcsfuse",  "fuse.blobfuse2", "fuse.rclone",     "fuse.davfs",     "fuse.curlftpfs",
    "fuse.smbnetfs", "fuse.hdfs",      "fuse.gvfsd-fuse", "fuse.nfs"};

std::string mount_table() {
  std::ifstream file("/proc/self/mountinfo");
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::string network_file_system_named(std::uint32_t magic, std::string_view kind) {
  if (magic == fuse_magic) {
    const bool is_network =
        std::find(network_fuse.begin(), network_fuse.end(), kind) != network_fuse.end();
    return is_network ? std::string(kind) : "";
  }
  for (const Known& known : network_kinds) {
    if (known.magic == magic) return known.kind;
  }
  return {};
}

std::string mounted_kind(std::string_view mounts, std::string_view device) {
  std::istringstream lines{std::string(mounts)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    for (int i = 0; i < 3; ++i) words >> word;  // number, number of the parent, device
    if (word != device) continue;
    while (words >> word && word != "-") continue;  // optional fields end with "-"
    words >> word;
    return word;
  }
  return {};
}

std::string network_file_system_of(const std::filesystem::path& folder) {
  struct statfs system {};
  struct stat about {};
  if (::statfs(folder.c_str(), &system) != 0 || ::stat(folder.c_str(), &about) != 0) {
    throw IoError("cannot tell what its file system is", folder.string(), errno);
  }
  const std::string device =
      std::to_string(major(about.st_dev)) + ":" + std::to_string(minor(about.st_dev));
  return network_file_system_named(static_cast<std::uint32_t>(system.f_type),
                                   mounted_kind(mount_table(), device));
}

}  // namespace tetfarm
