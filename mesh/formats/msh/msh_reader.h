/// Walks over a Gmsh file of tets, MSH 4.1 (text or little-endian binary) or 2.2 (text), and hands
/// on what is in it, in the order of the file.
///
/// Source: Gmsh reference manual, "MSH file format". Physical groups, by their numbers from 1, are
/// patches and regions, as write_msh41.h has them; what has none is of the first. Points and lines,
/// and elements of ghost entities, are passed over.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "mesh/core/vec3.h"
#include "mesh/formats/mesh_text.h"

namespace tetfarm {

/// Receives the content. Nodes are named by their tags.
class MshContent {
 public:
  virtual ~MshContent() = default;
  virtual void add_node(std::int64_t tag, const Vec3& p) = 0;
  virtual void add_triangle(const std::array<std::int64_t, 3>& nodes, std::int32_t patch) = 0;
  /// `subdomain`: the volume entity in 4.1, the partition in 2.2; 0 when the file does not say.
  virtual void add_tet(const std::array<std::int64_t, 4>& nodes, std::int32_t region,
                       std::int32_t subdomain) = 0;
};

class MshReader {
 public:
  /// Reads up to the nodes. @throws IoError, InvalidInput with the line or byte.
  explicit MshReader(const std::filesystem::path& path);

  /// Reads the rest. Called once. @throws InvalidInput.
  void read(MshContent& content);

  const std::vector<std::string>& patch_names() const { return names_[0]; }
  const std::vector<std::string>& region_names() const { return names_[1]; }
  /// Whether it is one of several files, each with its partition.
  bool is_partitioned() const { return is_partitioned_; }
  bool has_ghosts() const { return !ghost_entities_.empty(); }
  const std::string& name() const { return text_.name(); }

 private:
  bool read_head_section(const std::string& section);
  void read_format();
  void read_names();
  void read_entities();
  void read_partitioned_entities();
  void read_nodes_2(MshContent& content);
  void read_nodes_4(MshContent& content);
  void read_elements_2(MshContent& content);
  void read_elements_4(MshContent& content);

  void begin_numbers();
  void end_numbers(const char* end);
  std::int64_t small_number(const char* what);
  std::int64_t large_number(const char* what);
  double coordinate();
  std::size_t count();
  void pass_over_box(int dimension);
  std::int32_t physical_group();
  std::int32_t name_number(std::int64_t group) const;

  MeshText text_;  ///< behind the word $Nodes, or whatever followed the entities
  std::string section_;
  InputScanner& in_;
  bool is_version_4_ = false;
  bool is_binary_ = false;
  bool is_partitioned_ = false;
  std::array<std::vector<std::string>, 2> names_;
  std::array<std::map<std::int64_t, std::int32_t>, 4> entity2group_;  ///< of each dimension
  std::set<std::int64_t> ghost_entities_;
};

}  // namespace tetfarm
