/// Files of which a task reads the few parts that it needs, however large they are: their content
/// is followed by a checksum of each block of it, so that a part is checked without the rest.
///
/// A reader throws CorruptFile naming `name` when what it reads is damaged, also by a file that was
/// cut short; damage elsewhere is seen by whoever reads that. The grammar is in store/formats.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace tetfarm {

/// Bytes of the content that have one checksum; the last block may have fewer.
inline constexpr std::uint64_t block_size = 4096;

/// The content with its checksums behind it. Cost: O(n).
std::string with_block_checksums(std::string content);

/// The content of a whole file, all of it checked. @throws CorruptFile. Cost: O(n).
std::string_view content_of_blocks(std::string_view bytes, const std::string& name);

/// Such a file, open to read parts of it. @throws CorruptFile, IoError.
class BlockFile {
 public:
  BlockFile(const std::filesystem::path& path, std::string name);

  /// Of the content.
  std::uint64_t size() const { return size_; }
  /// Fails where the content ends before. Cost: the blocks that it lies in.
  std::string read(std::uint64_t offset, std::uint64_t size);
  /// Item `index` of the array that begins at `offset`. Cost: a block or two; none for those that
  /// lie in the blocks that were read last.
  template <class Item>
  Item item(std::uint64_t offset, std::uint64_t index);
  /// Bytes of content read so far.
  std::uint64_t bytes_read() const { return bytes_read_; }
  [[noreturn]] void fail(const std::string& what) const;

 private:
  void copy(std::uint64_t offset, std::span<char> into);
  const std::string& block(std::uint64_t number);
  std::string read_from_disk(std::uint64_t offset, std::uint64_t size) const;

  std::filesystem::path path_;
  std::string name_;
  std::shared_ptr<const int> descriptor_;
  std::uint64_t size_ = 0;
  std::map<std::uint64_t, std::string> kept_;  ///< of the blocks that were read last
  std::uint64_t bytes_read_ = 0;
};

template <class Item>
Item BlockFile::item(std::uint64_t offset, std::uint64_t index) {
  static_assert(std::is_trivially_copyable_v<Item>);
  Item item;
  copy(offset + index * sizeof(Item), {reinterpret_cast<char*>(&item), sizeof(Item)});
  return item;
}

}  // namespace tetfarm
