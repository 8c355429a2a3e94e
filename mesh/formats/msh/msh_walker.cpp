#include "mesh/formats/msh/msh_walker.h"

#include <cstdlib>

namespace tetfarm {
namespace {

constexpr std::size_t shortest_text = 2;  // bytes of one number and what parts it from the next

}  // namespace

MshWalker::MshWalker(InputScanner& in) : in_(in) {
  read_format();
  section_ = in_.word();
}

void MshWalker::walk_head(MshContent& content) {
  while (walk_head_section(content)) section_ = in_.word();
}

/// False when the section does not belong to the head.
bool MshWalker::walk_head_section(MshContent& content) {
  if (section_ == "$PhysicalNames") {
    read_names(content);
  } else if (section_ == "$Entities" && is_version_4_) {
    read_entities();
  } else if (section_ == "$PartitionedEntities" && is_version_4_) {
    read_partitioned_entities();
  } else {
    return false;
  }
  return true;
}

void MshWalker::walk(MshContent& content) {
  for (; !section_.empty(); section_ = in_.word()) {
    if (walk_head_section(content)) continue;
    if (section_ == "$Nodes") {
      is_version_4_ ? read_nodes_4(content) : read_nodes_2(content);
      content.end_nodes();
    } else if (section_ == "$Elements") {
      is_version_4_ ? read_elements_4(content) : read_elements_2(content);
      has_elements_ = true;
    } else if (!section_.starts_with("$")) {
      in_.fail("expected a section like $Nodes, found " + quoted(section_));
    } else if (!in_.skip_past("$End" + section_.substr(1))) {
      in_.fail("the section " + quoted(section_) + " has no end");
    }
  }
  if (!has_elements_) in_.fail("the file has no section $Elements");
}

void MshWalker::read_format() {
  const std::string_view first = in_.word();
  if (first == "$NOD") in_.fail("Gmsh format 1 is not supported; save it as 4.1 or 2.2");
  if (first != "$MeshFormat") {
    in_.fail("is not a mesh of Gmsh: expected $MeshFormat, found " + quoted(first) +
             "; Fluent and GiD give their files the ending .msh too");
  }
  const std::string_view version = in_.word();
  is_version_4_ = version == "4.1";
  if (!is_version_4_ && version != "2" && version != "2.1" && version != "2.2") {
    in_.fail("Gmsh format " + quoted(version) + " is not supported; save it as 4.1 or 2.2");
  }
  const std::int64_t file_type = in_.integer("the file type");
  if (file_type != 0 && file_type != 1) in_.fail("the file type is not 0 or 1");
  is_binary_ = file_type == 1;
  if (in_.integer("the size of a number") != 8) in_.fail("numbers do not have 8 bytes");
  if (is_binary_) {
    in_.rest_of_line();
    if (in_.raw<std::int32_t>() != 1) {
      in_.fail("is big-endian, which is not supported; save it as text");
    }
    in_.text_again();
  }
  in_.expect("$EndMeshFormat");
}

void MshWalker::read_names(MshContent& content) {
  const std::int64_t names = in_.integer("the number of physical names");
  for (std::size_t i = in_.to_count(names, shortest_text); i > 0; --i) {
    const std::int64_t dimension = in_.integer("a dimension");
    const std::int64_t group = in_.integer("a physical tag");
    std::string_view text = in_.rest_of_line();
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
      text = text.substr(1, text.size() - 2);
    }
    if (dimension >= 0 && dimension <= 3) {
      content.add_name(static_cast<int>(dimension), group, text);
    }
  }
  in_.expect("$EndPhysicalNames");
}

