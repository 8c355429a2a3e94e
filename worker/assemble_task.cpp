#include "worker/assemble_task.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/error.h"
#include "base/job_name.h"
#include "mesh/artifacts/surface_file.h"
#include "mesh/assemble/forced_dihedral.h"
#include "mesh/assemble/global_mesh.h"
#include "mesh/assemble/numbering_file.h"
#include "mesh/assemble/shared_feet.h"
#include "mesh/formats/patch_boxes.h"
#include "mesh/formats/ugrid/mapbc.h"
#include "mesh/formats/ugrid/write_ugrid.h"
#include "mesh/inspect/small_angles.h"
#include "mesh/job_file/job_file.h"
#include "mesh/job_file/job_formats.h"
#include "tasks/assemble_contract.h"
#include "worker/job_layers.h"
#include "worker/job_patch_types.h"
#include "worker/job_pml.h"
#include "worker/shared_mesh_file.h"
#include "worker/task_cost.h"

namespace tetfarm {
namespace {

Portion read_portion(const TaskIo& io, const AssembleGiven& given, const LeafNumbers& leaf) {
  return io.read(file_of_leaf(given.portions, leaf.path.heap), portion_from_bytes);
}

void read_cells(const TaskIo& io, const AssembleGiven& given, const LeafNumbers& leaf,
                Portion& portion) {
  const TaskFile& cells = file_of_leaf(given.tets, leaf.path.heap);
  add_portion_cells(io.read(cells), io.name_of(cells), portion);
}

PortionCounts counts_of(const TaskIo& io, const AssembleGiven& given, const LeafNumbers& leaf) {
  const TaskFile& file = file_of_leaf(given.portions, leaf.path.heap);
  return io.look_into(file, [&](const std::filesystem::path& path) {
    return portion_counts(path, io.name_of(file));
  });
}

std::vector<VtkhdfCounts> counts_of(const TaskIo& io, const AssembleGiven& given,
                                    const Numbering& numbering) {
  std::vector<VtkhdfCounts> counts;
  for (const LeafNumbers& leaf : numbering.leaves) {
    const PortionCounts portion = counts_of(io, given, leaf);
    counts.push_back({portion.nodes, portion.tets, portion.faces, portion.others});
  }
  return counts;
}

/// Chunks of layers come last, and their nodes are in the sub-domains before as well.
SharedFeet shared_feet_of(const TaskIo& io, const AssembleGiven& given,
                          const Numbering& numbering) {
  TF_CHECK(!numbering.leaves.empty());
  SharedFeet feet(numbering.leaves.front().nodes.first_node);
  for (const LeafNumbers& leaf : numbering.leaves) {
    if (counts_of(io, given, leaf).has_feet) feet.add(read_portion(io, given, leaf).part);
  }
  feet.finish();
  return feet;
}

/// The files of the result in the making.
class ResultFiles {
 public:
  ResultFiles(TaskIo& io, const AssembleGiven& given, const JobFile& job,
              const SurfaceMesh& surface, const Numbering& numbering)
      : io_(io), given_(given), job_(job), surface_(surface), numbering_(numbering) {
    for (const std::string& format : formats_of_tasks(job.formats)) start(format);
  }

  std::vector<GlobalMeshWriter*> writers() const {
    std::vector<GlobalMeshWriter*> all;
    if (vtkhdf_) all.push_back(vtkhdf_.get());
    if (ugrid_) all.push_back(ugrid_.get());
    return all;
  }

  /// With its cells where a file still needs them.
  Portion read(const LeafNumbers& leaf) {
    Portion portion = read_portion(io_, given_, leaf);
    const bool is_placed =
        vtkhdf_ && !io_.is_without_shared_store() &&
        vtkhdf_->takes(static_cast<std::size_t>(portion.part.number), portion.placed);
    if (!is_placed || ugrid_) read_cells(io_, given_, leaf, portion);
    NumberedPart& part = portion.part;
    if (shared_feet_ && part.feet.empty()) part.feet = shared_feet_->of(part.local2global);
    return portion;
  }

  void publish() {
    if (vtkhdf_) {
      const ReadThrough& finished = vtkhdf_->finished();
      io_.publish_checked_file(file_name_of_job(job_.name, ".vtkhdf"), shared_file().path,
                               {finished.hash.hex(), static_cast<std::uint64_t>(finished.size)});
    }
    if (ugrid_) io_.publish_file(file_name_of_job(job_.name, ".lb8.ugrid"), ugrid_path_);
  }

 private:
  SharedFile shared_file() const { return shared_mesh_file(io_, given_.surface, given_.numbering); }

