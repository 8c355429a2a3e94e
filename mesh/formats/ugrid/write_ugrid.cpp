#include "mesh/formats/ugrid/write_ugrid.h"

#include <bit>
#include <cstring>
#include <limits>

#include "base/check.h"
#include "base/error.h"
#include "mesh/assemble/node_blocks.h"
#include "mesh/assemble/node_runs.h"
#include "mesh/assemble/output_file.h"

namespace tetfarm {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();

template <class Number>
void turn_bytes(std::string& bytes) {
  for (std::size_t i = 0; i < bytes.size(); i += sizeof(Number)) {
    if constexpr (sizeof(Number) == 8) {
      std::uint64_t bits;
      std::memcpy(&bits, bytes.data() + i, 8);
      bits = __builtin_bswap64(bits);
      std::memcpy(bytes.data() + i, &bits, 8);
    } else {
      std::uint32_t bits;
      std::memcpy(&bits, bytes.data() + i, 4);
      bits = __builtin_bswap32(bits);
      std::memcpy(bytes.data() + i, &bits, 4);
    }
  }
}

template <class Integer>
class UgridFile : public UgridWriter {
 public:
  UgridFile(const std::filesystem::path& path, const UgridCounts& counts, bool big_endian)
      : file_(path),
        big_endian_(big_endian),
        boundary_triangles_(counts.boundary_triangles),
        first_triangle_(header_bytes + counts.nodes * 24),
        first_quad_(first_triangle_ + counts.boundary_triangles * 3 * integer_bytes),
        first_patch_(first_quad_ + counts.others[ElementType::quad] * 4 * integer_bytes),
        first_tet_(first_patch_ +
                   (counts.boundary_triangles + counts.others[ElementType::quad]) * integer_bytes) {
    std::int64_t place = first_tet_ + counts.tets * 4 * integer_bytes;
    std::vector<Integer> head(7);
    head[0] = static_cast<Integer>(counts.nodes);
    head[code(ElementType::triangle)] = static_cast<Integer>(counts.boundary_triangles);
    head[code(ElementType::tet)] = static_cast<Integer>(counts.tets);
    for (const ElementType type : cell_block_types) {
      first_cell_[type] = place;
      place += counts.others[type] * static_cast<std::int64_t>(nodes_of(type)) * integer_bytes;
    }
    for_each_block(counts.others, [&](ElementType type, std::int64_t count) {
      if (count > 0) head[code(type)] = static_cast<Integer>(count);
    });
    write<Integer>(0, head);
  }

  void add_behind(const UgridCounts& before, const NumberedPart& part) override {
    for_each_node_run(part, [&](std::int64_t first, const std::vector<Vec3>& nodes) {
      write<double>(header_bytes + first * 24, nodes);
    });
    TF_CHECK(part.patch_of_face.size() == part.faces.size());
    TF_CHECK(part.local2global.size() == part.nodes.size());
    const auto number = [&](std::int32_t local) { return global_number(part, local); };
    std::vector<Integer> triangles;
    for (const auto& [a, b, c] : part.faces) {
      triangles.insert(triangles.end(), {number(a), number(c), number(b)});
    }
    std::vector<Integer> patches;
    for (const std::int32_t patch : part.patch_of_face) patches.push_back(patch + 1);
    write<Integer>(first_triangle_ + before.boundary_triangles * 3 * integer_bytes, triangles);
    write<Integer>(first_patch_ + before.boundary_triangles * integer_bytes, patches);
    add_quads(before, part);
    for (const ElementType type : cell_block_types) add_cells(type, before.others[type], part);
    std::int64_t place = first_tet_ + before.tets * 4 * integer_bytes;
    for_each_block_of_nodes<Integer>(part, 1, [&](const std::vector<Integer>& nodes) {
      write<Integer>(place, nodes);
      place += std::ssize(nodes) * integer_bytes;
    });
  }

  void finish() override { file_.finish(); }

 private:
  static constexpr std::int64_t integer_bytes = sizeof(Integer);
  static constexpr std::int64_t header_bytes = 7 * integer_bytes;

  static std::size_t code(ElementType type) {
    return static_cast<std::size_t>(code_of(ElementCodes::ugrid, type));
  }