void MshWalker::read_entity(int dimension, bool has_parent) {
  const std::int64_t tag = small_number("an entity tag");
  if (has_parent) {
    small_number("the dimension of the parent");
    small_number("the tag of the parent");
    for (std::size_t k = count(); k > 0; --k) small_number("a partition");
  }
  for (int k = dimension == 0 ? 3 : 6; k > 0; --k) coordinate();
  std::int64_t first = 0;
  for (std::size_t k = 0, groups = count(); k < groups; ++k) {
    const std::int64_t group = small_number("a physical tag");
    if (k == 0) first = std::abs(group);
  }
  entity2group_[static_cast<std::size_t>(dimension)][tag] = first;
  if (dimension == 0) return;
  for (std::size_t k = count(); k > 0; --k) small_number("a bounding entity");
}

void MshWalker::read_entities() {
  begin_numbers();
  std::array<std::size_t, 4> counts{};
  for (std::size_t& entities : counts) entities = count();
  for (int dimension = 0; dimension < 4; ++dimension) {
    for (std::size_t i = counts[static_cast<std::size_t>(dimension)]; i > 0; --i) {
      read_entity(dimension, false);
    }
  }
  end_numbers("$EndEntities");
}

void MshWalker::read_partitioned_entities() {
  is_partitioned_ = true;
  begin_numbers();
  large_number("the number of partitions");
  for (std::size_t i = count(); i > 0; --i) {
    ghost_entities_.insert(small_number("an entity tag"));
    small_number("a partition");
  }
  std::array<std::size_t, 4> counts{};
  for (std::size_t& entities : counts) entities = count();
  for (int dimension = 0; dimension < 4; ++dimension) {
    for (std::size_t i = counts[static_cast<std::size_t>(dimension)]; i > 0; --i) {
      read_entity(dimension, true);
    }
  }
  end_numbers("$EndPartitionedEntities");
}

Vec3 MshWalker::read_point() {
  Vec3 p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = in_.finite(coordinate());
  return p;
}

void MshWalker::read_nodes_2(MshContent& content) {
  const std::int64_t nodes = in_.integer("the number of nodes");
  std::size_t left = in_.to_count(nodes, 4 * shortest_text);
  begin_numbers();
  for (; left > 0; --left) {
    const std::int64_t tag = small_number("a node number");
    content.add_node(tag, read_point());
  }
  end_numbers("$EndNodes");
}

void MshWalker::read_nodes_4(MshContent& content) {
  begin_numbers();
  const std::size_t blocks = count();
  count();
  large_number("the smallest node tag");
  large_number("the largest node tag");
  std::vector<std::int64_t> tags;
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::int64_t dimension = small_number("a dimension");
    small_number("an entity tag");
    const bool is_parametric = small_number("0 or 1 for parametric") != 0;
    tags.resize(count());
    for (std::int64_t& tag : tags) tag = large_number("a node number");
    for (const std::int64_t tag : tags) {
      const Vec3 p = read_point();
      for (std::int64_t k = 0; is_parametric && k < dimension; ++k) coordinate();
      content.add_node(tag, p);
    }
  }
  end_numbers("$EndNodes");
}

void MshWalker::read_elements_2(MshContent& content) {
  const std::int64_t all = in_.integer("the number of elements");
  const std::size_t elements = in_.to_count(all, 4 * shortest_text);
  begin_numbers();
  is_binary_ ? read_binary_elements_2(content, elements) : read_text_elements_2(content, elements);
  end_numbers("$EndElements");
}

void MshWalker::read_text_elements_2(MshContent& content, std::size_t elements) {
  for (std::size_t i = 0; i < elements; ++i) {
    in_.integer("an element number");
    const std::int64_t type = in_.integer("an element type");
    const MshElementType known = known_type(type);
    if (content.wants(known, type)) {
      MshElement element = read_tags_2(type, in_.integer("the number of tags"));
      read_element_nodes(element, known.nodes);
      content.add_element(element);
    }
    in_.rest_of_line();
  }
}

