#include <stdlib.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/check.h"
#include "base/error.h"
#include "mesh/formats/registry/open_mesh.h"
#include "mesh/quality/mesh_check.h"
#include "tests/fuzz/fuzz_targets.h"

namespace tetfarm::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::array names = {"a.lb8.ugrid",
                              "a.b8.ugrid",
                              "a.lb8l.ugrid",
                              "a.b8l.ugrid",
                              "a.su2",
                              "a.meshb",
                              "a.cgns",
                              "a_1.msh",
                              "a.vtu",
                              "a.ele",
                              "a.node",
                              "a.vtkhdf",
                              "a.pvtu",
                              "a.face",
                              "case/constant/polyMesh/points",
                              "case/constant/polyMesh/faces",
                              "case/constant/polyMesh/owner",
                              "case/constant/polyMesh/neighbour",
                              "case/constant/polyMesh/boundary",
                              "case/constant/polyMesh/cellZones",
                              "parts/processor1/constant/polyMesh/faces",
                              "parts/processor1/constant/polyMesh/boundary"};

/// In memory where there is such a place.
fs::path make_folder() {
  std::string folder = fs::is_directory("/dev/shm") ? "/dev/shm" : fs::temp_directory_path();
  folder += "/tetfarm-fuzz-mesh-XXXXXX";
  TF_CHECK(::mkdtemp(folder.data()) != nullptr);
  static fs::path to_remove;
  to_remove = folder;
  std::atexit([] { fs::remove_all(to_remove); });
  return folder;
}

void write(const fs::path& file, std::string_view bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

/// What TetGen's files need beside them: one tet.
void write_one_tet(const fs::path& folder) {
  write(folder / "a.node", "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n");
  write(folder / "a.face", "4 1\n0 1 2 3 1\n1 0 3 2 1\n2 0 1 3 1\n3 0 2 1 1\n");
  write(folder / "a.ele", "1 4 1\n0 0 1 2 3 1\n");
}

/// A polyMesh of one tet, with these faces first and these patches behind them.
void write_one_tet_as_foam(const fs::path& folder, const std::string& faces,
                           const std::string& patches) {
  const std::string head = "FoamFile{format ascii;}";
  const fs::path mesh = folder / "constant/polyMesh";
  fs::create_directories(mesh);
  write(mesh / "points", head + "4((0 0 0)(1 0 0)(0 1 0)(0 0 1))");
  write(mesh / "faces", head + "4(" + faces + ")");
  write(mesh / "owner", head + "4(0 0 0 0)");
  write(mesh / "neighbour", head + "0()");
  write(mesh / "boundary", head + patches);
  write(mesh / "cellZones", head + "1(a{type cellZone;cellLabels List<label> 1(0);})");
}

/// The cases that the files of OpenFOAM lie in: one tet, and two with a face between them.
void write_foam_cases(const fs::path& folder) {
  const std::string faces = "3(1 2 3)3(0 3 2)3(0 1 3)3(0 2 1)";
  write_one_tet_as_foam(folder / "case", faces, "1(a{type wall;nFaces 4;startFace 0;})");
  for (const char* here : {"0", "1"}) {
    const std::string there = here[0] == '0' ? "1" : "0";
    write_one_tet_as_foam(folder / ("parts/processor" + std::string(here)), faces,
                          "2(a{type wall;nFaces 3;startFace 0;}b{type processor;nFaces 1;"
                          "startFace 3;myProcNo " +
                              std::string(here) + ";neighbProcNo " + there + ";})");
  }
}

/// What is opened for a file with that name.
fs::path mesh_of(const fs::path& folder, std::string_view name) {
  if (name.starts_with("case/")) return folder / "case";
  if (name.starts_with("parts/")) return folder / "parts";
  return folder / (name == "a.face" ? "a.ele" : name);
}

void check_part(const NumberedPart& part) {
  const auto are_there = [&](const auto& nodes) {
    for (const std::int32_t v : nodes) {
      TF_CHECK(v >= 0 && static_cast<std::size_t>(v) < part.nodes.size());
    }
  };
  for (const Tet& tet : part.tets) are_there(tet);
  for (const Triangle& face : part.faces) are_there(face);
  TF_CHECK(part.local2global.size() == part.nodes.size());
  TF_CHECK(part.patch_of_face.size() == part.faces.size());
}

}  // namespace

void mesh(std::string_view input) {
  static const fs::path folder = make_folder();
  if (input.empty()) return;
  const std::string name = names[static_cast<unsigned char>(input[0]) % names.size()];
  write_one_tet(folder);
  if (name.find('/') != name.npos) write_foam_cases(folder);
  write(folder / name, input.substr(1));
  const fs::path file = mesh_of(folder, name);
  try {
    const auto source = open_mesh(file, folder);
    for (std::size_t i = 0; i < source->size(); ++i) check_part(source->part(i));
    MeshCheckOptions options;
    options.memory_bytes = 1 << 16;
    options.folder = folder;
    check_mesh(*source, options);
  } catch (const Error&) {
  }
}

}  // namespace tetfarm::fuzz
