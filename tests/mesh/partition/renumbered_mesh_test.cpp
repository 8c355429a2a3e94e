#include "mesh/partition/renumbered_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "base/error.h"
#include "mesh/assemble/part_cells.h"
#include "mesh/formats/communication/communication_table.h"
#include "mesh/formats/registry/export_mesh.h"
#include "mesh/formats/registry/open_mesh.h"
#include "mesh/quality/mesh_check.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/mesh/formats/marked_grid.h"
#include "tests/support/error_text.h"
#include "tests/support/hybrid_grid.h"

namespace tetfarm {
namespace {

constexpr NodeNumbering both[] = {NodeNumbering::hilbert, NodeNumbering::reverse_cuthill_mckee};

TEST(RenumberedMesh, is_the_same_mesh) {
  const GridSource grid(cut_grid(4));
  for (const NodeNumbering numbering : both) {
    EXPECT_EQ(content_of(RenumberedMesh(std::make_unique<GridSource>(grid), numbering)),
              content_of(grid));
  }
}

TEST(RenumberedMesh, gives_each_node_one_number_in_all_parts_and_leaves_no_gap) {
  const GridSource grid(cut_grid(4));
  for (const NodeNumbering numbering : both) {
    const RenumberedMesh mesh(std::make_unique<GridSource>(grid), numbering);
    std::map<std::int64_t, Vec3> number2place;
    for (std::size_t i = 0; i < mesh.size(); ++i) {
      const NumberedPart part = mesh.part(i);
      EXPECT_TRUE(std::is_sorted(part.local2global.begin(), part.local2global.end()));
      for (std::size_t v = 0; v < part.nodes.size(); ++v) {
        const auto [known, is_new] = number2place.emplace(part.local2global[v], part.nodes[v]);
        EXPECT_EQ(known->second, part.nodes[v]);
      }
    }
    ASSERT_EQ(std::ssize(number2place), grid.nodes);
    EXPECT_EQ(number2place.rbegin()->first, grid.nodes - 1);
    EXPECT_EQ(outline_of(mesh).nodes, grid.nodes);
  }
}

TEST(RenumberedMesh, along_the_curve_has_the_surface_first_then_borders_then_the_inside) {
  const GridSource grid(cut_grid(4));
  const RenumberedMesh mesh(std::make_unique<GridSource>(grid), NodeNumbering::hilbert);
  std::set<std::int64_t> surface;
  std::map<std::int64_t, int> parts_of_node;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const NumberedPart part = mesh.part(i);
    for (const Triangle& face : part.faces) {
      for (const std::int32_t v : face) {
        surface.insert(part.local2global[static_cast<std::size_t>(v)]);
      }
    }
    for (const std::int64_t node : part.local2global) ++parts_of_node[node];
  }
  ASSERT_FALSE(surface.empty());
  EXPECT_EQ(*surface.rbegin(), std::ssize(surface) - 1);
  bool is_past_borders = false;
  for (auto node = parts_of_node.upper_bound(*surface.rbegin()); node != parts_of_node.end();
       ++node) {
    is_past_borders = is_past_borders || node->second == 1;
    EXPECT_EQ(node->second == 1, is_past_borders);
  }
  EXPECT_TRUE(is_past_borders);
}

TEST(RenumberedMesh, has_a_node_on_the_surface_whichever_part_has_its_faces) {
  auto grid = std::make_unique<GridSource>(cut_grid(4));
  NumberedPart& first = grid->parts[0];
  std::vector<bool> is_on_surface(first.nodes.size(), false);
  for (const Triangle& face : first.faces) {
    for (const std::int32_t v : face) is_on_surface[static_cast<std::size_t>(v)] = true;
  }
  // A tet that has one node on the surface, and so no face of it, becomes a part of its own.
  const auto moved = std::find_if(first.tets.begin(), first.tets.end(), [&](const Tet& tet) {
    return std::count_if(tet.begin(), tet.end(), [&](std::int32_t v) {
             return is_on_surface[static_cast<std::size_t>(v)];
           }) == 1;
  });
  ASSERT_NE(moved, first.tets.end());
  NumberedPart last;
  last.number = static_cast<std::int32_t>(grid->parts.size());
  last.tets = {{0, 1, 2, 3}};
  for (const std::int32_t v : *moved) {
    last.nodes.push_back(first.nodes[static_cast<std::size_t>(v)]);
    last.local2global.push_back(first.local2global[static_cast<std::size_t>(v)]);
  }
  first.tets.erase(moved);
  grid->parts.push_back(last);
  const RenumberedMesh mesh(std::move(grid), NodeNumbering::hilbert);
  std::set<std::int64_t> surface;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const NumberedPart part = mesh.part(i);
    for (const Triangle& face : part.faces) {
      for (const std::int32_t v : face) {
        surface.insert(part.local2global[static_cast<std::size_t>(v)]);
      }
    }
  }
  EXPECT_EQ(*surface.rbegin(), std::ssize(surface) - 1) << "they have the first numbers";
}

