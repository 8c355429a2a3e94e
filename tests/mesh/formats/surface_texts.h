/// Surface files of each format, made by tests out of a mesh.
#pragma once

#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <string>
#include <vector>

#include "base/check.h"
#include "mesh/core/surface_mesh.h"

namespace tetfarm::texts {

inline std::string number(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

inline std::string point(const Vec3& p) {
  return number(p.x) + " " + number(p.y) + " " + number(p.z);
}

inline const Vec3& vertex(const SurfaceMesh& mesh, std::int32_t v) {
  return mesh.vertices[static_cast<std::size_t>(v)];
}

template <class T>
void append(std::string& bytes, std::initializer_list<T> values) {
  for (const T& value : values) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
}

inline std::string stl_binary(const SurfaceMesh& mesh, const std::string& header = "binary") {
  std::string bytes = header;
  bytes.resize(80, ' ');
  append(bytes, {static_cast<std::uint32_t>(mesh.triangles.size())});
  for (const Triangle& triangle : mesh.triangles) {
    append(bytes, {0.0F, 0.0F, 0.0F});
    for (const std::int32_t v : triangle) {
      const Vec3& p = vertex(mesh, v);
      append(bytes, {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    }
    append(bytes, {std::uint16_t{0}});
  }
  return bytes;
}

inline std::string stl_ascii(const SurfaceMesh& mesh) {
  std::string text;
  for (std::size_t patch = 0; patch < mesh.patch_names.size(); ++patch) {
    text += "solid " + mesh.patch_names[patch] + "\n";
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (mesh.patch_of_triangle[i] != static_cast<std::int32_t>(patch)) continue;
      text += " facet normal 0 0 0\n  outer loop\n";
      for (const std::int32_t v : mesh.triangles[i]) {
        text += "   vertex " + point(vertex(mesh, v)) + "\n";
      }
      text += "  endloop\n endfacet\n";
    }
    text += "endsolid " + mesh.patch_names[patch] + "\n";
  }
  return text;
}

inline std::string obj(const SurfaceMesh& mesh) {
  std::string text = "# made by a test\no shape\n";
  for (const Vec3& p : mesh.vertices) text += "v " + point(p) + "\n";
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    text += "g " + mesh.patch_names[static_cast<std::size_t>(mesh.patch_of_triangle[i])] + "\nf " +
            std::to_string(a + 1) + " " + std::to_string(b + 1) + "/1 " + std::to_string(c + 1) +
            "//2\n";
  }
  return text;
}

inline std::string off(const SurfaceMesh& mesh) {
  std::string text = "OFF\n# made by a test\n" + std::to_string(mesh.vertices.size()) + " " +
                     std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Vec3& p : mesh.vertices) text += point(p) + "\n";
  for (const auto& [a, b, c] : mesh.triangles) {
    text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  }
  return text;
}

/// Node tags have gaps (10, 13, 16…) and the physical tags are 11, 12….
class MshWriter {
 public:
  MshWriter(const SurfaceMesh& mesh, bool is_binary) : mesh_(mesh), is_binary_(is_binary) {}

