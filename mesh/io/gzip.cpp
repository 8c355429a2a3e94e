#include "mesh/io/gzip.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <limits>

#include "base/check.h"
#include "base/error.h"

namespace tetfarm {
namespace {

constexpr std::size_t max_unpacked = std::size_t{32} << 30;

class Inflater {
 public:
  Inflater() {
    constexpr int window_bits_of_gzip = 15 + 16;
    TF_CHECK(inflateInit2(&stream, window_bits_of_gzip) == Z_OK);
  }
  ~Inflater() { inflateEnd(&stream); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  z_stream stream{};
};

class File {
 public:
  explicit File(const std::string& path) : descriptor(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (descriptor < 0) throw IoError("cannot open", path, errno);
  }
  ~File() { close(descriptor); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  const int descriptor;
};

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::string unpack_gzip(std::string_view bytes, const std::string& name) {
  Inflater inflater;
  z_stream& z = inflater.stream;
  std::string unpacked;
  std::size_t used = 0;
  constexpr std::size_t most_at_once = std::numeric_limits<uInt>::max();
  const char* next = bytes.data();
  const char* const end = bytes.data() + bytes.size();
  for (;;) {
    if (used == unpacked.size()) {
      if (used >= max_unpacked) throw InvalidInput("is more than 32 GiB unpacked", name);
      unpacked.resize(std::max(4 * bytes.size(), 2 * used) + 1024);
    }
    const std::size_t in = std::min(static_cast<std::size_t>(end - next), most_at_once);
    const std::size_t out = std::min(unpacked.size() - used, most_at_once);
    z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(next));
    z.avail_in = static_cast<uInt>(in);
    z.next_out = reinterpret_cast<Bytef*>(unpacked.data() + used);
    z.avail_out = static_cast<uInt>(out);
    const int result = inflate(&z, Z_NO_FLUSH);
    next += in - z.avail_in;
    used += out - z.avail_out;
    if (result == Z_STREAM_END) {
      if (!is_gzip({next, static_cast<std::size_t>(end - next)})) break;
      TF_CHECK(inflateReset(&z) == Z_OK);
    } else if (result == Z_BUF_ERROR || (result == Z_OK && next == end && z.avail_out > 0)) {
      throw InvalidInput("the gzip data are cut short", name);
    } else if (result != Z_OK) {
      throw InvalidInput("the gzip data are damaged",
                         name + ": byte " + std::to_string(next - bytes.data()));
    }
  }
  if (std::any_of(next, end, [](char c) { return c != '\0'; })) {
    throw InvalidInput("has more bytes after the gzip data", name);
  }
  unpacked.resize(used);
  return unpacked;
}

std::string read_whole_file(const std::string& path) {
  const File file(path);
  struct stat status {};
  if (fstat(file.descriptor, &status) != 0) throw IoError("cannot look at", path, errno);
  std::string bytes;
  std::size_t used = 0;
  bytes.resize(static_cast<std::size_t>(std::max<off_t>(status.st_size, 0)) + 1);
  for (;;) {
    const ssize_t got = read(file.descriptor, bytes.data() + used, bytes.size() - used);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw IoError("cannot read", path, errno);
    if (got == 0) break;
    used += static_cast<std::size_t>(got);
    if (used == bytes.size()) bytes.resize(2 * bytes.size());
  }
  bytes.resize(used);
  return bytes;
}

}  // namespace tetfarm
