#include "mesh/inspect/region_choice.h"

#include <algorithm>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "base/counted.h"
#include "base/error.h"
#include "mesh/core/complaints.h"
#include "mesh/inspect/defect_text.h"
#include "mesh/inspect/region_map.h"

namespace tetfarm {
namespace {

/// A region of the map as it will be.
struct Choice {
  bool is_void = true;
  std::string name;
  const RegionWish* wish = nullptr;
};

bool is_void_by_default(const RegionMap& map, std::int32_t region, const RegionRules& rules,
                        bool has_interfaces) {
  if (region == 0) return !rules.is_outside_meshed;
  if (has_interfaces) return rules.is_outside_meshed;
  return (map.depth(region) % 2 == 0) != rules.is_outside_meshed;
}

void grant(const RegionWish& wish, const RegionMap& map, const RegionRules& rules,
           std::vector<Choice>& choices) {
  const std::optional<std::int32_t> region = map.region_at(wish.at);
  const auto refuse = [&wish](const std::string& what) {
    throw UsageError("the point " + text_of(wish.at) + " " + what, "region.at");
  };
  if (!region) return refuse("is on the surface, so it cannot tell which side is meant");
  if (*region == 0 && !rules.is_outside_meshed) return refuse("is outside the surface");
  if (*region == 0 && wish.is_void)
    return refuse("is outside the surface, which is to be meshed up to the outer boundary");
  Choice& choice = choices[at(*region)];
  if (choice.wish != nullptr) {
    return refuse("is in the same region as " + text_of(choice.wish->at));
  }
  choice = {wish.is_void, wish.name, &wish};
}

std::vector<Choice> choices_of(const RegionMap& map, const RegionRules& rules,
                               bool has_interfaces) {
  std::vector<Choice> choices(at(map.regions()) + 1);
  for (std::int32_t region = 0; region <= map.regions(); ++region) {
    choices[at(region)].is_void = is_void_by_default(map, region, rules, has_interfaces);
  }
  for (const RegionWish& wish : rules.wishes) grant(wish, map, rules, choices);
  return choices;
}

/// The numbers of the regions that are meshed; fills names and figures.
std::vector<std::int32_t> number_regions(const RegionMap& map, const std::vector<Choice>& choices,
                                         const RegionRules& rules, SurfaceMesh& surface,
                                         SurfaceReport& report) {
  std::vector<std::int32_t> old2new(choices.size(), 0);
  std::int32_t last = 0;
  for (std::size_t region = 0; region < choices.size(); ++region) {
    const Choice& choice = choices[region];
    if (region == 0 && !rules.is_outside_meshed) continue;
    RegionFigures figures;
    if (!choice.is_void) {
      figures.number = old2new[region] = ++last;
      figures.name = !choice.name.empty() ? choice.name
                     : region == 0        ? "outside"
                                          : "region " + std::to_string(last);
      surface.region_names.push_back(figures.name);
    } else {
      figures.name = choice.name;
    }
    if (region > 0) figures.volume = map.volume(static_cast<std::int32_t>(region));
    report.regions.push_back(figures);
  }
  TF_CHECK(at(last) == surface.region_names.size());
  return old2new;
}

/// Also remarks on what is turned, and what is left out.
void set_sides(const RegionMap& map, const std::vector<std::int32_t>& old2new, SurfaceMesh& surface,
               SurfaceReport& report) {
  std::size_t turned = 0;
  std::size_t left_out = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto [behind, front] = map.sides_of(t);
    TF_CHECK(at(behind) < old2new.size() && at(front) < old2new.size());
    Sides sides = {old2new[at(behind)], old2new[at(front)]};
    const bool points_in = sides[0] == 0 && sides[1] > 0;
    if (points_in || (sides[1] > 0 && sides[1] < sides[0])) {
      std::swap(surface.triangles[t][1], surface.triangles[t][2]);
      std::swap(sides[0], sides[1]);
      if (points_in) ++turned;
    }
    if (sides == Sides{0, 0}) ++left_out;
    surface.sides.push_back(sides);
  }
  if (turned > 0) {
    report.remarks.push_back(counted(turned, "triangle") +
                             " pointed into the domain and had to be turned");
  }
  if (left_out > 0) {
    report.remarks.push_back(counted(left_out, "triangle") +
                             " with no meshed region on either side: left out");
  }
}

std::optional<SurfaceDefect> sheets_inside(const RegionMap& map, const SurfaceMesh& surface) {
  std::vector<std::int32_t> sheet;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto [behind, front] = map.sides_of(t);
    if (behind == front) sheet.push_back(static_cast<std::int32_t>(t));
  }
  if (sheet.empty()) return std::nullopt;
  return defect_of_triangles(
      surface, "sheet inside a region",
      counted(sheet.size(), "triangle") + " with the same region on both sides: they bound nothing",
      sheet);
}

}  // namespace

std::optional<SurfaceDefect> choose_regions(const RegionMap& map, const RegionRules& rules,
                                            bool has_interfaces, SurfaceMesh& surface,
                                            SurfaceReport& report) {
  if (const auto part = map.unclear_part()) {
    return defect_of_triangles(
        surface, "unclear regions",
        "the surface touches itself in such a way that its inside is unclear",
        map.parts()[at(*part)].triangles);
  }
  if (auto defect = sheets_inside(map, surface)) return defect;
  const std::vector<Choice> choices = choices_of(map, rules, has_interfaces);
  const auto old2new = number_regions(map, choices, rules, surface, report);
  if (surface.region_names.empty()) {
    return SurfaceDefect{"nothing to mesh", "the job declares every region void", {}};
  }
  set_sides(map, old2new, surface, report);
  report.volume = 0;
  for (const RegionFigures& region : report.regions) {
    if (region.number > 0) report.volume += region.volume;
  }
  for (const RegionMap::Part& part : map.parts()) {
    Shell& shell = report.shells.emplace_back();
    shell.triangles = part.triangles;
    shell.volume = part.volume;
    shell.parent = part.parent;
    shell.depth = part.depth;
  }
  return std::nullopt;
}

}  // namespace tetfarm
