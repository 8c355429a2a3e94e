#include "mesh/formats/msh/msh_source.h"

#include <algorithm>

#include "base/error.h"
#include "mesh/formats/local_numbers.h"
#include "mesh/formats/mesh_text.h"
#include "mesh/formats/msh/msh_walker.h"
#include "mesh/formats/parsed_mesh.h"
#include "mesh/formats/regions_of_faces.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

struct MshFile {
  explicit MshFile(const fs::path& path) : text(path), walker(text.scanner()) {}

  MeshText text;
  MshWalker walker;
};

/// What files of the whole mesh and of a partition have in common: names and numbers of groups.
class GroupedContent : public MshContent {
 public:
  explicit GroupedContent(MshFile& file) : file_(file) {}

  void add_name(int dimension, std::int64_t group, std::string_view name) override {
    if (dimension < 2) return;
    std::vector<std::string>& of_kind = names_[dimension == 2 ? 0 : 1];
    const auto number = static_cast<std::size_t>(group_number(group));
    of_kind.resize(std::max(of_kind.size(), number));
    of_kind[number - 1] = name;
  }
  bool wants(const MshElementType& type, std::int64_t number) override {
    if (type.dimension < 2) return false;
    if (!type_of(ElementCodes::msh, number)) {
      fail("a " + std::string(type.name) +
           ": only triangles, quads, tets, pyramids, prisms and hexes are supported");
    }
    return true;
  }
  void add_element(const MshElement& element) override {
    const std::int32_t group = element.group == 0 ? 1 : group_number(element.group);
    const ElementType type = type_of(ElementCodes::msh, element.type).value();
    std::array<std::int64_t, most_element_nodes> ours{};
    take_from_order_of(ElementCodes::msh, type, element.nodes, std::span<std::int64_t>(ours));
    const std::span<std::int64_t> nodes(ours.data(), element.nodes.size());
    for (std::int64_t& node : nodes) --node;
    if (!is_cell(type)) {
      add_face(type, nodes, group - 1);
    } else if (!element.is_ghost) {
      const std::int32_t partition = element.partition == 0 ? 0 : group_number(element.partition);
      const auto entity = static_cast<std::int32_t>(element.entity);
      add_cell(type, nodes, group, file_.walker.is_version_4() ? entity : partition);
    }
    file_.text.pass();
  }

  const std::vector<std::string>& patch_names() const { return names_[0]; }
  const std::vector<std::string>& region_names() const { return names_[1]; }

 protected:
  /// Nodes are tags less 1, in our order.
  virtual void add_face(ElementType type, std::span<const std::int64_t> nodes,
                        std::int32_t patch) = 0;
  /// `subdomain`: the volume entity in 4.1, the partition in 2.2; 0 when the file does not say.
  virtual void add_cell(ElementType type, std::span<const std::int64_t> nodes, std::int32_t region,
                        std::int32_t subdomain) = 0;
  MshFile& file() { return file_; }
  /// For the place where the walker is.
  [[noreturn]] void fail(const std::string& what) const { file_.text.scanner().fail(what); }

 private:
  std::int32_t group_number(std::int64_t group) const {
    constexpr std::int64_t most_groups = 1'000'000;
    if (group < 1 || group > most_groups) {
      fail("the physical tag " + std::to_string(group) + " is out of range");
    }
    return static_cast<std::int32_t>(group);
  }

  MshFile& file_;
  std::array<std::vector<std::string>, 2> names_;
};

/// The content of a file that has the whole mesh.
class WholeMesh : public GroupedContent {
 public:
  WholeMesh(MshFile& file, const fs::path& scratch_folder)
      : GroupedContent(file),
        name_(file.text.name()),
        most_nodes_(fs::file_size(name_)),
        mesh_(scratch_folder) {}

  void add_node(std::int64_t tag, const Vec3& p) override {
    // A node takes some bytes: a tag above the size of the file leaves gaps.
    if (tag < 1 || static_cast<std::uintmax_t>(tag) > most_nodes_) {
      fail("node tags are not 1 to N: " + std::to_string(tag));
    }
    const auto number = static_cast<std::size_t>(tag - 1);
    if (number >= is_known_.size()) is_known_.resize(std::max(number + 1, 2 * is_known_.size()));
    if (is_known_[number]) {
      fail("two nodes have the tag " + std::to_string(tag));
    }
    is_known_[number] = true;
    ++nodes_;
    mesh_.set_node(tag - 1, p);
    file().text.pass();
  }
  void add_face(ElementType type, std::span<const std::int64_t> nodes,
                std::int32_t patch) override {
    mesh_.add_face(type, nodes, patch);
  }
  void add_cell(ElementType type, std::span<const std::int64_t> nodes, std::int32_t region,
                std::int32_t subdomain) override {
    mesh_.add_cell(type, nodes, region, subdomain);
    knows_subdomains_ = knows_subdomains_ || subdomain > 0;
  }
  ListedMesh take() {
    if (nodes_ != mesh_.nodes()) {
      throw InvalidInput("node tags are not 1 to N: " + std::to_string(nodes_) +
                             " nodes, but the largest tag is " + std::to_string(mesh_.nodes()),
                         name_);
    }
    mesh_.mesh().name = name_;
    mesh_.mesh().patch_names = patch_names();
    mesh_.mesh().region_names = region_names();
    mesh_.mesh().knows_subdomains = knows_subdomains_;
    return mesh_.take();
  }

 private:
  std::string name_;
  std::uintmax_t most_nodes_;
  ParsedMesh mesh_;
  std::vector<bool> is_known_;
  std::int64_t nodes_ = 0;
  bool knows_subdomains_ = false;
};

