#include "mesh/formats/pvtu/pvtu_source.h"

#include <algorithm>
#include <charconv>
#include <numeric>

#include "base/error.h"
#include "base/file_system.h"
#include "mesh/core/element_block.h"
#include "mesh/formats/input_file.h"
#include "mesh/formats/regions_of_faces.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

constexpr std::int32_t most_regions = 1'000'000;

/// The value of an attribute of the XML element that begins at `place`; empty when it has none.
std::string_view attribute(std::string_view text, std::size_t place, std::string_view name) {
  const std::string_view element = text.substr(place, text.find('>', place) - place);
  const std::string wanted = " " + std::string(name) + "=\"";
  const std::size_t found = element.find(wanted);
  if (found == element.npos) return {};
  const std::string_view rest = element.substr(found + wanted.size());
  return rest.substr(0, rest.find('"'));
}

/// A piece: its XML, then the arrays.
class VtuFile {
 public:
  explicit VtuFile(const fs::path& path) : file_(path) {
    read_head();
    points_ = count("NumberOfPoints");
    cells_ = count("NumberOfCells");
  }

  NumberedPart part(std::size_t number) const {
    NumberedPart part;
    part.number = static_cast<std::int32_t>(number);
    static_assert(sizeof(Vec3) == 24);
    part.nodes = array<Vec3>("Points", "Float64", points_);
    if (has("GlobalNodeId")) {
      part.local2global = array<std::int64_t>("GlobalNodeId", "Int64", points_);
    } else {
      part.local2global.resize(part.nodes.size());
      std::iota(part.local2global.begin(), part.local2global.end(), 0);
    }
    read_cells(part);
    return part;
  }
  bool has(std::string_view name) const { return place_of(name) != std::string::npos; }

 private:
  void read_head() {
    constexpr std::size_t most_bytes = 1 << 16;
    head_.resize(std::min<std::size_t>(most_bytes, static_cast<std::size_t>(file_.size())));
    file_.read(0, head_.data(), head_.size());
    const std::size_t data = head_.find("<AppendedData");
    const std::size_t begin = data == head_.npos ? data : head_.find('_', data);
    const std::size_t root = head_.find("<VTKFile");
    if (begin == head_.npos || root == head_.npos) {
      throw InvalidInput("is not a .vtu file with appended data", file_.name());
    }
    if (attribute(head_, root, "byte_order") != "LittleEndian" ||
        attribute(head_, root, "header_type") != "UInt64" ||
        !attribute(head_, root, "compressor").empty() ||
        attribute(head_, data, "encoding") != "raw") {
      throw InvalidInput("only raw, little-endian data with 64-bit lengths are supported",
                         file_.name());
    }
    first_ = static_cast<std::int64_t>(begin) + 1;
    head_.resize(data);
  }

  [[noreturn]] void fail(const std::string& what, std::size_t place) const {
    const auto line = 1 + std::count(head_.begin(), head_.begin() + static_cast<long>(place), '\n');
    throw InvalidInput(what, file_.name() + ":" + std::to_string(line));
  }

