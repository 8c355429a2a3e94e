#include "mesh/assemble/global_numbering.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <span>

#include "base/check.h"
#include "base/error.h"
#include "base/text_lines.h"

namespace tetfarm {
namespace {

struct Line {
  std::string_view kind;
  std::vector<std::uint64_t> numbers;
};

/// A word and whole numbers, one blank between them; nothing when the line is not like that.
std::optional<Line> parse_line(std::string_view text) {
  Line line;
  std::size_t end = std::min(text.find(' '), text.size());
  line.kind = text.substr(0, end);
  while (end < text.size()) {
    text.remove_prefix(end + 1);
    end = std::min(text.find(' '), text.size());
    std::uint64_t number = 0;
    const char* last = text.data() + end;
    const auto [stop, error] = std::from_chars(text.data(), last, number);
    if (error != std::errc{} || stop != last) return std::nullopt;
    line.numbers.push_back(number);
  }
  return line;
}

bool is_heap_number(std::uint64_t heap) { return heap >= 1 && heap < std::uint64_t{1} << 63; }

constexpr std::size_t words_with_faces = 4;
constexpr std::size_t words_with_others = words_with_faces + layer_types_without_sides;
constexpr std::size_t words_with_sides = words_with_faces + layer_types.size();

bool is_leaf_line(const std::vector<std::uint64_t>& n) {
  const bool has_words = n.size() + 1 == words_with_faces || n.size() == words_with_faces ||
                         n.size() == words_with_others || n.size() == words_with_sides;
  return has_words && is_heap_number(n[0]);
}

LeafNumbers leaf_of_line(const std::vector<std::uint64_t>& n) {
  LeafNumbers leaf;
  leaf.path = {n[0]};
  leaf.nodes.made = static_cast<std::int64_t>(n[1]);
  leaf.tets = static_cast<std::int64_t>(n[2]);
  if (n.size() >= words_with_faces) leaf.faces = static_cast<std::int64_t>(n[3]);
  for (std::size_t word = words_with_faces; word < n.size(); ++word) {
    leaf.others[layer_types.at(word - words_with_faces)] = static_cast<std::int64_t>(n[word]);
  }
  return leaf;
}

/// The triangles of the only leaf of which they were not told.
void count_rest_of_faces(Numbering& numbering) {
  std::int64_t rest = numbering.faces;
  LeafNumbers* unknown = nullptr;
  for (LeafNumbers& leaf : numbering.leaves) {
    if (leaf.faces) {
      rest -= *leaf.faces;
    } else if (unknown == nullptr) {
      unknown = &leaf;
    } else {
      return;
    }
  }
  if (unknown != nullptr && rest >= 0) unknown->faces = rest;
}

/// The numbers of a line of dropped nodes, to be added when all cuts and leaves are known.
using Dropped = std::vector<std::uint64_t>;

/// Reads one line of cut, leaf, joined leaf or dropped nodes; false when it is none.
bool add_line(const Line& line, Numbering& numbering, std::vector<Dropped>& dropped) {
  const std::vector<std::uint64_t>& n = line.numbers;
  for (const std::uint64_t number : std::span(n).subspan(std::min<std::size_t>(1, n.size()))) {
    if (number > static_cast<std::uint64_t>(most_in_numbering)) return false;
  }
  if (line.kind == "cut" && n.size() == 2 && is_heap_number(n[0])) {
    numbering.cuts.push_back({{n[0]}, {static_cast<std::int64_t>(n[1]), 0, {}}});
    return true;
  }
  if (line.kind == "leaf" && is_leaf_line(n)) {
    numbering.leaves.push_back(leaf_of_line(n));
    return true;
  }
  if (line.kind == "joined" && n.size() == 2 && is_heap_number(n[0]) && is_heap_number(n[1])) {
    numbering.joined.push_back({{n[0]}, {n[1]}});
    return true;
  }
  if (line.kind != "dropped" || n.size() != 3) return false;
  dropped.push_back(n);
  return true;
}

bool is_leaf(const Numbering& numbering, TreePath path) {
  const auto leaf =
      std::lower_bound(numbering.leaves.begin(), numbering.leaves.end(), path,
                       [](const LeafNumbers& a, TreePath b) { return comes_before(a.path, b); });
  return leaf != numbering.leaves.end() && leaf->path == path;
}

/// What the lines of a whole tree are: walking it depth first, each line is where the walk stands.
bool is_whole_tree(const Numbering& numbering) {
  std::size_t cut = 0;
  std::size_t leaf = 0;
  std::size_t joined = 0;
  std::vector<TreePath> to_visit = {{1}};
  while (!to_visit.empty()) {
    const TreePath here = to_visit.back();
    to_visit.pop_back();
    if (cut < numbering.cuts.size() && numbering.cuts[cut].path == here) {
      ++cut;
      to_visit.push_back(here.right());
      to_visit.push_back(here.left());
    } else if (leaf < numbering.leaves.size() && numbering.leaves[leaf].path == here) {
      ++leaf;
    } else if (joined < numbering.joined.size() && numbering.joined[joined].path == here &&
               is_leaf(numbering, numbering.joined[joined].into)) {
      ++joined;
    } else {
      return false;
    }
  }
  return cut == numbering.cuts.size() && leaf == numbering.leaves.size() &&
         joined == numbering.joined.size();
}

void sort_by_tree(Numbering& numbering) {
  const auto before = [](const auto& a, const auto& b) { return comes_before(a.path, b.path); };
  std::sort(numbering.cuts.begin(), numbering.cuts.end(), before);
  std::sort(numbering.leaves.begin(), numbering.leaves.end(), before);
  std::sort(numbering.joined.begin(), numbering.joined.end(), before);
}

void give_numbers(Numbering& numbering) {
  std::int64_t next = numbering.surface_nodes;
  for (CutNumbers& cut : numbering.cuts) {
    cut.nodes.first_node = next;
    next += cut.nodes.kept();
  }
  std::int64_t next_tet = 0;
  numbering.others = {};
  std::optional<std::int64_t> next_face = 0;
  for (LeafNumbers& leaf : numbering.leaves) {
    leaf.nodes.first_node = next;
    leaf.first_tet = next_tet;
    leaf.first_other = numbering.others;
    leaf.first_face = next_face;
    if (next_face && leaf.faces) {
      *next_face += *leaf.faces;
    } else {
      next_face.reset();
    }
    next += leaf.nodes.kept();
    next_tet += leaf.tets;
    for (const ElementType type : layer_types) numbering.others[type] += leaf.others[type];
  }
  numbering.nodes = next;
  numbering.tets = next_tet;
}

/// What a cut or leaf made; null when there is none of that path. @pre the lists are in tree order.
template <class AnyNumbering>
auto find_nodes(AnyNumbering& numbering, TreePath path) -> decltype(&numbering.cuts[0].nodes) {
  const auto find = [path](auto& list) -> decltype(&numbering.cuts[0].nodes) {
    const auto found =
        std::lower_bound(list.begin(), list.end(), path,
                         [](const auto& item, TreePath p) { return comes_before(item.path, p); });
    return found == list.end() || found->path != path ? nullptr : &found->nodes;
  };
  const auto of_cut = find(numbering.cuts);
  return of_cut != nullptr ? of_cut : find(numbering.leaves);
}

/// Adds each range to its cut or leaf; false when there is none, or a range does not follow the
/// last of its owner. @pre cuts and leaves are in tree order.
bool add_dropped(const std::vector<Dropped>& all, Numbering& numbering) {
  return std::all_of(all.begin(), all.end(), [&numbering](const Dropped& n) {
    const auto first = static_cast<std::int64_t>(n[1]);
    const auto count = static_cast<std::int64_t>(n[2]);
    if (n[0] == 0) return false;
    OwnedNodes* nodes = find_nodes(numbering, TreePath{n[0]});
    if (nodes == nullptr || count < 1 || first + count > nodes->made) return false;
    std::int64_t before = 0;
    if (!nodes->dropped.empty()) {
      const DroppedRange& last = nodes->dropped.back();
      if (first < last.first + last.count) return false;
      before = last.before + last.count;
    }
    nodes->dropped.push_back({first, count, before});
    return true;
  });
}

/// Which of the kept nodes it is; -1 when it was dropped.
std::int64_t rank_among_kept(const OwnedNodes& nodes, std::int64_t index) {
  const auto after =
      std::upper_bound(nodes.dropped.begin(), nodes.dropped.end(), index,
                       [](std::int64_t i, const DroppedRange& range) { return i < range.first; });
  if (after == nodes.dropped.begin()) return index;
  const DroppedRange& last = *std::prev(after);
  return index < last.first + last.count ? -1 : index - last.before - last.count;
}

void add_dropped_text(TreePath path, const OwnedNodes& nodes, std::string& text) {
  for (const DroppedRange& range : nodes.dropped) {
    text += "dropped " + std::to_string(path.heap) + ' ' + std::to_string(range.first) + ' ' +
            std::to_string(range.count) + '\n';
  }
}

}  // namespace

std::size_t told_layer_types(const ElementCounts& counts) {
  if (counts == ElementCounts{}) return 0;
  return counts[layer_types.back()] > 0 ? layer_types.size() : layer_types_without_sides;
}

bool comes_before(TreePath a, TreePath b) {
  const int difference = a.depth() - b.depth();
  TF_CHECK(a.heap > 0 && b.heap > 0);
  const std::uint64_t a_there = difference > 0 ? a.heap >> difference : a.heap;
  const std::uint64_t b_there = difference < 0 ? b.heap >> -difference : b.heap;
  return a_there != b_there ? a_there < b_there : difference < 0;
}

Numbering number_globally(const SurfaceMesh& surface, std::string_view table) {
  Numbering numbering;
  std::vector<Dropped> dropped;
  for (const std::string_view text : lines_of_text(table)) {
    const std::optional<Line> line = parse_line(text);
    if (!line || !add_line(*line, numbering, dropped)) {
      throw Error(ExitCode::failed,
                  "the table of the tree has the line \"" + std::string(text) + '"');
    }
  }
  sort_by_tree(numbering);
  if (!is_whole_tree(numbering)) {
    throw Error(ExitCode::failed,
                "the table of the tree does not have every cut and leaf exactly once");
  }
  if (!add_dropped(dropped, numbering)) {
    throw Error(ExitCode::failed, "the table of the tree drops nodes that do not exist");
  }
  std::vector<bool> is_used(surface.vertices.size(), false);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (meshed_sides(surface, t) == 0) continue;
    for (const std::int32_t v : surface.triangles[t]) is_used[static_cast<std::size_t>(v)] = true;
  }
  for (std::size_t v = 0; v < is_used.size(); ++v) {
    if (!is_used[v]) numbering.unused_vertices.push_back(static_cast<std::int32_t>(v));
  }
  numbering.surface_nodes =
      static_cast<std::int64_t>(is_used.size() - numbering.unused_vertices.size());
  add_surface_figures(surface, numbering);
  count_rest_of_faces(numbering);
  give_numbers(numbering);
  return numbering;
}

