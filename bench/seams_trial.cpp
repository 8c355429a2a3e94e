// What parallel cosmetics does near the cuts: cuts a surface into N leaves and meshes them as the
// tasks would, gives each its turn, and compares with the uncut mesh:
//   seams_trial surface N [--box FACTOR] [--growth g] [--spacing h] [--uncut] [--worst n] [--wanted
//   deg] [--height h] [--least h] [--lowest n] [--taken n] [--sought n] [--round n]
// --uncut also measures the mesh of one piece; --worst and --lowest print the n worst tets near
// cuts by angle and by height; --height and --least are the heights wanted, in spacings and in
// smallest spacings; --taken, --sought and --round are the layers of ExtractionOptions. For domains
// of one region.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "bench/cut_as_tasks.h"
#include "mesh/core/tet_quality.h"
#include "mesh/core/validate.h"
#include "mesh/cosmetics/altitude_improvement.h"
#include "mesh/cosmetics/element_extraction.h"
#include "mesh/cosmetics/element_passing.h"
#include "mesh/cosmetics/seam_cosmetics.h"
#include "mesh/cosmetics/subdomain_colouring.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/inspect/outer_boundary.h"

namespace {

using namespace tetfarm;
using trial::cpu_seconds;

struct Arguments {
  std::string surface;
  int parts = 16;
  double box_factor = 0;
  double growth = 0.3;
  double spacing = 0;
  bool uncut = false;
  std::size_t worst = 0;
  std::size_t lowest = 0;
  double wanted = 30;
  double height = 0.35;
  double least = 0.55;
  std::int64_t joint = cosmetics_near_cuts().most_joint_failures;
  ExtractionOptions extraction;
};

Arguments parse(int count, char** words) {
  Arguments a;
  a.surface = words[1];
  a.parts = std::stoi(words[2]);
  for (int i = 3; i < count; ++i) {
    if (!std::strcmp(words[i], "--box")) a.box_factor = std::stod(words[i + 1]);
    if (!std::strcmp(words[i], "--growth")) a.growth = std::stod(words[i + 1]);
    if (!std::strcmp(words[i], "--spacing")) a.spacing = std::stod(words[i + 1]);
    if (!std::strcmp(words[i], "--uncut")) a.uncut = true;
    if (!std::strcmp(words[i], "--worst")) a.worst = std::stoul(words[i + 1]);
    if (!std::strcmp(words[i], "--wanted")) a.wanted = std::stod(words[i + 1]);
    if (!std::strcmp(words[i], "--height")) a.height = std::stod(words[i + 1]);
    if (!std::strcmp(words[i], "--least")) a.least = std::stod(words[i + 1]);
    if (!std::strcmp(words[i], "--joint")) a.joint = std::stol(words[i + 1]);
    if (!std::strcmp(words[i], "--taken")) a.extraction.taken_layers = std::stoi(words[i + 1]);
    if (!std::strcmp(words[i], "--sought")) a.extraction.sought_layers = std::stoi(words[i + 1]);
    if (!std::strcmp(words[i], "--round")) a.extraction.layers_round_bad = std::stoi(words[i + 1]);
    if (!std::strcmp(words[i], "--lowest")) a.lowest = std::stoul(words[i + 1]);
  }
  return a;
}

struct Figures {
  double min_dihedral = 180;
  double max_dihedral = 0;
  double least_height = HUGE_VAL;           ///< in the unit of the surface
  double least_relative_height = HUGE_VAL;  ///< in units of the spacing there
  std::int64_t tets = 0;
  std::int64_t below_10 = 0;
  std::int64_t below_20 = 0;
  std::int64_t below_30 = 0;
  double sum_ratio = 0;
  std::vector<double> angles;

