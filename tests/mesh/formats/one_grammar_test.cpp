// What a file says does not depend on whether it is read as a surface or as a mesh: each format has
// one walker.

#include <gmock/gmock.h>

#include <functional>

#include "base/file_system.h"
#include "mesh/formats/registry/export_mesh.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/mesh/formats/refusal.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

std::string surface_refusal(const std::string& name, const std::string& bytes) {
  try {
    read_surface_bytes(bytes, name);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

/// The message without the folder that the file was in.
std::string mesh_refusal(const std::string& name, const std::string& bytes) {
  const std::string message = refusal_of(name, bytes);
  const std::size_t place = message.find(name);
  return place == message.npos ? message : message.substr(place);
}

std::string exported(const std::string& format, const std::string& name) {
  const TempFolder folder;
  export_mesh(GridSource(cut_grid(3)), find_mesh_format(format, name), folder.path() / name);
  return read_file(folder.path() / name);
}

struct Fault {
  std::string format;
  std::string name;
  std::function<void(std::string& bytes)> make;
};

void replace(std::string& bytes, std::string_view what, std::string_view with) {
  const std::size_t place = bytes.find(what);
  ASSERT_NE(place, bytes.npos) << what;
  bytes.replace(place, what.size(), with);
}

std::vector<Fault> faults() {
  const auto change = [](const char* what, const char* with) {
    return [=](std::string& bytes) { replace(bytes, what, with); };
  };
  const auto cut_behind = [](const char* what) {
    return [=](std::string& bytes) { bytes.resize(bytes.find(what) + 100); };
  };
  const auto cut = [](std::string& bytes) { bytes.resize(bytes.size() / 2); };
  return {{"msh41-text", "a.msh", change("4.1 0 8", "4.0 0 8")},
          {"msh41-text", "a.msh", change("4.1 0 8", "4.1 0 4")},
          {"msh41-text", "a.msh", change("$EndNodes", "$EndNode")},
          {"msh41-text", "a.msh", change("$Nodes", "Nodes")},
          {"msh22", "a.msh", change("$EndPhysicalNames", "$End")},
          {"msh22", "a.msh", cut_behind("$Nodes")},
          {"msh41", "a.msh", cut_behind("$Nodes")},
          {"su2", "a.su2", change("NDIME= 3", "NDIME= 2")},
          {"su2", "a.su2", change("NPOIN= ", "NPOIN= 9999999")},
          {"su2", "a.su2", change("NPOIN= ", "NPOIN  ")},
          {"su2", "a.su2", cut_behind("NPOIN")},
          {"meshb", "a.meshb", [](std::string& bytes) { bytes[0] = 2; }},
          {"meshb", "a.meshb", [](std::string& bytes) { bytes[4] = 5; }},
          {"meshb", "a.meshb", [](std::string& bytes) { bytes[20] = 2; }},
          {"meshb", "a.meshb", cut},
          {"lb8.ugrid", "a.lb8.ugrid", [](std::string& bytes) { bytes[3] = '\x80'; }},
          {"b8l.ugrid", "a.b8l.ugrid", [](std::string& bytes) { bytes[2] = 1; }},
          {"lb8.ugrid", "a.lb8.ugrid", [](std::string& bytes) { bytes.resize(2000); }}};
}

TEST(OneGrammar, surface_and_mesh_readers_say_the_same_of_the_same_fault) {
  for (const Fault& fault : faults()) {
    std::string bytes = exported(fault.format, fault.name);
    EXPECT_EQ(surface_refusal(fault.name, bytes), "") << fault.format;
    EXPECT_EQ(mesh_refusal(fault.name, bytes), "") << fault.format;
    fault.make(bytes);
    const std::string message = surface_refusal(fault.name, bytes);
    EXPECT_THAT(message, HasSubstr(fault.name)) << fault.format;
    EXPECT_EQ(mesh_refusal(fault.name, bytes), message) << fault.format;
  }
}

TEST(OneGrammar, the_surface_of_a_mesh_is_its_boundary) {
  for (const auto& [format, name] : {std::pair{"msh41", "a.msh"},
                                     {"msh41-text", "a.msh"},
                                     {"msh22", "a.msh"},
                                     {"su2", "a.su2"},
                                     {"meshb", "a.meshb"},
                                     {"lb8.ugrid", "a.lb8.ugrid"},
                                     {"b8.ugrid", "a.b8.ugrid"},
                                     {"lb8l.ugrid", "a.lb8l.ugrid"},
                                     {"b8l.ugrid", "a.b8l.ugrid"}}) {
    const SurfaceMesh surface = read_surface_bytes(exported(format, name), name);
    EXPECT_EQ(surface.triangles.size(), 6U * 3 * 3 * 2) << format;
    EXPECT_EQ(surface.vertices.size(), 4U * 4 * 4 - 2 * 2 * 2) << format;
    EXPECT_EQ(surface.patch_names.size(), 2U) << format;
    EXPECT_NEAR(std::abs(enclosed_volume(surface.vertices, surface.triangles)), 1, 1e-12) << format;
  }
}

}  // namespace
}  // namespace tetfarm
