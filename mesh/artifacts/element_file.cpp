#include "mesh/artifacts/element_file.h"

#include <algorithm>
#include <optional>

#include "base/check.h"
#include "base/file_system.h"
#include "mesh/artifacts/checked_bytes.h"

namespace tetfarm {
namespace {

static_assert(sizeof(Vec3) == 24 && sizeof(Triangle) == 12 && sizeof(Tet) == 16);

constexpr std::string_view elements_magic = "TFELEM\r\n";
constexpr std::string_view shared_magic = "TFSHAR\r\n";
constexpr std::uint32_t shared_version = 1;
constexpr std::uint32_t elements_version = 3;
/// Magic, version, size of the head, checksum of the head.
constexpr std::size_t prefix_size = 8 + 4 + 8 + checksum_size;

std::string section_bytes(const ElementSection& section) {
  ByteWriter writer;
  writer.number<std::uint64_t>(section.nodes.size());
  writer.number<std::uint64_t>(section.tets.size());
  writer.number<std::uint64_t>(section.triangles.size());
  writer.array(section.nodes);
  writer.origins(section.node_origin);
  writer.array(section.tets);
  writer.array(section.tet_owner);
  writer.array(section.triangles);
  writer.array(section.triangle_index);
  writer.array(section.triangle_owner);
  return writer.take();
}

ElementSection section_from(std::string_view bytes, const Sharers& sharers,
                            const std::string& name) {
  ByteReader reader(bytes, name);
  ElementSection section;
  section.sharers = sharers;
  const std::size_t nodes = reader.count();
  const std::size_t tets = reader.count();
  const std::size_t triangles = reader.count();
  section.nodes = reader.array<Vec3>(nodes);
  section.node_origin = reader.origins(nodes);
  section.tets = reader.array<Tet>(tets);
  section.tet_owner = reader.array<std::uint8_t>(tets);
  section.triangles = reader.array<Triangle>(triangles);
  section.triangle_index = reader.array<std::uint32_t>(triangles);
  section.triangle_owner = reader.array<std::uint8_t>(triangles);
  reader.expect_end();
  const std::vector<std::string> complaints = validate(section);
  if (!complaints.empty()) reader.fail(complaints.front());
  return section;
}

std::string core_bytes(const CoreElements& core) {
  ByteWriter writer;
  writer.number<std::uint64_t>(core.taken_tets.size());
  writer.number<std::uint64_t>(core.taken_triangles.size());
  writer.array(core.taken_tets);
  writer.array(core.taken_triangles);
  return writer.take();
}

CoreElements core_from(std::string_view bytes, const ElementFileHead::Section& entry,
                       const std::string& name) {
  ByteReader reader(bytes, name);
  CoreElements core;
  core.tets = entry.tets.front();
  core.triangles = entry.triangles.front();
  const std::size_t taken_tets = reader.count();
  const std::size_t taken_triangles = reader.count();
  core.taken_tets = reader.array<std::uint32_t>(taken_tets);
  core.taken_triangles = reader.array<std::uint32_t>(taken_triangles);
  reader.expect_end();
  for (const auto* taken : {&core.taken_tets, &core.taken_triangles}) {
    const auto out_of_order =
        std::adjacent_find(taken->begin(), taken->end(), [](auto a, auto b) { return a >= b; });
    if (out_of_order != taken->end()) reader.fail("does not list what was taken in order");
  }
  return core;
}

/// What the head says of a section, or of the core.
void add_entry(ByteWriter& writer, const Sharers& sharers, const std::vector<std::uint64_t>& tets,
               const std::vector<std::uint64_t>& triangles, const std::string& body) {
  TF_CHECK(tets.size() == sharers.size() && triangles.size() == sharers.size());
  writer.number<std::uint64_t>(sharers.size());
  writer.array(sharers);
  writer.array(tets);
  writer.array(triangles);
  writer.number<std::uint64_t>(body.size());
  writer.hash(hash128(body));
}

std::string head_bytes(const ElementFileHead& head, const std::vector<ElementSection>& sections,
                       const std::optional<CoreElements>& core,
                       const std::vector<std::string>& bodies) {
  ByteWriter writer;
  writer.number(head.path.heap);
  writer.number(head.next_node);
  writer.number<std::uint64_t>(head.gone.size());
  writer.origins(head.gone);
  writer.number<std::uint64_t>(bodies.size());
  auto body = bodies.begin();
  TF_CHECK(bodies.size() == sections.size() + (core ? 1 : 0));
  if (core) add_entry(writer, {head.path.heap}, {core->tets}, {core->triangles}, *body++);
  for (const ElementSection& section : sections) {
    add_entry(writer, section.sharers, tets_by_sharer(section), triangles_by_sharer(section),
              *body++);
  }
  return writer.take();
}

ElementFileHead head_from(std::string_view bytes, const std::string& name) {
  ByteReader reader(bytes, name);
  ElementFileHead head;
  head.path.heap = reader.number<std::uint64_t>();
  head.next_node = reader.number<std::uint32_t>();
  head.gone = reader.origins(reader.count());
  const std::size_t sections = reader.count();
  std::uint64_t offset = prefix_size + bytes.size();
  for (std::size_t s = 0; s < sections; ++s) {
    ElementFileHead::Section& section = head.sections.emplace_back();
    const std::size_t sharers = reader.count();
    if (sharers == 0 || sharers > most_sharers)
      reader.fail("has a section with no sharers, or too many");
    section.sharers = reader.array<std::uint64_t>(sharers);
    section.tets = reader.array<std::uint64_t>(sharers);
    section.triangles = reader.array<std::uint64_t>(sharers);
    section.offset = offset;
    section.size = reader.number<std::uint64_t>();
    section.checksum = reader.hash();
    offset += section.size;
  }
  reader.expect_end();
  return head;
}

}  // namespace

std::optional<std::size_t> ElementFileHead::find(const Sharers& sharers) const {
  for (std::size_t s = 0; s < sections.size(); ++s) {
    if (sections[s].sharers == sharers) return s;
  }
  return std::nullopt;
}

std::string elements_to_bytes(const ElementFileHead& head,
                              const std::vector<ElementSection>& sections,
                              const std::optional<CoreElements>& core) {
  std::vector<std::string> bodies;
  if (core) bodies.push_back(core_bytes(*core));
  for (const ElementSection& section : sections) bodies.push_back(section_bytes(section));
  const std::string described = head_bytes(head, sections, core, bodies);
  ByteWriter prefix;
  prefix.number(elements_version);
  prefix.number<std::uint64_t>(described.size());
  prefix.hash(hash128(described));
  std::string bytes = std::string(elements_magic) + prefix.bytes() + described;
  for (std::string& body : bodies) {
    bytes += body;
    body = {};
  }
  return bytes;
}

ElementFile::ElementFile(const std::filesystem::path& path, std::string name)
    : path_(path), name_(std::move(name)) {
  const std::string prefix = read_bytes(0, prefix_size);
  ByteReader reader = read_begun(prefix, elements_magic, elements_version, name_);
  const auto size = reader.number<std::uint64_t>();
  const Hash128 checksum = reader.hash();
  const std::string bytes = read_bytes(prefix_size, size);
  if (hash128(bytes) != checksum) reader.fail("has a wrong checksum for its head");
  head_ = head_from(bytes, name_);
}

std::string ElementFile::read_body(std::size_t section) {
  const ElementFileHead::Section& wanted = head_.sections.at(section);
  std::string bytes = read_bytes(wanted.offset, wanted.size);
  if (hash128(bytes) != wanted.checksum) {
    throw CorruptFile("has a wrong checksum for section " + std::to_string(section), name_);
  }
  return bytes;
}

ElementSection ElementFile::read(std::size_t section) {
  return section_from(read_body(section), head_.sections.at(section).sharers, name_);
}

CoreElements ElementFile::read_core() {
  const bool is_core = !head_.sections.empty() && head_.sections.front().sharers.size() == 1;
  if (!is_core) throw CorruptFile("has no core", name_);
  return core_from(read_body(0), head_.sections.front(), name_);
}

std::string ElementFile::read_bytes(std::uint64_t offset, std::uint64_t size) {
  const std::optional<std::uint64_t> end = size_of_file(path_);
  // Nothing is made room for before the file is known to have it.
  if (end && (offset > *end || size > *end - offset)) throw CorruptFile("is cut short", name_);
  std::string bytes = read_part_of_file(path_, offset, size);
  if (bytes.size() < size) throw CorruptFile("is cut short", name_);
  bytes_read_ += size;
  return bytes;
}

std::string shared_nodes_to_bytes(const SharedNodes& shared) {
  ByteWriter writer = begin_checked(shared_magic, shared_version);
  writer.number(shared.path.heap);
  writer.number<std::uint64_t>(shared.sets.size());
  for (const Sharers& sharers : shared.sets) {
    writer.number<std::uint64_t>(sharers.size());
    writer.array(sharers);
  }
  writer.number<std::uint64_t>(shared.nodes.size());
  for (const SharedNodes::Node& node : shared.nodes) {
    writer.number(node.origin.owner);
    writer.number(node.origin.index);
    writer.number(node.set);
  }
  return finish_checked(std::move(writer));
}

SharedNodes shared_nodes_from_bytes(std::string_view bytes, const std::string& name) {
  ByteReader reader = read_checked(bytes, shared_magic, shared_version, name);
  SharedNodes shared;
  shared.path.heap = reader.number<std::uint64_t>();
  const std::size_t sets = reader.count();
  for (std::size_t s = 0; s < sets; ++s) {
    shared.sets.push_back(reader.array<std::uint64_t>(reader.count()));
  }
  const std::size_t nodes = reader.count();
  for (std::size_t i = 0; i < nodes; ++i) {
    SharedNodes::Node node;
    node.origin.owner = reader.number<std::uint64_t>();
    node.origin.index = reader.number<std::uint32_t>();
    node.set = reader.number<std::uint32_t>();
    if (node.set >= sets) reader.fail("has a node of a set that does not exist");
    shared.nodes.push_back(node);
  }
  reader.expect_end();
  return shared;
}

}  // namespace tetfarm