  void start(const std::string& format) {
    if (format == "vtkhdf") {
      if (has_feet(job_)) shared_feet_ = shared_feet_of(io_, given_, numbering_);
      vtkhdf_ = std::make_unique<SharedVtkhdf>(
          shared_file(), counts_of(io_, given_, numbering_),
          names_of_file(job_, surface_.patch_names, surface_.region_names), [this](std::size_t i) {
            const LeafNumbers& leaf = numbering_.leaves.at(i);
            Portion portion = read_portion(io_, given_, leaf);
            read_cells(io_, given_, leaf, portion);
            return std::move(portion.part);
          });
    } else {
      ugrid_path_ = io_.scratch_path("mesh." + format);
      ugrid_ = write_ugrid(ugrid_path_, numbering_, meshed_sides(surface_));
      const std::vector<PatchType> types = patch_types_of(job_, surface_.patch_names);
      io_.publish(file_name_of_job(job_.name, ".mapbc"),
                  mapbc_text(surface_.patch_names, types,
                             wants_boxes(types) ? patch_boxes(surface_) : std::vector<Box3>()));
    }
  }

  TaskIo& io_;
  const AssembleGiven& given_;
  const JobFile& job_;
  const SurfaceMesh& surface_;
  const Numbering& numbering_;
  std::optional<SharedFeet> shared_feet_;  // where they are written
  std::unique_ptr<SharedVtkhdf> vtkhdf_;
  std::filesystem::path ugrid_path_;
  std::unique_ptr<GlobalMeshWriter> ugrid_;
};

/// Elements are counted by now; the model takes estimated ones.
TaskCost cost_of(const SurfaceMesh& surface, const Numbering& numbering) {
  SubdomainSize largest;
  for (const LeafNumbers& leaf : numbering.leaves) {
    largest.elements =
        std::max(largest.elements, static_cast<double>(leaf.tets + count_cells(leaf.others)));
  }
  return assemble_cost(static_cast<double>(surface.triangles.size()),
                       static_cast<double>(numbering.tets + count_cells(numbering.others)),
                       largest);
}

void report_place(TaskIo& io, const std::string& what, const Vec3& at) {
  io.number(what + "_x", at.x);
  io.number(what + "_y", at.y);
  io.number(what + "_z", at.z);
}

void report_shapes(TaskIo& io, const std::string& whose, const ShapeStatistics& shapes) {
  io.number(whose + "elements", static_cast<double>(shapes.tets));
  io.number(whose + "min_dihedral_deg", shapes.min_dihedral_deg);
  io.number(whose + "max_dihedral_deg", shapes.max_dihedral_deg);
  io.number(whose + "mean_radius_ratio", shapes.mean_radius_ratio());
  io.number(whose + "smallest_height", shapes.smallest_height);
  std::string histogram;
  for (const std::int64_t count : shapes.dihedral_histogram) {
    histogram += (histogram.empty() ? "" : " ") + std::to_string(count);
  }
  io.text(whose + "dihedral_histogram", histogram);
}

/// "region_1_elements", "region_1_name"…
void report_regions(TaskIo& io, const MeshShapes& shapes, const std::vector<std::string>& names) {
  TF_CHECK(names.size() >= shapes.regions.size());
  for (std::size_t i = 0; i < shapes.regions.size(); ++i) {
    const std::string whose = "region_" + std::to_string(i + 1) + "_";
    report_shapes(io, whose, shapes.regions[i].shapes);
    io.number(whose + "volume", shapes.regions[i].volume);
    io.text(whose + "name", names[i]);
  }
}

/// Which cells of a .lb8.ugrid are of which region: the format has no place for it, but those of a
/// region follow one another. A line each: number, first cell, last cell (from 1), name.
std::string regions_text(const GlobalMeshSummary& summary, const std::vector<std::string>& names) {
  const MeshShapes& shapes = summary.shapes;
  TF_CHECK(names.size() >= shapes.regions.size());
  if (shapes.regions.size() == 1) {
    const std::int64_t cells = summary.tets + count_cells(summary.others);
    return "1 1 " + std::to_string(cells) + ' ' + names.front() + '\n';
  }
  TF_CHECK(count_cells(summary.others) == 0);  // layers grow in one region
  std::string text;
  std::int64_t last = 0;
  for (std::size_t i = 0; i < shapes.regions.size(); ++i) {
    const std::int64_t first = last + 1;
    last += shapes.regions[i].shapes.tets;
    text += std::to_string(i + 1) + ' ' + std::to_string(first) + ' ' + std::to_string(last) + ' ' +
            names[i] + '\n';
  }
  return text;
}

/// Of a mesh with layers. Its figures of shape are of the tets beyond them.
void report_cells(TaskIo& io, const GlobalMeshSummary& summary) {
  const bool has_layers =
      summary.others != ElementCounts{} || summary.tets != summary.shapes.all.tets;
  if (!has_layers) return;
  io.number("elements", static_cast<double>(summary.tets + count_cells(summary.others)));
  io.number("tets", static_cast<double>(summary.tets));
  for (const ElementType type : layer_types) {
    if (!is_cell(type) && summary.others[type] == 0) continue;
    io.number(std::string(element(type).plural), static_cast<double>(summary.others[type]));
  }
}

/// The triangles of the surface beside layers that run in planes: as thin as the layers, and none
/// that another surface would not have.
class LayerSides {
 public:
  /// @pre the surface is that of a job that could be planned.
  LayerSides(const JobFile& job, const SurfaceMesh& surface) : surface_(surface) {
    if (job.layers.empty() && !has_pml_blocks(job)) return;
    are_sides_.assign(surface.triangles.size(), false);
    for (const LayerRequest& request : layer_requests_of(job, surface)) {
      walls_.insert(request.patches.begin(), request.patches.end());
    }
    if (!job.pml) return;
    const std::vector<std::int32_t> outer = pml_patches_of(job, surface);
    walls_.insert(outer.begin(), outer.end());
  }

