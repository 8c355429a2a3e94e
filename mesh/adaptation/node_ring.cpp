#include "mesh/adaptation/node_ring.h"

#include "base/check.h"

namespace tetfarm {

void NodeRing::gather(const MetricMesh& mesh, std::int32_t node) {
  collect_ball(mesh.complex, node, ball_);
  places_.clear();
  const auto add = [&](std::int32_t v) {
    places_.push_back({mesh.complex.point(v), mesh.metrics[at(v)], v});
  };
  for (const EdgeHandle corner : ball_.corners) {
    add(mesh.complex.node(triangle_of(corner), next(edge_of(corner))));
  }
  const EdgeHandle last = ball_.corners.back();
  if (ball_.is_closed) {
    places_.push_back(Place(places_.front()));
  } else {
    add(mesh.complex.node(triangle_of(last), previous(edge_of(last))));
  }
  energies_.resize(ball_.corners.size());
}

RingEnergies NodeRing::energies_at(const NodePlace& place) {
  RingEnergies result;
  for (std::int32_t k = 0; k < triangles(); ++k) {
    energies_[at(k)] = energy(k, place, result.is_certain);
    result.sum += energies_[at(k)];
  }
  return result;
}

double NodeRing::noted_sum(MetricMesh& mesh) const {
  double sum = 0;
  for (std::int32_t k = 0; k < triangles(); ++k) sum += known_energy(mesh, triangle(k));
  return sum;
}

void NodeRing::note(MetricMesh& mesh) const {
  TF_CHECK(energies_.size() == ball_.corners.size());
  for (std::int32_t k = 0; k < triangles(); ++k) {
    note_change(mesh, triangle(k));
    mesh.energies[at(triangle(k))] = noted_energy(energies_[at(k)]);
  }
}

void NodeRing::activate(MetricMesh& mesh) const {
  for (const Place& place : places_) mesh.active[at(place.node)] = 1;
}

}  // namespace tetfarm
