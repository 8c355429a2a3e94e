/// Exports the grid of grid_source.h, and puts together what a test read from the file.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

#include "base/file_system.h"
#include "mesh/formats/registry/export_mesh.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"

namespace tetfarm {

/// A mesh whose elements a test fills in, with numbers from `from`.
class ReadMesh : public MeshSource {
 public:
  explicit ReadMesh(int from) : from_(from) {}
  std::size_t size() const override { return 1; }
  NumberedPart part(std::size_t) const override { return part_; }
  std::vector<std::string> patch_names() const override { return {}; }
  std::vector<std::string> region_names() const override { return {}; }

  void node(const Vec3& p) { part_.nodes.push_back(p); }
  void tet(const std::array<std::int64_t, 4>& nodes) {
    Tet tet;
    for (std::size_t k = 0; k < 4; ++k) tet[k] = local(nodes[k]);
    part_.tets.push_back(tet);
  }
  void face(const std::array<std::int64_t, 3>& nodes, std::int64_t patch) {
    part_.faces.push_back({local(nodes[0]), local(nodes[1]), local(nodes[2])});
    part_.patch_of_face.push_back(static_cast<std::int32_t>(patch));
  }

 private:
  std::int32_t local(std::int64_t number) const {
    const std::int64_t index = number - from_;
    if (index < 0 || index >= std::ssize(part_.nodes)) throw std::out_of_range("a node number");
    return static_cast<std::int32_t>(index);
  }
  int from_;
  NumberedPart part_;
};

/// Numbers of a file, from its text or its bytes.
class FileNumbers {
 public:
  explicit FileNumbers(std::string bytes, bool is_text)
      : bytes_(std::move(bytes)), is_text_(is_text) {}

  void skip_past(const std::string& text) {
    const std::size_t found = bytes_.find(text, place_);
    if (found == std::string::npos) throw std::out_of_range("no " + text);
    place_ = found + text.size();
  }
  std::int64_t large() { return is_text_ ? number<std::int64_t>() : raw<std::int64_t>(); }
  std::int64_t small() { return is_text_ ? number<std::int64_t>() : raw<std::int32_t>(); }
  double real() { return is_text_ ? number<double>() : raw<double>(); }
  Vec3 point() {
    const double x = real();
    const double y = real();
    return {x, y, real()};
  }
  template <std::size_t N>
  std::array<std::int64_t, N> larges() {
    std::array<std::int64_t, N> values;
    for (std::int64_t& value : values) value = large();
    return values;
  }
  void go_to(std::int64_t place) { place_ = static_cast<std::size_t>(place); }
  std::int64_t place() const { return static_cast<std::int64_t>(place_); }

 private:
  template <class T>
  T raw() {
    T value;
    if (place_ + sizeof value > bytes_.size()) throw std::out_of_range("the file ends");
    std::memcpy(&value, bytes_.data() + place_, sizeof value);
    place_ += sizeof value;
    return value;
  }
  template <class T>
  T number() {
    const std::size_t begin = bytes_.find_first_not_of(" \n", place_);
    place_ = std::min(bytes_.find_first_of(" \n", begin), bytes_.size());
    std::istringstream word(bytes_.substr(begin, place_ - begin));
    T value{};
    if (!(word >> value)) throw std::invalid_argument("not a number");
    return value;
  }

  std::string bytes_;
  bool is_text_;
  std::size_t place_ = 0;
};

inline std::filesystem::path export_as(const MeshSource& mesh, const TempFolder& folder,
                                       const std::string& format, const std::string& name) {
  const std::filesystem::path file = folder.path() / name;
  export_mesh(mesh, find_mesh_format(format, file), file);
  return file;
}

}  // namespace tetfarm