  void add(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
           const SpacingField& spacing) {
    const double angle = dihedral_range(a, b, c, d).min_deg;
    max_dihedral = std::max(max_dihedral, dihedral_range(a, b, c, d).max_deg);
    const double volume = tet_volume(a, b, c, d);
    double area = 0;
    for (const auto& f : {std::array{a, b, c}, {a, b, d}, {a, c, d}, {b, c, d}}) {
      area = std::max(area, 0.5 * norm(cross(f[1] - f[0], f[2] - f[0])));
    }
    const double height = 3 * volume / area;
    min_dihedral = std::min(min_dihedral, angle);
    least_height = std::min(least_height, height);
    least_relative_height =
        std::min(least_relative_height, height / spacing.at(0.25 * (a + b + c + d)));
    ++tets;
    below_10 += angle < 10 ? 1 : 0;
    below_20 += angle < 20 ? 1 : 0;
    below_30 += angle < 30 ? 1 : 0;
    sum_ratio += radius_ratio(a, b, c, d);
    angles.push_back(angle);
  }
  void print(const char* what) {
    std::sort(angles.begin(), angles.end());
    const auto quantile = [this](double q) {
      return angles.empty() ? 0.0
                            : angles[static_cast<std::size_t>(q * static_cast<double>(tets - 1))];
    };
    std::printf(
        "  %-14s %9lld tets  min dihedral %6.2f  0.1%% %5.1f  1%% %5.1f  below 10/20/30: "
        "%4lld %5lld %6lld  height %.5g (%.4f h)  mean ratio %.4f  max dihedral %.2f\n",
        what, static_cast<long long>(tets), min_dihedral, quantile(0.001), quantile(0.01),
        static_cast<long long>(below_10), static_cast<long long>(below_20),
        static_cast<long long>(below_30), least_height, least_relative_height,
        tets > 0 ? sum_ratio / static_cast<double>(tets) : 0, max_dihedral);
  }
};

/// Of each tet of the joined sections, whether it is within four layers of a cut.
std::vector<bool> is_near_cuts(const JoinedElements& joined, const CosmeticOrder& order) {
  std::vector<bool> is_reached(joined.nodes.size(), false);
  for (const SharedNodes& shared : order.shared) {
    for (const SharedNodes::Node& node : shared.nodes) {
      const auto found =
          std::lower_bound(joined.node_origin.begin(), joined.node_origin.end(), node.origin);
      if (found == joined.node_origin.end() || *found != node.origin) continue;
      is_reached[static_cast<std::size_t>(found - joined.node_origin.begin())] = true;
    }
  }
  std::vector<bool> is_near(joined.tets.size(), false);
  for (int layer = 0; layer < 4; ++layer) {
    std::vector<bool> next = is_reached;
    for (std::size_t t = 0; t < joined.tets.size(); ++t) {
      const Tet& tet = joined.tets[t];
      const auto reached = [&](std::int32_t v) { return is_reached[static_cast<std::size_t>(v)]; };
      if (std::none_of(tet.begin(), tet.end(), reached)) continue;
      is_near[t] = true;
      for (const std::int32_t v : tet) next[static_cast<std::size_t>(v)] = true;
    }
    is_reached = std::move(next);
  }
  return is_near;
}

/// Of all tets, and of those near cuts.
struct AllFigures {
  Figures all;
  Figures seams;
};

AllFigures figures_of(const std::vector<ElementSection>& sections, const SpacingField& spacing,
                      const CosmeticOrder& order) {
  AllFigures figures;
  const JoinedElements joined = join_elements(sections);
  const std::vector<bool> is_near = is_near_cuts(joined, order);
  for (std::size_t t = 0; t < joined.tets.size(); ++t) {
    const auto at = [&](std::size_t i) {
      return joined.nodes[static_cast<std::size_t>(joined.tets[t][i])];
    };
    figures.all.add(at(0), at(1), at(2), at(3), spacing);
    if (is_near[t]) figures.seams.add(at(0), at(1), at(2), at(3), spacing);
  }
  return figures;
}

/// All sections of the job, pieces of different leaves with the same sharers joined.
std::map<Sharers, ElementSection> joined_by_sharers(const std::vector<ElementSection>& pieces) {
  std::map<Sharers, std::vector<ElementSection>> lists;
  for (const ElementSection& piece : pieces) lists[piece.sharers].push_back(piece);
  std::map<Sharers, ElementSection> sections;
  for (const auto& [sharers, list] : lists) {
    sections[sharers] = join_pieces(list);
  }
  return sections;
}

std::vector<ElementSection> values_of(const std::map<Sharers, ElementSection>& sections) {
  std::vector<ElementSection> list;
  for (const auto& [sharers, section] : sections) list.push_back(section);
  return list;
}

double smallest_dihedral_deg(const std::array<Vec3, 4>& p) {
  return dihedral_range(p[0], p[1], p[2], p[3]).min_deg;
}
double smallest_height(const std::array<Vec3, 4>& p) {
  return std::sqrt(cosmetics::smallest_height2(p[0], p[1], p[2], p[3]));
}

/// The worst tets of the seams: where they are, and which of their nodes the surface holds.
void print_worst(const std::vector<ElementSection>& sections, std::size_t count,
                 double (*measure)(const std::array<Vec3, 4>&)) {
  if (count == 0) return;
  struct Item {
    double angle;
    std::string text;
  };
  std::vector<Item> items;
  for (const ElementSection& section : sections) {
    for (std::size_t t = 0; t < section.tets.size(); ++t) {
      std::array<Vec3, 4> p;
      std::string origins;
      for (std::size_t i = 0; i < 4; ++i) {
        const auto v = static_cast<std::size_t>(section.tets[t][i]);
        p[i] = section.nodes[v];
        origins += " " + std::to_string(section.node_origin[v].owner) + ":" +
                   std::to_string(section.node_origin[v].index);
      }
      const double angle = measure(p);
      const Vec3 c = 0.25 * (p[0] + p[1] + p[2] + p[3]);
      std::string sharers;
      for (const std::uint64_t s : section.sharers) sharers += " " + std::to_string(s);
      char text[300];
      std::snprintf(text, sizeof text, "%.5g at %.6g %.6g %.6g nodes%s sharers%s triangles %d",
                    angle, c.x, c.y, c.z, origins.c_str(), sharers.c_str(),
                    static_cast<int>(std::count_if(
                        section.triangles.begin(), section.triangles.end(), [&](const Triangle& f) {
                          return std::all_of(f.begin(), f.end(), [&](std::int32_t v) {
                            return std::find(section.tets[t].begin(), section.tets[t].end(), v) !=
                                   section.tets[t].end();
                          });
                        })));
      items.push_back({angle, text});
    }
  }
  std::sort(items.begin(), items.end(),
            [](const Item& a, const Item& b) { return a.angle < b.angle; });
  for (std::size_t i = 0; i < std::min(count, items.size()); ++i) {
    std::printf("    %s\n", items[i].text.c_str());
  }
}

void complain(const std::vector<ElementSection>& sections, const SurfaceMesh& surface) {
  JoinedElements joined = join_elements(sections);
  std::int32_t surface_nodes = 0;
  while (surface_nodes < std::ssize(joined.nodes) &&
         joined.node_origin[static_cast<std::size_t>(surface_nodes)].owner == 0) {
    ++surface_nodes;
  }
  TetMesh mesh{joined.nodes, joined.tets, surface_nodes};
  for (const std::string& line : validate(mesh, joined.triangles)) {
    std::printf("  INVALID: %s\n", line.c_str());
  }
  if (joined.triangles.size() != surface.triangles.size()) std::printf("  LOST TRIANGLES\n");
}

struct Turns {
  double seconds = 0;
  std::int32_t colours = 0;
  std::size_t most_neighbours = 0;
  std::int64_t largest_region = 0;
  CosmeticReport report;
};

Turns give_turns(const CosmeticOrder& order, const Arguments& arguments,
                 const std::map<std::uint64_t, std::uint32_t>& interior,
                 const SpacingField& spacing, std::map<Sharers, ElementSection>& sections) {
  Turns turns;
  std::vector<ColouredLeaf> leaves = order.leaves;
  std::stable_sort(leaves.begin(), leaves.end(), [](const ColouredLeaf& a, const ColouredLeaf& b) {
    return a.colour < b.colour;
  });
  std::map<std::uint64_t, std::int32_t> colour_of;
  for (const ColouredLeaf& leaf : leaves) colour_of[leaf.path.heap] = leaf.colour;
  const double start = cpu_seconds();
  for (const ColouredLeaf& leaf : leaves) {
    SeamTurn turn{leaf.path.heap, {}, interior.at(leaf.path.heap)};
    for (const TreePath& other : leaf.neighbours) {
      if (colour_of[other.heap] < leaf.colour) turn.had_turn.push_back(other.heap);
    }
    std::vector<ElementSection> mine;
    for (const auto& [sharers, section] : sections) {
      const bool shares = std::binary_search(sharers.begin(), sharers.end(), turn.self);
      if (shares && sharers.size() > 1) mine.push_back(section);
    }
    SeamOptions options;
    options.cosmetics.wanted_dihedral_deg = arguments.wanted;
    options.cosmetics.height_in_spacings = arguments.height;
    options.cosmetics.height_in_smallest_spacings = arguments.least;
    options.cosmetics.most_joint_failures = arguments.joint;
    options.cosmetics.smallest_spacing = spacing.smallest();
    options.cosmetics.spacing = [&spacing](const Vec3& p) { return spacing.at(p); };
    SeamResult result = improve_seams(mine, turn, options);
    for (ElementSection& section : result.sections) sections[section.sharers] = section;
    turns.colours = std::max(turns.colours, leaf.colour + 1);
    turns.most_neighbours = std::max(turns.most_neighbours, leaf.neighbours.size());
    turns.largest_region = std::max(turns.largest_region, result.tets);
    turns.report.swaps += result.report.swaps;
    turns.report.moves += result.report.moves;
    turns.report.collapses += result.report.collapses;
    turns.report.splits += result.report.splits;
  }
  turns.seconds = cpu_seconds() - start;
  return turns;
}

Figures uncut_figures(const Subdomain& root, const SpacingField& spacing) {
  const TetMesh mesh = mesh_volume(root, spacing).mesh.value();
  Figures figures;
  for (const auto& [a, b, c, d] : mesh.tets) {
    const auto at = [&mesh](std::int32_t v) { return mesh.nodes[static_cast<std::size_t>(v)]; };
    figures.add(at(a), at(b), at(c), at(d), spacing);
  }
  return figures;
}

}  // namespace