  /// Those that the leaf has, where it is of layers: then its figures of shape are of no tet.
  void add(const Portion& portion) {
    if (are_sides_.empty() || portion.shapes.all.tets > 0) return;
    for (const std::uint32_t t : portion.surface_triangles) {
      if (!walls_.contains(patch_of(surface_, t))) are_sides_[t] = true;
    }
  }

  /// Of each triangle of the surface; empty of a job whose layers have no sides.
  const std::vector<bool>& are_sides() const { return are_sides_; }

 private:
  const SurfaceMesh& surface_;
  std::set<std::int32_t> walls_;  // patches
  std::vector<bool> are_sides_;
};

/// Which angles the surface forces, of the whole of it, however it was cut. Sides of layers are
/// thin because the job says so.
void report_forcing(TaskIo& io, const SurfaceMesh& surface, const LayerSides& sides) {
  const ForcedDihedral forced = forced_dihedral(surface);
  io.number("forced_dihedral_deg", forced.at_most_deg);
  report_place(io, "forced", forced.at);
  const SmallAngles small = small_angles(surface, sides.are_sides());
  io.number("surface_triangles", static_cast<double>(small.triangles));
  io.number("surface_smallest_angle_deg", small.smallest_deg);
  io.number("surface_triangles_below_1_deg", static_cast<double>(small.below_1_deg));
  io.number("surface_triangles_below_5_deg", static_cast<double>(small.below_5_deg));
  for (std::size_t i = 0; i < small.worst.size(); ++i) {
    const std::string which = "surface_worst_" + std::to_string(i + 1);
    io.number(which + "_triangle", static_cast<double>(small.worst[i].triangle));
    io.number(which + "_angle_deg", small.worst[i].angle_deg);
    report_place(io, which, small.worst[i].at);
    io.text(which + "_patch", small.worst[i].patch);
  }
}

void report(TaskIo& io, const GlobalMeshSummary& summary, const SurfaceMesh& surface,
            const LayerSides& sides, const JobFile& job) {
  io.number("nodes", static_cast<double>(summary.nodes));
  io.number("boundary_triangles", static_cast<double>(summary.boundary_triangles));
  io.number("subdomains", static_cast<double>(summary.subdomains));
  report_shapes(io, "", summary.shapes.all);
  report_cells(io, summary);
  if (summary.shapes.near_cuts.tets > 0) {
    report_shapes(io, "near_cuts_", summary.shapes.near_cuts);
    report_shapes(io, "away_from_cuts_", summary.shapes.away_from_cuts);
  }
  io.number("volume", summary.volume);
  io.number("min_dihedral_gate_deg", job.min_dihedral_deg);
  report_place(io, "worst", summary.shapes.all.worst_centroid);
  io.number("min_unforced_dihedral_gate_deg", job.min_unforced_dihedral_deg);
  report_forcing(io, surface, sides);
  io.text("digest", summary.digest.hex());
  std::string converted;
  for (const std::string& format : formats_to_convert(job.formats)) {
    converted += (converted.empty() ? "" : ",") + format;
  }
  if (!converted.empty()) io.text("formats_to_convert", converted);
}

}  // namespace

void assemble_task(TaskIo& io) {
  const auto given = io.given<AssembleGiven>();
  const JobFile job = parse_job_file(io.read(given.job), "job.toml");
  const SurfaceMesh surface = io.read(given.surface, surface_from_bytes);
  const Numbering numbering = io.read(given.numbering, numbering_from_bytes);
  report_cost(io, cost_of(surface, numbering));
  LayerSides sides(job, surface);
  ResultFiles files(io, given, job, surface, numbering);
  io.progress().begin(WorkStage::assemble, numbering.leaves.size());
  const auto read = [&](const LeafNumbers& leaf) {
    io.progress().add();
    Portion portion = files.read(leaf);
    sides.add(portion);
    return portion;
  };
  const GlobalMeshSummary summary = assemble_global_mesh(surface, numbering, read, files.writers());
  files.publish();
  report(io, summary, surface, sides, job);
  if (given.layer_map) {
    io.publish(file_name_of_job(job.name, ".layers.vtp"), io.read(*given.layer_map));
  }
  if (surface.region_names.empty()) return;
  report_regions(io, summary.shapes, surface.region_names);
  if (std::find(job.formats.begin(), job.formats.end(), "lb8.ugrid") != job.formats.end()) {
    io.publish(file_name_of_job(job.name, ".regions"), regions_text(summary, surface.region_names));
  }
}

}  // namespace tetfarm
