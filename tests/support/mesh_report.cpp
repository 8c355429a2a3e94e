#include "tests/support/mesh_report.h"

#include <algorithm>
#include <utility>

#include "mesh/assemble/mesh_digest.h"
#include "mesh/core/validate.h"

namespace tetfarm {
namespace {

bool all_nodes_exist(const GlobalMesh& mesh) {
  const auto exists = [&](std::int32_t v) {
    return v >= 0 && static_cast<std::size_t>(v) < mesh.mesh.nodes.size();
  };
  for (const Tet& tet : mesh.mesh.tets) {
    for (const std::int32_t v : tet) {
      if (!exists(v)) return false;
    }
  }
  for (const Triangle& triangle : mesh.boundary) {
    for (const std::int32_t v : triangle) {
      if (!exists(v)) return false;
    }
  }
  return true;
}

/// The tets of one sub-domain, or what it has of one region: mesh.tets[first] up to [last].
struct TetRange {
  std::size_t first = 0;
  std::size_t last = 0;
  std::int32_t region = 1;
};

bool is_same(const std::vector<std::int32_t>& of_tet, std::size_t a, std::size_t b) {
  return of_tet.empty() || of_tet[a] == of_tet[b];
}

std::vector<TetRange> subdomains_of(const GlobalMesh& mesh) {
  const std::size_t tets = mesh.mesh.tets.size();
  std::vector<TetRange> ranges;
  for (std::size_t first = 0; first < tets;) {
    std::size_t last = mesh.subdomain_of_tet.empty() ? tets : first + 1;
    while (last < tets && is_same(mesh.subdomain_of_tet, first, last) &&
           is_same(mesh.region_of_tet, first, last)) {
      ++last;
    }
    ranges.push_back({first, last, mesh.region_of_tet.empty() ? 1 : mesh.region_of_tet[first]});
    first = last;
  }
  return ranges;
}

/// A sub-domain's tets with node numbers of its own.
struct LocalMesh {
  std::vector<std::int32_t> local2global;
  std::vector<Vec3> nodes;
  std::vector<Tet> tets;
};

/// `global2local` is -1 everywhere, before and after.
LocalMesh local_mesh(const GlobalMesh& mesh, const TetRange& range,
                     std::vector<std::int32_t>& global2local) {
  LocalMesh local;
  for (std::size_t t = range.first; t < range.last; ++t) {
    Tet tet = mesh.mesh.tets[t];
    for (std::int32_t& v : tet) {
      std::int32_t& number = global2local[static_cast<std::size_t>(v)];
      if (number < 0) {
        number = static_cast<std::int32_t>(local.nodes.size());
        local.nodes.push_back(mesh.mesh.nodes[static_cast<std::size_t>(v)]);
        local.local2global.push_back(v);
      }
      v = number;
    }
    local.tets.push_back(tet);
  }
  for (const std::int32_t v : local.local2global) global2local[static_cast<std::size_t>(v)] = -1;
  return local;
}

/// Of each region, the nodes that several of its sub-domains have. Sorted.
class SharedNodes {
 public:
  SharedNodes(const GlobalMesh& mesh, const std::vector<TetRange>& ranges) {
    std::vector<std::int32_t> last_range(mesh.mesh.nodes.size(), -1);
    std::vector<bool> has_several(mesh.mesh.nodes.size(), false);
    for_each_use(mesh, ranges, last_range, [&](std::size_t v, std::size_t, bool is_again) {
      if (is_again) has_several[v] = true;
    });
    std::fill(last_range.begin(), last_range.end(), -1);
    std::vector<Use> uses;
    for_each_use(mesh, ranges, last_range, [&](std::size_t v, std::size_t range, bool) {
      if (has_several[v]) uses.push_back({static_cast<std::int32_t>(v), ranges[range].region});
    });
    std::sort(uses.begin(), uses.end());
    for (std::size_t i = 1; i < uses.size(); ++i) {
      const bool is_known = !shared_.empty() && shared_.back() == uses[i];
      if (uses[i] == uses[i - 1] && !is_known) shared_.push_back(uses[i]);
    }
  }

  bool contains(std::int32_t node, std::int32_t region) const {
    return std::binary_search(shared_.begin(), shared_.end(), Use{node, region});
  }

 private:
  using Use = std::pair<std::int32_t, std::int32_t>;  // node, region

  /// Calls visit(node, range, whether an earlier range has it) once for each range with the node.
  template <class Visit>
  static void for_each_use(const GlobalMesh& mesh, const std::vector<TetRange>& ranges,
                           std::vector<std::int32_t>& last_range, const Visit& visit) {
    for (std::size_t r = 0; r < ranges.size(); ++r) {
      for (std::size_t t = ranges[r].first; t < ranges[r].last; ++t) {
        for (const std::int32_t node : mesh.mesh.tets[t]) {
          const auto v = static_cast<std::size_t>(node);
          if (last_range[v] == static_cast<std::int32_t>(r)) continue;
          visit(v, r, last_range[v] >= 0);
          last_range[v] = static_cast<std::int32_t>(r);
        }
      }
    }
  }

  std::vector<Use> shared_;
};

void add_all_shapes(const GlobalMesh& mesh, MeshShapes& shapes) {
  const std::vector<TetRange> ranges = subdomains_of(mesh);
  const SharedNodes shared(mesh, ranges);
  std::vector<std::int32_t> global2local(mesh.mesh.nodes.size(), -1);
  for (const TetRange& range : ranges) {
    const LocalMesh local = local_mesh(mesh, range, global2local);
    std::vector<bool> is_on_cut;
    for (const std::int32_t v : local.local2global) {
      is_on_cut.push_back(shared.contains(v, range.region));
    }
    add_shapes(local.nodes, local.tets, range.region, is_on_cut, shapes);
  }
}

void add_figures(const GlobalMesh& mesh, MeshReport& report) {
  MeshDigest digest;
  for (std::size_t v = 0; v < mesh.mesh.nodes.size(); ++v) {
    digest.add_node(static_cast<std::int64_t>(v), mesh.mesh.nodes[v]);
  }
  for (std::size_t i = 0; i < mesh.mesh.tets.size(); ++i) {
    const auto& [a, b, c, d] = mesh.mesh.tets[i];
    digest.add_tet(static_cast<std::int64_t>(i), {a, b, c, d});
  }
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
    const auto& [a, b, c] = mesh.boundary[i];
    digest.add_boundary_triangle({a, b, c}, mesh.patch_of_triangle[i]);
  }
  add_all_shapes(mesh, report.shapes);
  for (const RegionShapes& region : report.shapes.regions) report.volume += region.volume;
  report.digest = digest.finish();
}

}  // namespace

MeshReport report_on(const GlobalMesh& mesh) {
  MeshReport report;
  report.nodes = std::ssize(mesh.mesh.nodes);
  report.tets = std::ssize(mesh.mesh.tets);
  report.boundary_triangles = std::ssize(mesh.boundary);
  report.subdomains = mesh.subdomains;
  report.complaints = validate(mesh.mesh, mesh.boundary);
  if (all_nodes_exist(mesh)) add_figures(mesh, report);
  return report;
}

}  // namespace tetfarm
