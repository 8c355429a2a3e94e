#include "mesh/assemble/leaf_numbering.h"

#include <algorithm>

#include "base/error.h"

namespace tetfarm {

LeafNumbering leaf_numbering(const Numbering& numbering, const LeafQuestion& question) {
  const std::vector<LeafNumbers>& leaves = numbering.leaves;
  const auto leaf =
      std::lower_bound(leaves.begin(), leaves.end(), question.leaf,
                       [](const LeafNumbers& a, TreePath b) { return comes_before(a.path, b); });
  if (leaf == leaves.end() || leaf->path != question.leaf) refuse_leaf(question.leaf);
  LeafNumbering result;
  result.number = static_cast<std::int32_t>(leaf - leaves.begin());
  result.first_node = leaf->nodes.first_node;
  result.kept_nodes = leaf->nodes.kept();
  result.tets = leaf->tets;
  result.first_tet = leaf->first_tet;
  result.others = leaf->others;
  result.first_other = leaf->first_other;
  if (counts_faces(numbering)) result.first_face = leaf->first_face;
  for (const Origin& origin : question.nodes) {
    result.node_numbers.push_back(global_number(numbering, origin));
    const ForcedNode node = {static_cast<std::int32_t>(origin.index), question.region};
    const bool is_forced_by_surface =
        origin.owner == 0 &&
        std::binary_search(numbering.forced.begin(), numbering.forced.end(), node);
    result.is_forced.push_back(is_forced_by_surface || origin.owner == top_of_layers);
  }
  result.whole = {std::ssize(leaves), numbering.tets, numbering.faces, numbering.regions,
                  numbering.others};
  return result;
}

void refuse_leaf(TreePath leaf) {
  throw Error(ExitCode::failed, "sub-domain " + leaf.text() + " is not a leaf of the numbering");
}

}  // namespace tetfarm
