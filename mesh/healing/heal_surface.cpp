#include "mesh/healing/heal_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/core/complaints.h"
#include "mesh/healing/body_union.h"
#include "mesh/healing/crossing_replacement.h"
#include "mesh/healing/equal_triangles.h"
#include "mesh/healing/flat_triangles.h"
#include "mesh/healing/hole_filling.h"
#include "mesh/healing/nearly_flat_triangles.h"
#include "mesh/healing/open_seams.h"
#include "mesh/healing/vertex_welding.h"
#include "mesh/inspect/defect_text.h"

namespace tetfarm {
namespace {

constexpr int most_heal_rounds = 8;
constexpr double weld_share = 1e-6;
constexpr double hole_share = 0.1;
constexpr double move_share = 1e-3;

struct KindWords {
  const char* name;
  const char* one;
  const char* several;
};

constexpr std::array<KindWords, heal_kinds> kind_words = {{
    {"vertex", "vertex joined with another", "vertices joined with others"},
    {"duplicate triangle", "duplicate triangle removed", "duplicate triangles removed"},
    {"fold", "fold of two equal triangles removed", "folds of two equal triangles removed"},
    {"flat triangle", "triangle without area removed", "triangles without area removed"},
    {"nearly flat triangle", "nearly flat triangle removed", "nearly flat triangles removed"},
    {"seam", "open edge divided at a vertex on it", "open edges divided at vertices on them"},
    {"hole", "hole filled", "holes filled"},
    {"crossing", "group of crossing triangles replaced", "groups of crossing triangles replaced"},
    {"union", "body that goes through others or itself united",
     "bodies that go through others or themselves united"},
    {"inner body", "body inside others removed", "bodies inside others removed"},
}};

/// Numbers and coordinates that nobody can make sense of are not for healing.
bool is_beyond_healing(const SurfaceReport& report) {
  return std::ranges::any_of(report.defects, [](const SurfaceDefect& defect) {
    return defect.kind == "bad vertex number" || defect.kind == "bad coordinate" ||
           defect.kind == "too few triangles";
  });
}

std::vector<char> marked(const SurfaceMesh& surface, const SurfaceReport& report,
                         const std::string& kind) {
  std::vector<char> is_marked(surface.triangles.size(), 0);
  for (const SurfaceDefect& defect : report.defects) {
    if (!kind.empty() && defect.kind != kind) continue;
    for (const std::int64_t t : defect.triangles) is_marked[static_cast<std::size_t>(t)] = 1;
  }
  return is_marked;
}

/// What is done to the surface as it is; the number of changes.
std::int64_t heal_once(HealingWork& work, const SurfaceReport& report) {
  std::int64_t changes = weld_vertices(work, marked(work.surface, report, ""));
  changes += remove_equal_triangles(work);
  changes += remove_flat_triangles(work);
  changes += divide_open_edges(work);
  changes += remove_equal_triangles(work);
  if (changes == 0) changes += fill_holes(work);
  // Of the same triangles as the report speaks of.
  if (changes == 0) {
    changes += replace_crossings(work, marked(work.surface, report, "self-intersection"));
  }
  if (changes == 0) changes += unite_bodies(work);
  return changes;
}

void require_length(double value, const std::string& option) {
  if (value >= 0 && std::isfinite(value)) return;
  throw UsageError("must be a length, and positive", option);
}

}  // namespace

HealedSurface heal_surface(const SurfaceMesh& surface, const RegionRules& rules,
                           const HealOptions& options) {
  require_length(options.tolerance, "--heal-tolerance");
  require_length(options.largest_hole, "--largest-hole");
  HealedSurface healed{surface, {}, check_surface(surface, rules)};
  if (is_beyond_healing(healed.checked.report)) return healed;
  const double diagonal = norm(bounding_box(surface.vertices).size());
  HealingWork work{healed.surface,
                   options.tolerance > 0 ? options.tolerance : weld_share * diagonal,
                   options.largest_hole > 0 ? options.largest_hole : hole_share * diagonal,
                   move_share * diagonal, healed.acts};
  for (int round = 0; round < most_heal_rounds; ++round) {
    if (healed.checked.report.defects.empty()) break;
    if (heal_once(work, healed.checked.report) == 0) break;
    healed.checked = check_surface(healed.surface, rules);
    if (is_beyond_healing(healed.checked.report)) break;
  }
  if (healed.checked.report.defects.empty() && remove_nearly_flat_triangles(work) > 0) {
    healed.checked = check_surface(healed.surface, rules);
  }
  return healed;
}

std::vector<std::string> heal_texts(const std::vector<HealAct>& acts) {
  std::vector<std::string> texts;
  for (std::size_t kind = 0; kind < heal_kinds; ++kind) {
    std::vector<std::string> places;
    std::size_t count = 0;
    for (const HealAct& act : acts) {
      if (static_cast<std::size_t>(act.kind) != kind) continue;
      if (++count <= places_named) places.push_back(text_of(act.at));
    }
    if (count == 0) continue;
    const KindWords& words = kind_words.at(kind);
    texts.push_back(with_places(counted(count, words.one, words.several), places, count));
  }
  return texts;
}

const char* name_of(HealKind kind) { return kind_words.at(static_cast<std::size_t>(kind)).name; }

}  // namespace tetfarm