void add_surface_figures(const SurfaceMesh& surface, Numbering& numbering) {
  numbering.faces = meshed_sides(surface);
  numbering.regions = region_count(surface);
  numbering.forced = forced_nodes(surface);
}

bool counts_faces(const Numbering& numbering) {
  return numbering.leaves.back().faces && numbering.leaves.back().first_face;
}

std::int64_t global_number(const Numbering& numbering, const Origin& origin) {
  if (origin.owner == 0) {
    const auto& unused = numbering.unused_vertices;
    const std::int64_t index = origin.index;
    const auto after = std::lower_bound(unused.begin(), unused.end(), index);
    const std::int64_t rank = index - (after - unused.begin());
    if (rank >= numbering.surface_nodes || (after != unused.end() && *after == index))
      refuse_node(origin);
    return rank;
  }
  const OwnedNodes* nodes = find_nodes(numbering, TreePath{owner_in_tree(origin)});
  if (nodes == nullptr || origin.index >= nodes->made) refuse_node(origin);
  const std::int64_t rank = rank_among_kept(*nodes, origin.index);
  if (rank < 0) refuse_node(origin);
  return nodes->first_node + rank;
}

void refuse_node(const Origin& origin) {
  throw Error(ExitCode::failed,
              "no node " + std::to_string(origin.index) + " of " +
                  (origin.owner == 0 ? "the surface"
                                     : "cut or leaf " + TreePath{owner_in_tree(origin)}.text()) +
                  " in the numbering");
}

