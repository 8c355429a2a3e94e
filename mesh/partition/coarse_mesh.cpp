#include "mesh/partition/coarse_mesh.h"

#include <algorithm>
#include <tuple>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/formats/node_records.h"
#include "mesh/graph/graph_coarsening.h"
#include "mesh/partition/dual_graph.h"

namespace tetfarm {
namespace {

/// A face that only one cell of its sub-domain has.
struct OpenFace {
  FaceNodes<std::int64_t> nodes;  ///< in the whole mesh, ascending
  std::int32_t subdomain = 0;
  std::int32_t column = 0;
  std::int32_t cluster = 0;
  bool operator<(const OpenFace& other) const {
    return nodes != other.nodes ? nodes < other.nodes : subdomain < other.subdomain;
  }
};

/// Clusters a < b that share so many faces.
struct Bond {
  std::int32_t a = 0;
  std::int32_t b = 0;
  std::int32_t faces = 1;
};

/// Bonds of the same two clusters become one.
void join_bonds(std::vector<Bond>& bonds) {
  std::sort(bonds.begin(), bonds.end(),
            [](const Bond& x, const Bond& y) { return std::tie(x.a, x.b) < std::tie(y.a, y.b); });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < bonds.size(); ++i) {
    if (kept > 0 && bonds[kept - 1].a == bonds[i].a && bonds[kept - 1].b == bonds[i].b) {
      bonds[kept - 1].faces += bonds[i].faces;
    } else {
      bonds[kept++] = bonds[i];
    }
  }
  bonds.resize(kept);
}

class Coarsening {
 public:
  Coarsening(bool keeps_columns, const std::filesystem::path& folder)
      : keeps_columns_(keeps_columns), open_(folder), mesh_(folder) {}

  void add(const NumberedPart& part, std::int32_t subdomain, std::int32_t wanted) {
    TF_CHECK(wanted >= 1);
    const CellFaces faces = cell_faces(part);
    const CellColumns columns = kept_columns(part, faces, keeps_columns_);
    const std::vector<GraphLevel> levels =
        coarsen_graph(dual_graph(faces, columns), columns.sizes.size(), at(wanted));
    TF_CHECK(!levels.empty());
    const auto first = static_cast<std::int32_t>(mesh_.graph.weight.size());
    mesh_.first_cluster.push_back(first);
    mesh_.wanted_clusters.push_back(wanted);
    add_clusters(levels.back().graph, first);
    for (const OuterFace& face : faces.outer) {
      const std::int32_t column = columns.column_of_cell[at(face.owner)];
      std::int32_t cluster = column;
      for (std::size_t i = 1; i < levels.size(); ++i) cluster = levels[i].coarse_of[at(cluster)];
      const auto nodes =
          face.nodes.renumbered([&](std::int32_t v) { return global_node(part, v); });
      open_.push({nodes.sorted(), subdomain, column, first + cluster});
    }
  }

  CoarseMesh finish() {
    match_open_faces();
    join_bonds(bonds_);
    make_rows(mesh_.graph, [this](const auto& visit) {
      for (const Bond& bond : bonds_) visit(at(bond.a), at(bond.b), bond.faces);
    });
    return std::move(mesh_);
  }

 private:
  void add_clusters(const WeightedGraph& clusters, std::int32_t first) {
    mesh_.graph.weight.insert(mesh_.graph.weight.end(), clusters.weight.begin(),
                              clusters.weight.end());
    for (std::size_t v = 0; v < clusters.size(); ++v) {
      for (std::size_t e = clusters.begin(v); e < clusters.end(v); ++e) {
        const auto a = static_cast<std::int32_t>(v);
        const std::int32_t b = clusters.neighbour[e];
        if (a < b) bonds_.push_back({first + a, first + b, clusters.edge_weight[e]});
      }
    }
  }

  void match_open_faces() {
    OpenFace last;
    OpenFace here;
    for (bool has_last = open_.next(last); has_last && open_.next(here);) {
      if (here.nodes != last.nodes) {
        last = here;
        continue;
      }
      bonds_.push_back(
          {std::min(last.cluster, here.cluster), std::max(last.cluster, here.cluster)});
      for (const OpenFace& face : {last, here}) {
        mesh_.sides.push({face.subdomain, face.column, std::ssize(mesh_.cluster_of_side)});
        mesh_.cluster_of_side.push_back(face.cluster);
      }
      has_last = open_.next(last);
      if (has_last && last.nodes == here.nodes) throw InvalidInput("a face has three cells", "");
    }
  }

  bool keeps_columns_;
  ExternalSort<OpenFace> open_;
  CoarseMesh mesh_;
  std::vector<Bond> bonds_;
};

}  // namespace

CellColumns kept_columns(const NumberedPart& part, const CellFaces& faces, bool keeps_columns) {
  return keeps_columns ? columns_of_prisms(part, faces)
                       : single_cells(static_cast<std::size_t>(cells_of(part)));
}

CoarseMesh coarsen(const MeshSource& source, std::int64_t clusters, bool keeps_columns,
                   const std::filesystem::path& folder) {
  TF_CHECK(clusters >= 1);
  Coarsening coarsening(keeps_columns, folder);
  const auto subdomains = static_cast<std::int64_t>(source.size());
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    const std::int64_t wanted = std::min(cells_of(part), clusters / subdomains);
    coarsening.add(part, static_cast<std::int32_t>(i),
                   static_cast<std::int32_t>(std::max<std::int64_t>(1, wanted)));
  }
  return coarsening.finish();
}

}  // namespace tetfarm
