#include "mesh/formats/ugrid_source.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "base/error.h"

namespace tetfarm {
namespace {

/// The bytes of a file, brought into memory by the system as they are looked at.
class MappedFile {
 public:
  explicit MappedFile(const std::filesystem::path& path) : name_(path.string()) {
    const int descriptor = ::open(name_.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) throw IoError("cannot read", name_, errno);
    struct stat status {};
    if (::fstat(descriptor, &status) == 0) size_ = static_cast<std::size_t>(status.st_size);
    void* bytes = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, descriptor, 0);
    const int error = errno;
    ::close(descriptor);
    if (bytes == MAP_FAILED) throw IoError("cannot read", name_, error);
    bytes_ = static_cast<const char*>(bytes);
  }
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  ~MappedFile() { ::munmap(const_cast<char*>(bytes_), size_); }

  std::size_t size() const { return size_; }
  const std::string& name() const { return name_; }
  template <class T>
  T at(std::size_t offset) const {
    T value;
    std::memcpy(&value, bytes_ + offset, sizeof value);
    return value;
  }

 private:
  std::string name_;
  const char* bytes_ = nullptr;
  std::size_t size_ = 0;
};

constexpr std::size_t header_bytes = 28;
constexpr std::size_t most_regions = 1'000'000;

/// The smallest number first, turning the same way round.
Triangle smallest_first(Triangle triangle) {
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  return triangle;
}

/// Consecutive tets.
struct Piece {
  std::size_t first = 0;
  std::size_t tets = 0;
  std::int32_t region = 1;
};

struct RegionLine {
  std::size_t number = 1;
  std::size_t first = 0;
  std::size_t last = 0;
  std::string name;
};

/// A file beside the mesh: the same name with another ending.
std::filesystem::path beside(const std::filesystem::path& path, const std::string& ending) {
  const std::string name = path.string();
  return name.substr(0, name.size() - std::strlen(".lb8.ugrid")) + ending;
}

std::vector<std::string> names_of_mapbc(const std::filesystem::path& path) {
  std::vector<std::string> names;
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream words(line);
    long number = 0;
    long code = 0;
    std::string name;
    if (words >> number >> code && std::getline(words >> std::ws, name)) names.push_back(name);
  }
  return names;
}

std::vector<RegionLine> regions_beside(const std::filesystem::path& path, std::size_t tets) {
  std::vector<RegionLine> regions;
  std::ifstream file(path);
  std::string line;
  std::size_t expected = 1;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    RegionLine region;
    const bool is_whole = static_cast<bool>(words >> region.number >> region.first >> region.last);
    if (!is_whole || region.number < 1 || region.number > most_regions ||
        region.first != expected || region.last + 1 < region.first || region.last > tets) {
      throw InvalidInput("a line that does not fit the mesh: " + line, path.string());
    }
    std::getline(words >> std::ws, region.name);
    expected = region.last + 1;
    regions.push_back(region);
  }
  return regions;
}

class UgridSource : public MeshSource {
 public:
  UgridSource(const std::filesystem::path& path, std::int64_t tets_of_piece)
      : file_(path), patch_names_(names_of_mapbc(beside(path, ".mapbc"))) {
    read_counts();
    sort_boundary();
    std::vector<RegionLine> regions = regions_beside(beside(path, ".regions"), tets_);
    if (regions.empty()) regions = {{1, 1, tets_, "domain"}};
    for (const RegionLine& region : regions) {
      region_names_.resize(std::max(region_names_.size(), region.number));
      region_names_[region.number - 1] = region.name;
      add_pieces(region, static_cast<std::int32_t>(region.number),
                 static_cast<std::size_t>(tets_of_piece));
    }
  }

  std::size_t size() const override { return pieces_.size(); }
  bool knows_subdomains() const override { return false; }
  bool takes_threads() const override { return true; }
  std::vector<std::string> patch_names() const override { return patch_names_; }
  std::vector<std::string> region_names() const override { return region_names_; }

  NumberedPart part(std::size_t i) const override {
    const Piece& piece = pieces_.at(i);
    NumberedPart part;
    part.number = static_cast<std::int32_t>(i);
    part.region = piece.region;
    std::vector<std::int32_t> numbers;
    for (std::size_t t = piece.first; t < piece.first + piece.tets; ++t) {
      const Tet tet = tet_at(t);
      part.tets.push_back(tet);
      numbers.insert(numbers.end(), tet.begin(), tet.end());
    }
    add_boundary(part);
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    const auto local = [&](std::int32_t& v) {
      v = static_cast<std::int32_t>(std::lower_bound(numbers.begin(), numbers.end(), v) -
                                    numbers.begin());
    };
    for (Tet& tet : part.tets) std::for_each(tet.begin(), tet.end(), local);
    for (Triangle& face : part.faces) std::for_each(face.begin(), face.end(), local);
    for (const std::int32_t number : numbers) part.nodes.push_back(node_at(number));
    part.local2global.assign(numbers.begin(), numbers.end());
    return part;
  }