int main(int count, char** words) {
  if (count < 3) {
    std::puts(
        "seams_trial surface N [--box FACTOR] [--growth g] [--spacing h] [--uncut] [--worst n] "
        "[--wanted deg]");
    return 2;
  }
  const Arguments arguments = parse(count, words);
  SurfaceMesh surface = read_surface(arguments.surface);
  if (arguments.box_factor > 0) {
    surface = add_outer_boundary(surface, {OuterBoundary::Kind::box, arguments.box_factor, 0},
                                 arguments.growth);
  }
  SpacingOptions options;
  options.growth = arguments.growth;
  options.background = arguments.spacing;
  const SpacingField spacing = make_spacing_field(surface, options);
  const Subdomain root = root_subdomain(surface);
  if (arguments.uncut) uncut_figures(root, spacing).print("uncut");
  const trial::CutLeaves made = trial::cut_as_tasks(root, spacing, arguments.parts);
  const std::vector<Subdomain>& leaves = made.leaves;
  std::printf(" %d cuts, %d not made, %d planes tried, smallest angle %.1f, %.2f s\n", made.cuts,
              made.uncut, made.planes_tried, made.smallest_angle_deg, made.seconds);
  std::vector<InterfaceNodes> nodes;
  for (const Subdomain& leaf : leaves) nodes.push_back(interface_nodes(leaf));
  const CosmeticOrder order = colour_subdomains(std::move(nodes));
  std::vector<ElementSection> pieces;
  std::map<std::uint64_t, std::uint32_t> interior;
  double mesh_seconds = 0;
  double extract_seconds = 0;
  double estimated = 0;
  double worst_estimate = 0;
  for (const Subdomain& leaf : leaves) {
    mesh_seconds -= cpu_seconds();
    const TetMesh mesh = mesh_volume(leaf, spacing).mesh.value();
    mesh_seconds += cpu_seconds();
    const double estimate = estimated_elements(leaf, spacing);
    const double off = estimate / static_cast<double>(mesh.tets.size()) - 1;
    estimated += estimate;
    if (std::fabs(off) > std::fabs(worst_estimate)) worst_estimate = off;
    const auto place = std::find_if(order.shared.begin(), order.shared.end(),
                                    [&](const SharedNodes& s) { return s.path == leaf.path; });
    extract_seconds -= cpu_seconds();
    ExtractedElements extracted = extract_elements(leaf, mesh, *place, arguments.extraction);
    extract_seconds += cpu_seconds();
    for (ElementSection& piece : extracted.sections) pieces.push_back(std::move(piece));
    pieces.push_back(core_section(leaf, mesh, extracted.core));
    interior[leaf.path.heap] = static_cast<std::uint32_t>(mesh.nodes.size() - leaf.vertices.size());
  }
  std::map<Sharers, ElementSection> sections = joined_by_sharers(pieces);
  pieces.clear();
  complain(values_of(sections), surface);
  std::printf(" %zu leaves, meshed in %.2f s\n", leaves.size(), mesh_seconds);
  std::printf(" estimate %.0f, worst leaf %+.1f %%\n", estimated, 100 * worst_estimate);
  AllFigures before = figures_of(values_of(sections), spacing, order);
  before.all.print("all before");
  before.seams.print("seams before");
  std::int64_t taken = 0;
  for (const auto& [sharers, section] : sections) {
    if (sharers.size() > 1) taken += std::ssize(section.tets);
  }
  const Turns turns = give_turns(order, arguments, interior, spacing, sections);
  complain(values_of(sections), surface);
  AllFigures after = figures_of(values_of(sections), spacing, order);
  after.seams.print("seams after");
  after.all.print("all after");
  print_worst(values_of(sections), arguments.worst, smallest_dihedral_deg);
  print_worst(values_of(sections), arguments.lowest, smallest_height);
  std::printf("  %lld tets taken out of cores in %.2f s\n", static_cast<long long>(taken),
              extract_seconds);
  std::printf(
      "  %d colours, at most %zu neighbours, largest region %lld tets, %.2f s; %lld swaps, %lld "
      "moves, %lld collapses, %lld splits\n",
      turns.colours, turns.most_neighbours, static_cast<long long>(turns.largest_region),
      turns.seconds, static_cast<long long>(turns.report.swaps),
      static_cast<long long>(turns.report.moves), static_cast<long long>(turns.report.collapses),
      static_cast<long long>(turns.report.splits));
  return 0;
}
