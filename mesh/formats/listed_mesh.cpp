#include "mesh/formats/listed_mesh.h"

#include <algorithm>
#include <limits>
#include <map>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/formats/local_numbers.h"
#include "mesh/formats/regions_of_faces.h"
#include "mesh/formats/unclaimed_faces.h"

namespace tetfarm {
namespace {

using Nodes = ListedMesh::Nodes;

constexpr std::int64_t tets_at_once = 65536;
constexpr std::int32_t most_names = 1'000'000;

/// Consecutive cells of one type and one region.
struct CellsOfList {
  std::int64_t first = 0;
  std::int64_t count = 0;
  std::int32_t region = 1;
};

struct PartOfList {
  std::int64_t first_tet = 0;
  std::int64_t tets = 0;
  std::vector<TetRun> runs;
  std::vector<std::size_t> triangles;
  ByType<std::vector<CellsOfList>> cells;
  std::vector<std::size_t> quads;
  std::int32_t subdomain = 0;
};

/// Appends the boundary triangles that the tet has as faces.
void give_faces(const Nodes& tet, const std::vector<bool>& is_on_boundary,
                UnclaimedFaces<3>& unclaimed, std::vector<std::size_t>& to) {
  std::array<bool, 4> is_outside{};
  for (std::size_t k = 0; k < 4; ++k) is_outside[k] = is_on_boundary[at(tet[k])];
  if (is_outside[0] + is_outside[1] + is_outside[2] + is_outside[3] < 3) return;
  for (const auto& [i, j, k] : tet_face_nodes) {
    if (is_outside[at(i)] && is_outside[at(j)] && is_outside[at(k)]) {
      unclaimed.give({tet[at(i)], tet[at(j)], tet[at(k)]}, to);
    }
  }
}

class ListedSource : public MeshSource {
 public:
  ListedSource(ListedMesh mesh, std::int64_t tets_of_piece) : mesh_(std::move(mesh)) {
    check();
    if (mesh_.knows_subdomains) {
      make_subdomains();
      add_cells_to_subdomains();
    } else {
      make_pieces(tets_of_piece);
      make_pieces_of_cells(tets_of_piece);
    }
    if (parts_.empty()) fail("has no tets");
    share_out();
  }

  std::size_t size() const override { return parts_.size(); }
  bool knows_subdomains() const override { return mesh_.knows_subdomains; }
  bool takes_threads() const override { return mesh_.takes_threads; }
  std::vector<std::string> complaints() const override { return complaints_; }
  std::vector<std::string> patch_names() const override { return mesh_.patch_names; }
  std::vector<PatchType> patch_types() const override { return mesh_.patch_types; }
  std::vector<std::string> region_names() const override { return mesh_.region_names; }

  NumberedPart part(std::size_t i) const override {
    const PartOfList& here = parts_.at(i);
    NumberedPart part;
    part.number = static_cast<std::int32_t>(i);
    set_regions(here, part);
    std::vector<Nodes> tets(at(here.tets));
    mesh_.read_tets(here.first_tet, tets);
    LocalNumbers numbers;
    part.tets.resize(tets.size());
    for (std::size_t t = 0; t < tets.size(); ++t) {
      for (std::size_t k = 0; k < 4; ++k) part.tets[t][k] = numbers.of(tets[t][k]);
    }
    tets = {};
    for (const ElementType type : cell_block_types) {
      read_cells(type, here.cells[type], numbers, part.blocks[type]);
    }
    for (const std::size_t t : here.triangles) {
      Triangle& face = part.faces.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) face[k] = numbers.of(mesh_.triangles[t].nodes[k]);
      part.patch_of_face.push_back(mesh_.triangles[t].patch);
    }
    ElementBlock& quads = part.blocks[ElementType::quad];
    for (const std::size_t q : here.quads) {
      for (const std::int64_t node : mesh_.quads[q].nodes) quads.nodes.push_back(numbers.of(node));
      quads.patches.push_back(mesh_.quads[q].patch);
      quads.regions.push_back(part.region);
    }
    renumber(part, numbers.sort());
    part.local2global = numbers.take();
    read_nodes(part);
    if (has_several_regions(part)) {
      // Its tets may be of one region, and its other cells of another.
      part.region_of_tet.resize(part.tets.size(), part.region);
      set_regions_of_faces(part);
    }
    return part;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InvalidInput(what, mesh_.name); }