 private:
  struct BoundaryFace {
    Triangle nodes;  ///< numbers in the whole mesh, the normal out of the domain
    std::int32_t patch = 0;
    bool operator<(const BoundaryFace& other) const { return nodes < other.nodes; }
  };

  [[noreturn]] void fail(const std::string& what) const { throw InvalidInput(what, file_.name()); }

  void read_counts() {
    if (file_.size() < header_bytes) fail("the file ends too early");
    std::array<std::size_t, 7> counts{};
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const auto count = file_.at<std::int32_t>(4 * i);
      if (count < 0) fail("a count is negative, byte " + std::to_string(4 * i));
      counts[i] = static_cast<std::size_t>(count);
    }
    if (counts[2] + counts[4] + counts[5] + counts[6] != 0) {
      fail("elements other than triangles and tets");
    }
    nodes_ = counts[0];
    triangles_ = counts[1];
    tets_ = counts[3];
    if (file_.size() != header_bytes + nodes_ * 24 + triangles_ * 16 + tets_ * 16) {
      fail("the length of the file does not fit its counts");
    }
  }

  std::int32_t number_at(std::size_t offset) const {
    const auto number = file_.at<std::int32_t>(offset);
    if (number < 1 || static_cast<std::size_t>(number) > nodes_) {
      fail("node " + std::to_string(number) + " of " + std::to_string(nodes_) + ", byte " +
           std::to_string(offset));
    }
    return number - 1;
  }
  Vec3 node_at(std::int32_t number) const {
    return file_.at<Vec3>(header_bytes + 24 * static_cast<std::size_t>(number));
  }
  Tet tet_at(std::size_t t) const {
    const std::size_t offset = header_bytes + nodes_ * 24 + triangles_ * 16 + t * 16;
    Tet tet;
    for (std::size_t k = 0; k < 4; ++k) tet[k] = number_at(offset + 4 * k);
    return tet;
  }

  /// Normals in the file all point into the domain or all out of it.
  void sort_boundary() {
    const std::size_t offset = header_bytes + nodes_ * 24;
    double volume = 0;
    boundary_.resize(triangles_);
    for (std::size_t t = 0; t < triangles_; ++t) {
      Triangle& face = boundary_[t].nodes;
      for (std::size_t k = 0; k < 3; ++k) face[k] = number_at(offset + 12 * t + 4 * k);
      boundary_[t].patch = file_.at<std::int32_t>(offset + 12 * triangles_ + 4 * t) - 1;
      volume += dot(node_at(face[0]), cross(node_at(face[1]), node_at(face[2])));
    }
    for (BoundaryFace& face : boundary_) {
      if (volume < 0) std::swap(face.nodes[1], face.nodes[2]);
      face.nodes = smallest_first(face.nodes);
    }
    std::sort(boundary_.begin(), boundary_.end());
  }

  void add_pieces(const RegionLine& region, std::int32_t number, std::size_t most) {
    for (std::size_t first = region.first - 1; first < region.last; first += most) {
      pieces_.push_back({first, std::min(most, region.last - first), number});
    }
  }

  /// The boundary triangles that are faces of the part's tets.
  void add_boundary(NumberedPart& part) const {
    for (const Tet& tet : part.tets) {
      for (const auto& corners : tet_face_nodes) {
        const auto v = [&](std::size_t k) { return tet[static_cast<std::size_t>(corners[k])]; };
        const BoundaryFace wanted{smallest_first({v(0), v(1), v(2)}), 0};
        const auto found = std::lower_bound(boundary_.begin(), boundary_.end(), wanted);
        if (found == boundary_.end() || found->nodes != wanted.nodes) continue;
        part.faces.push_back(found->nodes);
        part.patch_of_face.push_back(found->patch);
      }
    }
  }

  MappedFile file_;
  std::size_t nodes_ = 0;
  std::size_t triangles_ = 0;
  std::size_t tets_ = 0;
  std::vector<BoundaryFace> boundary_;
  std::vector<Piece> pieces_;
  std::vector<std::string> patch_names_;
  std::vector<std::string> region_names_;
};

}  // namespace

std::unique_ptr<MeshSource> open_ugrid(const std::filesystem::path& path,
                                       std::int64_t tets_of_piece) {
  return std::make_unique<UgridSource>(path, tets_of_piece);
}

}  // namespace tetfarm