TEST(RenumberedMesh, by_rcm_numbers_part_after_part_what_no_part_before_has) {
  const RenumberedMesh mesh(std::make_unique<GridSource>(cut_grid(4)),
                            NodeNumbering::reverse_cuthill_mckee);
  std::set<std::int64_t> met;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const NumberedPart part = mesh.part(i);
    met.insert(part.local2global.begin(), part.local2global.end());
    EXPECT_EQ(*met.rbegin(), std::ssize(met) - 1) << "no gap after part " << i;
  }
}

TEST(RenumberedMesh, keeps_the_tets_of_a_part_in_the_order_of_their_regions) {
  GridSource grid(cut_grid(4));
  NumberedPart& part = grid.parts[0];
  part.region_of_tet.assign(part.tets.size(), 1);
  part.region_of_face.assign(part.faces.size(), 1);
  std::fill(part.region_of_tet.begin() + static_cast<long>(part.tets.size() / 2),
            part.region_of_tet.end(), 2);
  const NumberedPart ours =
      RenumberedMesh(std::make_unique<GridSource>(grid), NodeNumbering::hilbert).part(0);
  EXPECT_TRUE(std::is_sorted(ours.region_of_tet.begin(), ours.region_of_tet.end()));
  EXPECT_EQ(std::count(ours.region_of_tet.begin(), ours.region_of_tet.end(), 2),
            std::count(part.region_of_tet.begin(), part.region_of_tet.end(), 2));
}

TEST(RenumberedMesh, is_written_whole_in_every_format) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  for (const NodeNumbering numbering : both) {
    const RenumberedMesh mesh(std::make_unique<GridSource>(grid), numbering);
    for (const char* name : {"a.vtkhdf", "a.lb8.ugrid"}) {
      export_mesh(mesh, find_mesh_format("", folder.path() / name), folder.path() / name);
      EXPECT_EQ(content_of(*open_mesh(folder.path() / name)), content_of(grid)) << name;
    }
    for (const Format& format : written_formats()) {
      const auto file = folder.path() / (std::string(format.name) + std::string(format.endings[0]));
      EXPECT_EQ(export_mesh(mesh, format, file).nodes, grid.nodes) << format.name;
    }
  }
}

TEST(RenumberedMesh, has_communication_tables_that_fit_to_each_other) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  for (const NodeNumbering numbering : both) {
    const RenumberedMesh mesh(std::make_unique<GridSource>(grid), numbering);
    std::vector<CommunicationTable> tables;
    for_each_communication_table(mesh, outline_of(mesh), folder.path(),
                                 [&](const CommunicationTable& table) { tables.push_back(table); });
    ASSERT_EQ(tables.size(), grid.size());
    EXPECT_FALSE(tables[0].neighbours.empty());
    EXPECT_THAT(communication_complaints(
                    static_cast<std::int32_t>(tables.size()),
                    [&](std::int32_t i) { return tables[static_cast<std::size_t>(i)]; }),
                testing::IsEmpty());
  }
}

TEST(RenumberedMesh, of_all_types_of_cells_is_the_same_mesh) {
  const HybridGrid grid(5, 3);
  const MeshCheckResult wanted = check_mesh(grid);
  for (const NodeNumbering numbering : both) {
    const RenumberedMesh mesh(std::make_unique<HybridGrid>(5, 3), numbering);
    const MeshCheckResult check = check_mesh(mesh);
    EXPECT_THAT(check.complaints, testing::IsEmpty());
    EXPECT_EQ(check.nodes, wanted.nodes);
    EXPECT_NEAR(check.volume, grid.volume(), 1e-9);
    for (const ElementType type : all_element_types) {
      EXPECT_EQ(outline_of(mesh).elements()[type], outline_of(grid).elements()[type]);
    }
  }
}