std::string numbering_to_text(const Numbering& numbering) {
  std::string text = "tetfarm-numbering 1\n";
  text += "surface " + std::to_string(numbering.surface_nodes) + '\n';
  for (const std::int32_t v : numbering.unused_vertices) {
    text += "unused " + std::to_string(v) + '\n';
  }
  for (const CutNumbers& cut : numbering.cuts) {
    text += "cut " + std::to_string(cut.path.heap) + ' ' + std::to_string(cut.nodes.made) + '\n';
    add_dropped_text(cut.path, cut.nodes, text);
  }
  for (const LeafNumbers& leaf : numbering.leaves) {
    text += "leaf " + std::to_string(leaf.path.heap) + ' ' + std::to_string(leaf.nodes.made) + ' ' +
            std::to_string(leaf.tets) + (leaf.faces ? ' ' + std::to_string(*leaf.faces) : "");
    const std::size_t told = told_layer_types(leaf.others);
    TF_CHECK(told == 0 || leaf.faces.has_value());  // of layers, whose triangles are known
    for (std::size_t i = 0; i < told; ++i) {
      text += ' ' + std::to_string(leaf.others[layer_types.at(i)]);
    }
    text += '\n';
    add_dropped_text(leaf.path, leaf.nodes, text);
  }
  for (const JoinedLeaf& leaf : numbering.joined) {
    text +=
        "joined " + std::to_string(leaf.path.heap) + ' ' + std::to_string(leaf.into.heap) + '\n';
  }
  return text + "end\n";
}