/// The content of a file that has a partition.
class PartitionOfMesh : public GroupedContent {
 public:
  using GroupedContent::GroupedContent;

  void add_node(std::int64_t tag, const Vec3& p) override {
    if (numbers_.of(tag - 1) != std::ssize(part_.nodes)) {
      fail("two nodes have the tag " + std::to_string(tag));
    }
    part_.nodes.push_back(p);
    file().text.pass();
  }
  void add_face(ElementType type, std::span<const std::int64_t> nodes,
                std::int32_t patch) override {
    if (type == ElementType::triangle) {
      part_.faces.push_back(local<3>(nodes));
      part_.patch_of_face.push_back(patch);
      return;
    }
    // The region is known when all cells are.
    add_to_block(part_.blocks[type], nodes, 1);
    part_.blocks[type].patches.push_back(patch);
  }
  void add_cell(ElementType type, std::span<const std::int64_t> nodes, std::int32_t region,
                std::int32_t) override {
    if (type == ElementType::tet) {
      part_.tets.push_back(local<4>(nodes));
      part_.region_of_tet.push_back(region);
    } else {
      add_to_block(part_.blocks[type], nodes, region);
    }
  }
  /// Without the nodes of ghosts where there are such.
  NumberedPart take() {
    part_.local2global = numbers_.take();
    if (file().walker.has_ghosts()) keep_own_nodes();
    set_regions_from_cells(part_);
    return std::move(part_);
  }

 private:
  std::int32_t local(std::int64_t node) const {
    const std::int32_t number = numbers_.find(node);
    if (number < 0) {
      fail("an element has the node " + std::to_string(node + 1) + ", which is not in the file");
    }
    return number;
  }
  template <std::size_t N>
  std::array<std::int32_t, N> local(std::span<const std::int64_t> nodes) const {
    std::array<std::int32_t, N> result;
    for (std::size_t k = 0; k < N; ++k) result[k] = local(nodes[k]);
    return result;
  }
  void add_to_block(ElementBlock& block, std::span<const std::int64_t> nodes,
                    std::int32_t region) const {
    for (const std::int64_t node : nodes) block.nodes.push_back(local(node));
    block.regions.push_back(region);
  }

  /// Calls visit(v) for each node of each element.
  template <class Visit>
  void for_each_use(const Visit& visit) {
    for (Tet& tet : part_.tets) {
      for (std::int32_t& v : tet) visit(v);
    }
    for (Triangle& face : part_.faces) {
      for (std::int32_t& v : face) visit(v);
    }
    for_each_block(part_.blocks, [&](ElementType, ElementBlock& block) {
      for (std::int32_t& v : block.nodes) visit(v);
    });
  }

  void keep_own_nodes() {
    std::vector<std::int32_t> new_number(part_.nodes.size(), -1);
    for_each_use([&](std::int32_t v) { new_number[static_cast<std::size_t>(v)] = 0; });
    std::size_t kept = 0;
    for (std::size_t v = 0; v < new_number.size(); ++v) {
      if (new_number[v] < 0) continue;
      new_number[v] = static_cast<std::int32_t>(kept);
      part_.nodes[kept] = part_.nodes[v];
      part_.local2global[kept] = part_.local2global[v];
      ++kept;
    }
    part_.nodes.resize(kept);
    part_.local2global.resize(kept);
    for_each_use([&](std::int32_t& v) { v = new_number[static_cast<std::size_t>(v)]; });
  }

  LocalNumbers numbers_;
  NumberedPart part_;
};

/// NAME_1.msh, NAME_2.msh, …: a partition each.
class SplitSource : public MeshSource {
 public:
  /// @throws IoError, InvalidInput: all are read once.
  explicit SplitSource(const fs::path& first) {
    const std::string stem = first.stem().string();
    const std::string name = stem.substr(0, stem.size() - 1);
    for (std::size_t i = 1;; ++i) {
      const fs::path file = first.parent_path() / (name + std::to_string(i) + ".msh");
      if (!fs::exists(file)) break;
      files_.push_back(file);
    }
    MshFile file(first);
    PartitionOfMesh head(file);
    file.walker.walk_head(head);
    names_ = {head.patch_names(), head.region_names()};
    for (std::size_t i = 0; i < files_.size(); ++i) read(i);
  }

  std::size_t size() const override { return files_.size(); }
  bool takes_threads() const override { return true; }
  NumberedPart part(std::size_t i) const override { return read(i); }
  std::vector<std::string> patch_names() const override { return names_[0]; }
  std::vector<std::string> region_names() const override { return names_[1]; }

 private:
  NumberedPart read(std::size_t i) const {
    MshFile file(files_.at(i));
    PartitionOfMesh partition(file);
    file.walker.walk(partition);
    NumberedPart part = partition.take();
    part.number = static_cast<std::int32_t>(i);
    return part;
  }

  std::vector<fs::path> files_;
  std::array<std::vector<std::string>, 2> names_;
};

}  // namespace

std::unique_ptr<MeshSource> open_msh(const fs::path& path, const fs::path& scratch_folder) {
  MshFile file(path);
  WholeMesh mesh(file, scratch_folder);
  file.walker.walk_head(mesh);
  if (file.walker.is_partitioned()) {
    if (path.stem().string().ends_with("_1")) return std::make_unique<SplitSource>(path);
    throw InvalidInput(
        "is one of several partitions; give the file whose name ends in _1, which stands for all",
        path.string());
  }
  file.walker.walk(mesh);
  return open_listed(mesh.take());
}

}  // namespace tetfarm
