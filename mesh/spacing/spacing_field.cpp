#include "mesh/spacing/spacing_field.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/mapped_file.h"
#include "mesh/spacing/lattice_planes.h"
#include "mesh/spacing/lattice_volume.h"
#include "mesh/spacing/octree_build.h"

namespace tetfarm {

struct SpacingField::Octree : SpacingOctree {
  Octree() = default;
  Octree(SpacingOctree octree, double everywhere, MappedFile holder)
      : SpacingOctree(std::move(octree)), constant(everywhere), file(std::move(holder)) {}

  /// Not 0: the spacing everywhere, to the last bit.
  double constant = 0;
  /// Holds the arrays where they are not the octree's own.
  MappedFile file;
};

namespace {

static_assert(std::endian::native == std::endian::little, "the bytes are little-endian");

/// The bytes are this header, then child_of, values, lattice_level and owned_corners
/// (docs/spacing_format.md). The checksum is of all that follows it.
struct BytesHeader {
  std::array<char, 8> magic{'T', 'F', 'S', 'P', 'A', 'C', 'E', '1'};
  std::uint64_t checksum_high = 0;
  std::uint64_t checksum_low = 0;
  std::uint64_t node_count = 0;
  std::uint64_t leaf_count = 0;
  std::array<std::int64_t, 3> low{};
  double unit = 0;
  double constant = 0;
};
static_assert(sizeof(BytesHeader) == 80);
constexpr std::size_t checksum_from = 24;
constexpr std::size_t bytes_per_leaf = sizeof(std::array<float, 8>) + 2;

template <typename T>
void append(std::string& bytes, const TreeArray<T>& items) {
  bytes.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(T));
}

enum class Arrays { copied, left_in_place };

/// The first so many items of the bytes, which lose them. @pre those left in place are aligned.
template <typename T>
TreeArray<T> take(std::string_view& bytes, std::uint64_t count, Arrays arrays) {
  const char* const first = bytes.data();
  const auto items = static_cast<std::size_t>(count);
  bytes.remove_prefix(items * sizeof(T));
  if (arrays == Arrays::left_in_place) {
    return TreeArray<T>::elsewhere(std::span<const T>(reinterpret_cast<const T*>(first), items));
  }
  std::vector<T> own(items);
  if (items > 0) std::memcpy(own.data(), first, items * sizeof(T));
  return own;
}

/// @throws CorruptFile when what follows it has another checksum or length than it says.
BytesHeader checked_header(std::string_view bytes, const std::string& name) {
  BytesHeader header;
  if (bytes.size() < sizeof header) throw CorruptFile("is too short for a spacing field", name);
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.magic != BytesHeader{}.magic) throw CorruptFile("is not a spacing field", name);
  const Hash128 checksum = hash128(bytes.substr(checksum_from));
  if (checksum != Hash128{header.checksum_high, header.checksum_low}) {
    throw CorruptFile("the spacing field has a wrong checksum", name);
  }
  bytes.remove_prefix(sizeof header);
  if (header.node_count > bytes.size() || header.leaf_count > bytes.size() ||
      header.node_count * 4 + header.leaf_count * bytes_per_leaf != bytes.size()) {
    throw CorruptFile("the spacing field has a wrong length", name);
  }
  return header;
}

struct StoredField {
  SpacingOctree octree;
  double constant = 0;
};

/// @throws CorruptFile.
StoredField stored_field(std::string_view bytes, const std::string& name, Arrays arrays) {
  const BytesHeader header = checked_header(bytes, name);
  bytes.remove_prefix(sizeof header);
  StoredField field;
  SpacingOctree& octree = field.octree;
  octree.frame = {header.low, header.unit};
  octree.child_of = take<std::int32_t>(bytes, header.node_count, arrays);
  octree.values = take<std::array<float, 8>>(bytes, header.leaf_count, arrays);
  octree.lattice_level = take<std::uint8_t>(bytes, header.leaf_count, arrays);
  octree.owned_corners = take<std::uint8_t>(bytes, header.leaf_count, arrays);
  const char* fault = validate(octree);
  field.constant = header.constant;
  if (fault == nullptr && !(field.constant >= 0 && std::isfinite(field.constant))) {
    fault = "constant";
  }
  if (fault != nullptr) {
    throw CorruptFile(std::string("the spacing field is unsound: ") + fault, name);
  }
  return field;
}

void check_options(const SpacingOptions& options) {
  if (!(options.growth > 0) || !std::isfinite(options.growth)) {
    throw InvalidInput("the growth is not positive", "spacing");
  }
  if (!(options.background >= 0) || !std::isfinite(options.background)) {
    throw InvalidInput("the background spacing is negative", "spacing");
  }
  check_sources(options.sources);
  check_triangle_demands(options.triangles);
}

TriangleDemandTree tree_of_triangles(const SpacingOptions& options) {
  std::vector<TriangleDemand> demands = options.triangles;
  for (TriangleDemand& demand : demands) demand.growth = std::min(demand.growth, options.growth);
  return TriangleDemandTree(std::move(demands));
}

/// The spacing whose cells come out exactly: the background's, or else the typical one of the
/// surface.
double reference_spacing(double ceiling, const SpacingOptions& options,
                         const std::vector<PointDemand>& points) {
  if (options.background > 0 || points.empty()) return ceiling;
  std::vector<double> spacings;
  spacings.reserve(points.size());
  for (const PointDemand& p : points) spacings.push_back(p.spacing);
  const auto middle = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  return *middle;
}

}  // namespace

