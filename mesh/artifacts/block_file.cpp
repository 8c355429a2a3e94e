#include "mesh/artifacts/block_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/retry_on_eintr.h"
#include "mesh/artifacts/byte_stream.h"
#include "mesh/artifacts/checked_bytes.h"

namespace tetfarm {
namespace {

/// A quarter of a mebibyte: binary searches meet the same blocks again and again.
constexpr std::size_t most_kept_blocks = 64;

std::uint64_t blocks_of(std::uint64_t content) { return (content + block_size - 1) / block_size; }

/// How much of a file of that size is content; no whole blocks with their checksums make up certain
/// sizes.
std::uint64_t content_size(std::uint64_t file_size, const std::string& name) {
  const std::uint64_t with_checksum = block_size + checksum_size;
  const std::uint64_t blocks = (file_size + with_checksum - 1) / with_checksum;
  const std::uint64_t checksums = blocks * checksum_size;
  if (file_size < checksums || blocks_of(file_size - checksums) != blocks) {
    throw CorruptFile("is cut short", name);
  }
  return file_size - checksums;
}

void check_block(std::string_view block, std::string_view checksum, std::uint64_t number,
                 const std::string& name) {
  if (ByteReader(checksum, name).hash() != hash128(block)) {
    throw CorruptFile("has a wrong checksum for block " + std::to_string(number), name);
  }
}

}  // namespace

std::string with_block_checksums(std::string content) {
  ByteWriter checksums;
  for (std::uint64_t offset = 0; offset < content.size(); offset += block_size) {
    checksums.hash(hash128(std::string_view(content).substr(offset, block_size)));
  }
  return std::move(content) + checksums.bytes();
}

std::string_view content_of_blocks(std::string_view bytes, const std::string& name) {
  const std::string_view content = bytes.substr(0, content_size(bytes.size(), name));
  const std::string_view checksums = bytes.substr(content.size());
  for (std::uint64_t i = 0; i < blocks_of(content.size()); ++i) {
    check_block(content.substr(i * block_size, block_size),
                checksums.substr(i * checksum_size, checksum_size), i, name);
  }
  return content;
}

BlockFile::BlockFile(const std::filesystem::path& path, std::string name)
    : path_(path), name_(std::move(name)) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw IoError("cannot open", path.string(), errno);
  descriptor_ = {new int(descriptor), [](const int* open) {
                   ::close(*open);
                   delete open;
                 }};
  const off_t end = ::lseek(descriptor, 0, SEEK_END);
  if (end < 0) throw IoError("cannot read", path.string(), errno);
  size_ = content_size(static_cast<std::uint64_t>(end), name_);
}

std::string BlockFile::read(std::uint64_t offset, std::uint64_t size) {
  if (offset > size_ || size > size_ - offset) fail("is cut short");
  std::string bytes(size, '\0');
  copy(offset, bytes);
  return bytes;
}

void BlockFile::copy(std::uint64_t offset, std::span<char> into) {
  if (offset > size_ || into.size() > size_ - offset) fail("is cut short");
  while (!into.empty()) {
    const std::string& here = block(offset / block_size);
    const std::uint64_t skipped = offset % block_size;
    TF_CHECK(skipped < here.size());
    const std::size_t size = std::min<std::size_t>(into.size(), here.size() - skipped);
    std::memcpy(into.data(), here.data() + skipped, size);
    into = into.subspan(size);
    offset += size;
  }
}

const std::string& BlockFile::block(std::uint64_t number) {
  const auto found = kept_.find(number);
  if (found != kept_.end()) return found->second;
  const std::uint64_t offset = number * block_size;
  std::string bytes = read_from_disk(offset, std::min(block_size, size_ - offset));
  check_block(bytes, read_from_disk(size_ + number * checksum_size, checksum_size), number, name_);
  bytes_read_ += bytes.size();
  if (kept_.size() == most_kept_blocks) kept_.clear();
  return kept_.emplace(number, std::move(bytes)).first->second;
}

std::string BlockFile::read_from_disk(std::uint64_t offset, std::uint64_t size) const {
  std::string bytes(size, '\0');
  for (std::size_t done = 0; done < size;) {
    const ssize_t n = retry_on_eintr([&] {
      return ::pread(*descriptor_, bytes.data() + done, size - done,
                     static_cast<off_t>(offset + done));
    });
    if (n <= 0) throw IoError("cannot read", path_.string(), n < 0 ? errno : EIO);
    done += static_cast<std::size_t>(n);
  }
  return bytes;
}

void BlockFile::fail(const std::string& what) const { throw CorruptFile(what, name_); }

}  // namespace tetfarm
