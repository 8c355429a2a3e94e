#include "mesh/assemble/portion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "base/file_system.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/assemble/cut_grid.h"
#include "tests/support/error_text.h"
#include "tests/support/hybrid_grid.h"

namespace tetfarm {
namespace {

Portion portion_of(const CutGrid& grid, std::uint64_t leaf) { return grid.portion(leaf); }

TEST(Portion, survives_its_file_bit_by_bit) {
  const CutGrid grid = cut_grid(4);
  for (const std::uint64_t leaf : {2U, 6U, 7U}) {
    Portion portion = portion_of(grid, leaf);
    portion.placed = {{8, 80, {1, 2}}, {100, 7, {3, 4}}};
    const std::string bytes = portion_to_bytes(portion);
    const std::string tets = portion_cells_to_bytes(portion);
    Portion read = portion_from_bytes(bytes, "portion");
    EXPECT_TRUE(read.part.tets.empty());
    add_portion_cells(tets, "tets", read);
    EXPECT_EQ(portion_to_bytes(read), bytes) << leaf;
    EXPECT_EQ(portion_cells_to_bytes(read), tets) << leaf;
    EXPECT_EQ(read.placed, portion.placed);
    EXPECT_EQ(read.tet_digest, portion.tet_digest);
    EXPECT_EQ(read.part.tets, grid.parts.at(leaf).mesh.tets);
    EXPECT_EQ(read.part.nodes, grid.parts.at(leaf).mesh.nodes);
  }
}

/// Of a part with cells of every type and both kinds of boundary faces.
Portion hybrid_portion(std::size_t part = 1) {
  Portion portion;
  portion.part = HybridGrid(4, 2).parts[part];
  portion.surface_triangles.resize(portion.part.faces.size(), 7);
  take_figures(std::vector<bool>(portion.part.nodes.size()), {}, portion);
  return portion;
}

TEST(Portion, with_cells_of_every_type_survives_its_file_bit_by_bit) {
  const Portion portion = hybrid_portion();
  const std::string bytes = portion_to_bytes(portion);
  const std::string cells = portion_cells_to_bytes(portion);
  Portion read = portion_from_bytes(bytes, "portion");
  for (const ElementType type : cell_block_types) {
    EXPECT_TRUE(read.part.blocks[type].empty());
    EXPECT_GT(read.others[type], 0);
  }
  EXPECT_GT(read.others[ElementType::quad], 0);
  add_portion_cells(cells, "cells", read);
  EXPECT_EQ(portion_to_bytes(read), bytes);
  EXPECT_EQ(portion_cells_to_bytes(read), cells);
  EXPECT_EQ(read.others, portion.others);
  EXPECT_EQ(read.other_digest, portion.other_digest);
  EXPECT_EQ(read.part.tets, portion.part.tets);
  for_each_block(read.part.blocks, [&](ElementType type, const ElementBlock& block) {
    EXPECT_EQ(block.nodes, portion.part.blocks[type].nodes);
    EXPECT_EQ(block.regions, portion.part.blocks[type].regions);
    EXPECT_EQ(block.patches, portion.part.blocks[type].patches);
  });
}

TEST(Portion, with_other_cells_its_files_are_refused_where_they_are_damaged_or_of_another) {
  Portion portion = hybrid_portion();
  const std::string bytes = portion_to_bytes(portion);
  const std::string cells = portion_cells_to_bytes(portion);
  for (std::size_t place = 0; place < bytes.size(); place += 13) {
    std::string damaged = bytes;
    damaged[place] = static_cast<char>(damaged[place] ^ 1);
    EXPECT_THROW(portion_from_bytes(damaged, "portion"), CorruptFile) << place;
    EXPECT_THROW(portion_from_bytes(bytes.substr(0, place), "portion"), CorruptFile) << place;
  }
  for (std::size_t place = 0; place < cells.size(); place += 13) {
    std::string damaged = cells;
    damaged[place] = static_cast<char>(damaged[place] ^ 1);
    EXPECT_THROW(add_portion_cells(damaged, "cells", portion), CorruptFile) << place;
  }
  EXPECT_THROW(add_portion_cells(portion_cells_to_bytes(hybrid_portion(0)), "cells", portion),
               CorruptFile);
  const std::string of_tets = portion_cells_to_bytes(portion_of(cut_grid(2), 7));
  EXPECT_THROW(add_portion_cells(of_tets, "cells", portion), CorruptFile);
}

TEST(Portion, with_other_cells_its_volume_is_that_of_all) {
  const HybridGrid grid(4, 2);
  double volume = 0;
  for (const std::size_t part : {0U, 1U}) {
    volume += hybrid_portion(part).shapes.regions.at(0).volume;
  }
  EXPECT_NEAR(volume, grid.volume(), 1e-12 * grid.volume());
}

TEST(Portion, a_file_that_is_cut_short_or_differs_in_one_byte_is_refused) {
  const std::string bytes = portion_to_bytes(portion_of(cut_grid(2), 2));
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    EXPECT_THROW(portion_from_bytes(bytes.substr(0, size), "portion"), CorruptFile) << size;
  }
  for (std::size_t place = 0; place < bytes.size(); place += 5) {
    std::string damaged = bytes;
    damaged[place] = static_cast<char>(damaged[place] ^ 1);
    EXPECT_THROW(portion_from_bytes(damaged, "portion"), CorruptFile) << place;
  }
}

TEST(Portion, tets_that_are_cut_short_damaged_or_of_another_are_refused) {
  const CutGrid grid = cut_grid(2);
  Portion portion = portion_of(grid, 7);
  const std::string bytes = portion_cells_to_bytes(portion);
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    EXPECT_THROW(add_portion_cells(bytes.substr(0, size), "tets", portion), CorruptFile) << size;
  }
  for (std::size_t place = 0; place < bytes.size(); place += 5) {
    std::string damaged = bytes;
    damaged[place] = static_cast<char>(damaged[place] ^ 1);
    EXPECT_THROW(add_portion_cells(damaged, "tets", portion), CorruptFile) << place;
  }
  EXPECT_THROW(add_portion_cells(portion_cells_to_bytes(portion_of(grid, 6)), "tets", portion),
               CorruptFile);
}

