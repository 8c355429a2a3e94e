#include "mesh/formats/msh/msh_reader.h"

#include <algorithm>
#include <cstdlib>

#include "mesh/formats/msh/msh_elements.h"

namespace tetfarm {
namespace {

constexpr std::size_t shortest_text = 2;  // bytes of one number and what parts it from the next
constexpr std::int64_t msh_tet = 4;
constexpr std::int64_t most_groups = 1'000'000;

}  // namespace

MshReader::MshReader(const std::filesystem::path& path) : text_(path), in_(text_.scanner()) {
  read_format();
  do section_ = in_.word();
  while (read_head_section(section_));
}

/// False when the section does not belong to the head.
bool MshReader::read_head_section(const std::string& section) {
  if (section == "$PhysicalNames") {
    read_names();
  } else if (section == "$Entities" && is_version_4_) {
    read_entities();
  } else if (section == "$PartitionedEntities" && is_version_4_) {
    read_partitioned_entities();
  } else {
    return false;
  }
  return true;
}

void MshReader::read(MshContent& content) {
  bool has_elements = false;
  for (; !section_.empty(); section_ = in_.word()) {
    if (section_ == "$Nodes") {
      is_version_4_ ? read_nodes_4(content) : read_nodes_2(content);
    } else if (section_ == "$Elements") {
      is_version_4_ ? read_elements_4(content) : read_elements_2(content);
      has_elements = true;
    } else if (!section_.starts_with("$")) {
      in_.fail("expected a section like $Nodes, found " + tetfarm::quoted(section_));
    } else if (!in_.skip_past("$End" + section_.substr(1))) {
      in_.fail("the section " + tetfarm::quoted(section_) + " has no end");
    }
  }
  if (!has_elements) in_.fail("the file has no section $Elements");
}

void MshReader::read_format() {
  in_.expect("$MeshFormat");
  const std::string_view version = in_.word();
  is_version_4_ = version == "4.1";
  if (!is_version_4_ && version != "2.2") {
    in_.fail("Gmsh format " + quoted(version) + " is not supported; save it as 4.1 or 2.2");
  }
  is_binary_ = in_.integer("the file type") != 0;
  if (is_binary_ && !is_version_4_)
    in_.fail("binary files of format 2.2 are not supported; save it as 4.1, or as text");
  if (in_.integer("the size of a number") != 8) in_.fail("numbers do not have 8 bytes");
  if (is_binary_) {
    in_.rest_of_line();
    if (in_.raw<std::int32_t>() != 1)
      in_.fail("is big-endian, which is not supported; save it as text");
    in_.text_again();
  }
  in_.expect("$EndMeshFormat");
}

void MshReader::read_names() {
  const std::int64_t names = in_.integer("the number of physical names");
  for (std::size_t i = in_.to_count(names, 3 * shortest_text); i > 0; --i) {
    const std::int64_t dimension = in_.integer("a dimension");
    const std::int32_t number = name_number(in_.integer("a physical tag"));
    std::string_view text = in_.rest_of_line();
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
      text = text.substr(1, text.size() - 2);
    }
    if (dimension != 2 && dimension != 3) continue;
    std::vector<std::string>& of_kind = names_[dimension == 2 ? 0 : 1];
    of_kind.resize(std::max(of_kind.size(), static_cast<std::size_t>(number)));
    of_kind[static_cast<std::size_t>(number - 1)] = text;
  }
  in_.expect("$EndPhysicalNames");
}

std::int32_t MshReader::name_number(std::int64_t group) const {
  if (group < 1 || group > most_groups) {
    in_.fail("the physical tag " + std::to_string(group) + " is out of range");
  }
  return static_cast<std::int32_t>(group);
}

/// The first of the physical groups that are listed here; 1 when there is none.
std::int32_t MshReader::physical_group() {
  std::int32_t first = 1;
  const std::size_t groups = count();
  for (std::size_t i = 0; i < groups; ++i) {
    const std::int64_t group = small_number("a physical tag");
    if (i == 0) first = name_number(std::abs(group));
  }
  return first;
}

void MshReader::pass_over_box(int dimension) {
  for (int k = dimension == 0 ? 3 : 6; k > 0; --k) coordinate();
}

void MshReader::read_entities() {
  begin_numbers();
  std::array<std::size_t, 4> counts{};
  for (std::size_t& entities : counts) entities = count();
  for (int dimension = 0; dimension < 4; ++dimension) {
    for (std::size_t i = counts[static_cast<std::size_t>(dimension)]; i > 0; --i) {
      const std::int64_t tag = small_number("an entity tag");
      pass_over_box(dimension);
      entity2group_[static_cast<std::size_t>(dimension)][tag] = physical_group();
      if (dimension == 0) continue;
      for (std::size_t k = count(); k > 0; --k) small_number("a bounding entity");
    }
  }
  end_numbers("$EndEntities");
}

void MshReader::read_partitioned_entities() {
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
      const std::int64_t tag = small_number("an entity tag");
      small_number("the dimension of the parent");
      small_number("the tag of the parent");
      for (std::size_t k = count(); k > 0; --k) small_number("a partition");
      pass_over_box(dimension);
      entity2group_[static_cast<std::size_t>(dimension)][tag] = physical_group();
      if (dimension == 0) continue;
      for (std::size_t k = count(); k > 0; --k) small_number("a bounding entity");
    }
  }
  end_numbers("$EndPartitionedEntities");
}

