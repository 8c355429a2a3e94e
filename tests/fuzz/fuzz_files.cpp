#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <string>

#include "base/check.h"
#include "base/error.h"
#include "base/hash.h"
#include "mesh/artifacts/artifact_file.h"
#include "mesh/artifacts/element_file.h"
#include "mesh/formats/flite/read_flite_sources.h"
#include "mesh/formats/gzip.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/job_file/job_file.h"
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

/// What is read must be written as it was read.
void read_surface_artifact(const std::string& bytes) {
  TF_CHECK(surface_to_bytes(surface_from_bytes(bytes, "surface")) == bytes);
}

using Read = void (*)(const std::string&);
const std::array<Read, 12> kinds = {
    [](const std::string& bytes) { read_surface_artifact(with_checksum_last(bytes)); },
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
};

}  // namespace

void job_file(std::string_view input) {
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
