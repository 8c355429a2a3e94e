#include "mesh/formats/msh/read_msh.h"

#include <limits>
#include <map>

#include "mesh/formats/input_scanner.h"
#include "mesh/formats/msh/msh_elements.h"
#include "mesh/formats/patch_names.h"
#include "mesh/formats/used_vertices.h"

namespace tetfarm {
namespace {

constexpr std::size_t shortest_text = 2;  // bytes of one number and what parts it from the next

/// Reads both versions, ASCII and binary: a number is a word of the text or a raw value, where the
/// section's numbers are written in binary.
class MshReader {
 public:
  MshReader(std::string_view bytes, const std::string& name) : scanner_(bytes, name) {}

  SurfaceMesh read() {
    read_format();
    while (!scanner_.at_end()) {
      const std::string_view section = scanner_.word();
      if (section == "$PhysicalNames") {
        read_physical_names();
      } else if (section == "$Entities" && is_version_4_) {
        read_entities();
      } else if (section == "$Nodes") {
        is_version_4_ ? read_nodes_4() : read_nodes_2();
      } else if (section == "$Elements") {
        is_version_4_ ? read_elements_4() : read_elements_2();
      } else if (!section.starts_with("$")) {
        scanner_.fail("expected a section like $Nodes, found " + quoted(section));
      } else if (!scanner_.skip_past("$End" + std::string(section.substr(1)))) {
        scanner_.fail("the section " + quoted(section) + " has no end");
      }
    }
    if (!has_elements_) scanner_.fail("the file has no section $Elements");
    keep_used_vertices(surface_);
    surface_.patch_names = patches_.take();
    return std::move(surface_);
  }

 private:
  void read_format() {
    scanner_.expect("$MeshFormat");
    const std::string_view version = scanner_.word();
    is_version_4_ = version == "4.1";
    if (!is_version_4_ && version != "2" && version != "2.1" && version != "2.2") {
      scanner_.fail("Gmsh format " + quoted(version) + " is not supported; save it as 2.2 or 4.1");
    }
    const std::int64_t file_type = scanner_.integer("the file type");
    if (file_type != 0 && file_type != 1) scanner_.fail("the file type is not 0 or 1");
    is_binary_ = file_type == 1;
    if (scanner_.integer("the size of a number") != 8) scanner_.fail("numbers do not have 8 bytes");
    if (is_binary_) {
      scanner_.rest_of_line();
      if (scanner_.raw<std::int32_t>() != 1)
        scanner_.fail("is big-endian, which is not supported; save it as text");
      scanner_.text_again();
    }
    scanner_.expect("$EndMeshFormat");
  }

  void read_physical_names() {
    const std::int64_t count = scanner_.integer("the number of physical names");
    for (std::size_t i = scanner_.to_count(count, shortest_text); i > 0; --i) {
      const std::int64_t dimension = scanner_.integer("a dimension");
      const std::int64_t tag = scanner_.integer("a physical tag");
      std::string_view text = scanner_.rest_of_line();
      if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
        text = text.substr(1, text.size() - 2);
      }
      if (dimension == 2) physical_names_[tag] = text;
    }
    scanner_.expect("$EndPhysicalNames");
  }

  /// The first physical tag of each surface.
  void read_entities() {
    begin_numbers();
    std::array<std::size_t, 4> counts{};
    for (std::size_t& count : counts) count = count_of_items();
    for (int dimension = 0; dimension < 4; ++dimension) {
      for (std::size_t i = counts[static_cast<std::size_t>(dimension)]; i > 0; --i) {
        const std::int64_t tag = small_number("an entity tag");
        for (int k = dimension == 0 ? 3 : 6; k > 0; --k) coordinate();
        for (std::size_t k = 0, physicals = count_of_items(); k < physicals; ++k) {
          const std::int64_t physical = small_number("a physical tag");
          if (dimension == 2 && k == 0)
            surface2physical_[tag] = physical < 0 ? -physical : physical;
        }
        if (dimension == 0) continue;
        for (std::size_t k = count_of_items(); k > 0; --k) small_number("a bounding entity");
      }
    }
    end_numbers("$EndEntities");
  }