void MshReader::read_nodes_2(MshContent& content) {
  const std::int64_t nodes = in_.integer("the number of nodes");
  for (std::size_t i = in_.to_count(nodes, 4 * shortest_text); i > 0; --i) {
    const std::int64_t tag = in_.integer("a node number");
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = in_.coordinate();
    content.add_node(tag, p);
    text_.pass();
  }
  in_.expect("$EndNodes");
}

void MshReader::read_nodes_4(MshContent& content) {
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
      Vec3 p;
      for (int axis = 0; axis < 3; ++axis) p[axis] = in_.finite(coordinate());
      for (std::int64_t k = 0; is_parametric && k < dimension; ++k) coordinate();
      content.add_node(tag, p);
      text_.pass();
    }
  }
  end_numbers("$EndNodes");
}

void MshReader::read_elements_2(MshContent& content) {
  const std::int64_t elements = in_.integer("the number of elements");
  for (std::size_t i = in_.to_count(elements, 4 * shortest_text); i > 0; --i) {
    in_.integer("an element number");
    const std::int64_t type = in_.integer("an element type");
    const auto known = msh_element_type(type);
    if (!known) in_.fail("unknown element type " + std::to_string(type));
    std::int32_t group = 1;
    std::int32_t partition = 0;
    std::int64_t partitions = 0;
    const std::size_t tags = in_.to_count(in_.integer("the number of tags"), shortest_text);
    for (std::size_t k = 0; k < tags; ++k) {
      const std::int64_t tag = in_.integer("a tag");
      if (k == 0 && tag != 0) group = name_number(tag);
      if (k == 2) partitions = tag;
      if (k == 3 && partitions > 0) partition = name_number(tag);
    }
    if (type == msh_triangle) {
      std::array<std::int64_t, 3> nodes;
      for (std::int64_t& node : nodes) node = in_.integer("a node number");
      content.add_triangle(nodes, group - 1);
    } else if (type == msh_tet) {
      std::array<std::int64_t, 4> nodes;
      for (std::int64_t& node : nodes) node = in_.integer("a node number");
      content.add_tet(nodes, group, partition);
    } else if (known->dimension < 2) {
      for (int k = 0; k < known->nodes; ++k) in_.integer("a node number");
    } else {
      in_.fail("a " + std::string(known->name) + ": only triangles and tets are supported");
    }
    text_.pass();
  }
  in_.expect("$EndElements");
}

void MshReader::read_elements_4(MshContent& content) {
  begin_numbers();
  const std::size_t blocks = count();
  for (const char* what : {"the number of elements", "the smallest tag", "the largest tag"}) {
    large_number(what);
  }
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::int64_t dimension = small_number("a dimension");
    const std::int64_t entity = small_number("an entity tag");
    const std::int64_t type = small_number("an element type");
    const auto known = msh_element_type(type);
    if (!known || known->dimension != dimension) {
      in_.fail("element type " + std::to_string(type) + " in an entity of dimension " +
               std::to_string(dimension));
    }
    if (dimension >= 2 && type != msh_triangle && type != msh_tet) {
      in_.fail("a " + std::string(known->name) + ": only triangles and tets are supported");
    }
    const auto& groups = entity2group_[static_cast<std::size_t>(dimension)];
    const auto found = groups.find(entity);
    const std::int32_t group = found == groups.end() ? 1 : found->second;
    const bool is_ghost = dimension == 3 && ghost_entities_.contains(entity);
    for (std::size_t i = count(); i > 0; --i) {
      large_number("an element number");
      std::array<std::int64_t, 4> nodes{};
      for (std::size_t k = 0; k < static_cast<std::size_t>(known->nodes); ++k) {
        const std::int64_t node = large_number("a node number");
        if (k < nodes.size()) nodes[k] = node;
      }
      if (type == msh_triangle) {
        content.add_triangle({nodes[0], nodes[1], nodes[2]}, group - 1);
      } else if (type == msh_tet && !is_ghost) {
        content.add_tet(nodes, group, static_cast<std::int32_t>(entity));
      }
      text_.pass();
    }
  }
  end_numbers("$EndElements");
}

void MshReader::begin_numbers() {
  if (is_binary_) in_.rest_of_line();
}

void MshReader::end_numbers(const char* end) {
  in_.text_again();
  in_.expect(end);
}

std::int64_t MshReader::small_number(const char* what) {
  return is_binary_ ? in_.raw<std::int32_t>() : in_.integer(what);
}

std::int64_t MshReader::large_number(const char* what) {
  return is_binary_ ? in_.raw<std::int64_t>() : in_.integer(what);
}

double MshReader::coordinate() { return is_binary_ ? in_.raw<double>() : in_.coordinate(); }

/// Of things that take one number at least.
std::size_t MshReader::count() {
  return in_.to_count(large_number("a count"), is_binary_ ? sizeof(std::int32_t) : shortest_text);
}

}  // namespace tetfarm