TEST(Portion, its_counts_are_told_by_its_first_bytes) {
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "portion";
  const Portion portion = portion_of(cut_grid(3), 7);
  write_file_atomically(path, portion_to_bytes(portion));
  const PortionCounts counts = portion_counts(path, "portion");
  EXPECT_EQ(counts.nodes, std::ssize(portion.part.nodes));
  EXPECT_EQ(counts.tets, std::ssize(portion.part.tets));
  EXPECT_EQ(counts.faces, std::ssize(portion.part.faces));
  EXPECT_EQ(counts.others, ElementCounts{});
  write_file_atomically(path, portion_to_bytes(hybrid_portion()));
  EXPECT_EQ(portion_counts(path, "portion").others, hybrid_portion().others);
  write_file_atomically(path, portion_to_bytes(portion).substr(0, 40));
  EXPECT_THROW(portion_counts(path, "portion"), CorruptFile);
  write_file_atomically(path, "something else, and long enough to have had counts in it");
  EXPECT_THROW(portion_counts(path, "portion"), CorruptFile);
}

TEST(Portion, a_node_of_the_surface_elsewhere_along_any_axis_is_refused) {
  for (int axis = 0; axis < 3; ++axis) {
    CutGrid grid = cut_grid(2);
    MeshPart& part = grid.parts.at(7);
    const std::vector<Origin>& origins = part.subdomain.node_origin;
    std::size_t v = 0;
    while (origins.at(v).owner != 0) ++v;
    part.mesh.nodes[v][axis] = std::nextafter(part.mesh.nodes[v][axis], 9);
    EXPECT_EQ(error_text_of([&] { portion_of(grid, 7); }),
              "sub-domain RR: a node is not where the input surface has it")
        << axis;
  }
}

TEST(Portion, an_element_of_no_node_is_refused) {
  for (const std::int32_t wrong : {-1, std::numeric_limits<std::int32_t>::max()}) {
    Portion portion = portion_of(cut_grid(2), 7);
    portion.part.tets.back()[2] = wrong;
    EXPECT_THROW(add_portion_cells(portion_cells_to_bytes(portion), "tets", portion), CorruptFile);
    portion = portion_of(cut_grid(2), 7);
    portion.part.faces.back()[0] = wrong;
    EXPECT_THROW(portion_from_bytes(portion_to_bytes(portion), "portion"), CorruptFile);
    portion = hybrid_portion();
    portion.part.blocks[ElementType::quad].nodes.back() = wrong;
    EXPECT_THROW(portion_from_bytes(portion_to_bytes(portion), "portion"), CorruptFile);
    portion = hybrid_portion();
    portion.part.blocks[ElementType::prism].nodes.back() = wrong;
    EXPECT_THROW(add_portion_cells(portion_cells_to_bytes(portion), "cells", portion), CorruptFile);
  }
}