  void read_nodes_2() {
    const std::int64_t count = scanner_.integer("the number of nodes");
    const std::size_t nodes = scanner_.to_count(count, 4 * shortest_text);
    begin_numbers();
    tags_.reserve(nodes);
    surface_.vertices.reserve(nodes);
    for (std::size_t i = 0; i < nodes; ++i) {
      tags_.add(small_number("a node number"));
      read_point();
    }
    end_nodes();
  }

  void read_nodes_4() {
    begin_numbers();
    const std::size_t blocks = count_of_items();
    const std::size_t nodes = count_of_items();
    large_number("the smallest node tag");
    large_number("the largest node tag");
    tags_.reserve(nodes);
    surface_.vertices.reserve(nodes);
    for (std::size_t block = 0; block < blocks; ++block) {
      const std::int64_t dimension = small_number("a dimension");
      small_number("an entity tag");
      const bool is_parametric = small_number("0 or 1 for parametric") != 0;
      const std::size_t nodes_here = count_of_items();
      for (std::size_t i = 0; i < nodes_here; ++i) tags_.add(large_number("a node number"));
      for (std::size_t i = 0; i < nodes_here; ++i) {
        read_point();
        for (std::int64_t k = 0; is_parametric && k < dimension; ++k) coordinate();
      }
    }
    end_nodes();
  }

  void end_nodes() {
    end_numbers("$EndNodes");
    if (surface_.vertices.size() > std::numeric_limits<std::int32_t>::max()) {
      scanner_.fail("too many nodes");
    }
    if (const auto twice = tags_.sort()) {
      scanner_.fail("two nodes have the number " + std::to_string(*twice));
    }
  }

  void read_elements_2() {
    const std::int64_t count = scanner_.integer("the number of elements");
    const std::size_t elements = scanner_.to_count(count, 4 * shortest_text);
    begin_numbers();
    is_binary_ ? read_binary_elements_2(elements) : read_text_elements_2(elements);
    end_numbers("$EndElements");
    has_elements_ = true;
  }

  void read_text_elements_2(std::size_t elements) {
    for (std::size_t i = 0; i < elements; ++i) {
      scanner_.integer("an element number");
      const std::int64_t type = scanner_.integer("an element type");
      if (is_triangle(type)) {
        const std::int64_t physical = first_tag(scanner_.integer("the number of tags"));
        add_triangle(physical);
      }
      scanner_.rest_of_line();
    }
  }

  void read_binary_elements_2(std::size_t elements) {
    for (std::size_t done = 0; done < elements;) {
      const std::int64_t type = small_number("an element type");
      const bool is_wanted = is_triangle(type);
      const auto here = static_cast<std::uint32_t>(small_number("the number of elements"));
      const std::int64_t tags = small_number("the number of tags");
      if (here == 0 || here > elements - done) {
        scanner_.fail("a block of " + std::to_string(here) + " elements, but only " +
                      std::to_string(elements - done) + " are left");
      }
      done += here;
      const auto nodes = static_cast<std::size_t>(known_type(type).nodes);
      for (std::uint32_t i = 0; i < here; ++i) {
        small_number("an element number");
        const std::int64_t physical = first_tag(tags);
        is_wanted ? add_triangle(physical) : scanner_.skip_bytes(nodes * sizeof(std::int32_t));
      }
    }
  }

