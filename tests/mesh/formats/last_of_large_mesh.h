/// A mesh with more nodes, triangles and tets than 32 bits count, of which only the last sub-domain
/// is there: what is written of the others are holes in the file.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// How much comes before the last sub-domain.
struct CountsBefore {
  std::int64_t nodes = 0;
  std::int64_t tets = 0;
  std::int64_t faces_of_each_patch = 0;
};

/// One tet; its faces are on the patches "inner" and "outer", two on each.
class LastOfLargeMesh : public MeshSource {
 public:
  explicit LastOfLargeMesh(std::int64_t before) : LastOfLargeMesh({before, before, before}) {}
  explicit LastOfLargeMesh(const CountsBefore& before) {
    part_.nodes = {{0.5, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    part_.tets = {{0, 1, 2, 3}};
    part_.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    part_.patch_of_face = {0, 0, 1, 1};
    for (std::int64_t i = 0; i < 4; ++i) part_.local2global.push_back(before.nodes + i);
    outline_.patch_names = patch_names();
    outline_.region_names = {"domain"};
    PartOutline here;
    here.nodes = here.owned_nodes = here.faces = 4;
    here.tets = 1;
    here.tets_of_region = {1};
    here.faces_of_patch = {2, 2};
    here.box = bounding_box(part_.nodes);
    outline_.parts = {here};
    add_up(outline_);
    const std::int64_t faces = before.faces_of_each_patch;
    outline_.nodes += before.nodes;
    outline_.tets += before.tets;
    outline_.boundary_triangles += 2 * faces;
    for (std::int64_t& of_patch : outline_.faces_of_patch) of_patch += faces;
    outline_.tets_of_region[0] += before.tets;
    outline_.parts[0].first_tet = before.tets;
    outline_.parts[0].first_cell = before.tets;
    outline_.parts[0].first_face = 2 * faces;
    outline_.parts[0].first_face_of_patch = {faces, faces};
  }
  std::size_t size() const override { return 1; }
  NumberedPart part(std::size_t) const override { return part_; }
  std::vector<std::string> patch_names() const override { return {"inner", "outer"}; }
  std::vector<std::string> region_names() const override { return {}; }
  const MeshOutline& outline() const { return outline_; }

 private:
  NumberedPart part_;
  MeshOutline outline_;
};

/// Reads a file of which most are holes.
class SparseFile {
 public:
  explicit SparseFile(const std::filesystem::path& path) : size_(file_size(path)) {
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  }
  SparseFile(const SparseFile&) = delete;
  SparseFile& operator=(const SparseFile&) = delete;
  ~SparseFile() { ::close(descriptor_); }

  std::int64_t size() const { return static_cast<std::int64_t>(size_); }
  std::string text(std::int64_t place, std::size_t bytes) const {
    std::string read(bytes, '\0');
    const ssize_t done = ::pread(descriptor_, read.data(), bytes, place);
    read.resize(done < 0 ? 0 : static_cast<std::size_t>(done));
    return read;
  }
  template <class T>
  std::vector<T> numbers(std::int64_t place, std::size_t count) const {
    std::vector<T> values(count);
    const std::string bytes = text(place, count * sizeof(T));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
  template <class T>
  std::vector<T> big_endian(std::int64_t place, std::size_t count) const {
    std::string bytes = text(place, count * sizeof(T));
    std::vector<T> values(count);
    std::reverse(bytes.begin(), bytes.end());
    std::memcpy(values.data(), bytes.data(), bytes.size());
    std::reverse(values.begin(), values.end());
    return values;
  }
  /// Where the text is, in what is no hole; -1: nowhere.
  std::int64_t place_of(const std::string& wanted) const {
    for (std::int64_t end = 0, begin; (begin = ::lseek(descriptor_, end, SEEK_DATA)) >= 0;) {
      end = ::lseek(descriptor_, begin, SEEK_HOLE);
      const auto found = text(begin, static_cast<std::size_t>(end - begin)).find(wanted);
      if (found != std::string::npos) return begin + static_cast<std::int64_t>(found);
    }
    return -1;
  }

 private:
  std::uintmax_t size_;
  int descriptor_ = -1;
};

}  // namespace tetfarm
