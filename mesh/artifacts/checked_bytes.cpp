#include "mesh/artifacts/checked_bytes.h"

#include <utility>

#include "base/error.h"
#include "base/hash.h"

namespace tetfarm {

ByteWriter begin_checked(std::string_view magic, std::uint32_t version, std::size_t rest) {
  ByteWriter writer;
  writer.reserve(magic.size() + sizeof version + rest + checksum_size);
  writer.text(magic);
  writer.number(version);
  return writer;
}

bool says_version(std::string_view bytes, std::string_view magic, std::uint32_t version) {
  return bytes.starts_with(begin_checked(magic, version).bytes());
}

std::string finish_checked(ByteWriter writer) {
  writer.hash(hash128(writer.bytes()));
  return writer.take();
}

ByteReader read_checked(std::string_view bytes, std::string_view magic, std::uint32_t version,
                        const std::string& name) {
  const std::size_t end = bytes.size() < checksum_size ? 0 : bytes.size() - checksum_size;
  const std::string_view checked = bytes.substr(0, end);
  // What begins rightly and ends too early is no other kind of file.
  if (bytes.starts_with(magic) && checked.size() < magic.size()) {
    throw CorruptFile("is cut short", name);
  }
  ByteReader reader = read_begun(checked, magic, version, name);
  if (ByteReader(bytes.substr(end), name).hash() != hash128(checked)) {
    reader.fail("has a wrong checksum");
  }
  return reader;
}

ByteReader read_begun(std::string_view bytes, std::string_view magic, std::uint32_t version,
                      const std::string& name) {
  if (!bytes.starts_with(magic)) {
    throw CorruptFile("does not begin like the expected kind of file", name);
  }
  ByteReader reader(bytes.substr(magic.size()), name);
  const auto found = reader.number<std::uint32_t>();
  if (found != version) {
    reader.fail("has the format version " + std::to_string(found) + ", not " +
                std::to_string(version));
  }
  return reader;
}

}  // namespace tetfarm
