// Parts of real models, meshed by the built program in 16 sub-domains.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "mesh/formats/cell_faces.h"
#include "mesh/formats/communication/communication_table.h"
#include "mesh/formats/registry/open_mesh.h"
#include "mesh/graph/metis_partition.h"
#include "mesh/partition/dual_graph.h"
#include "mesh/partition/partitioned_mesh.h"
#include "tests/support/program.h"
#include "tests/support/whole_dual_graph.h"

namespace tetfarm {
namespace {

struct Model {
  const char* name;
  const char* file;
  const char* outer;
  std::vector<std::int32_t> parts = {4, 16, 64};
};

class PartsOfModels : public testing::TestWithParam<Model> {
 protected:
  void SetUp() override {
    const char* data = std::getenv("TETFARM_DATA");
    if (data == nullptr) GTEST_SKIP() << "TETFARM_DATA is not set";
    const auto surface = std::filesystem::path(data) / GetParam().file;
    const test::Ended meshed =
        test::run_program({"run", surface.string(), "--subdomains", "16", "--outer",
                           GetParam().outer, "-o", "out", "--progress", "none"},
                          folder_.path(), 500);
    ASSERT_EQ(meshed.code, 0) << meshed.err;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "out")) {
      if (entry.path().extension() == ".vtkhdf") source_ = open_mesh(entry.path());
    }
    ASSERT_NE(source_, nullptr);
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<MeshSource> source_;
};

/// Of tables that are all in memory.
std::vector<std::string> complaints_of(const MeshSource& mesh,
                                       const std::filesystem::path& folder) {
  std::vector<CommunicationTable> tables;
  const MeshOutline outline = outline_of(mesh);
  for_each_communication_table(mesh, outline, folder,
                               [&](const CommunicationTable& table) { tables.push_back(table); });
  std::int64_t owned = 0;
  for (const CommunicationTable& table : tables) {
    owned += std::count(table.owner.begin(), table.owner.end(), table.part);
  }
  EXPECT_EQ(owned, outline.nodes);
  return communication_complaints(static_cast<std::int32_t>(tables.size()), [&](std::int32_t i) {
    return tables.at(static_cast<std::size_t>(i));
  });
}

std::int32_t pieces_of(const WeightedGraph& graph) {
  const std::vector<std::int32_t> pieces =
      pieces_of_parts(graph, std::vector<std::int32_t>(graph.size(), 0));
  return *std::max_element(pieces.begin(), pieces.end()) + 1;
}

TEST_P(PartsOfModels, are_even_whole_short_and_have_right_communication_tables) {
  const WeightedGraph whole = test::whole_dual_graph(*source_);
  // The inside of d150 is in pieces: parts may then have a share of several.
  const std::int32_t pieces = pieces_of(whole);
  const WeightedGraph tied = tie_pieces(whole);
  for (const std::int32_t parts : GetParam().parts) {
    SCOPED_TRACE(parts);
    const PartitionedMesh mesh(*source_, {parts}, folder_.path());
    EXPECT_LE(mesh.figures().largest_over_mean(), 1.03);
    for (std::size_t i = 0; i < mesh.size(); ++i) {
      const NumberedPart part = mesh.part(i);
      EXPECT_LE(pieces_of(dual_graph(cell_faces(part), part.tets.size())), pieces) << i;
    }
    EXPECT_THAT(complaints_of(mesh, folder_.path()), testing::IsEmpty());
    // In thin models METIS's parts are in pieces unless it is asked for whole ones, as ours are.
    MetisOptions whole_parts;
    whole_parts.contiguous = true;
    const auto of_metis =
        static_cast<double>(edge_cut(whole, metis_partition(tied, parts, whole_parts)));
    const double over_metis = static_cast<double>(mesh.figures().cut_faces) / of_metis;
    std::printf(
        "%-24s %8zu tets in %d pieces, %3d parts: largest/mean %.3f, %8lld faces, %.3f of "
        "METIS's\n",
        GetParam().name, whole.size(), pieces, parts, mesh.figures().largest_over_mean(),
        static_cast<long long>(mesh.figures().cut_faces), over_metis);
    EXPECT_LE(over_metis, 1.10);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Data, PartsOfModels,
    testing::Values(
        Model{"cube_sphere", "cube_sphere/cube_sphere.msh", "none"},
        Model{"almond_quarter", "nasa_almond_quarter/NasaAlmondQuarterWavelengthv2.stl", "none"},
        Model{"almond_tenth", "nasa_almond_tenth/NasaAlmondTenthWavelengthv2.stl", "none"},
        Model{"almond_in_box", "nasa_almond_in_box/nasa_almond_in_box.msh", "none"},
        Model{"flange", "flange/flange.msh", "none"}, Model{"pipe", "pipe/pipe.msh", "none"},
        Model{"onera_m6", "onera_m6_sharp_te/onera_m6_sharp_te.msh.gz", "none"},
        Model{"dtc_hull", "dtc_hull/dtc_hull.off.gz", "none"},
        Model{"netgen_plane", "netgen_plane/netgen_plane.stl", "none"},
        Model{"cessna210", "cessna210/cessna210.msh.gz", "none"},
        Model{"prime", "prime_open_duct/prime_open_duct.stl", "none"},
        Model{"d150", "d150_aircraft/d150_aircraft.msh.gz", "none"},
        Model{"d150_box2", "d150_aircraft/d150_aircraft.msh.gz", "box:2", {16}},
        Model{"dtc_hull_box2", "dtc_hull/dtc_hull.off.gz", "box:2", {64}},
        Model{"piece_4vol", "gmsh_piece_4vol/gmsh_piece_4vol.msh", "none"}),
    [](const auto& model) { return std::string(model.param.name); });

}  // namespace
}  // namespace tetfarm