Numbering numbering_from_text(std::string_view text, const std::string& name) {
  const auto refuse = [&](const std::string& what) { throw CorruptFile(what, name); };
  const std::vector<std::string_view> lines = lines_of_text(text);
  if (lines.size() < 3 || lines.front() != "tetfarm-numbering 1") refuse("not a numbering");
  if (lines.back() != "end") refuse("the end is missing");
  Numbering numbering;
  std::vector<Dropped> dropped;
  for (std::size_t i = 1; i + 1 < lines.size(); ++i) {
    const std::optional<Line> line = parse_line(lines[i]);
    if (line && line->kind == "surface" && line->numbers.size() == 1 && i == 1 &&
        line->numbers[0] <= std::numeric_limits<std::int32_t>::max()) {
      numbering.surface_nodes = static_cast<std::int64_t>(line->numbers[0]);
    } else if (line && line->kind == "unused" && line->numbers.size() == 1 && i > 1 &&
               line->numbers[0] <= std::numeric_limits<std::int32_t>::max()) {
      numbering.unused_vertices.push_back(static_cast<std::int32_t>(line->numbers[0]));
    } else if (!line || i == 1 || !add_line(*line, numbering, dropped)) {
      refuse("line " + std::to_string(i + 1) + " is wrong");
    }
  }
  sort_by_tree(numbering);
  if (!is_whole_tree(numbering)) refuse("does not have every cut and leaf exactly once");
  if (!add_dropped(dropped, numbering)) refuse("drops nodes that do not exist");
  if (!std::is_sorted(numbering.unused_vertices.begin(), numbering.unused_vertices.end())) {
    refuse("unused vertices are not in order");
  }
  give_numbers(numbering);
  return numbering;
}

}  // namespace tetfarm
