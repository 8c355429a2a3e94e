#include "worker/assemble_task.h"

#include <memory>
#include <optional>
#include <utility>

#include "base/error.h"
#include "mesh/assemble/forced_dihedral.h"
#include "mesh/assemble/global_mesh.h"
#include "mesh/assemble/write_ugrid.h"
#include "mesh/assemble/write_vtkhdf.h"
#include "mesh/io/artifact_file.h"
#include "mesh/io/job_file.h"
#include "worker/part_after_cosmetics.h"

namespace tetfarm {
namespace {

/// A file in the making: its name in the result, where it grows, and who writes it.
struct GrowingFile {
  std::string name;
  std::filesystem::path path;
  std::unique_ptr<GlobalMeshWriter> writer;
};

GrowingFile start_file(TaskIo& io, const std::string& format, const JobFile& job,
                       const SurfaceMesh& surface, const Numbering& numbering) {
  GrowingFile file;
  file.name = job.name + "." + format;
  file.path = io.store().scratch_path(file.name);
  if (format == "vtkhdf") {
    file.writer = write_vtkhdf(file.path, surface.patch_names);
  } else if (format == "lb8.ugrid") {
    file.writer =
        write_ugrid(file.path, numbering, static_cast<std::int64_t>(surface.triangles.size()));
    io.publish(job.name + ".mapbc", mapbc_text(surface.patch_names));
  } else {
    throw UsageError("unknown format \"" + format + "\"; known are vtkhdf, lb8.ugrid",
                     "[output] formats");
  }
  return file;
}

MeshPart read_part(TaskIo& io, const LeafNumbers& leaf) {
  const std::string heap = std::to_string(leaf.path.heap);
  MeshPart part;
  part.subdomain = subdomain_from_bytes(io.read("subdomain:" + heap), "subdomain:" + heap);
  part.mesh = tet_mesh_from_bytes(io.read("mesh:" + heap), part.subdomain, "mesh:" + heap);
  return part;
}

void report_place(TaskIo& io, const std::string& what, const Vec3& at) {
  io.number(what + "_x", at.x);
  io.number(what + "_y", at.y);
  io.number(what + "_z", at.z);
}

void report(TaskIo& io, const GlobalMeshSummary& summary, const SurfaceMesh& surface,
            const JobFile& job) {
  io.number("elements", static_cast<double>(summary.tets));
  io.number("nodes", static_cast<double>(summary.nodes));
  io.number("boundary_triangles", static_cast<double>(summary.boundary_triangles));
  io.number("subdomains", static_cast<double>(summary.subdomains));
  io.number("min_dihedral_deg", summary.shapes.min_dihedral_deg);
  io.number("max_dihedral_deg", summary.shapes.max_dihedral_deg);
  io.number("mean_radius_ratio", summary.shapes.mean_radius_ratio());
  io.number("volume", summary.volume);
  io.number("min_dihedral_gate_deg", job.min_dihedral_deg);
  report_place(io, "worst", summary.shapes.worst_centroid);
  // Of the whole surface, however it was cut.
  const ForcedDihedral forced = forced_dihedral(surface.vertices, surface.triangles);
  io.number("forced_dihedral_deg", forced.at_most_deg);
  report_place(io, "forced", forced.at);
  io.text("digest", summary.digest.hex());
}

}  // namespace

void assemble_task(TaskIo& io) {
  const JobFile job = parse_job_file(io.read("job"), "job.toml");
  const SurfaceMesh surface = surface_from_bytes(io.read("surface"), "surface");
  const Numbering numbering = numbering_from_text(io.read("numbering"), "numbering");
  std::vector<GrowingFile> files;
  std::vector<GlobalMeshWriter*> writers;
  for (const std::string& format : job.formats) {
    files.push_back(start_file(io, format, job, surface, numbering));
    writers.push_back(files.back().writer.get());
  }
  std::optional<Colours> colours;
  if (io.has_parameter("order")) colours = colours_of(io.parameter("order"));
  std::int64_t tets = 0;
  const auto read = [&](const LeafNumbers& leaf) {
    tets += leaf.tets;
    io.progress("assemble", tets);
    return colours ? part_after_cosmetics(io, leaf.path, *colours) : read_part(io, leaf);
  };
  const GlobalMeshSummary summary = assemble_global_mesh(surface, numbering, read, writers);
  for (GrowingFile& file : files) {
    file.writer.reset();
    io.publish_file(file.name, file.path);
  }
  report(io, summary, surface, job);
}

}  // namespace tetfarm
