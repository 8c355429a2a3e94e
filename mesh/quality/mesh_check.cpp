#include "mesh/quality/mesh_check.h"

#include <algorithm>
#include <cmath>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/element_block.h"
#include "mesh/core/signed_volume.h"

namespace tetfarm {
namespace {

using std::to_string;

template <std::size_t N>
std::array<std::int64_t, N> global_nodes(const std::array<std::int32_t, N>& local,
                                         const NumberedPart& part) {
  std::array<std::int64_t, N> global;
  for (std::size_t i = 0; i < N; ++i) global[i] = part.local2global[at(local[i])];
  return global;
}

std::string text_of(const std::array<std::int64_t, 4>& nodes) {
  return "(" + to_string(nodes[0]) + ", " + to_string(nodes[1]) + ", " + to_string(nodes[2]) +
         ", " + to_string(nodes[3]) + ")";
}

bool is_finite(const Vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace

MeshCheck::MeshCheck(const MeshSource& source, const MeshCheckOptions& options)
    : source_(source),
      nodes_(source, options.folder, options.memory_bytes / 8),
      angles_(options.folder, options.memory_bytes / 8) {
  if (options.faces) faces_.emplace(options.folder, options.memory_bytes * 3 / 4);
}

std::string MeshCheck::where(const NumberedPart& part) const {
  return source_.knows_subdomains() ? " of sub-domain " + to_string(part.number) : "";
}

void MeshCheck::add(const NumberedPart& part) {
  nodes_.add(part, [this](std::int64_t number, const Vec3& p) {
    digest_.add_node(number, p);
    if (!is_finite(p)) complaints_.add("node " + to_string(number) + " is not finite");
  });
  add_tets(part);
  add_faces(part);
  if (faces_) faces_->add(part);
}

void MeshCheck::add_tets(const NumberedPart& part) {
  TF_CHECK(part.local2global.size() == part.nodes.size());
  std::vector<bool> is_used(part.nodes.size(), false);
  for (const Tet& tet : part.tets) {
    const auto p = [&](std::size_t i) -> const Vec3& { return part.nodes[at(tet[i])]; };
    for (const std::int32_t v : tet) is_used[at(v)] = true;
    const std::array<std::int64_t, 4> nodes = global_nodes(tet, part);
    digest_.add_tet(tets_, nodes);
    const long double volume = signed_volume(p(0), p(1), p(2), p(3));
    volume_ += volume;
    if (!(volume > 0) && !has_positive_volume(p(0), p(1), p(2), p(3))) {
      complaints_.add("tet " + to_string(tets_) + where(part) + ", nodes " + text_of(nodes) +
                      " at " + tetfarm::text_of(0.25 * (p(0) + p(1) + p(2) + p(3))) +
                      ", has the volume " + tetfarm::text_of(static_cast<double>(volume)));
    }
    ++tets_;
  }
  add_other_cells(part, is_used);
  complain_of_unused(part, is_used);
}

/// Numbered within their type.
void MeshCheck::add_other_cells(const NumberedPart& part, std::vector<bool>& is_used) {
  std::vector<std::int64_t> global;
  std::vector<Vec3> corners;
  for_each_block_cell(
      part.blocks, [&](ElementType type, std::span<const std::int32_t> nodes, std::int32_t) {
        global.clear();
        corners.clear();
        Vec3 sum;
        for (const std::int32_t v : nodes) {
          is_used[at(v)] = true;
          global.push_back(part.local2global[at(v)]);
          corners.push_back(part.nodes[at(v)]);
          sum += part.nodes[at(v)];
        }
        const std::int64_t number = others_[type]++;
        digest_.add_other(type, number, global);
        const long double volume = element_volume(type, corners);
        volume_ += volume;
        const double jacobian = scaled_jacobian(type, corners);
        if (volume > 0 && jacobian > 0) return;
        complaints_.add(std::string(element(type).name) + " " + to_string(number) + where(part) +
                        ", at " + tetfarm::text_of(sum / static_cast<double>(nodes.size())) +
                        ", has the volume " + tetfarm::text_of(static_cast<double>(volume)) +
                        " and the scaled Jacobian " + tetfarm::text_of(jacobian));
      });
}

void MeshCheck::complain_of_unused(const NumberedPart& part, const std::vector<bool>& is_used) {
  const auto unused = std::find(is_used.begin(), is_used.end(), false);
  if (unused == is_used.end()) return;
  const auto v = static_cast<std::size_t>(unused - is_used.begin());
  complaints_.add("node " + to_string(part.local2global[v]) + " at " +
                  tetfarm::text_of(part.nodes[v]) + " is in no tet" + where(part) +
                  "; such nodes: " + to_string(std::count(is_used.begin(), is_used.end(), false)));
}

void MeshCheck::add_faces(const NumberedPart& part) {
  if (!origin_ && !part.nodes.empty()) origin_ = part.nodes.front();
  TF_CHECK(part.patch_of_face.size() == part.faces.size());
  TF_CHECK(origin_ || part.faces.empty());
  for (std::size_t i = 0; i < part.faces.size(); ++i) {
    const Triangle& face = part.faces[i];
    digest_.add_boundary_triangle(global_nodes(face, part), part.patch_of_face[i]);
    enclosed_ += signed_volume(*origin_, part.nodes[at(face[0])], part.nodes[at(face[1])],
                               part.nodes[at(face[2])]);
  }
  add_other_faces(part);
  angles_.add(part);
}

void MeshCheck::add_other_faces(const NumberedPart& part) {
  std::vector<std::int64_t> global;
  std::vector<Vec3> corners;
  for_each_block_face(part.blocks, [&](ElementType type, std::span<const std::int32_t> nodes,
                                       std::int32_t, std::int32_t patch) {
    global.clear();
    corners.clear();
    for (const std::int32_t v : nodes) {
      global.push_back(part.local2global[at(v)]);
      corners.push_back(part.nodes[at(v)]);
    }
    digest_.add_other(type, patch, global);
    enclosed_ += cone_volume(*origin_, corners);
  });
}

MeshCheckResult MeshCheck::finish() {
  for (std::string& line : source_.complaints()) complaints_.add(std::move(line));
  for (std::string& line : nodes_.finish(Complaints::limit)) complaints_.add(std::move(line));
  if (faces_) {
    const std::vector<FaceCorners> bad = faces_->finish(Complaints::limit);
    if (!bad.empty()) {
      for (std::string& line : describe_faces(source_, bad)) complaints_.add(std::move(line));
    }
  }
  if (!(std::fabs(volume_ - enclosed_) <= 1e-9L * std::fabs(enclosed_))) {
    complaints_.add("the tets fill " + tetfarm::text_of(static_cast<double>(volume_)) +
                    " but the boundary encloses " +
                    tetfarm::text_of(static_cast<double>(enclosed_)));
  }
  MeshCheckResult result;
  result.nodes = nodes_.nodes();
  result.volume = static_cast<double>(volume_);
  result.enclosed_volume = static_cast<double>(enclosed_);
  result.forced = angles_.finish();
  result.digest = digest_.finish();
  result.complaints = complaints_.take();
  return result;
}

MeshCheckResult check_mesh(const MeshSource& source, const MeshCheckOptions& options) {
  MeshCheck check(source, options);
  for (std::size_t i = 0; i < source.size(); ++i) check.add(source.part(i));
  return check.finish();
}

}  // namespace tetfarm