TEST(Portion, a_node_away_from_where_the_surface_has_it_is_refused) {
  const CutGrid grid = cut_grid(4);
  for (const bool is_moved : {false, true}) {
    MeshPart part = grid.parts.at(6);
    const auto moved = static_cast<std::size_t>(
        std::find_if(part.subdomain.node_origin.begin(), part.subdomain.node_origin.end(),
                     [](const Origin& origin) { return origin.owner == 0; }) -
        part.subdomain.node_origin.begin());
    if (is_moved) part.mesh.nodes[moved].x = std::nextafter(part.mesh.nodes[moved].x, 2);
    EXPECT_EQ(error_text_of([&] { grid.portion_of(part); }),
              is_moved ? "sub-domain RL: a node is not where the input surface has it" : "");
  }
}

TEST(Portion, a_surface_triangle_with_other_nodes_or_another_orientation_is_refused) {
  const CutGrid grid = cut_grid(4);
  const MeshPart good = grid.parts.at(6);
  const auto t = static_cast<std::size_t>(
      std::find_if(good.subdomain.triangle_origin.begin(), good.subdomain.triangle_origin.end(),
                   [](const Origin& origin) { return origin.owner == 0; }) -
      good.subdomain.triangle_origin.begin());
  MeshPart turned = good;
  std::swap(turned.subdomain.triangles[t][1], turned.subdomain.triangles[t][2]);
  const std::string other_nodes =
      "sub-domain RL: a surface triangle has other nodes than in the input";
  EXPECT_EQ(error_text_of([&] { grid.portion_of(turned); }), other_nodes);
  MeshPart other = good;
  other.subdomain.triangle_origin[t].index ^= 1;
  EXPECT_EQ(error_text_of([&] { grid.portion_of(other); }), other_nodes);
  MeshPart unknown = good;
  unknown.subdomain.triangle_origin[t].index = 1'000'000;
  EXPECT_EQ(error_text_of([&] { grid.portion_of(unknown); }),
            "the surface has no triangle 1000000");
}

TEST(Portion, counts_that_differ_from_the_numbering_are_refused) {
  const CutGrid grid = cut_grid(4);
  MeshPart part = grid.parts.at(6);
  const std::string counts = "sub-domain RL: different counts from the numbering";
  part.mesh.tets.pop_back();
  EXPECT_EQ(error_text_of([&] { grid.portion_of(part); }), counts);
  part = grid.parts.at(6);
  part.mesh.nodes.emplace_back();
  EXPECT_EQ(error_text_of([&] { grid.portion_of(part); }), counts);
  part = grid.parts.at(6);
  --part.mesh.boundary_nodes;
  EXPECT_EQ(error_text_of([&] { grid.portion_of(part); }), counts);
}

TEST(Portion, a_portion_in_the_place_of_another_is_not_assembled) {
  const CutGrid grid = cut_grid(4);
  const auto swapped = [&](const LeafNumbers& leaf) {
    const std::uint64_t heap = leaf.path.heap;
    return portion_of(grid, heap == 6 ? 7 : heap == 7 ? 6 : heap);
  };
  EXPECT_THROW(assemble_global_mesh(grid.surface, grid.numbering(), swapped, {}), Error);
}

TEST(Portion, a_global_number_of_no_node_is_not_assembled) {
  const CutGrid grid = cut_grid(4);
  for (const std::int64_t wrong : {std::int64_t{-1}, std::int64_t{125}}) {
    const auto damaged = [&](const LeafNumbers& leaf) {
      Portion portion = portion_of(grid, leaf.path.heap);
      portion.part.local2global.back() = wrong;
      return portion;
    };
    EXPECT_THROW(assemble_global_mesh(grid.surface, grid.numbering(), damaged, {}), Error);
  }
}

TEST(Portion, figures_of_the_portions_add_up_to_those_of_the_whole) {
  const CutGrid grid = cut_grid(4);
  MeshShapes sum;
  ShapeStatistics one_by_one;
  for (const std::uint64_t leaf : {2U, 6U, 7U}) {
    add_shapes(portion_of(grid, leaf).shapes, sum);
    const TetMesh& mesh = grid.parts.at(leaf).mesh;
    for (const Tet& t : mesh.tets) {
      const auto at = [&](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(t[i])]; };
      one_by_one.add(at(0), at(1), at(2), at(3));
    }
  }
  EXPECT_EQ(sum.all.tets, one_by_one.tets);
  EXPECT_EQ(sum.all.dihedral_histogram, one_by_one.dihedral_histogram);
  EXPECT_EQ(sum.all.min_dihedral_deg, one_by_one.min_dihedral_deg);
  EXPECT_EQ(sum.all.smallest_height, one_by_one.smallest_height);
  EXPECT_NEAR(sum.all.sum_radius_ratio, one_by_one.sum_radius_ratio, 1e-9);
  EXPECT_EQ(sum.near_cuts.tets + sum.away_from_cuts.tets, sum.all.tets);
}

}  // namespace
}  // namespace tetfarm