  std::string version_2() {
    begin("2.2");
    text_ += "$Nodes\n" + std::to_string(mesh_.vertices.size()) + "\n";
    for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
      small({node_tag(static_cast<std::int32_t>(v))});
      xyz(mesh_.vertices[v]);
    }
    // A tetrahedron and a point come with the surface, as in files of volume meshes.
    text_ += "$EndNodes\n$Elements\n" + std::to_string(mesh_.triangles.size() + 2) + "\n";
    block_header(15);
    small({1, 15, 2, 0, 1, node_tag(0)}, 1);
    if (!is_binary_) line();
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const auto& [a, b, c] = mesh_.triangles[i];
      block_header(2);
      small({static_cast<std::int32_t>(i) + 2, 2, 2, physical(i), 1, node_tag(a), node_tag(b),
             node_tag(c)},
            1);
      line();
    }
    block_header(4);
    small({99, 4, 2, 7, 1, node_tag(0), node_tag(1), node_tag(2), node_tag(3)}, 1);
    line();
    return text_ += "$EndElements\n";
  }

  std::string version_4() {
    begin("4.1");
    const auto patches = static_cast<std::int64_t>(mesh_.patch_names.size());
    text_ += "$Entities\n";
    large({1, 0, patches, 0});
    line();
    small({1});
    xyz({0, 0, 0});
    large({0});
    line();
    for (std::int32_t patch = 0; patch < patches; ++patch) {
      small({patch + 1});
      xyz({0, 0, 0});
      xyz({1, 1, 1});
      large({1});
      small({11 + patch});
      large({0});
      line();
    }
    end("Entities");
    nodes_4();
    elements_4(patches);
    return text_;
  }

 private:
  void begin(const std::string& version) {
    text_ = "$MeshFormat\n" + version + (is_binary_ ? " 1 8\n" : " 0 8\n");
    if (is_binary_) append(text_, {std::int32_t{1}});
    text_ += std::string(is_binary_ ? "\n" : "") + "$EndMeshFormat\n$PhysicalNames\n" +
             std::to_string(mesh_.patch_names.size()) + "\n";
    for (std::size_t patch = 0; patch < mesh_.patch_names.size(); ++patch) {
      text_ += "2 " + std::to_string(11 + patch) + " \"" + mesh_.patch_names[patch] + "\"\n";
    }
    text_ += "$EndPhysicalNames\n$Comment\nPassed over.\n$EndComment\n";
  }
  void nodes_4() {
    const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
    text_ += "$Nodes\n";
    large({1, count, 10, 10 + 3 * count});
    line();
    small({2, 1, 0});
    large({count});
    line();
    for (std::int32_t v = 0; v < count; ++v) large({node_tag(v)});
    line();
    for (const Vec3& p : mesh_.vertices) xyz(p);
    end("Nodes");
  }
  void elements_4(std::int64_t patches) {
    const auto count = static_cast<std::int64_t>(mesh_.triangles.size());
    text_ += "$Elements\n";
    large({patches + 1, count + 1, 1, count + 1});
    line();
    small({3, 1, 4});
    large({1});
    line();
    large({99, node_tag(0), node_tag(1), node_tag(2), node_tag(3)});
    line();
    for (std::int32_t patch = 0; patch < patches; ++patch) {
      const auto& of = mesh_.patch_of_triangle;
      small({2, patch + 1, 2});
      large({std::count(of.begin(), of.end(), patch)});
      line();
      for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
        if (of[i] != patch) continue;
        const auto& [a, b, c] = mesh_.triangles[i];
        large({static_cast<std::int64_t>(i), node_tag(a), node_tag(b), node_tag(c)});
        line();
      }
    }
    end("Elements");
  }
  void end(const std::string& section) {
    text_ += std::string(is_binary_ ? "\n" : "") + "$End" + section + "\n";
  }
  static std::int32_t node_tag(std::int32_t v) { return 10 + 3 * v; }
  std::int32_t physical(std::size_t triangle) const {
    return 11 + mesh_.patch_of_triangle[triangle];
  }
  /// The binary elements of version 2 have type and number of tags in a header, not each.
  void block_header(std::int32_t type) {
    if (is_binary_) append(text_, {type, std::int32_t{1}, std::int32_t{2}});
  }
  void small(std::initializer_list<std::int32_t> values, int is_element = 0) {
    int place = 0;
    for (const std::int32_t value : values) {
      const bool is_in_header = is_element == 1 && (place == 1 || place == 2);
      ++place;
      if (!is_binary_) text_ += std::to_string(value) + " ";
      if (is_binary_ && !is_in_header) append(text_, {value});
    }
  }
  void large(std::initializer_list<std::int64_t> values) {
    for (const std::int64_t value : values) {
      if (is_binary_) append(text_, {value});
      if (!is_binary_) text_ += std::to_string(value) + " ";
    }
  }
  void xyz(const Vec3& p) {
    if (is_binary_) append(text_, {p.x, p.y, p.z});
    if (!is_binary_) text_ += point(p) + "\n";
  }
  void line() {
    if (!is_binary_) text_ += "\n";
  }

  const SurfaceMesh& mesh_;
  bool is_binary_;
  std::string text_;
};

inline std::string msh(const SurfaceMesh& mesh, int version, bool is_binary) {
  MshWriter writer(mesh, is_binary);
  return version == 2 ? writer.version_2() : writer.version_4();
}

inline std::string gzip(const std::string& bytes) {
  z_stream z{};
  TF_CHECK(deflateInit2(&z, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) == Z_OK);
  std::string packed(deflateBound(&z, bytes.size()), '\0');
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  z.avail_in = static_cast<uInt>(bytes.size());
  z.next_out = reinterpret_cast<Bytef*>(packed.data());
  z.avail_out = static_cast<uInt>(packed.size());
  TF_CHECK(deflate(&z, Z_FINISH) == Z_STREAM_END);
  packed.resize(z.total_out);
  deflateEnd(&z);
  return packed;
}

struct File {
  std::string name;
  std::string bytes;
};

/// The mesh in every format that is read.
inline std::vector<File> all_formats(const SurfaceMesh& mesh) {
  return {{"binary.stl", stl_binary(mesh)},
          {"ascii.stl", stl_ascii(mesh)},
          {"a.obj", obj(mesh)},
          {"a.off", off(mesh)},
          {"a22.msh", msh(mesh, 2, false)},
          {"binary22.msh", msh(mesh, 2, true)},
          {"a41.msh", msh(mesh, 4, false)},
          {"binary41.msh", msh(mesh, 4, true)}};
}

}  // namespace tetfarm::texts