  void read_elements_4() {
    begin_numbers();
    const std::size_t blocks = count_of_items();
    count_of_items();
    large_number("the smallest element tag");
    large_number("the largest element tag");
    for (std::size_t block = 0; block < blocks; ++block) {
      small_number("a dimension");
      const std::int64_t entity = small_number("an entity tag");
      const std::int64_t type = small_number("an element type");
      const bool is_wanted = is_triangle(type);
      const std::size_t elements = count_of_items();
      const auto found = surface2physical_.find(entity);
      const std::int64_t physical = found == surface2physical_.end() ? 0 : found->second;
      for (std::size_t i = 0; i < elements; ++i) {
        large_number("an element number");
        if (is_wanted) {
          add_triangle(physical);
        } else if (is_binary_) {
          scanner_.skip_bytes(static_cast<std::size_t>(known_type(type).nodes) *
                              sizeof(std::int64_t));
        } else {
          scanner_.rest_of_line();
        }
      }
    }
    end_numbers("$EndElements");
    has_elements_ = true;
  }

  /// The first of `count` tags, 0 when there are none.
  std::int64_t first_tag(std::int64_t count) {
    std::int64_t first = 0;
    if (count < 0) scanner_.fail("a negative number of tags");
    for (std::int64_t k = 0; k < count; ++k) {
      const std::int64_t tag = small_number("a tag");
      if (k == 0) first = tag;
    }
    return first;
  }

  MshElementType known_type(std::int64_t type) const {
    const auto known = msh_element_type(type);
    if (!known) scanner_.fail("unknown element type " + std::to_string(type));
    return *known;
  }

  bool is_triangle(std::int64_t type) const {
    if (type == msh_triangle) return true;
    const MshElementType known = known_type(type);
    if (known.dimension == 2) {
      scanner_.fail("a " + std::string(known.name) + ": only 3-node triangles are supported");
    }
    return false;
  }

  void add_triangle(std::int64_t physical) {
    Triangle triangle;
    for (std::int32_t& vertex : triangle) {
      const std::int64_t tag =
          is_version_4_ ? large_number("a node number") : small_number("a node number");
      vertex = tags_.find(tag);
      if (vertex < 0) scanner_.fail("there is no node " + std::to_string(tag));
    }
    if (surface_.triangles.empty() || physical != last_physical_) {
      last_physical_ = physical;
      last_patch_ = patches_.number_of(patch_name(physical));
    }
    surface_.triangles.push_back(triangle);
    surface_.patch_of_triangle.push_back(last_patch_);
  }

  std::string patch_name(std::int64_t physical) const {
    if (physical == 0) return "";
    const auto named = physical_names_.find(physical);
    return named != physical_names_.end() ? named->second : "physical " + std::to_string(physical);
  }

  void read_point() {
    const double x = coordinate();
    const double y = coordinate();
    surface_.vertices.push_back({x, y, coordinate()});
  }

  // From here: a number of a section, as text or binary.
  void begin_numbers() {
    if (is_binary_) scanner_.rest_of_line();
  }
  void end_numbers(std::string_view end) {
    scanner_.text_again();
    scanner_.expect(end);
  }
  std::int64_t small_number(std::string_view what) {
    return is_binary_ ? scanner_.raw<std::int32_t>() : scanner_.integer(what);
  }
  std::int64_t large_number(std::string_view what) {
    return is_binary_ ? scanner_.raw<std::int64_t>() : scanner_.integer(what);
  }
  std::size_t count_of_items() {
    const std::int64_t count = large_number("a count");
    return scanner_.to_count(count, is_binary_ ? sizeof(std::int32_t) : shortest_text);
  }
  double coordinate() {
    if (!is_binary_) return scanner_.coordinate();
    return scanner_.finite(scanner_.raw<double>());
  }

  InputScanner scanner_;
  bool is_version_4_ = false;
  bool is_binary_ = false;
  bool has_elements_ = false;
  SurfaceMesh surface_;
  MshNodeTags tags_;
  PatchNames patches_;
  std::map<std::int64_t, std::string> physical_names_;
  std::map<std::int64_t, std::int64_t> surface2physical_;
  std::int64_t last_physical_ = 0;
  std::int32_t last_patch_ = 0;
};

}  // namespace

SurfaceMesh read_msh(std::string_view bytes, const std::string& name) {
  return MshReader(bytes, name).read();
}

}  // namespace tetfarm