  std::int64_t integer(std::string_view text, std::size_t place) const {
    std::int64_t value = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < 0) {
      fail("expected a number, found \"" + std::string(text.substr(0, 40)) + "\"", place);
    }
    return value;
  }

  std::int64_t count(std::string_view name) const {
    const std::size_t place = head_.find("<Piece ");
    if (place == head_.npos) fail("there is no piece", 0);
    const std::int64_t value = integer(attribute(head_, place, name), place);
    if (value > file_.size()) fail("a count is larger than the file", place);
    return value;
  }

  std::size_t place_of(std::string_view name) const {
    for (std::size_t place = head_.find("<DataArray"); place != head_.npos;
         place = head_.find("<DataArray", place + 1)) {
      if (attribute(head_, place, "Name") == name) return place;
    }
    return std::string::npos;
  }

  /// `count` records, of numbers of that type.
  template <class T>
  std::vector<T> array(std::string_view name, std::string_view type, std::int64_t count) const {
    const std::size_t place = place_of(name);
    if (place == std::string::npos) fail("there is no array " + std::string(name), 0);
    if (attribute(head_, place, "type") != type ||
        attribute(head_, place, "format") != "appended") {
      fail(std::string(name) + " is not " + std::string(type) + ", appended", place);
    }
    const std::int64_t offset = integer(attribute(head_, place, "offset"), place);
    if (offset > file_.size()) fail("an offset is larger than the file", place);
    const auto bytes = file_.at<std::int64_t>(first_ + offset);
    if (bytes != count * static_cast<std::int64_t>(sizeof(T))) {
      file_.fail(std::string(name) + " has " + std::to_string(bytes) + " bytes", first_ + offset);
    }
    if (bytes > file_.size() - first_ - offset) {
      file_.fail(std::string(name) + " ends after the end of the file", first_ + offset);
    }
    std::vector<T> values(static_cast<std::size_t>(count));
    file_.read(first_ + offset + 8, values.data(), static_cast<std::size_t>(bytes));
    return values;
  }

  ElementType type_of_cell(std::uint8_t code) const {
    const std::optional<ElementType> type = type_of(ElementCodes::vtk, code);
    if (!type) {
      throw InvalidInput("has a cell of type " + std::to_string(code) +
                             "; only triangles (5), quads (9), tetrahedra (10), hexahedra (12), "
                             "wedges (13) and pyramids (14) are read",
                         file_.name());
    }
    return *type;
  }

  void read_cells(NumberedPart& part) const {
    const auto types = array<std::uint8_t>("types", "UInt8", cells_);
    std::size_t count = 0;
    for (const std::uint8_t code : types) count += nodes_of(type_of_cell(code));
    const auto nodes =
        array<std::int64_t>("connectivity", "Int64", static_cast<std::int64_t>(count));
    for (const std::int64_t node : nodes) {
      if (node < 0 || node >= points_) {
        throw InvalidInput(
            "a cell has point " + std::to_string(node) + " of " + std::to_string(points_),
            file_.name());
      }
    }
    const auto regions = optional_array("region", 1);
    const auto patches = optional_array("patch", 0);
    std::span<const std::int64_t> rest = nodes;
    for (std::size_t cell = 0; cell < types.size(); ++cell) {
      if (regions[cell] < 1 || regions[cell] > most_regions) {
        throw InvalidInput("a cell has the region " + std::to_string(regions[cell]), file_.name());
      }
      const ElementType type = type_of_cell(types[cell]);
      add_cell(type, rest.first(nodes_of(type)), regions[cell], patches[cell], part);
      rest = rest.subspan(nodes_of(type));
    }
    settle_regions(regions, part);
  }

  static void add_cell(ElementType type, std::span<const std::int64_t> nodes, std::int32_t region,
                       std::int32_t patch, NumberedPart& part) {
    const auto take = [&](auto into) {
      take_from_order_of(ElementCodes::vtk, type, nodes, std::span<std::int32_t>(into));
      return into;
    };
    if (type == ElementType::tet) {
      part.tets.push_back(take(Tet{}));
      part.region_of_tet.push_back(region);
    } else if (type == ElementType::triangle) {
      part.faces.push_back(take(Triangle{}));
      part.region_of_face.push_back(region);
      part.patch_of_face.push_back(patch);
    } else {
      ElementBlock& block = part.blocks[type];
      block.nodes.resize(block.nodes.size() + nodes.size());
      take_from_order_of(ElementCodes::vtk, type, nodes, std::span(block.nodes).last(nodes.size()));
      block.regions.push_back(region);
      if (!is_cell(type)) block.patches.push_back(patch);
    }
  }

  /// One region of all tets and triangles is said once.
  static void settle_regions(const std::vector<std::int32_t>& regions, NumberedPart& part) {
    const auto is_of = [](const std::vector<std::int32_t>& all, std::int32_t region) {
      return std::all_of(all.begin(), all.end(), [region](auto r) { return r == region; });
    };
    if (!regions.empty()) part.region = regions.front();
    if (!is_of(part.region_of_tet, part.region) || !is_of(part.region_of_face, part.region)) return;
    part.region_of_tet.clear();
    part.region_of_face.clear();
  }

  std::vector<std::int32_t> optional_array(std::string_view name, std::int32_t value) const {
    if (has(name)) return array<std::int32_t>(name, "Int32", cells_);
    return std::vector<std::int32_t>(static_cast<std::size_t>(cells_), value);
  }

  InputFile file_;
  std::string head_;
  std::int64_t first_ = 0;
  std::int64_t points_ = 0;
  std::int64_t cells_ = 0;
};

class PvtuSource : public MeshSource {
 public:
  explicit PvtuSource(std::vector<fs::path> pieces) : pieces_(std::move(pieces)) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const VtuFile file(pieces_[i]);
      if (pieces_.size() > 1 && !file.has("GlobalNodeId")) {
        throw InvalidInput("is one of several pieces, but has no GlobalNodeId to join them by",
                           pieces_[i].string());
      }
      file.part(i);
    }
  }
  std::size_t size() const override { return pieces_.size(); }
  bool takes_threads() const override { return true; }
  NumberedPart part(std::size_t i) const override { return VtuFile(pieces_.at(i)).part(i); }
  std::vector<std::string> patch_names() const override { return {}; }
  std::vector<std::string> region_names() const override { return {}; }

 private:
  std::vector<fs::path> pieces_;
};

/// A .vtu, which is not read as a whole.
bool is_piece(const fs::path& path) {
  const InputFile file(path);
  std::string head(static_cast<std::size_t>(std::min<std::int64_t>(file.size(), 4096)), ' ');
  file.read(0, head.data(), head.size());
  return head.find("type=\"UnstructuredGrid\"") != head.npos;
}

}  // namespace

std::unique_ptr<MeshSource> open_pvtu(const fs::path& path, const fs::path&) {
  if (is_piece(path)) return std::make_unique<PvtuSource>(std::vector{path});
  const std::string text = read_file(path);
  std::vector<fs::path> pieces;
  for (std::size_t place = text.find("<Piece "); place != text.npos;
       place = text.find("<Piece ", place + 1)) {
    pieces.push_back(path.parent_path() / attribute(text, place, "Source"));
  }
  if (pieces.empty() || text.find("</VTKFile>") == text.npos) {
    throw InvalidInput("is not a complete .pvtu file", path.string());
  }
  return std::make_unique<PvtuSource>(std::move(pieces));
}

}  // namespace tetfarm
