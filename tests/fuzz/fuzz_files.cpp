#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <span>
#include <string>

#include "base/check.h"
#include "base/error.h"
#include "base/hash.h"
#include "mesh/artifacts/artifact_file.h"
#include "mesh/artifacts/element_file.h"
#include "mesh/artifacts/surface_file.h"
#include "mesh/assemble/numbering_file.h"
#include "mesh/formats/flite/read_flite_sources.h"
#include "mesh/formats/gzip.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/job_file/job_file.h"
#include "mesh/job_file/plane_sources.h"
#include "mesh/layers/layer_chunk_file.h"
#include "mesh/layers/layer_growth.h"
#include "mesh/spacing/spacing_field.h"
#include "proto/authorized_keys.h"
#include "tests/fuzz/fuzz_targets.h"

namespace tetfarm::fuzz {
namespace {

constexpr std::size_t spacing_checksum_at = 8;
constexpr std::size_t spacing_checked_from = 24;
constexpr std::size_t head_size_at = 12;
constexpr std::size_t head_checksum_at = 20;
constexpr std::size_t head_at = 36;

void put(std::string& bytes, std::size_t at, std::uint64_t first, std::uint64_t second) {
  if (bytes.size() < at + 16) return;
  std::memcpy(bytes.data() + at, &first, 8);
  std::memcpy(bytes.data() + at + 8, &second, 8);
}

/// Files whose last 16 bytes are the checksum of all before.
std::string with_checksum_last(std::string bytes) {
  const Hash128 checksum = hash128(bytes);
  bytes.resize(bytes.size() + 16);
  put(bytes, bytes.size() - 16, checksum.low, checksum.high);
  return bytes;
}

std::string with_spacing_checksum(std::string bytes) {
  if (bytes.size() < spacing_checked_from) return bytes;
  const Hash128 checksum = hash128(std::string_view(bytes).substr(spacing_checked_from));
  put(bytes, spacing_checksum_at, checksum.high, checksum.low);
  return bytes;
}

/// Elements: the head's checksum; those of the sections are in the head, for the fuzzer to keep.
std::string with_head_checksum(std::string bytes) {
  if (bytes.size() < head_at) return bytes;
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data() + head_size_at, sizeof size);
  const Hash128 checksum = hash128(std::string_view(bytes).substr(head_at, size));
  put(bytes, head_checksum_at, checksum.low, checksum.high);
  return bytes;
}

/// A file in memory with a path.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& bytes) : descriptor_(::memfd_create("fuzz", 0)) {
    TF_CHECK(descriptor_ >= 0);
    TF_CHECK(::write(descriptor_, bytes.data(), bytes.size()) ==
             static_cast<ssize_t>(bytes.size()));
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

void read_elements(const std::string& bytes) {
  const MemoryFile memory(bytes);
  ElementFile file(memory.path(), "elements");
  const auto& sections = file.head().sections;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (i == 0 && sections[i].sharers.size() == 1) {
      file.read_core();
    } else {
      file.read(i);
    }
  }
}

/// A mesh is read with its sub-domain: here one of four nodes.
void read_tets(const std::string& bytes) {
  Subdomain subdomain;
  subdomain.vertices.resize(4);
  tet_mesh_from_bytes(bytes, subdomain, "mesh");
}

/// What is read must be written as it was read, and pieces of it must be what the whole has there.
/// Of one block the checksum is that of a surface without blocks, too.
void read_surface_artifact(const std::string& bytes) {
  const SurfaceMesh surface = surface_from_bytes(bytes, "surface");
  const std::string again = surface_to_bytes(surface);
  TF_CHECK(again == bytes || is_surface_without_blocks(bytes));
  const MemoryFile memory(again);
  SurfaceFile file(memory.path(), "surface");
  WantedPieces wanted;
  for (std::uint32_t v = 0; v < surface.vertices.size(); ++v) wanted.vertices.push_back(v);
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) wanted.triangles.push_back(t);
  const SurfacePieces pieces = file.read(wanted);
  TF_CHECK(pieces.vertices.size() == surface.vertices.size());
  TF_CHECK(pieces.triangles == surface.triangles);
}

/// Another leaf may be there where this one is refused.
void ask_leaf(NumberingFile& file, std::uint64_t heap) {
  const std::array<Origin, 6> nodes = {{{0, 0}, {0, 5}, {1, 0}, {1, 4}, {heap, 1}, {heap, 3}}};
  for (const Origin& node : nodes) {
    try {
      const LeafNumbering leaf = file.leaf({TreePath{heap}, 1, std::span(&node, 1)});
      TF_CHECK(leaf.node_numbers.size() == 1 && leaf.kept_nodes >= 0);
    } catch (const Error&) {
      continue;
    }
  }
}

/// First as a leaf reads it, which sees less and must stand more.
void read_numbering(const std::string& bytes) {
  if (!is_numbering_text(bytes)) {
    const MemoryFile memory(bytes);
    NumberingFile file(memory.path(), "numbering");
    for (const std::uint64_t heap : {1U, 2U, 3U, 5U}) ask_leaf(file, heap);
  }
  const Numbering numbering = numbering_from_bytes(bytes, "numbering");
  const std::string again = numbering_to_bytes(numbering);
  TF_CHECK(again == bytes || is_numbering_text(bytes));
}

