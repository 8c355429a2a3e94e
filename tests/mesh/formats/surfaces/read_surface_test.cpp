#include "mesh/formats/surfaces/read_surface.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <utility>

#include "base/error.h"
#include "mesh/core/validate.h"
#include "tests/mesh/formats/surface_texts.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class ReadSurface : public testing::Test {
 protected:
  ReadSurface() {
    std::string pattern = testing::TempDir() + "tetfarm_io_XXXXXX";
    folder_ = mkdtemp(pattern.data());
  }
  ~ReadSurface() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }

  std::filesystem::path folder_;
};

TEST_F(ReadSurface, reads_every_format_plain_and_gzipped_whatever_the_case_of_the_ending) {
  for (const texts::File& file : texts::all_formats(shapes::nested_spheres(1))) {
    const std::string plain = write(file.name, file.bytes);
    const std::string packed = write(file.name + ".GZ", texts::gzip(file.bytes));
    for (const std::string& path : {plain, packed}) {
      const SurfaceMesh mesh = read_surface(path);
      EXPECT_EQ(mesh.triangles.size(), 160U) << path;
      EXPECT_EQ(mesh.vertices.size(), 84U) << path;
      EXPECT_THAT(mesh.patch_names, testing::ElementsAre("surface")) << path;
      EXPECT_EQ(mesh.patch_of_triangle.size(), 160U) << path;
    }
  }
}

TEST_F(ReadSurface, knows_gzip_by_its_first_bytes_and_reads_all_its_members) {
  const std::string text = texts::off(shapes::unit_cube());
  const std::string bytes = texts::gzip(text.substr(0, 50)) + texts::gzip(text.substr(50));
  EXPECT_EQ(read_surface(write("cube.off", bytes)).triangles.size(), 12U);
}

TEST_F(ReadSurface, refuses_damaged_gzip) {
  const std::string packed = texts::gzip(texts::off(shapes::sphere({0, 0, 0}, 1, 2)));
  EXPECT_THAT([&] { read_surface(write("a.off.gz", packed.substr(0, packed.size() - 9))); },
              ThrowsMessage<InvalidInput>(HasSubstr("cut short")));
  std::string damaged = packed;
  damaged[damaged.size() - 6] = static_cast<char>(damaged[damaged.size() - 6] ^ 1);  // its checksum
  EXPECT_THAT([&] { read_surface(write("b.off.gz", damaged)); },
              ThrowsMessage<InvalidInput>(HasSubstr("damaged")));
  EXPECT_THAT([&] { read_surface(write("c.off.gz", packed + "x")); },
              ThrowsMessage<InvalidInput>(HasSubstr("more bytes")));
}

TEST_F(ReadSurface, a_missing_file_is_not_found) {
  try {
    read_surface(folder_ / "none.stl");
    FAIL();
  } catch (const IoError& error) {
    EXPECT_EQ(error.code(), ExitCode::not_found);
  }
  EXPECT_THROW(read_surface(write("x", "") + "/a.stl"), IoError);
  std::filesystem::create_directory(folder_ / "folder.stl");
  EXPECT_THROW(read_surface(folder_ / "folder.stl"), IoError);
}

/// What is said of a file type, with the exit code that goes with it.
std::pair<ExitCode, std::string> refusal_of(const std::string& name) {
  try {
    read_surface_bytes("x", name);
  } catch (const Error& error) {
    return {error.code(), error.what()};
  }
  return {ExitCode::ok, ""};
}

TEST_F(ReadSurface, an_unknown_ending_is_a_usage_error_that_lists_what_is_read) {
  for (const std::string name : {"a.foo", "a.FOO", "a.foo.gz"}) {
    const auto [code, message] = refusal_of(name);
    EXPECT_EQ(code, ExitCode::usage);
    EXPECT_THAT(message,
                HasSubstr(name + ": unsupported file type `.foo`; Tetfarm reads .stl .obj"));
  }
  for (const std::string name : {"a", "stl", "a.gz"}) {
    EXPECT_THAT(refusal_of(name).second,
                HasSubstr(name + ": unknown file type, as the name has no extension"));
  }
}

TEST_F(ReadSurface, a_file_of_cad_is_refused_with_the_command_that_triangulates_it) {
  for (const std::string ending : {".stp", ".step", ".STEP", ".iges"}) {
    const auto [code, message] = refusal_of("d/x" + ending);
    EXPECT_EQ(code, ExitCode::usage);
    EXPECT_THAT(message,
                HasSubstr("mesh a CAD file first: `gmsh -2 d/x" + ending + " -o d/x.msh`"));
  }
}

TEST_F(ReadSurface, empty_files_no_triangles_and_garbage_are_refused) {
  for (const std::string name : {"a.stl", "a.obj", "a.off", "a.msh"}) {
    EXPECT_THAT([&] { read_surface_bytes("", name); },
                ThrowsMessage<InvalidInput>(HasSubstr(name + ": the file is empty")));
    for (const std::string& garbage :
         {std::string("It was a dark and stormy night;\n"), std::string(300, '\0'),
          std::string(1000, '\xff'), std::string("\n\n \n"), std::string("nan nan nan\n")}) {
      EXPECT_THROW(read_surface_bytes(garbage, name), InvalidInput) << name << garbage;
    }
  }
  SurfaceMesh empty;
  empty.patch_names = {"surface"};
  for (const texts::File& file : texts::all_formats(empty)) {
    if (file.name.ends_with(".msh")) continue;  // the writer adds a tet of the first nodes
    EXPECT_THAT([&] { read_surface_bytes(file.bytes, file.name); },
                ThrowsMessage<InvalidInput>(HasSubstr("no triangles")));
  }
}

