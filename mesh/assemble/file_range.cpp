#include "mesh/assemble/file_range.h"

#include <algorithm>
#include <cerrno>
#include <fstream>

#include "base/error.h"

namespace tetfarm {
namespace {

/// Ranges as the bytes of the file pass by.
class PassedRanges {
 public:
  explicit PassedRanges(std::span<const FileRange> ranges) : ranges_(ranges) {}

  void add(const char* bytes, std::int64_t first, std::int64_t size) {
    const std::int64_t end = first + size;
    while (now_ < ranges_.size() && ranges_[now_].offset < end) {
      const FileRange& range = ranges_[now_];
      const std::int64_t from = std::max(range.offset, first);
      const std::int64_t to = std::min(range.offset + range.size, end);
      hasher_.add(bytes + (from - first), static_cast<std::size_t>(std::max(to - from, {})));
      if (range.offset + range.size > end) return;
      judge(hasher_.finish() == range.hash);
    }
  }

  std::vector<std::size_t> finish() {
    while (now_ < ranges_.size()) judge(false);
    return std::move(wrong_);
  }

 private:
  void judge(bool is_right) {
    if (!is_right) wrong_.push_back(now_);
    ++now_;
    hasher_ = Hasher();
  }

  std::span<const FileRange> ranges_;
  std::size_t now_ = 0;
  Hasher hasher_;  ///< of what has passed of the range `now_`
  std::vector<std::size_t> wrong_;
};

}  // namespace

ReadThrough read_through(const std::filesystem::path& path, std::span<const FileRange> ranges) {
  constexpr std::size_t buffer_bytes = std::size_t{1} << 20;
  std::ifstream file;
  file.rdbuf()->pubsetbuf(nullptr, 0);
  file.open(path, std::ios::binary);
  if (!file) throw IoError("cannot read", path.string(), errno);
  ReadThrough result;
  Hasher whole;
  PassedRanges passed(ranges);
  std::vector<char> buffer(buffer_bytes);
  while (file) {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    if (file.bad()) throw IoError("cannot read", path.string(), EIO);
    const std::int64_t count = file.gcount();
    whole.add(buffer.data(), static_cast<std::size_t>(count));
    passed.add(buffer.data(), result.size, count);
    result.size += count;
  }
  result.hash = whole.finish();
  result.wrong = passed.finish();
  return result;
}

}  // namespace tetfarm
