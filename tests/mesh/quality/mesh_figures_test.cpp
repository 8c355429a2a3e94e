#include "mesh/quality/mesh_figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "mesh/formats/registry/export_mesh.h"
#include "mesh/formats/registry/open_mesh.h"
#include "mesh/formats/registry/read_global_mesh.h"
#include "mesh/quality/cut_nodes.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/support/hybrid_grid.h"
#include "tests/support/mesh_report.h"

namespace tetfarm {
namespace {

std::int64_t sum(const std::vector<std::int64_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

TEST(MeshFigures, part_by_part_are_those_of_the_whole_mesh_in_memory) {
  const TempFolder folder;
  for (const bool has_regions : {false, true}) {
    GridSource grid(cut_grid(8));
    if (has_regions) grid.parts[2].region = 2;
    const auto file = folder.path() / "a.vtkhdf";
    export_mesh(grid, find_mesh_format("", file), file);
    const MeshFigures figures = figures_of(grid);
    const MeshReport report = report_on(read_global_mesh(file));
    EXPECT_EQ(figures.tets, report.tets);
    EXPECT_EQ(figures.nodes, report.nodes);
    EXPECT_EQ(figures.boundary_triangles, report.boundary_triangles);
    EXPECT_NEAR(figures.volume, report.volume, 1e-12);
    for (const auto& [ours, theirs] :
         {std::pair{&figures.all.shapes, &report.shapes.all},
          {&figures.near_cuts.shapes, &report.shapes.near_cuts},
          {&figures.away_from_cuts.shapes, &report.shapes.away_from_cuts}}) {
      EXPECT_EQ(ours->tets, theirs->tets);
      EXPECT_EQ(ours->dihedral_histogram, theirs->dihedral_histogram);
      EXPECT_EQ(ours->smallest_height, theirs->smallest_height);
    }
    EXPECT_GT(figures.near_cuts.shapes.tets, 0);
    EXPECT_GT(figures.away_from_cuts.shapes.tets, 0);
  }
}

TEST(MeshFigures, count_each_tet_once_in_each_histogram) {
  const MeshFigures figures = figures_of(GridSource(cut_grid(4)));
  EXPECT_EQ(sum(figures.all.radius_ratio.counts), figures.tets);
  EXPECT_EQ(
      sum(figures.near_cuts.radius_ratio.counts) + sum(figures.away_from_cuts.radius_ratio.counts),
      figures.tets);
  // Six equal tets in each cube of edge 1/4: 1/384 lies between 2^-9 and 2^-8.
  EXPECT_EQ(figures.volumes, (std::map<int, std::int64_t>{{-9, figures.tets}}));
}

TEST(MeshFigures, measure_edges_by_the_spacing_at_their_middles) {
  const GridSource grid(cut_grid(4));
  EXPECT_EQ(figures_of(grid).edges.edges, 0) << "no spacing is known";
  // Cubes of edge 1/4; the longest edges are their diagonals.
  const MeshFigures even = figures_of(grid, [](const Vec3&) { return 0.5; });
  EXPECT_DOUBLE_EQ(even.edges.shortest, 0.5);
  EXPECT_DOUBLE_EQ(even.edges.longest, std::sqrt(3.0) / 2);
  EXPECT_EQ(sum(even.edges.over_spacing.counts), even.edges.edges);
  const MeshFigures graded = figures_of(grid, [](const Vec3& p) { return 1 + p.x; });
  EXPECT_DOUBLE_EQ(graded.edges.shortest, 0.25 / 2);
  EXPECT_DOUBLE_EQ(graded.edges.longest, std::sqrt(3.0) / 4 / 1.125);
}

TEST(MeshFigures, name_the_worst_tets_and_the_lowest_by_their_places) {
  GridSource grid(cut_grid(4));
  NumberedPart& part = grid.parts[1];
  const std::size_t bad = part.tets.size() / 2;
  // Its fourth node is drawn near to the face opposite: all others are right-angled.
  const Tet& tet = part.tets[bad];
  const auto node = [&](std::size_t i) -> Vec3& {
    return part.nodes[static_cast<std::size_t>(tet[i])];
  };
  const Vec3 middle = (node(0) + node(1) + node(2)) / 3.0;
  node(3) = middle + 0.001 * (node(3) - middle);
  const MeshFigures figures = figures_of(grid);
  ASSERT_EQ(figures.worst.size(), most_worst_tets);
  for (std::size_t i = 1; i < figures.worst.size(); ++i) {
    EXPECT_LE(figures.worst[i - 1].min_dihedral_deg, figures.worst[i].min_dihedral_deg);
  }
  EXPECT_EQ(figures.worst[0].min_dihedral_deg, figures.all.shapes.min_dihedral_deg);
  EXPECT_EQ(figures.worst[0].centroid, figures.all.shapes.worst_centroid);
  EXPECT_EQ(figures.time_step(), figures.all.shapes.smallest_height);
  EXPECT_LT(figures.time_step(), 0.001);
  EXPECT_EQ(figures.subdomains[1].min_dihedral_deg, figures.worst[0].min_dihedral_deg);
}

TEST(MeshFigures, number_the_worst_tets_through_all_parts) {
  const GridSource grid(cut_grid(4));
  std::vector<std::pair<std::size_t, std::size_t>> tets;  // in their order: part, place there
  for (std::size_t i = 0; i < grid.size(); ++i) {
    for (std::size_t t = 0; t < grid.parts[i].tets.size(); ++t) tets.emplace_back(i, t);
  }
  GridSource bad = grid;
  for (const std::size_t i : {1U, 2U}) bad.parts[i].nodes[0] += Vec3{0.1, 0.07, 0.03};
  const MeshFigures figures = figures_of(bad);
  std::set<std::size_t> met;
  for (const WorstTet& worst : figures.worst) {
    const auto [part, place] = tets.at(static_cast<std::size_t>(worst.tet));
    EXPECT_EQ(part, worst.subdomain);
    const NumberedPart& here = bad.parts[part];
    Vec3 sum;
    for (const std::int32_t v : here.tets[place]) sum += here.nodes[static_cast<std::size_t>(v)];
    EXPECT_LT(distance(0.25 * sum, worst.centroid), 1e-12);
    met.insert(part);
  }
  EXPECT_GT(met.size(), 1U);
}

TEST(MeshFigures, of_a_file_without_subdomains_has_no_tets_near_cuts) {
  const TempFolder folder;
  const auto file = folder.path() / "a.lb8.ugrid";
  export_mesh(GridSource(cut_grid(4)), find_mesh_format("", file), file);
  const MeshFigures figures = figures_of(*open_mesh(file));
  EXPECT_FALSE(figures.knows_subdomains);
  EXPECT_EQ(figures.near_cuts.shapes.tets, 0);
  EXPECT_EQ(figures.away_from_cuts.shapes.tets, figures.tets);
}

TEST(MeshFigures, balance_counts_cells_of_every_type) {
  const HybridGrid grid(5, 3);
  const MeshFigures figures = figures_of(grid);
  std::vector<std::int64_t> cells;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    cells.push_back(cells_of(grid.parts[i]));
    EXPECT_EQ(figures.subdomains.at(i).cells, cells.back());
  }
  const auto sum = std::accumulate(cells.begin(), cells.end(), std::int64_t{0});
  EXPECT_EQ(figures.cells(), sum);
  const auto largest = static_cast<double>(*std::max_element(cells.begin(), cells.end()));
  EXPECT_DOUBLE_EQ(figures.largest_over_mean(), largest * 3 / static_cast<double>(sum));
}

TEST(MeshFigures, steps_beside_the_mesh_away_from_cuts_are_the_ratio_of_heights) {
  MeshFigures figures;
  EXPECT_EQ(figures.steps_beside_away(), 1);
  figures.away_from_cuts.shapes.smallest_height = 6;
  figures.all.shapes.smallest_height = 2;
  EXPECT_EQ(figures.steps_beside_away(), 3);
}

TEST(CutNodes, are_those_of_two_subdomains_of_one_region) {
  GridSource grid(cut_grid(4));
  for (const bool is_region_apart : {false, true}) {
    if (is_region_apart) {
      for (std::size_t i = 0; i < grid.size(); ++i) {
        grid.parts[i].region = static_cast<std::int32_t>(i + 1);
      }
    }
    const CutNodes cuts(grid);
    std::int64_t found = 0;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const NumberedPart part = grid.part(i);
      for (const bool is_on_cut : cuts.of(part, part.region)) found += is_on_cut ? 1 : 0;
    }
    EXPECT_EQ(found > 0, !is_region_apart);
  }
}

TEST(CutNodes, are_none_of_a_single_subdomain_however_often_its_tets_have_a_node) {
  GridSource grid(cut_grid(4));
  grid.parts.resize(1);
  NumberedPart& part = grid.parts[0];
  // Two regions, each in one run of tets.
  part.region_of_tet.assign(part.tets.size(), 1);
  for (std::size_t t = part.tets.size() / 2; t < part.tets.size(); ++t) part.region_of_tet[t] = 2;
  const CutNodes cuts(grid);
  for (const std::int32_t region : {1, 2}) {
    const std::vector<bool> is_on_cut = cuts.of(part, region);
    EXPECT_EQ(std::ranges::count(is_on_cut, true), 0);
  }
}

TEST(Histogram, counts_what_lies_outside_in_the_bins_at_the_ends) {
  Histogram histogram(0, 1, 4);
  for (const double value : {-1.0, 0.0, 0.25, 0.99, 1.0, 7.0}) histogram.add(value);
  EXPECT_THAT(histogram.counts, testing::ElementsAre(2, 1, 0, 3));
  EXPECT_EQ(histogram.end_of(1), 0.25);
}

}  // namespace
}  // namespace tetfarm
