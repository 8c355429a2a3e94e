// What cosmetics makes of small meshes, known by its digests (tests/golden/cosmetics.txt): each
// operation on its own, then whole passes, then turns across cuts. Angles in degrees come from libm
// and are in no digest.
#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/cosmetics/altitude_improvement.h"
#include "mesh/cosmetics/bad_tets.h"
#include "mesh/cosmetics/edge_removal.h"
#include "mesh/cosmetics/element_collapse.h"
#include "mesh/cosmetics/element_extraction.h"
#include "mesh/cosmetics/element_passing.h"
#include "mesh/cosmetics/element_splitting.h"
#include "mesh/cosmetics/face_swapping.h"
#include "mesh/cosmetics/improve_mesh.h"
#include "mesh/cosmetics/joint_climbing.h"
#include "mesh/cosmetics/joint_splitting.h"
#include "mesh/cosmetics/relaxation.h"
#include "mesh/cosmetics/seam_cosmetics.h"
#include "mesh/cosmetics/small_polyhedron_reconnection.h"
#include "mesh/cosmetics/smoothing.h"
#include "mesh/cosmetics/subdomain_colouring.h"
#include "tests/mesh/cosmetics/cut_bar.h"
#include "tests/mesh/cosmetics/trial_meshes.h"
#include "tests/support/complex_digest.h"