  void check() const {
    check_regions(mesh_.runs, ElementType::tet);
    for (const ElementType type : cell_block_types) check_regions(mesh_.cells[type].runs, type);
    check_faces(mesh_.triangles, "boundary triangle ");
    check_faces(mesh_.quads, "boundary quad ");
  }

  void check_regions(const std::vector<TetRun>& runs, ElementType type) const {
    for (const TetRun& run : runs) {
      if (run.region < 1 || run.region > most_names) {
        fail("a " + std::string(element(type).name) + " has the region " +
             std::to_string(run.region));
      }
    }
  }

  template <class Listed>
  void check_faces(const std::vector<Listed>& faces, const std::string& kind) const {
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (faces[f].patch < 0 || faces[f].patch >= most_names) {
        fail(kind + std::to_string(f) + " has the patch " + std::to_string(faces[f].patch));
      }
      for (const std::int64_t node : faces[f].nodes) {
        if (node < 0 || node >= mesh_.nodes) {
          fail(kind + std::to_string(f) + " has node " + std::to_string(node) + " of " +
               std::to_string(mesh_.nodes));
        }
      }
    }
  }

  void make_subdomains() {
    std::int64_t first = 0;
    std::int32_t subdomain = 0;
    for (const TetRun& run : mesh_.runs) {
      if (run.tets == 0) continue;
      if (parts_.empty() || run.subdomain != subdomain) parts_.emplace_back().first_tet = first;
      subdomain = run.subdomain;
      PartOfList& part = parts_.back();
      part.subdomain = subdomain;
      part.tets += run.tets;
      part.runs.push_back(run);
      if (part.tets > std::numeric_limits<std::int32_t>::max()) {
        fail("a sub-domain has more than 2147483647 tets");
      }
      first += run.tets;
    }
  }

  void make_pieces(std::int64_t most) {
    TF_CHECK(most > 0);
    std::int64_t first = 0;
    for (const TetRun& run : mesh_.runs) {
      for (std::int64_t done = 0; done < run.tets; done += most) {
        const TetRun piece{std::min(most, run.tets - done), run.region, 0};
        PartOfList& part = parts_.emplace_back();
        part.first_tet = first + done;
        part.tets = piece.tets;
        part.runs = {piece};
      }
      first += run.tets;
    }
  }

  /// Other cells go to the part of their sub-domain; parts without tets get the place that the
  /// number of their sub-domain says.
  void add_cells_to_subdomains() {
    std::map<std::int32_t, std::size_t> part_of;
    for (std::size_t i = 0; i < parts_.size(); ++i) part_of.emplace(parts_[i].subdomain, i);
    bool has_cells = false;
    for (const ElementType type : cell_block_types) {
      std::int64_t first = 0;
      for (const TetRun& run : mesh_.cells[type].runs) {
        const auto [found, is_new] = part_of.emplace(run.subdomain, parts_.size());
        if (is_new) parts_.emplace_back().subdomain = run.subdomain;
        parts_[found->second].cells[type].push_back({first, run.tets, run.region});
        first += run.tets;
        has_cells = true;
      }
    }
    if (!has_cells) return;
    std::stable_sort(parts_.begin(), parts_.end(), [](const PartOfList& a, const PartOfList& b) {
      return a.subdomain < b.subdomain;
    });
  }

  void make_pieces_of_cells(std::int64_t most) {
    for (const ElementType type : cell_block_types) {
      std::int64_t first = 0;
      for (const TetRun& run : mesh_.cells[type].runs) {
        for (std::int64_t done = 0; done < run.tets; done += most) {
          parts_.emplace_back().cells[type] = {
              {first + done, std::min(most, run.tets - done), run.region}};
        }
        first += run.tets;
      }
    }
  }