void MshWalker::read_binary_elements_2(MshContent& content, std::size_t elements) {
  for (std::size_t done = 0; done < elements;) {
    const std::int64_t type = small_number("an element type");
    const MshElementType known = known_type(type);
    const bool is_wanted = content.wants(known, type);
    const auto here = static_cast<std::uint32_t>(small_number("the number of elements"));
    const std::int64_t tags = small_number("the number of tags");
    if (here == 0 || here > elements - done) {
      in_.fail("a block of " + std::to_string(here) + " elements, but only " +
               std::to_string(elements - done) + " are left");
    }
    done += here;
    for (std::uint32_t i = 0; i < here; ++i) {
      small_number("an element number");
      MshElement element = read_tags_2(type, tags);
      if (is_wanted) {
        read_element_nodes(element, known.nodes);
        content.add_element(element);
      } else {
        in_.skip_bytes(static_cast<std::size_t>(known.nodes) * sizeof(std::int32_t));
      }
    }
  }
}

/// The physical group, the elementary entity, the number of partitions, the partitions.
MshElement MshWalker::read_tags_2(std::int64_t type, std::int64_t tags) {
  MshElement element;
  element.type = type;
  if (tags < 0) in_.fail("a negative number of tags");
  std::int64_t partitions = 0;
  for (std::int64_t k = 0; k < tags; ++k) {
    const std::int64_t tag = small_number("a tag");
    if (k == 0) element.group = tag;
    if (k == 2) partitions = tag;
    if (k == 3 && partitions > 0) element.partition = tag;
  }
  return element;
}

void MshWalker::read_element_nodes(MshElement& element, int nodes) {
  nodes_.resize(static_cast<std::size_t>(nodes));
  for (std::int64_t& node : nodes_) {
    node = is_version_4_ ? large_number("a node number") : small_number("a node number");
  }
  element.nodes = nodes_;
}

void MshWalker::read_elements_4(MshContent& content) {
  begin_numbers();
  const std::size_t blocks = count();
  for (const char* what : {"the number of elements", "the smallest tag", "the largest tag"}) {
    large_number(what);
  }
  for (std::size_t block = 0; block < blocks; ++block) read_block_4(content);
  end_numbers("$EndElements");
}

void MshWalker::read_block_4(MshContent& content) {
  const std::int64_t dimension = small_number("a dimension");
  MshElement element;
  element.entity = small_number("an entity tag");
  element.type = small_number("an element type");
  const MshElementType known = known_type(element.type);
  if (known.dimension != dimension) {
    in_.fail("element type " + std::to_string(element.type) + " in an entity of dimension " +
             std::to_string(dimension));
  }
  const auto& groups = entity2group_[static_cast<std::size_t>(dimension)];
  const auto found = groups.find(element.entity);
  if (found != groups.end()) element.group = found->second;
  element.is_ghost = dimension == 3 && ghost_entities_.contains(element.entity);
  const bool is_wanted = content.wants(known, element.type);
  for (std::size_t i = count(); i > 0; --i) {
    large_number("an element number");
    if (is_wanted) {
      read_element_nodes(element, known.nodes);
      content.add_element(element);
    } else if (is_binary_) {
      in_.skip_bytes(static_cast<std::size_t>(known.nodes) * sizeof(std::int64_t));
    } else {
      in_.rest_of_line();
    }
  }
}

MshElementType MshWalker::known_type(std::int64_t type) const {
  const auto known = msh_element_type(type);
  if (!known) in_.fail("unknown element type " + std::to_string(type));
  return *known;
}

void MshWalker::begin_numbers() {
  if (is_binary_) in_.rest_of_line();
}

void MshWalker::end_numbers(std::string_view end) {
  in_.text_again();
  in_.expect(end);
}

std::int64_t MshWalker::small_number(std::string_view what) {
  return is_binary_ ? in_.raw<std::int32_t>() : in_.integer(what);
}

std::int64_t MshWalker::large_number(std::string_view what) {
  return is_binary_ ? in_.raw<std::int64_t>() : in_.integer(what);
}

double MshWalker::coordinate() { return is_binary_ ? in_.raw<double>() : in_.coordinate(); }

/// Of things that take one number at least.
std::size_t MshWalker::count() {
  return in_.to_count(large_number("a count"), is_binary_ ? sizeof(std::int32_t) : shortest_text);
}

}  // namespace tetfarm