namespace tetfarm {
namespace {

using cosmetics::WorkMesh;
using test::ResultDigest;

void expect_known(const std::string& name, const ResultDigest& result) {
  test::expect_known("cosmetics", name, result);
}

void add_replacement(ResultDigest& result, const std::optional<cosmetics::Replacement>& found) {
  result.add(found.has_value());
  if (!found) return;
  result.add(found->old_tets, found->new_tets, found->old_worst, found->new_worst,
             found->new_point);
}

void add_report(ResultDigest& result, const CosmeticReport& report) {
  result.add(report.swaps, report.moves, report.collapses, report.splits, report.reconnections,
             report.joint_moves, report.attempts);
}

/// Without depth, so that most tets are needles or flat.
TetMesh flat_ball(int points, std::uint64_t seed, double depth) {
  TetMesh mesh = trial::random_ball(1, points, seed);
  for (Vec3& p : mesh.nodes) p.z *= depth;
  return mesh;
}

TEST(CosmeticsResults, of_operations_that_replace_tets_are_known) {
  TetComplex complex = make_tet_complex(trial::random_ball(1, 30, 3));
  WorkMesh work(complex, 42);
  const auto tets = static_cast<std::int32_t>(complex.nodes.size());
  ResultDigest swaps;
  for (std::int32_t t = 0; t < tets; ++t) {
    for (const auto& [i, j] : cosmetics::edges_by_angle(work, t)) {
      swaps.add(i, j);
      add_replacement(swaps, cosmetics::find_edge_removal(work, t, i, j, 0));
      add_replacement(swaps, cosmetics::find_edge_removal(work, t, i, j, 0.05));
    }
    for (int face = 0; face < 4; ++face) {
      add_replacement(swaps, cosmetics::find_face_removal(work, t, face, 0));
    }
  }
  expect_known("swaps", swaps);
  ResultDigest collapses;
  for (std::int32_t node = 42; node < 72; ++node) {
    const std::vector<std::int32_t> ball = cosmetics::ball_of_node(work, node);
    collapses.add(ball, cosmetics::is_inner(work, ball, node));
    for (const std::int32_t t : ball) {
      for (const std::int32_t onto : work.tet(t)) {
        if (onto != node) {
          add_replacement(collapses, cosmetics::find_collapse(work, ball, node, onto, 0));
        }
      }
    }
  }
  expect_known("collapses", collapses);
  ResultDigest splits;
  for (std::int32_t t = 0; t < tets; t += 5) {
    cosmetics::SplitOptions options;
    options.is_flat = t % 4 == 0;
    options.takes_any = t % 3 == 0;
    options.least_distance = t % 2 == 0 ? 0.1 : 0;
    add_replacement(splits, cosmetics::find_split(work, t, options));
  }
  expect_known("splits", splits);
  ResultDigest fillings;
  for (std::int32_t t = 0; t < tets; t += 3) {
    add_replacement(fillings, cosmetics::find_reconnection(work, t));
    cosmetics::ReconnectionOptions options;
    options.most_nodes = 8;
    options.most_steps = 300;
    options.enough = 0.1;
    options.measure = cosmetics::smallest_height2;
    add_replacement(fillings, cosmetics::find_reconnection(work, t, options));
  }
  expect_known("reconnections", fillings);
}

TEST(CosmeticsResults, of_operations_that_move_nodes_are_known) {
  TetComplex complex = make_tet_complex(trial::random_ball(1, 30, 7));
  WorkMesh work(complex, 42);
  ResultDigest moves;
  for (std::int32_t node = 42; node < 72; ++node) {
    const std::vector<std::int32_t> ball = cosmetics::ball_of_node(work, node);
    const auto place = cosmetics::find_move(work, ball, node, 0.4);
    moves.add(place.has_value());
    if (place) moves.add(place->point, place->worst);
    moves.add(cosmetics::find_rounder_place(work, ball, node, 0.02));
    const cosmetics::Star star = cosmetics::star_of(work, ball, node);
    const cosmetics::Place top = cosmetics::climb(star, work.point(node), 0.5);
    moves.add(top.point, top.worst, cosmetics::worst_at(star, top.point, -1));
  }
  expect_known("moves", moves);
  ResultDigest joint;
  for (std::int32_t t = 0; t < std::ssize(complex.nodes); t += 11) {
    const cosmetics::NodePatch patch = cosmetics::patch_round(work, t);
    joint.add(patch.nodes, patch.tets, patch.points, patch.corners);
    if (!patch.nodes.empty()) joint.add(cosmetics::shortest_edge(patch));
    if (t % 3 == 0) joint.add(cosmetics::improve_together(work, t, 0.2));
    if (t % 3 == 1 && complex.is_live(t)) {
      joint.add(cosmetics::split_together(work, t, 0.3, 0.05));
    }
  }
  test::add_complex(joint, complex);
  expect_known("joint_moves", joint);
}

TEST(CosmeticsResults, of_raised_heights_are_known) {
  for (const bool in_spacings : {false, true}) {
    TetComplex complex = make_tet_complex(trial::random_ball(1, 30, 11));
    WorkMesh work(complex, 42);
    cosmetics::HeightOptions options;
    options.floor = 0.01;
    if (in_spacings) {
      options.wanted_spacings = 0.3;
      options.spacing = [](const Vec3& p) { return 0.5 + 0.2 * p.x; };
      options.most_joint_failures = 3;
      options.traded_quality = 0.1;
    } else {
      options.wanted_length = 0.12;
      options.most_stuck = 4;
    }
    ResultDigest result;
    result.add(cosmetics::improve_altitudes(work, options), work.node2change, work.changes);
    test::add_complex(result, complex);
    expect_known(in_spacings ? "heights_in_spacings" : "heights", result);
  }
}

TEST(CosmeticsResults, of_scans_are_known) {
  const TetComplex complex = make_tet_complex(trial::kuhn_box(3, 0.8, 4));
  CosmeticOptions options;
  options.regular = {20, 60, 0.3};
  for (const bool measures : {true, false}) {
    options.measures_angles = measures;
    const cosmetics::BadTetScan scan = cosmetics::scan_for_bad_tets(complex, {0.2, 0.4}, options);
    ResultDigest result;
    result.add(scan.bad.size(), scan.to_relax, scan.min_dihedral_deg > 0);
    for (const double quality : scan.tet2quality) result.add(quality == quality ? quality : -2);
    for (const cosmetics::BadTet& bad : scan.bad) result.add(bad.tet, bad.quality);
    expect_known(measures ? "scan" : "scan_without_angles", result);
  }
}

void improve(const std::string& name, const TetMesh& mesh, CosmeticOptions options) {
  ResultDigest result;
  options.progress = result.listener();
  TetComplex complex = make_tet_complex(mesh);
  add_report(result, improve_mesh(complex, mesh.boundary_nodes, options));
  test::add_complex(result, complex);
  expect_known(name, result);
}

TEST(CosmeticsResults, of_whole_meshes_are_known) {
  CosmeticOptions near_cuts = cosmetics_near_cuts();
  near_cuts.spacing = [](const Vec3& p) { return 0.45 + 0.1 * p.y; };
  near_cuts.smallest_spacing = 0.35;
  CosmeticOptions much;
  much.wanted_dihedral_deg = 40;
  much.rebuilt_dihedral_deg = 40;
  CosmeticOptions low;
  low.smallest_spacing = 0.5;
  low.regular = {10, 30, 0.4};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const std::string number = "_" + std::to_string(seed);
    const TetMesh ball = trial::random_ball(1, 25, seed);
    improve("ball" + number, ball, {});
    improve("ball_near_cuts" + number, ball, near_cuts);
    improve("ball_much" + number, ball, much);
    improve("box" + number, trial::kuhn_box(3, 0.9, seed), low);
  }
  improve("flat", flat_ball(25, 5, 0.05), {});
  improve("flatter", flat_ball(12, 6, 0.004), near_cuts);
}

/// A number from -0.5 to 0.5 for each axis by the place of a corner.
Vec3 push(const trial::Cell& corner, std::uint64_t seed) {
  return trial::random_vector(
      seed, static_cast<std::uint64_t>(corner[0] * 97 + corner[1] * 31 + corner[2] * 7));
}

void add_section(ResultDigest& result, const ElementSection& section) {
  result.add(section.sharers, section.nodes, section.tets, section.tet_owner, section.triangles,
             section.triangle_index, section.triangle_owner);
  for (const Origin& origin : section.node_origin) result.add(origin.owner, origin.index);
}

TEST(CosmeticsResults, of_turns_across_cuts_are_known) {
  constexpr int n = 6;
  const trial::CutBar bar(
      {n, n, 3},
      [](const trial::Cell& cell) {
        return std::uint64_t{4} + static_cast<std::uint64_t>(2 * (cell[0] / 3) + cell[1] / 3);
      },
      [](const trial::Cell& corner) {
        const Vec3 p = trial::on_the_grid(corner);
        const bool is_outside = corner[0] % n == 0 || corner[1] % n == 0 || corner[2] % 3 == 0;
        return is_outside ? p : p + 0.7 * push(corner, 3);
      });
  std::vector<InterfaceNodes> leaves;
  for (const auto& [heap, part] : bar.parts) leaves.push_back(interface_nodes(part.leaf));
  const CosmeticOrder order = colour_subdomains(leaves);
  ResultDigest coloured;
  for (const ColouredLeaf& leaf : order.leaves) {
    coloured.add(leaf.path.heap, leaf.colour, leaf.neighbours.size());
    for (const TreePath& path : leaf.neighbours) coloured.add(path.heap);
  }
  std::map<Sharers, std::vector<ElementSection>> pieces;
  for (const SharedNodes& shared : order.shared) {
    coloured.add(shared.path.heap, shared.sets);
    for (const SharedNodes::Node& node : shared.nodes) {
      coloured.add(node.origin.owner, node.origin.index, node.set);
    }
    const trial::LeafMesh& part = bar.parts.at(shared.path.heap);
    const ExtractedElements extracted = extract_elements(part.leaf, part.mesh, shared);
    coloured.add(extracted.core.tets, extracted.core.taken_tets, extracted.core.taken_triangles,
                 extracted.core.triangles);
    for (const ElementSection& piece : extracted.sections) pieces[piece.sharers].push_back(piece);
    add_section(coloured, core_section(part.leaf, part.mesh, extracted.core));
  }
  std::map<Sharers, ElementSection> sections;
  for (const auto& [sharers, list] : pieces) {
    sections[sharers] = join_pieces(list);
    add_section(coloured, sections[sharers]);
    for (const std::uint64_t owner : sharers) {
      add_section(coloured, elements_of(sections[sharers], owner));
    }
  }
  expect_known("sections", coloured);

  SeamOptions options;
  options.cosmetics.spacing = [](const Vec3&) { return 1.3; };
  for (const ColouredLeaf& leaf : order.leaves) {
    std::vector<ElementSection> mine;
    for (const auto& [sharers, section] : sections) {
      if (std::binary_search(sharers.begin(), sharers.end(), leaf.path.heap)) {
        mine.push_back(section);
      }
    }
    SeamTurn turn{leaf.path.heap, {}, 100};
    for (const ColouredLeaf& other : order.leaves) {
      if (other.colour < leaf.colour) turn.had_turn.push_back(other.path.heap);
    }
    ResultDigest result;
    const SeamResult seams = improve_seams(mine, turn, options);
    for (const ElementSection& section : seams.sections) {
      sections[section.sharers] = section;
      add_section(result, section);
    }
    for (const Origin& origin : seams.gone) result.add(origin.owner, origin.index);
    result.add(seams.next_node, seams.tets);
    add_report(result, seams.report);
    expect_known("turn_" + std::to_string(leaf.path.heap), result);
  }
}

/// As thin along two axes, or one, as it is given.
TetMesh squeezed(TetMesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.nodes) p = {by.x * p.x, by.y * p.y, by.z * p.z};
  return mesh;
}