  /// Turned round, their first node the same, and their patches behind those of the triangles.
  void add_quads(const UgridCounts& before, const NumberedPart& part) {
    const ElementBlock& block = part.blocks[ElementType::quad];
    if (block.empty()) return;
    TF_CHECK(block.patches.size() == block.size());
    std::vector<Integer> quads;
    std::vector<Integer> patches;
    for (std::size_t i = 0; i < block.size(); ++i) {
      const std::span<const std::int32_t> nodes = block.element(ElementType::quad, i);
      for (const std::size_t k : {0, 3, 2, 1}) quads.push_back(global_number(part, nodes[k]));
      patches.push_back(block.patches[i] + 1);
    }
    const std::int64_t first = before.others[ElementType::quad];
    write<Integer>(first_quad_ + first * 4 * integer_bytes, quads);
    write<Integer>(first_patch_ + (boundary_triangles_ + first) * integer_bytes, patches);
  }

  void add_cells(ElementType type, std::int64_t first, const NumberedPart& part) {
    const ElementBlock& block = part.blocks[type];
    if (block.empty()) return;
    std::vector<Integer> numbers;
    std::array<std::int32_t, most_element_nodes> theirs{};
    const std::span<std::int32_t> nodes(theirs.data(), nodes_of(type));
    for (std::size_t i = 0; i < block.size(); ++i) {
      put_in_order_of(ElementCodes::ugrid, type, block.element(type, i), nodes);
      for (const std::int32_t v : nodes) numbers.push_back(global_number(part, v));
    }
    write<Integer>(
        first_cell_[type] + first * static_cast<std::int64_t>(nodes_of(type)) * integer_bytes,
        numbers);
  }

  static Integer global_number(const NumberedPart& part, std::int32_t local) {
    return static_cast<Integer>(part.local2global[static_cast<std::size_t>(local)] + 1);
  }

  /// `Number` is what the values are made of.
  template <class Number, class T>
  void write(std::int64_t place, const std::vector<T>& values) {
    if (!big_endian_) {
      file_.write(place, values);
      return;
    }
    std::string bytes(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    turn_bytes<Number>(bytes);
    file_.write(place, bytes);
  }

  OutputFile file_;
  bool big_endian_;
  std::int64_t boundary_triangles_;
  std::int64_t first_triangle_;
  std::int64_t first_quad_;
  std::int64_t first_patch_;
  std::int64_t first_tet_;
  ByType<std::int64_t> first_cell_;
};

}  // namespace

void UgridWriter::add(const NumberedPart& part) {
  add_behind(before_, part);
  before_.boundary_triangles += std::ssize(part.faces);
  before_.tets += std::ssize(part.tets);
  for_each_block(part.blocks, [this](ElementType type, const ElementBlock& block) {
    before_.others[type] += std::ssize(block.regions);
  });
}

std::unique_ptr<UgridWriter> write_ugrid(const std::filesystem::path& path,
                                         const UgridCounts& counts, UgridLayout layout) {
  if (layout.wide) {
    return std::make_unique<UgridFile<std::int64_t>>(path, counts, layout.big_endian);
  }
  bool is_too_large = counts.nodes > most || counts.tets > most || counts.boundary_triangles > most;
  for_each_block(counts.others, [&](ElementType, std::int64_t count) {
    is_too_large = is_too_large || count > most;
  });
  if (is_too_large) {
    throw Error(
        ExitCode::failed,
        "the mesh is too large for 32-bit UGRID, whose counts end at 2147483647: " +
            std::to_string(counts.nodes) + " nodes, " + std::to_string(counts.tets) + " tets, " +
            std::to_string(counts.boundary_triangles) +
            " boundary triangles; write vtkhdf instead, then lb8l.ugrid with `tetfarm export`");
  }
  return std::make_unique<UgridFile<std::int32_t>>(path, counts, layout.big_endian);
}

std::unique_ptr<GlobalMeshWriter> write_ugrid(const std::filesystem::path& path,
                                              const Numbering& numbering,
                                              std::int64_t boundary_triangles) {
  return write_ugrid(path, {numbering.nodes, boundary_triangles, numbering.tets, numbering.others},
                     {});
}

}  // namespace tetfarm