/// Surfaces and numberings, and the text that a numbering was before it had blocks.
void read_file_in_blocks(const std::string& bytes) {
  if (is_numbering_text(bytes)) {
    read_numbering(bytes);
  } else if (bytes.starts_with("TFNUMB")) {
    read_numbering(with_block_checksums(bytes));
  } else {
    read_surface_artifact(with_block_checksums(bytes));
  }
}

/// What is read must be written as it was read, but in no later version than it takes, and grow
/// what it counts.
void read_layer_chunk(const std::string& bytes) {
  const LayerChunk chunk = layer_chunk_from_bytes(bytes, "layers");
  const std::string again = layer_chunk_to_bytes(chunk);
  TF_CHECK(again == bytes || again.size() < bytes.size());
  TF_CHECK(layer_chunk_from_bytes(again, "layers") == chunk);
  const GrownLayers layers = grow(chunk);
  const ChunkCounts counts = counts_of(chunk);
  TF_CHECK(std::ssize(layers.mesh.tets) == counts.tets);
  TF_CHECK(std::ssize(layers.blocks[ElementType::quad].regions) == counts.quads);
}

using Read = void (*)(const std::string&);
const std::array<Read, 13> kinds = {
    [](const std::string& bytes) { read_file_in_blocks(bytes); },
    [](const std::string& bytes) { subdomain_from_bytes(with_checksum_last(bytes), "subdomain"); },
    [](const std::string& bytes) { read_tets(with_checksum_last(bytes)); },
    [](const std::string& bytes) { shared_nodes_from_bytes(with_checksum_last(bytes), "shared"); },
    [](const std::string& bytes) {
      SpacingField::from_bytes(with_spacing_checksum(bytes), "spacing");
    },
    [](const std::string& bytes) { read_elements(with_head_checksum(bytes)); },
    [](const std::string& bytes) { read_surface_bytes(bytes, "a.stl"); },
    [](const std::string& bytes) { read_surface_bytes(bytes, "a.obj"); },
    [](const std::string& bytes) { read_surface_bytes(bytes, "a.off"); },
    [](const std::string& bytes) { read_surface_bytes(bytes, "a.msh"); },
    [](const std::string& bytes) { unpack_gzip(bytes, "a.gz"); },
    [](const std::string& bytes) { parse_authorized_keys(bytes); },
    [](const std::string& bytes) { read_layer_chunk(with_checksum_last(bytes)); },
};

/// The same text as a file of sources of the plane.
void plane_sources(std::string_view input) {
  try {
    const PlaneSources written = parse_plane_sources(input, "/job/sources.toml");
    const std::string canonical = to_toml(written.sources);
    TF_CHECK(to_toml(parse_plane_sources(canonical, "/job/sources.toml").sources) == canonical);
  } catch (const UsageError&) {
    return;
  }
}

}  // namespace

void job_file(std::string_view input) {
  plane_sources(input);
  try {
    const JobFile job = parse_job_file(input, "/job/job.toml");
    const std::string canonical = to_toml(job);
    TF_CHECK(to_toml(parse_job_file(canonical, "/job/job.toml")) == canonical);
  } catch (const UsageError&) {
    return;
  }
}

void surface(std::string_view input) {
  constexpr std::array<const char*, 17> names = {
      "a.ply",      "a.ugrid",     "a.b8.ugrid", "a.lb8.ugrid", "a.b8l.ugrid", "a.lb8l.ugrid",
      "a.b4.ugrid", "a.lb4.ugrid", "a.su2",      "a.mesh",      "a.meshb",     "a.poly",
      "a.smesh",    "a.fro",       "a.stl",      "a.obj",       "a.msh"};
  if (input.empty()) return;
  const auto kind = static_cast<unsigned char>(input.front()) % names.size();
  try {
    const SurfaceMesh surface = read_surface_bytes(input.substr(1), names.at(kind));
    TF_CHECK(surface.patch_of_triangle.size() == surface.triangles.size());
    for (const Triangle& triangle : surface.triangles) {
      for (const std::int32_t v : triangle) {
        TF_CHECK(v >= 0 && static_cast<std::size_t>(v) < surface.vertices.size());
      }
    }
    for (const std::int32_t patch : surface.patch_of_triangle) {
      TF_CHECK(static_cast<std::size_t>(patch) < surface.patch_names.size());
    }
  } catch (const Error&) {
    return;
  }
}

void flite_sources(std::string_view input) {
  try {
    JobFile job;
    job.name = "job";
    job.surface = "/job/a.stl";
    job.sources = read_flite_sources(input, "a.ba3").sources;
    const std::string canonical = to_toml(job);
    TF_CHECK(to_toml(parse_job_file(canonical, "/job/job.toml")) == canonical);
  } catch (const InvalidInput&) {
    return;
  }
}

void artifact(std::string_view input) {
  if (input.empty()) return;
  const auto kind = static_cast<unsigned char>(input.front()) % kinds.size();
  try {
    kinds.at(kind)(std::string(input.substr(1)));
  } catch (const Error&) {
    return;
  }
}

}  // namespace tetfarm::fuzz