TEST(CosmeticsResults, of_splits_of_needles_and_flat_tets_are_known) {
  for (const Vec3& by : {Vec3{1, 1, 0.01}, Vec3{1, 0.02, 0.01}, Vec3{1, 0.004, 0.2}}) {
    TetComplex complex = make_tet_complex(squeezed(trial::random_ball(1, 25, 4), by));
    WorkMesh work(complex, 42);
    ResultDigest result;
    for (std::int32_t t = 0; t < std::ssize(complex.nodes); t += 9) {
      cosmetics::SplitOptions options;
      options.is_flat = true;
      options.takes_any = t % 2 == 0;
      options.least_distance = 1e-3;
      add_replacement(result, cosmetics::find_split(work, t, options));
    }
    expect_known("splits_of_thin_" + std::to_string(static_cast<int>(1000 * by.y)), result);
  }
}

TEST(CosmeticsResults, of_large_patches_are_known) {
  TetComplex complex = make_tet_complex(trial::random_ball(1, 160, 2));
  WorkMesh work(complex, 42);
  ResultDigest result;
  std::size_t most = 0;
  for (std::int32_t t = 3; t < std::ssize(complex.nodes); t += 31) {
    const cosmetics::NodePatch patch = cosmetics::patch_round(work, t);
    most = std::max(most, patch.nodes.size());
    result.add(patch.nodes, patch.tets);
    if (t % 7 == 0) result.add(cosmetics::improve_together(work, t, 0.3));
  }
  EXPECT_EQ(most, 32U) << "no more move at once";
  result.add(work.node2change);
  test::add_complex(result, complex);
  expect_known("large_patches", result);
}