SpacingField::SpacingField(double constant) : octree_(std::make_unique<Octree>()) {
  TF_CHECK(constant > 0 && std::isfinite(constant));
  octree_->constant = constant;
  octree_->frame.unit = ideal_cell(constant) / size_at_level(octree_max_level);
  octree_->frame.low.fill(-octree_span / 2);
  octree_->child_of = {~0};
  octree_->values.resize(1);
  octree_->values[0].fill(static_cast<float>(constant));
  octree_->lattice_level = {octree_max_level};
  octree_->owned_corners = {0};
}

SpacingField::SpacingField(std::unique_ptr<Octree> octree) : octree_(std::move(octree)) {}
SpacingField::SpacingField(SpacingField&&) noexcept = default;
SpacingField& SpacingField::operator=(SpacingField&&) noexcept = default;
SpacingField::~SpacingField() = default;

double SpacingField::at(const Vec3& point) const {
  return octree_->constant > 0 ? octree_->constant : octree_->at(point);
}

double SpacingField::smallest() const {
  if (octree_->constant > 0) return octree_->constant;
  float smallest = std::numeric_limits<float>::max();
  for (const auto& corners : octree_->values)
    smallest = std::min(smallest, std::ranges::min(corners));
  return smallest;
}

double SpacingField::lattice_cell_edge(const Vec3& point) const {
  return octree_->lattice_cell_edge(point);
}

std::vector<LatticeNode> SpacingField::lattice_nodes(const Box3& box) const {
  if (box.empty()) return {};
  return lattice_nodes_in(*octree_, box);
}

std::vector<LatticeNode> SpacingField::lattice_nodes(const Box3& box,
                                                     const BoxPredicate& is_needless,
                                                     LatticeVisits* visits) const {
  if (box.empty()) return {};
  LatticeFilter filter;
  filter.is_needless = &is_needless;
  filter.visits = visits;
  return lattice_nodes_in(*octree_, box, filter);
}

std::vector<LatticeNode> SpacingField::lattice_nodes_in_plane(const Box3& box,
                                                              const LatticePlane& plane) const {
  if (box.empty()) return {};
  return lattice_nodes_in(*octree_, box, {.plane = &plane});
}

LatticeSample SpacingField::sample_lattice(const Box3& box, std::size_t most) const {
  if (box.empty() || most == 0) return {};
  if (cells_to_walk(*octree_, box) > most_cells_walked) {
    return sample_by_volume(*octree_, box, most);
  }
  return sample_lattice_in(*octree_, box, most);
}

std::optional<LatticePlane> SpacingField::coarsest_lattice_plane(std::size_t direction,
                                                                 double least_offset,
                                                                 double largest_offset) const {
  return tetfarm::coarsest_lattice_plane(octree_->frame, direction, least_offset, largest_offset);
}

std::string SpacingField::to_bytes() const {
  TF_CHECK(octree_->values.size() == octree_->lattice_level.size());
  BytesHeader header;
  header.node_count = octree_->child_of.size();
  header.leaf_count = octree_->lattice_level.size();
  header.low = octree_->frame.low;
  header.unit = octree_->frame.unit;
  header.constant = octree_->constant;
  std::string bytes(sizeof header, '\0');
  bytes.reserve(sizeof header + header.node_count * 4 + header.leaf_count * bytes_per_leaf);
  std::memcpy(bytes.data(), &header, sizeof header);
  append(bytes, octree_->child_of);
  append(bytes, octree_->values);
  append(bytes, octree_->lattice_level);
  append(bytes, octree_->owned_corners);
  const Hash128 checksum = hash128(std::string_view(bytes).substr(checksum_from));
  header.checksum_high = checksum.high;
  header.checksum_low = checksum.low;
  std::memcpy(bytes.data(), &header, sizeof header);
  return bytes;
}

SpacingField SpacingField::from_bytes(std::string_view bytes, const std::string& name) {
  StoredField field = stored_field(bytes, name, Arrays::copied);
  return SpacingField(
      std::make_unique<Octree>(std::move(field.octree), field.constant, MappedFile()));
}

SpacingField SpacingField::from_file(const std::filesystem::path& path, const std::string& name) {
  MappedFile file(path);
  StoredField field = stored_field(file.bytes(), name, Arrays::left_in_place);
  return SpacingField(
      std::make_unique<Octree>(std::move(field.octree), field.constant, std::move(file)));
}

SpacingField make_spacing_field(const SurfaceMesh& surface, const SpacingOptions& options) {
  check_options(options);
  const Box3 domain = bounding_box(surface.vertices);
  const Vec3 sides = domain.size();
  const double side = std::max({sides.x, sides.y, sides.z});
  if (!(side > 0) || !std::isfinite(side)) {
    throw InvalidInput("the surface has no finite extent", "surface");
  }
  const double ceiling = options.background > 0 ? options.background : side;
  std::vector<PointDemand> points;
  if (options.inherit_surface) points = surface_spacing(surface);
  const GridFrame frame = grid_frame(domain, reference_spacing(ceiling, options, points));
  SpacingDemand demand{DemandTree(std::move(points), options.growth),
                       {},
                       options.background,
                       options.growth,
                       ceiling,
                       tree_of_triangles(options)};
  for (const Source& source : options.sources) {
    demand.sources.push_back(source_demand(source, options.growth));
  }
  auto octree = std::make_unique<SpacingField::Octree>();
  static_cast<SpacingOctree&>(*octree) = build_octree(demand, frame, domain);
  return SpacingField(std::move(octree));
}

}  // namespace tetfarm