  /// Gives each part its boundary faces, and the last one those that no cell has.
  void share_out() {
    TF_CHECK(!parts_.empty());
    UnclaimedFaces<3> triangles(mesh_.triangles);
    UnclaimedFaces<4> quads(mesh_.quads);
    std::vector<bool> is_on_boundary(at(mesh_.nodes), false);
    for (const ListedTriangle& face : mesh_.triangles) {
      for (const std::int64_t node : face.nodes) is_on_boundary[at(node)] = true;
    }
    for (const ListedQuad& face : mesh_.quads) {
      for (const std::int64_t node : face.nodes) is_on_boundary[at(node)] = true;
    }
    std::vector<bool> is_used = is_on_boundary;
    for (PartOfList& part : parts_) {
      for_each_tet(part, [&](const Nodes& tet) {
        for (const std::int64_t node : tet) is_used[at(node)] = true;
        give_faces(tet, is_on_boundary, triangles, part.triangles);
      });
      for_each_cell(part, [&](ElementType type, std::span<const std::int64_t> nodes) {
        for (const std::int64_t node : nodes) is_used[at(node)] = true;
        for_each_face_of(type, nodes, [&](ElementType, std::span<const std::int64_t> face) {
          if (face.size() == 3) {
            triangles.give({face[0], face[1], face[2]}, part.triangles);
          } else {
            quads.give({face[0], face[1], face[2], face[3]}, part.quads);
          }
        });
      });
    }
    give_rest(triangles.rest(), parts_.back().triangles);
    give_rest(quads.rest(), parts_.back().quads);
    // As the file has them.
    for (PartOfList& part : parts_) {
      std::sort(part.triangles.begin(), part.triangles.end());
      std::sort(part.quads.begin(), part.quads.end());
    }
    complain_of_unused(is_used);
  }

  static void give_rest(const std::vector<std::size_t>& rest, std::vector<std::size_t>& last) {
    last.insert(last.end(), rest.begin(), rest.end());
  }

  void complain_of_unused(const std::vector<bool>& is_used) {
    const auto unused = std::find(is_used.begin(), is_used.end(), false);
    if (unused == is_used.end()) return;
    complaints_.push_back("node " + std::to_string(unused - is_used.begin()) +
                          " is in no tet and no boundary triangle; such nodes: " +
                          std::to_string(std::count(unused, is_used.end(), false)));
  }

  template <class Visit>
  void for_each_tet(const PartOfList& part, const Visit& visit) const {
    std::vector<Nodes> tets;
    for (std::int64_t done = 0; done < part.tets; done += std::ssize(tets)) {
      tets.resize(at(std::min(tets_at_once, part.tets - done)));
      mesh_.read_tets(part.first_tet + done, tets);
      for (std::size_t t = 0; t < tets.size(); ++t) {
        for (const std::int64_t node : tets[t]) {
          if (node >= 0 && node < mesh_.nodes) continue;
          fail("tet " + std::to_string(part.first_tet + done + static_cast<std::int64_t>(t)) +
               " has node " + std::to_string(node) + " of " + std::to_string(mesh_.nodes));
        }
        visit(tets[t]);
      }
    }
  }

  /// Visits the cells of a part that are no tets.
  template <class Visit>
  void for_each_cell(const PartOfList& part, const Visit& visit) const {
    std::vector<std::int64_t> nodes;
    for (const ElementType type : cell_block_types) {
      const auto nodes_of_cell = static_cast<std::int64_t>(nodes_of(type));
      for (const CellsOfList& cells : part.cells[type]) {
        for (std::int64_t done = 0, count = 0; done < cells.count; done += count) {
          count = std::min(tets_at_once, cells.count - done);
          nodes.resize(at(count * nodes_of_cell));
          mesh_.cells[type].read(cells.first + done, nodes);
          for (std::int64_t i = 0; i < count; ++i) {
            const auto cell =
                std::span<const std::int64_t>(nodes).subspan(at(i * nodes_of_cell), nodes_of(type));
            check_nodes(type, cells.first + done + i, cell);
            visit(type, cell);
          }
        }
      }
    }
  }