TEST(CosmeticsResults, of_heights_that_are_bought_with_angles_are_known) {
  ResultDigest result;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    TetComplex complex = make_tet_complex(trial::random_ball(1, 30, seed));
    WorkMesh work(complex, 42);
    cosmetics::HeightOptions options;
    options.floor = 0.2;
    options.wanted_length = 0.3;
    options.most_joint_failures = 4;
    options.traded_quality = seed % 2 == 0 ? 0.1 : 0.4;
    result.add(cosmetics::improve_altitudes(work, options));
    test::add_complex(result, complex);
  }
  expect_known("traded_heights", result);
}

TEST(CosmeticsResults, of_sections_of_leaves_that_meet_at_all_angles_are_known) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    // Cells of scattered points.
    std::array<Vec3, 6> middles;
    for (std::size_t i = 0; i < 6; ++i) middles[i] = 7 * trial::random_vector(seed, i);
    const trial::CutBar bar(
        {7, 7, 7},
        [&](const trial::Cell& cell) {
          const Vec3 here = trial::on_the_grid(cell) - Vec3{3, 3, 3};
          std::size_t nearest = 0;
          for (std::size_t i = 1; i < 6; ++i) {
            if (norm2(middles[i] - here) < norm2(middles[nearest] - here)) nearest = i;
          }
          return std::uint64_t{8} + nearest;
        },
        [seed](const trial::Cell& corner) {
          const Vec3 p = trial::on_the_grid(corner);
          const bool is_outside = corner[0] % 7 == 0 || corner[1] % 7 == 0 || corner[2] % 7 == 0;
          return is_outside ? p : p + 0.45 * push(corner, seed);
        });
    std::vector<InterfaceNodes> leaves;
    for (const auto& [heap, part] : bar.parts) leaves.push_back(interface_nodes(part.leaf));
    const CosmeticOrder order = colour_subdomains(leaves);
    ResultDigest result;
    for (const ColouredLeaf& leaf : order.leaves) {
      result.add(leaf.path.heap, leaf.colour, leaf.neighbours.size());
    }
    for (const SharedNodes& shared : order.shared) {
      const trial::LeafMesh& part = bar.parts.at(shared.path.heap);
      for (const int layers : {1, 3}) {
        ExtractionOptions options;
        options.taken_layers = layers - 1;
        options.sought_layers = layers;
        options.layers_round_bad = layers;
        const ExtractedElements extracted = extract_elements(part.leaf, part.mesh, shared, options);
        result.add(extracted.core.taken_tets, extracted.core.taken_triangles);
        for (const ElementSection& piece : extracted.sections) add_section(result, piece);
      }
    }
    expect_known("scattered_leaves_" + std::to_string(seed), result);
  }
}

}  // namespace
}  // namespace tetfarm
