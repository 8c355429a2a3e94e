#include "worker/grow_task.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "mesh/assemble/portion.h"
#include "mesh/layers/layer_chunk_file.h"
#include "mesh/layers/layer_growth.h"
#include "mesh/layers/layer_shape.h"
#include "tasks/grow_contract.h"
#include "tasks/ratio_histogram.h"
#include "worker/leaf_inputs.h"
#include "worker/shared_mesh_file.h"
#include "worker/task_cost.h"

namespace tetfarm {
namespace {

MeshPart part_of(GrownLayers layers) {
  const std::vector<std::string> complaints = validate(layers);
  if (!complaints.empty()) throw OwnDefect("the layers are wrong: " + complaints.front(), {});
  MeshPart part;
  part.subdomain = std::move(layers.subdomain);
  part.mesh = std::move(layers.mesh);
  part.blocks = std::move(layers.blocks);
  part.marks = std::move(layers.marks);
  part.feet = std::move(layers.feet);
  part.is_of_layers = true;
  return part;
}

/// How well the prisms of boundary layers are shaped; nothing where there are none.
void report_jacobians(TaskIo& io, const std::vector<double>& shares) {
  if (shares.empty()) return;
  RatioHistogram histogram;
  for (const double share : shares) histogram.add(share);
  io.number("min_scaled_jacobian", *std::min_element(shares.begin(), shares.end()));
  io.text("scaled_jacobians", histogram.text());
}

/// The numbers of the chunk's nodes, and after them of its far feet.
LeafNumbering numbers_with_far_feet(NumberingInput& numbering, const Subdomain& wall,
                                    const std::vector<FarFoot>& far) {
  std::vector<Origin> nodes = wall.node_origin;
  for (const FarFoot& foot : far) nodes.push_back(foot.foot);
  return numbering.leaf({wall.path, wall.region, nodes});
}

/// Takes the numbers of the far feet off. @pre `numbers` has them, after those of the nodes.
std::vector<std::int64_t> taken_far_numbers(std::size_t far, LeafNumbering& numbers) {
  const std::size_t nodes = numbers.node_numbers.size() - far;
  std::vector<std::int64_t> taken(numbers.node_numbers.begin() + static_cast<std::ptrdiff_t>(nodes),
                                  numbers.node_numbers.end());
  numbers.node_numbers.resize(nodes);
  numbers.is_forced.resize(nodes);
  return taken;
}

}  // namespace

void grow_task(TaskIo& io) {
  const auto given = io.given<GrowGiven>();
  SurfaceInput surface(io, given.surface);
  NumberingInput numbering(io, given.numbering, surface);
  io.progress().begin(WorkStage::layers);
  const LayerChunk chunk = io.read(given.layers, layer_chunk_from_bytes);
  const ChunkCounts counts = counts_of(chunk);
  report_cost(io, grow_cost(static_cast<double>(counts.cells())));
  GrownLayers layers = grow(chunk);
  const std::vector<double> jacobians = jacobian_shares(layers);
  const std::vector<FarFoot> far = layers.far_feet;
  MeshPart part = part_of(std::move(layers));
  const Subdomain& wall = part.subdomain;
  LeafNumbering numbers = numbers_with_far_feet(numbering, wall, far);
  const std::vector<std::int64_t> far_numbers = taken_far_numbers(far.size(), numbers);
  const SurfacePieces pieces = surface.pieces(surface_pieces(wall));
  Portion portion = make_portion(std::move(part), pieces, numbers);
  for (std::size_t i = 0; i < far.size(); ++i) {
    portion.part.feet.foot.at(static_cast<std::size_t>(far[i].node)) = far_numbers[i];
  }
  place_in_shared_file(io, {given.job, given.surface, given.numbering}, surface, numbers, portion);
  io.number("tets", static_cast<double>(counts.tets));
  io.number("pyramids", static_cast<double>(counts.pyramids));
  io.number("prisms", static_cast<double>(counts.prisms));
  report_jacobians(io, jacobians);
  if (counts.quads > 0) io.number("quads", static_cast<double>(counts.quads));
  GrowMade made;
  made.portion = io.publish(portion_to_bytes(portion));
  made.cells = io.publish(portion_cells_to_bytes(portion));
  io.made(made);
}

}  // namespace tetfarm
