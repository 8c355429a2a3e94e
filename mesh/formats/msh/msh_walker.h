/// Walks over a Gmsh file, MSH 2.2 or 4.1, text or little-endian binary, and hands on what is in
/// it, in the order of the file: what the readers of surfaces and of meshes have in common.
///
/// Source: Gmsh reference manual, "MSH file format". Sections of other kinds are passed over.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/core/vec3.h"
#include "mesh/formats/input_scanner.h"
#include "mesh/formats/msh/msh_elements.h"

namespace tetfarm {

/// Nodes are named by their tags.
struct MshElement {
  std::int64_t type = 0;
  std::span<const std::int64_t> nodes;
  std::int64_t group = 0;      ///< the first physical group, without its sign in 4.1; 0: none
  std::int64_t entity = 0;     ///< in 4.1
  std::int64_t partition = 0;  ///< in 2.2 the first; 0: none
  bool is_ghost = false;       ///< of another partition
};

/// Receives the content. Functions may throw; `fail` of the scanner names the place.
class MshContent {
 public:
  virtual ~MshContent() = default;
  virtual void add_name(int dimension, std::int64_t group, std::string_view name) = 0;
  virtual void add_node(std::int64_t tag, const Vec3& p) = 0;
  /// Behind the last node of a section.
  virtual void end_nodes() {}
  /// Whether elements of that type are to be handed on; those that cannot be taken fail.
  virtual bool wants(const MshElementType& type, std::int64_t number) = 0;
  virtual void add_element(const MshElement& element) = 0;
};

class MshWalker {
 public:
  /// Reads the format. @throws InvalidInput with the line or byte, also later.
  explicit MshWalker(InputScanner& in);

  /// Up to the first section that is neither names nor entities.
  void walk_head(MshContent& content);
  /// To the end; what the head has is not handed on again.
  void walk(MshContent& content);
  /// Whether it is one of several files, each with its partition: known behind the head.
  bool is_partitioned() const { return is_partitioned_; }
  bool has_ghosts() const { return !ghost_entities_.empty(); }
  bool is_version_4() const { return is_version_4_; }

 private:
  bool walk_head_section(MshContent& content);
  void read_format();
  void read_names(MshContent& content);
  void read_entities();
  void read_partitioned_entities();
  void read_entity(int dimension, bool has_parent);
  void read_nodes_2(MshContent& content);
  void read_nodes_4(MshContent& content);
  Vec3 read_point();
  void read_elements_2(MshContent& content);
  void read_text_elements_2(MshContent& content, std::size_t elements);
  void read_binary_elements_2(MshContent& content, std::size_t elements);
  void read_elements_4(MshContent& content);
  void read_block_4(MshContent& content);
  MshElement read_tags_2(std::int64_t type, std::int64_t tags);
  void read_element_nodes(MshElement& element, int nodes);
  MshElementType known_type(std::int64_t type) const;

  void begin_numbers();
  void end_numbers(std::string_view end);
  std::int64_t small_number(std::string_view what);
  std::int64_t large_number(std::string_view what);
  double coordinate();
  std::size_t count();

  InputScanner& in_;
  std::string section_;  ///< whose name was read, but not its content
  bool is_version_4_ = false;
  bool is_binary_ = false;
  bool is_partitioned_ = false;
  bool has_elements_ = false;
  std::array<std::map<std::int64_t, std::int64_t>, 4> entity2group_;  ///< of each dimension
  std::set<std::int64_t> ghost_entities_;
  std::vector<std::int64_t> nodes_;  ///< of the element at hand
};

}  // namespace tetfarm