  void check_nodes(ElementType type, std::int64_t number,
                   std::span<const std::int64_t> nodes) const {
    for (const std::int64_t node : nodes) {
      if (node >= 0 && node < mesh_.nodes) continue;
      fail(std::string(element(type).name) + " " + std::to_string(number) + " has node " +
           std::to_string(node) + " of " + std::to_string(mesh_.nodes));
    }
  }

  /// Region after region, as the blocks of a part have them.
  void read_cells(ElementType type, std::vector<CellsOfList> stretches, LocalNumbers& numbers,
                  ElementBlock& block) const {
    std::stable_sort(stretches.begin(), stretches.end(),
                     [](const auto& a, const auto& b) { return a.region < b.region; });
    std::vector<std::int64_t> nodes;
    for (const CellsOfList& cells : stretches) {
      nodes.resize(at(cells.count) * nodes_of(type));
      mesh_.cells[type].read(cells.first, nodes);
      for (const std::int64_t node : nodes) block.nodes.push_back(numbers.of(node));
      block.regions.insert(block.regions.end(), at(cells.count), cells.region);
    }
  }

  static bool has_several_regions(const NumberedPart& part) {
    bool has = !part.region_of_tet.empty();
    for_each_block_cell(part.blocks,
                        [&](ElementType, std::span<const std::int32_t>, std::int32_t region) {
                          has = has || region != part.region;
                        });
    return has;
  }

  static void set_regions(const PartOfList& here, NumberedPart& part) {
    if (here.runs.empty()) {
      for (const ElementType type : cell_block_types) {
        if (!here.cells[type].empty()) part.region = here.cells[type].front().region;
      }
      return;
    }
    part.region = here.runs.front().region;
    const bool is_one = std::all_of(here.runs.begin(), here.runs.end(),
                                    [&](const TetRun& run) { return run.region == part.region; });
    if (is_one) return;
    for (const TetRun& run : here.runs) {
      part.region_of_tet.insert(part.region_of_tet.end(), at(run.tets), run.region);
    }
    TF_CHECK(part.region_of_tet.size() == at(here.tets));
  }

  static void renumber(NumberedPart& part, const std::vector<std::int32_t>& new_number) {
    for (Tet& tet : part.tets) {
      for (std::int32_t& v : tet) v = new_number[at(v)];
    }
    for (Triangle& face : part.faces) {
      for (std::int32_t& v : face) v = new_number[at(v)];
    }
    for_each_block(part.blocks, [&](ElementType, ElementBlock& block) {
      for (std::int32_t& v : block.nodes) v = new_number[at(v)];
    });
  }

  /// Stretches of the list that have nearly all their nodes in the part are read at once.
  void read_nodes(NumberedPart& part) const {
    constexpr std::int64_t widest_gap = 16;
    constexpr std::int64_t most_at_once = 65536;
    const std::vector<std::int64_t>& numbers = part.local2global;
    std::vector<Vec3> stretch;
    part.nodes.resize(numbers.size());
    for (std::size_t first = 0; first < numbers.size();) {
      std::size_t last = first;
      while (last + 1 < numbers.size() && numbers[last + 1] - numbers[last] <= widest_gap &&
             numbers[last + 1] - numbers[first] < most_at_once) {
        ++last;
      }
      stretch.resize(at(numbers[last] - numbers[first] + 1));
      mesh_.read_nodes(numbers[first], stretch);
      for (std::size_t v = first; v <= last; ++v) {
        part.nodes[v] = stretch[at(numbers[v] - numbers[first])];
      }
      first = last + 1;
    }
  }

  ListedMesh mesh_;
  std::vector<PartOfList> parts_;
  std::vector<std::string> complaints_;
};

}  // namespace

void add_tets(std::vector<TetRun>& runs, const TetRun& next) {
  if (!runs.empty() && runs.back().region == next.region &&
      runs.back().subdomain == next.subdomain) {
    runs.back().tets += next.tets;
  } else {
    runs.push_back(next);
  }
}

std::unique_ptr<MeshSource> open_listed(ListedMesh mesh, std::int64_t tets_of_piece) {
  return std::make_unique<ListedSource>(std::move(mesh), tets_of_piece);
}

}  // namespace tetfarm