/// Of each cell, by the places of its nodes, which no numbering changes.
std::map<std::vector<std::array<double, 3>>, std::int32_t> layers_of(const MeshSource& mesh) {
  std::map<std::vector<std::array<double, 3>>, std::int32_t> layer_of_cell;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const NumberedPart part = mesh.part(i);
    for_each_cell(part, [&](std::int32_t cell, ElementType, std::span<const std::int32_t> nodes) {
      std::vector<std::array<double, 3>> places;
      for (const std::int32_t v : nodes) {
        const Vec3& place = part.nodes[static_cast<std::size_t>(v)];
        places.push_back({place.x, place.y, place.z});
      }
      layer_of_cell[places] = part.marks[CellMark::layer].at(static_cast<std::size_t>(cell));
    });
  }
  return layer_of_cell;
}

TEST(RenumberedMesh, keeps_the_marks_of_each_cell) {
  for (const NodeNumbering numbering : both) {
    const RenumberedMesh mesh(std::make_unique<MarkedGrid>(), numbering);
    EXPECT_EQ(mesh.cell_marks(), std::vector{CellMark::layer});
    EXPECT_EQ(layers_of(mesh), layers_of(MarkedGrid()));
  }
}

/// Of each node by its place the place of its foot, and its depth.
using FeetByPlace = std::map<std::array<double, 3>, std::pair<std::array<double, 3>, std::int32_t>>;

FeetByPlace feet_by_place(const MeshSource& mesh) {
  std::map<std::int64_t, std::array<double, 3>> places = {{no_foot, {-1, -1, -1}}};
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const NumberedPart part = mesh.part(i);
    for (std::size_t v = 0; v < part.nodes.size(); ++v) {
      places[part.local2global[v]] = {part.nodes[v].x, part.nodes[v].y, part.nodes[v].z};
    }
  }
  FeetByPlace feet;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const NumberedPart part = mesh.part(i);
    for (std::size_t v = 0; v < part.nodes.size(); ++v) {
      feet[places.at(part.local2global[v])] = {places.at(part.feet.foot.at(v)),
                                               part.feet.depth.at(v)};
    }
  }
  return feet;
}

TEST(RenumberedMesh, has_the_new_numbers_of_feet_whichever_part_they_are_of) {
  for (const NodeNumbering numbering : both) {
    const RenumberedMesh mesh(std::make_unique<MarkedGrid>(), numbering);
    EXPECT_TRUE(mesh.has_feet());
    EXPECT_EQ(feet_by_place(mesh), feet_by_place(MarkedGrid()));
  }
}

TEST(RenumberedMesh, numbers_nodes_as_if_they_had_no_feet) {
  for (const NodeNumbering numbering : both) {
    auto without = std::make_unique<MarkedGrid>();
    for (NumberedPart& part : without->parts) part.feet = {};
    const RenumberedMesh mesh(std::make_unique<MarkedGrid>(), numbering);
    const RenumberedMesh other(std::move(without), numbering);
    for (std::size_t i = 0; i < mesh.size(); ++i) {
      EXPECT_EQ(mesh.part(i).nodes, other.part(i).nodes);
      EXPECT_EQ(mesh.part(i).local2global, other.part(i).local2global);
    }
  }
}

TEST(RenumberedMesh, refuses_a_foot_that_is_no_node) {
  for (const std::int64_t foot : {std::int64_t{-2}, std::int64_t{1} << 60}) {
    auto grid = std::make_unique<MarkedGrid>();
    grid->parts[1].feet.foot[3] = foot;
    const RenumberedMesh mesh(std::move(grid), NodeNumbering::hilbert);
    EXPECT_NO_THROW(mesh.part(0));
    EXPECT_EQ(error_text_of<InvalidInput>([&] { mesh.part(1); }),
              "sub-domain 1: a node has a foot that is no node of the mesh");
  }
}

}  // namespace
}  // namespace tetfarm
