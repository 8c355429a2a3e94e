#include "mesh/formats/gzip.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <vector>

#include "base/check.h"
#include "base/error.h"
#include "base/mebibytes.h"

namespace tetfarm {
namespace {

constexpr std::uint64_t most_bytes = std::uint64_t{32} << 30;
/// Surfaces as text pack to between a tenth and a fortieth; gzip itself reaches a thousandth.
constexpr std::uint64_t most_times = 200;
/// Whatever the ratio: small files are often regular.
constexpr std::uint64_t always_allowed = std::uint64_t{64} << 20;
constexpr std::size_t window_bytes = std::size_t{256} << 10;

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

[[noreturn]] void refuse_size(std::uint64_t packed_bytes, std::uint64_t limit,
                              const std::string& name) {
  throw InvalidInput("unpacks to more than " + mebibytes(limit) +
                         ", the most that is accepted from " + std::to_string(packed_bytes) +
                         " bytes of gzip; if that is as it should be, unpack it with gunzip and "
                         "give the unpacked file",
                     name);
}

/// What all members hold, one after the other, given to `take` a window at a time.
template <class Take>
void inflate_members(std::string_view bytes, const std::string& name, const Take& take) {
  Inflater inflater;
  z_stream& z = inflater.stream;
  std::vector<char> window(window_bytes);
  constexpr std::size_t most_at_once = std::numeric_limits<uInt>::max();
  const char* next = bytes.data();
  const char* const end = bytes.data() + bytes.size();
  for (;;) {
    const std::size_t in = std::min(static_cast<std::size_t>(end - next), most_at_once);
    z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(next));
    z.avail_in = static_cast<uInt>(in);
    z.next_out = reinterpret_cast<Bytef*>(window.data());
    z.avail_out = static_cast<uInt>(window.size());
    const int result = inflate(&z, Z_NO_FLUSH);
    next += in - z.avail_in;
    take(window.data(), window.size() - z.avail_out);
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
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::uint64_t most_unpacked(std::uint64_t packed_bytes) {
  return std::min(most_bytes, std::max(always_allowed, most_times * packed_bytes));
}

std::string unpack_gzip(std::string_view bytes, const std::string& name) {
  // Counted first: what is too large is refused without ever being in memory, and what is not gets
  // memory once, no more than it needs.
  const std::uint64_t limit = most_unpacked(bytes.size());
  std::uint64_t size = 0;
  inflate_members(bytes, name, [&](const char*, std::size_t count) {
    size += count;
    if (size > limit) refuse_size(bytes.size(), limit, name);
  });
  std::string unpacked;
  unpacked.reserve(size);
  inflate_members(bytes, name, [&unpacked](const char* window, std::size_t count) {
    unpacked.append(window, count);
  });
  return unpacked;
}

std::string read_whole_file(const std::string& path) {
  const File file(path);
  struct stat status {};
  if (fstat(file.descriptor, &status) != 0) throw IoError("cannot stat", path, errno);
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
