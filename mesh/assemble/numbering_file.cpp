#include "mesh/assemble/numbering_file.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/error.h"
#include "mesh/artifacts/checked_bytes.h"

namespace tetfarm {

/// An entry of the table of cuts.
struct NumberingFile::Owner {
  std::uint64_t heap = 0;
  std::int64_t made = 0;
  std::int64_t first_node = 0;
  std::uint64_t first_dropped = 0;  ///< its first entry in the table of dropped ranges
  std::uint64_t dropped = 0;        ///< how many it has there
};

/// An entry of the table of leaves.
struct NumberingFile::Leaf {
  Owner nodes;
  std::int64_t tets = 0;
  std::int64_t first_tet = 0;
  std::int64_t first_face = 0;  ///< 0 where not all leaves' were counted
};

/// And of those of a mesh with layers.
struct NumberingFile::LeafWithOthers {
  Leaf leaf;
  std::array<std::int64_t, layer_types.size()> others{};
  std::array<std::int64_t, layer_types.size()> first_other{};
};

namespace {

constexpr std::string_view numbering_magic = "TFNUMB\r\n";
/// Of a mesh of tets alone, of one with layers, and of one whose layers have sides in planes.
constexpr std::array<std::uint32_t, 3> numbering_versions = {2, 3, 4};
constexpr std::array<std::size_t, numbering_versions.size()> types_of_version = {
    0, layer_types_without_sides, layer_types.size()};
constexpr std::string_view text_magic = "tetfarm-numbering 1\n";
constexpr std::uint64_t owner_size = 5 * 8;
constexpr std::uint64_t leaf_size = owner_size + 3 * 8;
/// Magic, version, sizes of the whole, counts of the tables.
constexpr std::uint64_t head_size = numbering_magic.size() + sizeof(std::uint32_t) + 5 * 8 + 5 * 8;

static_assert(sizeof(DroppedRange) == 24 && sizeof(ForcedNode) == 8);

constexpr std::uint64_t size_of_others(std::uint64_t types) { return 8 * types; }

void write_counts(const ElementCounts& counts, std::size_t types, ByteWriter& writer) {
  for (std::size_t i = 0; i < types; ++i) writer.number(counts[layer_types.at(i)]);
}

ElementCounts counts_of(const std::array<std::int64_t, layer_types.size()>& numbers) {
  ElementCounts counts{};
  for (std::size_t i = 0; i < numbers.size(); ++i) counts[layer_types[i]] = numbers[i];
  return counts;
}

/// Its place among the versions.
std::size_t version_of(const Numbering& numbering) {
  const auto found = std::find(types_of_version.begin(), types_of_version.end(),
                               told_layer_types(numbering.others));
  return static_cast<std::size_t>(found - types_of_version.begin());
}

/// Whether it can be a count or a number of nodes or elements.
bool is_possible(std::int64_t count) { return count >= 0 && count <= most_in_numbering; }

void write_head(const Numbering& numbering, ByteWriter& writer) {
  std::uint64_t dropped = 0;
  for (const CutNumbers& cut : numbering.cuts) dropped += cut.nodes.dropped.size();
  for (const LeafNumbers& leaf : numbering.leaves) dropped += leaf.nodes.dropped.size();
  writer.text(numbering_magic);
  writer.number(numbering_versions.at(version_of(numbering)));
  writer.number(numbering.surface_nodes);
  writer.number(numbering.tets);
  writer.number(numbering.faces);
  writer.number<std::int64_t>(numbering.regions);
  writer.number<std::int64_t>(counts_faces(numbering) ? 1 : 0);
  writer.number<std::uint64_t>(numbering.unused_vertices.size());
  writer.number<std::uint64_t>(numbering.forced.size());
  writer.number<std::uint64_t>(numbering.cuts.size());
  writer.number<std::uint64_t>(numbering.leaves.size());
  writer.number(dropped);
  write_counts(numbering.others, told_layer_types(numbering.others), writer);
}

void write_owner(TreePath path, const OwnedNodes& nodes, std::uint64_t& next_dropped,
                 ByteWriter& writer) {
  writer.number(path.heap);
  writer.number(nodes.made);
  writer.number(nodes.first_node);
  writer.number(next_dropped);
  writer.number<std::uint64_t>(nodes.dropped.size());
  next_dropped += nodes.dropped.size();
}

void write_tables(const Numbering& numbering, ByteWriter& writer) {
  writer.array(numbering.unused_vertices);
  writer.array(numbering.forced);
  std::uint64_t next_dropped = 0;
  for (const CutNumbers& cut : numbering.cuts) {
    write_owner(cut.path, cut.nodes, next_dropped, writer);
  }
  const bool has_faces = counts_faces(numbering);
  const std::size_t types = told_layer_types(numbering.others);
  for (const LeafNumbers& leaf : numbering.leaves) {
    write_owner(leaf.path, leaf.nodes, next_dropped, writer);
    writer.number(leaf.tets);
    writer.number(leaf.first_tet);
    writer.number(has_faces ? leaf.first_face.value() : 0);
    write_counts(leaf.others, types, writer);
    write_counts(leaf.first_other, types, writer);
  }
  for (const CutNumbers& cut : numbering.cuts) writer.array(cut.nodes.dropped);
  for (const LeafNumbers& leaf : numbering.leaves) writer.array(leaf.nodes.dropped);
}

std::string content_of(const Numbering& numbering) {
  TF_CHECK(!numbering.leaves.empty());
  ByteWriter writer;
  write_head(numbering, writer);
  write_tables(numbering, writer);
  writer.text(numbering_to_text(numbering));
  return writer.take();
}

struct Head {
  MeshTotals whole;
  std::int64_t surface_nodes = 0;
  bool counts_faces = false;
  NumberingTables tables;
};

/// By the first bytes; what else they say is looked at by who reads on.
std::size_t version_that_is_said(std::string_view begin) {
  for (std::size_t i = numbering_versions.size() - 1; i > 0; --i) {
    if (says_version(begin, numbering_magic, numbering_versions.at(i))) return i;
  }
  return 0;
}

/// What follows magic and version.
ByteReader read_version(std::string_view begin, const std::string& name) {
  return read_begun(begin, numbering_magic, numbering_versions.at(version_that_is_said(begin)),
                    name);
}

Head read_head(std::string_view begin, const std::string& name) {
  ByteReader reader = read_version(begin, name);
  Head head;
  head.surface_nodes = reader.number<std::int64_t>();
  head.whole.tets = reader.number<std::int64_t>();
  head.whole.faces = reader.number<std::int64_t>();
  if (!is_possible(head.surface_nodes) || !is_possible(head.whole.tets) ||
      !is_possible(head.whole.faces)) {
    reader.fail("has impossible counts");
  }
  head.whole.regions = static_cast<std::int32_t>(reader.count());
  head.counts_faces = reader.count() != 0;
  head.tables.unused = reader.count();
  head.tables.forced = reader.count();
  head.tables.cuts = reader.count();
  head.tables.leaves = reader.count();
  head.tables.dropped = reader.count();
  head.tables.others = types_of_version.at(version_that_is_said(begin));
  for (std::size_t i = 0; i < head.tables.others; ++i) {
    std::int64_t& count = head.whole.others[layer_types.at(i)];
    count = reader.number<std::int64_t>();
    if (!is_possible(count)) reader.fail("has impossible counts");
  }
  head.whole.subdomains = static_cast<std::int64_t>(head.tables.leaves);
  if (head.whole.regions == 0 || head.tables.leaves == 0) reader.fail("has no leaf or no region");
  return head;
}

/// The first of `count` places where `is_behind` holds; count where it holds nowhere.
/// @pre where it holds, it holds for all places that follow.
template <class IsBehind>
std::uint64_t first_place(std::uint64_t count, const IsBehind& is_behind) {
  std::uint64_t first = 0;
  while (first < count) {
    const std::uint64_t middle = first + (count - first) / 2;
    if (is_behind(middle)) {
      count = middle;
    } else {
      first = middle + 1;
    }
  }
  return first;
}

/// Where that path is in a table in tree order; `path_at` tells whose an entry is.
template <class PathAt>
std::optional<std::uint64_t> place_of(TreePath path, std::uint64_t count, const PathAt& path_at) {
  const std::uint64_t place =
      first_place(count, [&](std::uint64_t i) { return !comes_before(path_at(i), path); });
  if (place == count || path_at(place) != path) return std::nullopt;
  return place;
}

}  // namespace

std::uint64_t NumberingTables::unused_at() const { return head_size + size_of_others(others); }

std::uint64_t NumberingTables::forced_at() const {
  return unused_at() + sizeof(std::int32_t) * unused;
}

std::uint64_t NumberingTables::cuts_at() const { return forced_at() + sizeof(ForcedNode) * forced; }

std::uint64_t NumberingTables::leaves_at() const { return cuts_at() + owner_size * cuts; }

std::uint64_t NumberingTables::dropped_at() const {
  return leaves_at() + (leaf_size + 2 * size_of_others(others)) * leaves;
}

std::uint64_t NumberingTables::text_at() const {
  return dropped_at() + sizeof(DroppedRange) * dropped;
}

std::string numbering_to_bytes(const Numbering& numbering) {
  return with_block_checksums(content_of(numbering));
}

Numbering numbering_from_bytes(std::string_view bytes, const std::string& name) {
  if (is_numbering_text(bytes)) return numbering_from_text(bytes, name);
  // Another kind of file is called that before its checksums are found wrong.
  read_version(bytes, name);
  const std::string_view content = content_of_blocks(bytes, name);
  const Head head = read_head(content, name);
  if (head.tables.text_at() > content.size()) throw CorruptFile("is cut short", name);
  Numbering numbering = numbering_from_text(content.substr(head.tables.text_at()), name);
  numbering.faces = head.whole.faces;
  numbering.regions = head.whole.regions;
  numbering.forced = ByteReader(content.substr(head.tables.forced_at()), name)
                         .array<ForcedNode>(head.tables.forced);
  if (!std::is_sorted(numbering.forced.begin(), numbering.forced.end()) ||
      content_of(numbering) != content) {
    throw CorruptFile("has tables that are not those of its text", name);
  }
  return numbering;
}

bool is_numbering_text(std::string_view begin) { return begin.starts_with(text_magic); }

NumberingFile::NumberingFile(const std::filesystem::path& path, const std::string& name)
    : file_(path, name) {
  const Head head = read_head(
      file_.read(0, std::min(file_.size(), head_size + size_of_others(layer_types.size()))), name);
  tables_ = head.tables;
  whole_ = head.whole;
  surface_nodes_ = head.surface_nodes;
  counts_faces_ = head.counts_faces;
  if (tables_.text_at() > file_.size()) file_.fail("is cut short");
}

LeafNumbering NumberingFile::leaf(const LeafQuestion& question) {
  const auto place =
      place_of(question.leaf, tables_.leaves, [this](std::uint64_t i) { return path_of_leaf(i); });
  if (!place) refuse_leaf(question.leaf);
  const LeafWithOthers found = leaf_at(*place);
  const Leaf& leaf = found.leaf;
  LeafNumbering result;
  result.number = static_cast<std::int32_t>(*place);
  result.first_node = leaf.nodes.first_node;
  result.kept_nodes = leaf.nodes.made;
  if (leaf.nodes.dropped > 0) {
    const DroppedRange last = dropped_range(leaf.nodes, leaf.nodes.dropped - 1);
    result.kept_nodes -= last.before + last.count;
  }
  result.tets = leaf.tets;
  result.first_tet = leaf.first_tet;
  result.others = counts_of(found.others);
  result.first_other = counts_of(found.first_other);
  if (counts_faces_) result.first_face = leaf.first_face;
  result.whole = whole_;
  add_nodes(question, result);
  return result;
}

/// Node by node in the order of their origins, so that nodes of one owner, and near to each other,
/// are looked for in the same blocks.
void NumberingFile::add_nodes(const LeafQuestion& question, LeafNumbering& result) {
  const std::span<const Origin> nodes = question.nodes;
  std::vector<std::size_t> order(nodes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [nodes](std::size_t a, std::size_t b) { return nodes[a] < nodes[b]; });
  result.node_numbers.resize(nodes.size());
  result.is_forced.resize(nodes.size(), false);
  Owner owner;
  for (const std::size_t i : order) {
    const Origin& origin = nodes[i];
    if (origin.owner == 0) {
      result.node_numbers[i] = number_on_surface(origin);
      result.is_forced[i] = is_forced({static_cast<std::int32_t>(origin.index), question.region});
      continue;
    }
    result.is_forced[i] = origin.owner == top_of_layers;
    if (owner_in_tree(origin) != owner.heap) owner = find_owner(origin);
    result.node_numbers[i] = number_of(owner, origin);
  }
}

NumberingFile::Owner NumberingFile::find_owner(const Origin& origin) {
  const TreePath path{owner_in_tree(origin)};
  if (const auto cut = place_of(path, tables_.cuts,
                                [this](std::uint64_t i) { return TreePath{cut_at(i).heap}; })) {
    return cut_at(*cut);
  }
  if (const auto leaf =
          place_of(path, tables_.leaves, [this](std::uint64_t i) { return path_of_leaf(i); })) {
    return leaf_at(*leaf).leaf.nodes;
  }
  refuse_node(origin);
}

NumberingFile::Owner NumberingFile::cut_at(std::uint64_t i) {
  static_assert(sizeof(Owner) == owner_size);
  return checked(file_.item<Owner>(tables_.cuts_at(), i));
}

TreePath NumberingFile::path_of_leaf(std::uint64_t i) { return {leaf_at(i).leaf.nodes.heap}; }

NumberingFile::LeafWithOthers NumberingFile::leaf_at(std::uint64_t i) {
  static_assert(sizeof(Leaf) == leaf_size);
  LeafWithOthers found;
  const auto read = [&]<std::size_t types>(const std::array<std::int64_t, types>&) {
    struct Entry {
      Leaf leaf;
      std::array<std::int64_t, types> others;
      std::array<std::int64_t, types> first_other;
    };
    static_assert(sizeof(Entry) == leaf_size + 2 * size_of_others(types));
    const auto entry = file_.item<Entry>(tables_.leaves_at(), i);
    found.leaf = entry.leaf;
    std::copy(entry.others.begin(), entry.others.end(), found.others.begin());
    std::copy(entry.first_other.begin(), entry.first_other.end(), found.first_other.begin());
  };
  if (tables_.others == 0) {
    found.leaf = file_.item<Leaf>(tables_.leaves_at(), i);
  } else if (tables_.others == layer_types_without_sides) {
    read(std::array<std::int64_t, layer_types_without_sides>{});
  } else {
    read(std::array<std::int64_t, layer_types.size()>{});
  }
  const Leaf& leaf = found.leaf;
  std::vector<std::int64_t> counts = {leaf.tets, leaf.first_tet, leaf.first_face};
  counts.insert(counts.end(), found.others.begin(), found.others.end());
  counts.insert(counts.end(), found.first_other.begin(), found.first_other.end());
  if (!std::all_of(counts.begin(), counts.end(), is_possible)) {
    file_.fail("has impossible counts");
  }
  checked(leaf.nodes);
  return found;
}

const NumberingFile::Owner& NumberingFile::checked(const Owner& owner) const {
  if (owner.heap == 0 || !is_possible(owner.made) || !is_possible(owner.first_node) ||
      owner.first_dropped > tables_.dropped ||
      owner.dropped > tables_.dropped - owner.first_dropped) {
    file_.fail("has impossible counts");
  }
  return owner;
}

DroppedRange NumberingFile::dropped_range(const Owner& owner, std::uint64_t i) {
  TF_CHECK(i < owner.dropped);
  const auto range = file_.item<DroppedRange>(tables_.dropped_at(), owner.first_dropped + i);
  if (!is_possible(range.first) || !is_possible(range.count) || range.before < 0 ||
      range.before > range.first || range.first + range.count > owner.made) {
    file_.fail("drops nodes that do not exist");
  }
  return range;
}

std::int64_t NumberingFile::number_of(const Owner& owner, const Origin& origin) {
  const std::int64_t index = origin.index;
  if (index >= owner.made) refuse_node(origin);
  const std::uint64_t ranges = first_place(
      owner.dropped, [&](std::uint64_t i) { return dropped_range(owner, i).first > index; });
  if (ranges == 0) return owner.first_node + index;
  const DroppedRange last = dropped_range(owner, ranges - 1);
  if (index < last.first + last.count) refuse_node(origin);
  return owner.first_node + index - last.before - last.count;
}

std::int64_t NumberingFile::number_on_surface(const Origin& origin) {
  const std::int64_t index = origin.index;
  const auto unused = [this](std::uint64_t i) {
    return file_.item<std::int32_t>(tables_.unused_at(), i);
  };
  const std::uint64_t before =
      first_place(tables_.unused, [&](std::uint64_t i) { return unused(i) >= index; });
  const std::int64_t number = index - static_cast<std::int64_t>(before);
  const bool is_unused = before < tables_.unused && unused(before) == index;
  if (is_unused || number >= surface_nodes_) refuse_node(origin);
  return number;
}

bool NumberingFile::is_forced(const ForcedNode& node) {
  const auto forced = [this](std::uint64_t i) {
    return file_.item<ForcedNode>(tables_.forced_at(), i);
  };
  const std::uint64_t place =
      first_place(tables_.forced, [&](std::uint64_t i) { return forced(i) >= node; });
  return place < tables_.forced && forced(place) == node;
}

}  // namespace tetfarm
