#include "mesh/formats/medit/meshb_source.h"

#include <algorithm>
#include <limits>

#include "mesh/formats/input_file.h"
#include "mesh/formats/listed_mesh.h"
#include "mesh/formats/medit/medit_keywords.h"

namespace tetfarm {
namespace {

/// A list of records of 8-byte numbers.
struct List {
  std::int64_t place = 0;
  std::int64_t count = 0;
};

class Meshb {
 public:
  explicit Meshb(const std::filesystem::path& path) : file_(path) {
    if (file_.at<std::int32_t>(0) != 1) file_.fail("is not a little-endian .meshb file", 0);
    if (file_.at<std::int32_t>(4) != 4) file_.fail("is not version 4 of the format", 4);
    std::int64_t place = 8;
    while (place != 0) place = read_keyword(place);
  }

  void read_nodes(std::int64_t first, std::span<Vec3> into) const {
    std::vector<std::array<double, 4>> records(
        into.size());  // the last has the bits of a reference
    file_.read(nodes.place + first * 32, records.data(), records.size() * 32);
    for (std::size_t i = 0; i < into.size(); ++i) {
      into[i] = {records[i][0], records[i][1], records[i][2]};
    }
  }
  void read_tets(std::int64_t first, std::span<ListedMesh::Nodes> into) const {
    const auto records = read_records<5>(tets, first, into.size());
    for (std::size_t i = 0; i < into.size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k) into[i][k] = records[i][k] - 1;
    }
  }
  std::vector<TetRun> runs() const {
    constexpr std::int64_t at_once = 65536;
    std::vector<TetRun> runs;
    for (std::int64_t first = 0; first < tets.count; first += at_once) {
      const auto count = static_cast<std::size_t>(std::min(at_once, tets.count - first));
      for (const auto& tet : read_records<5>(tets, first, count)) {
        add_tets(runs, {1, small(tet[4]), 0});
      }
    }
    return runs;
  }
  std::vector<ListedTriangle> boundary() const {
    std::vector<ListedTriangle> result;
    for (const auto& [a, b, c, patch] :
         read_records<4>(faces, 0, static_cast<std::size_t>(faces.count))) {
      result.push_back({{a - 1, b - 1, c - 1}, small(patch) - 1});
    }
    return result;
  }
  const std::string& name() const { return file_.name(); }

  List nodes;
  List faces;
  List tets;

 private:
  /// Returns where the next keyword is; 0 after the last.
  std::int64_t read_keyword(std::int64_t place) {
    const auto keyword = file_.at<std::int32_t>(place);
    if (keyword == medit::end) return 0;
    const auto next = file_.at<std::int64_t>(place + 4);
    if (next != 0 && (next <= place || next > file_.size())) {
      file_.fail("the place of the next keyword is wrong", place + 4);
    }
    if (keyword == medit::dimension) {
      if (file_.at<std::int32_t>(place + 12) != 3)
        file_.fail("the mesh is not three-dimensional", place);
    } else if (keyword == medit::vertices) {
      nodes = list_at(place, 32);
    } else if (keyword == medit::triangles) {
      faces = list_at(place, 32);
    } else if (keyword == medit::tetrahedra) {
      tets = list_at(place, 40);
    } else {
      file_.fail("unknown keyword " + std::to_string(keyword), place);
    }
    return next;
  }

  List list_at(std::int64_t place, std::int64_t record_bytes) const {
    const List list{place + 20, file_.at<std::int64_t>(place + 12)};
    if (list.count < 0 || list.count > (file_.size() - list.place) / record_bytes) {
      file_.fail("a count of " + std::to_string(list.count) + ", but the file has only " +
                     std::to_string(file_.size()) + " bytes",
                 place + 12);
    }
    return list;
  }

  template <std::size_t N>
  std::vector<std::array<std::int64_t, N>> read_records(const List& list, std::int64_t first,
                                                        std::size_t count) const {
    std::vector<std::array<std::int64_t, N>> records(count);
    file_.read(list.place + first * std::int64_t{8 * N}, records.data(), count * 8 * N);
    return records;
  }

  /// What is out of range stays so.
  static std::int32_t small(std::int64_t reference) {
    return static_cast<std::int32_t>(
        std::clamp<std::int64_t>(reference, 0, std::numeric_limits<std::int32_t>::max()));
  }

  InputFile file_;
};

}  // namespace

std::unique_ptr<MeshSource> open_meshb(const std::filesystem::path& path) {
  const auto file = std::make_shared<const Meshb>(path);
  ListedMesh mesh;
  mesh.name = file->name();
  mesh.nodes = file->nodes.count;
  mesh.read_nodes = [file](std::int64_t first, std::span<Vec3> into) {
    file->read_nodes(first, into);
  };
  mesh.read_tets = [file](std::int64_t first, std::span<ListedMesh::Nodes> into) {
    file->read_tets(first, into);
  };
  mesh.runs = file->runs();
  mesh.triangles = file->boundary();
  return open_listed(std::move(mesh));
}

}  // namespace tetfarm
