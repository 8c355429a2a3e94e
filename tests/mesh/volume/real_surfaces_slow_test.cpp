#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <string>

#include "mesh/core/tet_quality.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/inspect/surface_check.h"
#include "tests/mesh/volume/volume_checks.h"

namespace tetfarm {
namespace {

struct RealSurface {
  const char* file;
  double outer_box;           // factor, 0: none
  double smallest_angle_deg;  // that the mesh must have at least
};

void PrintTo(const RealSurface& surface, std::ostream* out) { *out << surface.file; }

class VolumeMeshOfRealSurface : public testing::TestWithParam<RealSurface> {};

TEST_P(VolumeMeshOfRealSurface, is_valid_and_holds_every_input_triangle) {
  const char* folder = std::getenv("TETFARM_DATA");
  if (folder == nullptr) GTEST_SKIP() << "TETFARM_DATA is not set";
  const auto& [file, outer_box, smallest_angle_deg] = GetParam();
  CheckedSurface checked = check_surface(read_surface(std::string(folder) + "/" + file));
  ASSERT_TRUE(checked.report.defects.empty());
  if (outer_box > 0) {
    OuterBoundary outer;
    outer.kind = OuterBoundary::Kind::box;
    outer.factor = outer_box;
    checked.surface = add_outer_boundary(checked.surface, outer, 0.3);
  }
  const Subdomain domain = root_subdomain(checked.surface);
  const SpacingField spacing = make_spacing_field(checked.surface, {});
  const TetMesh mesh = mesh_volume(domain, spacing).mesh.value();
  expect_mesh_of(mesh, domain);
  double smallest = 180;
  for (const Tet& t : mesh.tets) {
    const auto p = [&](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(t[i])]; };
    smallest = std::min(smallest, dihedral_range(p(0), p(1), p(2), p(3)).min_deg);
  }
  EXPECT_GT(smallest, smallest_angle_deg);
}

INSTANTIATE_TEST_SUITE_P(
    Models, VolumeMeshOfRealSurface,
    testing::Values(RealSurface{"cube_sphere/cube_sphere.stl", 0, 8},
                    RealSurface{"nasa_almond_quarter/NasaAlmondQuarterWavelengthv2.stl", 0, 5},
                    RealSurface{"nasa_almond_tenth/NasaAlmondTenthWavelengthv2.stl", 2, 8},
                    RealSurface{"nasa_almond_in_box/nasa_almond_in_box.stl", 0, 8},
                    RealSurface{"flange/flange.stl", 0, 12}, RealSurface{"pipe/pipe.stl", 0, 15},
                    RealSurface{"onera_m6_sharp_te/onera_m6_sharp_te.msh.gz", 0, 5},
                    RealSurface{"netgen_plane/netgen_plane.stl", 0, 0},
                    RealSurface{"cessna210/cessna210.msh.gz", 0, 0},
                    RealSurface{"cdt_bracket/bracket.off", 0, 0.5},
                    RealSurface{"thingi_520644/520644.stl", 0, 0.02},
                    RealSurface{"printer_spool_holder/printer_spool_holder.stl", 0, 0.1},
                    RealSurface{"printer_extruder_cover/printer_extruder_cover.stl", 0, 0.5},
                    RealSurface{"printer_adapter_printer/printer_adapter_printer.stl", 0, 2},
                    RealSurface{"prime_open_duct/prime_open_duct.stl", 0, 1},
                    RealSurface{"d150_aircraft/d150_aircraft.msh.gz", 2, 1}),
    [](const auto& test) {
      std::string name = test.param.file;
      name.resize(name.find('/'));
      return name + (test.param.outer_box > 0 ? "_in_box" : "");
    });

/// Closed and valid, but with the needles, caps and fans of CAD and modelling programs.
class RecoveryOfTessellation : public testing::TestWithParam<const char*> {};

TEST_P(RecoveryOfTessellation, loses_no_triangle_and_leaves_few_points_inside) {
  const char* folder = std::getenv("TETFARM_DATA");
  if (folder == nullptr) GTEST_SKIP() << "TETFARM_DATA is not set";
  const CheckedSurface checked =
      check_surface(read_surface(std::string(folder) + "/" + GetParam()));
  ASSERT_TRUE(checked.report.defects.empty());
  const Subdomain domain = root_subdomain(checked.surface);
  VolumeMeshOptions options;
  options.fill = false;
  VolumeMeshReport report;
  const TetMesh mesh = mesh_volume(domain, SpacingField(1), options, &report).mesh.value();
  expect_mesh_of(mesh, domain);
  EXPECT_GT(report.missing_edges, 100);
  EXPECT_LT(report.interior_steiner_points, report.missing_edges / 8);
}

INSTANTIATE_TEST_SUITE_P(Models, RecoveryOfTessellation,
                         testing::Values("cdt_bracket/bracket.off", "thingi_65004/65004.stl",
                                         "thingi_72214/72214.stl", "thingi_472042/472042.stl",
                                         "thingi_520644/520644.stl", "thingi_58011/58011.stl",
                                         "printer_spool_holder/printer_spool_holder.stl",
                                         "printer_extruder_cover/printer_extruder_cover.stl",
                                         "printer_adapter_printer/printer_adapter_printer.stl",
                                         "printer_psu_cover_delta/printer_psu_cover_delta.stl",
                                         "printer_cable_holder/printer_cable_holder.stl"),
                         [](const auto& test) {
                           const std::string name = test.param;
                           return name.substr(0, name.find('/'));
                         });

}  // namespace
}  // namespace tetfarm