TEST_F(ReadSurface, a_file_with_a_vertex_for_each_texture_is_as_closed_as_it_looks) {
  std::string text;
  const SurfaceMesh cube = shapes::unit_cube();
  int number = 0;
  for (const Triangle& t : cube.triangles) {
    for (const std::int32_t v : t) {
      const Vec3& p = cube.vertices[static_cast<std::size_t>(v)];
      text += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z);
      text += "\nvt 0 0\n";
    }
    text += "f";
    for (int k = 0; k < 3; ++k) {
      ++number;
      text += " " + std::to_string(number) + "/" + std::to_string(number);
    }
    text += "\n";
  }
  const SurfaceMesh read = read_surface_bytes(text, "cube.obj");
  EXPECT_EQ(enclosed_volume(read.vertices, read.triangles), 1);
  EXPECT_THAT(unmatched_edges(read.triangles), testing::IsEmpty());
}

TEST_F(ReadSurface, two_triangles_are_for_the_check_to_refuse) {
  SurfaceMesh mesh = shapes::unit_cube();
  mesh.triangles.resize(2);
  mesh.patch_of_triangle.resize(2);
  for (const texts::File& file : texts::all_formats(mesh)) {
    EXPECT_EQ(read_surface_bytes(file.bytes, file.name).triangles.size(), 2U) << file.name;
  }
}

void expect_usable(const SurfaceMesh& mesh) {
  ASSERT_EQ(mesh.patch_of_triangle.size(), mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::int32_t v : triangle) {
      ASSERT_GE(v, 0);
      ASSERT_LT(static_cast<std::size_t>(v), mesh.vertices.size());
    }
  }
  for (const Vec3& p : mesh.vertices) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
}

TEST_F(ReadSurface, damaged_files_are_read_or_refused_but_never_crash) {
  std::mt19937 random(20240607);
  SurfaceMesh two_patches = shapes::unit_cube();
  two_patches.patch_names = {"wall", "far"};
  two_patches.patch_of_triangle[7] = 1;
  std::vector<texts::File> files = texts::all_formats(two_patches);
  files.push_back({"packed.msh.gz", texts::gzip(files[7].bytes)});
  int refused = 0;
  for (const texts::File& file : files) {
    const std::string path = folder_ / file.name;
    for (int round = 0; round < 400; ++round) {
      std::string bytes = file.bytes;
      for (unsigned changes = random() % 4; changes > 0; --changes) {
        bytes[random() % bytes.size()] = static_cast<char>(random());
      }
      if (random() % 4 == 0) bytes.resize(random() % bytes.size());
      if (random() % 8 == 0) bytes.insert(random() % (bytes.size() + 1), "4294967295 ");
      try {
        if (file.name.ends_with(".gz")) {
          expect_usable(read_surface(write(file.name, bytes)));
        } else {
          expect_usable(read_surface_bytes(bytes, file.name));
        }
      } catch (const Error&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 400);
}

/// One row of the manifest of the developer data; a comment in quotes may hold commas.
std::vector<std::string> split_csv(const std::string& line) {
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (const char c : line) {
    if (c == '"')
      is_quoted = !is_quoted;
    else if (c == ',' && !is_quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  return fields;
}

TEST_F(ReadSurface, reads_the_developer_data_with_the_counts_of_its_manifest) {
  const char* data = std::getenv("TETFARM_DATA");
  if (data == nullptr) GTEST_SKIP() << "TETFARM_DATA is not set";
  const std::filesystem::path folder = data;
  std::ifstream manifest(folder / "MANIFEST.csv");
  std::string line;
  int files = 0;
  for (std::getline(manifest, line); std::getline(manifest, line);) {
    const std::vector<std::string> row = split_csv(line);
    std::istringstream names(row[1]);
    for (std::string name; names >> name;) {
      const bool is_surface = std::string(name).find("markers/") == name.npos &&
                              (name.find(".stl") != name.npos || name.find(".msh") != name.npos ||
                               name.find(".obj") != name.npos || name.find(".off") != name.npos) &&
                              !name.ends_with(".meshb");
      if (!is_surface) continue;
      const SurfaceMesh mesh = read_surface(folder / row[0] / name);
      expect_usable(mesh);
      EXPECT_EQ(std::to_string(mesh.triangles.size()), row[6]) << name;
      EXPECT_EQ(std::to_string(mesh.vertices.size()), row[7]) << name;
      if (name.find(".msh") != name.npos && name != "cessna.msh" && name != "piece.asc.v22.msh") {
        EXPECT_EQ(std::to_string(mesh.patch_names.size()), row[15]) << name;
      }
      ++files;
    }
  }
  EXPECT_GE(files, 30);
}

}  // namespace
}  // namespace tetfarm
