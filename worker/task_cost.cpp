#include "worker/task_cost.h"

#include <algorithm>
#include <cmath>

#include "mesh/core/triangle_angles.h"
#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

/// A process that has loaded the program and read a job.
constexpr double process_bytes = 19e6;

/// Elements that come out for each estimated one, at most but for the smallest sub-domains.
constexpr double elements_in_estimate = 1.15;

/// To plan the layers of a triangle, and divide them into chunks, takes as much memory as to
/// inspect so many.
constexpr double triangles_in_planned_one = 2;

/// What a turn reads, at most: elements near the cuts of a leaf on both sides of them. Of small
/// leaves these are all, and as many again of the neighbours.
constexpr double turn_elements_of_leaf = 2.5;
constexpr double turn_elements_per_triangle = 23;

double bytes_of(TaskKind kind, const MemorySize& size) {
  const TaskMemory& of = traits_of(kind).memory;
  return process_bytes + of.fixed + of.of_spacing_byte * size.spacing_bytes +
         of.of_input_byte * size.input_bytes + of.of_element * size.elements +
         of.of_triangle * size.triangles + of.of_triangle_of_largest * size.triangles_of_largest;
}

}  // namespace

TaskCost cost_of(TaskKind kind, const MemorySize& memory, const TaskSize& size) {
  return {bytes_of(kind, memory), usual_seconds(kind, size).expected, kind, size};
}

TaskCost inspect_cost(double input_bytes, const SubdomainSize& root, double wall_triangles) {
  const double triangles = root.triangles + triangles_in_planned_one * wall_triangles;
  return cost_of(TaskKind::inspect, {0, triangles, root.spacing_bytes, input_bytes},
                 {root.elements, root.triangles, root.needles});
}

TaskCost remesh_cost(double input_bytes, double triangles) {
  return cost_of(TaskKind::remesh, {0, triangles, 0, input_bytes}, {0, triangles, 0});
}

TaskCost decompose_cost(const SubdomainSize& size) {
  return cost_of(TaskKind::decompose, {size.elements, size.triangles, size.spacing_bytes},
                 {size.elements, size.triangles, size.needles});
}

TaskCost mesh_cost(const SubdomainSize& size) {
  return cost_of(TaskKind::mesh,
                 {elements_in_estimate * size.elements, size.triangles, size.spacing_bytes},
                 {size.elements, size.triangles, size.needles});
}

TaskCost assimilate_cost(double triangles, double largest_group) {
  return cost_of(TaskKind::assimilate, {0, triangles, 0, 0, largest_group}, {0, triangles, 0});
}

TaskCost order_cost(double triangles, double largest_leaf) {
  return cost_of(TaskKind::order, {0, triangles, 0, 0, largest_leaf}, {0, triangles, 0});
}

TaskCost extract_cost(double elements, double triangles) {
  return cost_of(TaskKind::extract, {elements, triangles}, {elements, triangles, 0});
}

TaskCost cosmetic_cost(double elements, double spacing_bytes) {
  return cost_of(TaskKind::cosmetic, {elements, 0, spacing_bytes}, {elements, 0, 0});
}

double turn_elements(const SubdomainSize& leaf) {
  return std::min(turn_elements_of_leaf * leaf.elements,
                  turn_elements_per_triangle * leaf.triangles);
}

double leaf_bytes(const SubdomainSize& leaf) {
  return std::max({mesh_cost(leaf).bytes,
                   cosmetic_cost(turn_elements(leaf), leaf.spacing_bytes).bytes,
                   extract_cost(elements_in_estimate * leaf.elements, leaf.triangles).bytes});
}

double triangles_of_leaves(const SubdomainSize& root, double parts) {
  // A cube of e elements has 6 faces of (e / 8.5)^(2/3) h^2, with 2.31 triangles each.
  constexpr double of_cube = 3.33;
  return root.triangles + of_cube * std::cbrt(parts) * std::pow(std::cbrt(root.elements), 2);
}

TaskCost number_cost(double surface_triangles) {
  return cost_of(TaskKind::number, {0, surface_triangles}, {0, surface_triangles, 0});
}

TaskCost write_cost(double elements) { return cost_of(TaskKind::write, {elements}, {elements}); }

TaskCost grow_cost(double cells) { return cost_of(TaskKind::grow, {cells}, {cells}); }

TaskCost assemble_cost(double surface_triangles, double elements, const SubdomainSize& largest) {
  return cost_of(TaskKind::assemble, {elements_in_estimate * largest.elements, surface_triangles},
                 {elements, surface_triangles, 0});
}

SubdomainSize size_of(const Subdomain& subdomain, double elements, const TaskFile& spacing) {
  return {elements, static_cast<double>(subdomain.triangles.size()),
          static_cast<double>(spacing.size),
          static_cast<double>(needle_count(subdomain.vertices, subdomain.triangles))};
}

void report_cost(TaskIo& io, const TaskCost& cost) {
  io.number("expected_bytes", cost.bytes);
  io.number("expected_seconds", cost.seconds);
  io.number("size_elements", cost.size.elements);
  io.number("size_triangles", cost.size.triangles);
  io.number("size_needles", cost.size.needles);
}

std::int64_t parts_for_memory(const SubdomainSize& size, double most_bytes) {
  if (leaf_bytes(size) <= most_bytes) return 1;
  const double fixed = leaf_bytes({0, 0, size.spacing_bytes});
  const double room = most_bytes - fixed;
  if (room <= 0) return static_cast<std::int64_t>(most_parts);
  const double parts = std::ceil((leaf_bytes(size) - fixed) / room);
  return static_cast<std::int64_t>(std::clamp(parts, 2.0, static_cast<double>(most_parts)));
}

double least_memory(double input_bytes, const SubdomainSize& root) {
  const SubdomainSize nothing{0, 0, root.spacing_bytes};
  // Half a process more than the tasks of a leaf without elements: leaves of a useful size have to
  // fit.
  return std::max({inspect_cost(input_bytes, root).bytes, decompose_cost(root).bytes,
                   number_cost(root.triangles).bytes,
                   assemble_cost(root.triangles, 0, nothing).bytes,
                   process_bytes / 2 + leaf_bytes(nothing)});
}

}  // namespace tetfarm
