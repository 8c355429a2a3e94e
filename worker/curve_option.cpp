#include "worker/curve_option.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "mesh/adaptation/checked_plane_mesh.h"
#include "mesh/adaptation/circle_curve.h"
#include "mesh/adaptation/naca_fit.h"
#include "mesh/adaptation/point_spline.h"
#include "mesh/formats/plane/read_loops.h"

namespace tetfarm {
namespace {

constexpr std::string_view kinds =
    "naca00XX (naca0012:chord=1,x=0,y=0,angle=0), circle (circle:x=0,y=0,r=1), line, "
    "spline:FILE.xy";

/// An option taken apart.
struct CurveWish {
  std::string name;  ///< "--curve 1=circle"
  std::vector<std::int32_t> patches;
  std::string kind;
  std::map<std::string, double> numbers;
  std::string file;
  double thickness = 0;
};

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t comma = text.find(',');
    parts.push_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

template <class Number>
std::optional<Number> whole_text_as(std::string_view text) {
  Number value{};
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc{} || read.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

void read_numbers(CurveWish& wish, std::string_view text, const std::set<std::string>& allowed) {
  for (const std::string_view part : split(text)) {
    const std::size_t equals = part.find('=');
    const std::string key(part.substr(0, equals));
    if (!allowed.contains(key)) {
      std::string known;
      for (const std::string& name : allowed) known += (known.empty() ? "" : ", ") + name;
      throw UsageError("there is no \"" + key + "\"; it has " + known, wish.name);
    }
    const std::optional<double> value = equals == std::string_view::npos
                                            ? std::nullopt
                                            : whole_text_as<double>(part.substr(equals + 1));
    const bool is_length = key == "chord" || key == "r";
    if (!value.has_value() || !(std::abs(*value) < 1e12) || (is_length && !(*value > 1e-12))) {
      throw UsageError(key + " must be a number" + (is_length ? " above 0" : ""), wish.name);
    }
    if (!wish.numbers.emplace(key, *value).second) {
      throw UsageError(key + " is there twice", wish.name);
    }
  }
}

/// Of naca0012 0.12.
double thickness_of(const CurveWish& wish, std::string_view digits) {
  const std::optional<int> number = whole_text_as<int>(digits);
  if (digits.size() != 4 || !number.has_value()) {
    throw UsageError("a profile is naca and four digits, as naca0012", wish.name);
  }
  if (*number > 99 || *number < 1) {
    throw UsageError("only symmetric profiles are known, naca0001 to naca0099", wish.name);
  }
  return *number / 100.0;
}

void read_kind(CurveWish& wish, std::string_view text) {
  const std::size_t colon = text.find(':');
  wish.kind = text.substr(0, colon);
  const bool has_more = colon != std::string_view::npos;
  const std::string_view more = has_more ? text.substr(colon + 1) : std::string_view{};
  if (wish.kind == "spline") {
    wish.file = more;
    if (wish.file.empty()) throw UsageError("a spline has a file: spline:FILE.xy", wish.name);
  } else if (wish.kind == "circle") {
    if (has_more) read_numbers(wish, more, {"x", "y", "r"});
    if (has_more && !wish.numbers.contains("r")) {
      throw UsageError("a circle has a radius r; x and y are 0 where they are not given",
                       wish.name);
    }
  } else if (wish.kind.starts_with("naca")) {
    wish.thickness = thickness_of(wish, std::string_view(wish.kind).substr(4));
    if (has_more) read_numbers(wish, more, {"chord", "x", "y", "angle"});
  } else if (wish.kind != "line" || has_more) {
    throw UsageError(
        "there is no curve \"" + std::string(text) + "\"; there are " + std::string(kinds),
        wish.name);
  }
}

CurveWish wish_of(const std::string& option) {
  CurveWish wish;
  wish.name = "--curve " + option;
  const std::size_t equals = option.find('=');
  if (equals == std::string::npos) {
    throw UsageError("is PATCH=KIND, and KIND one of " + std::string(kinds), wish.name);
  }
  for (const std::string_view part : split(std::string_view(option).substr(0, equals))) {
    const std::optional<std::int32_t> patch = whole_text_as<std::int32_t>(part);
    if (!patch.has_value()) {
      throw UsageError("patches of a .mesh file are numbers, not \"" + std::string(part) + "\"",
                       wish.name);
    }
    wish.patches.push_back(*patch);
  }
  read_kind(wish, std::string_view(option).substr(equals + 1));
  return wish;
}

std::vector<CurveWish> wishes_of(const std::vector<std::string>& options) {
  std::vector<CurveWish> wishes;
  std::set<std::int32_t> taken;
  for (const std::string& option : options) {
    wishes.push_back(wish_of(option));
    for (const std::int32_t patch : wishes.back().patches) {
      if (taken.insert(patch).second) continue;
      throw UsageError("patch " + std::to_string(patch) + " has a curve already",
                       wishes.back().name);
    }
  }
  return wishes;
}

double number_of(const CurveWish& wish, const std::string& key, double otherwise) {
  const auto found = wish.numbers.find(key);
  return found == wish.numbers.end() ? otherwise : found->second;
}

/// A curve, and what it is in words.
struct NamedParts {
  std::vector<std::shared_ptr<const TrueCurve>> parts;
  std::string text;
};

NamedParts circle_of(const CurveWish& wish, const std::vector<Vec2>& nodes) {
  std::optional<Circle> circle;
  if (wish.numbers.empty()) {
    circle = fitted_circle(nodes);
  } else {
    circle = Circle{{number_of(wish, "x", 0), number_of(wish, "y", 0)}, number_of(wish, "r", 1)};
  }
  if (!circle.has_value()) throw InvalidInput("the nodes do not make a circle", wish.name);
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "radius %.9g about (%.9g, %.9g)", circle->radius,
                circle->centre.x, circle->centre.y);
  return {{std::make_shared<const CircleCurve>(*circle)}, text.data()};
}

NamedParts naca_of(const CurveWish& wish, const std::vector<Vec2>& nodes) {
  if (wish.numbers.empty()) {
    const std::optional<NacaPlace> place = fitted_naca(nodes, wish.thickness);
    if (!place.has_value()) {
      throw InvalidInput(
          "the patch has too few nodes to find the profile by: give its chord, x, y "
          "and angle",
          wish.name);
    }
    return {naca_parts(*place), naca_text(*place)};
  }
  NacaPlace place;
  place.thickness = wish.thickness;
  place.nose = {number_of(wish, "x", 0), number_of(wish, "y", 0)};
  place.chord = number_of(wish, "chord", 1);
  place.along = direction_of_angle(number_of(wish, "angle", 0));
  place = with_fitting_edge(nodes, place);
  return {naca_parts(place), naca_text(place)};
}

NamedParts splines_of(const CurveWish& wish, const std::filesystem::path& file,
                      double corner_angle_deg) {
  NamedParts named;
  for (const PlaneLoop& loop : read_loops(file)) {
    for (auto& part : splines_of_loop(loop.points, corner_angle_deg)) {
      named.parts.push_back(std::move(part));
    }
  }
  named.text = std::to_string(named.parts.size()) + " between corners of " + wish.file;
  return named;
}

NamedParts parts_of(const CurveWish& wish, const std::vector<Vec2>& nodes, double corner_angle_deg,
                    const PlaceOfSpline& place) {
  if (wish.kind == "line") return {{}, "straight between corners"};
  if (wish.kind == "spline") return splines_of(wish, place(wish.file), corner_angle_deg);
  return wish.kind == "circle" ? circle_of(wish, nodes) : naca_of(wish, nodes);
}

}  // namespace

void check_curve_options(const std::vector<std::string>& options) { wishes_of(options); }

std::vector<std::string> spline_files(const std::vector<std::string>& options) {
  std::vector<std::string> files;
  for (const CurveWish& wish : wishes_of(options)) {
    if (wish.file.empty() || std::find(files.begin(), files.end(), wish.file) != files.end()) {
      continue;
    }
    files.push_back(wish.file);
  }
  return files;
}

CurvesOfMesh curves_of_options(const std::vector<std::string>& options, PlaneMesh mesh,
                               double corner_angle_deg) {
  return curves_of_options(options, std::move(mesh), corner_angle_deg,
                           [](const std::string& typed) { return typed; });
}

CurvesOfMesh curves_of_options(const std::vector<std::string>& options, PlaneMesh mesh,
                               double corner_angle_deg, const PlaceOfSpline& place) {
  CurvesOfMesh result;
  result.complex = checked_complex(mesh);
  for (const CurveWish& wish : wishes_of(options)) {
    std::vector<Vec2> nodes;
    for (const std::int32_t v : nodes_of_patches(mesh, result.complex, wish.patches, wish.name)) {
      nodes.push_back(mesh.points[static_cast<std::size_t>(v)]);
    }
    NamedParts named = parts_of(wish, nodes, corner_angle_deg, place);
    result.curves.push_back({wish.patches, wish.name, std::move(named.parts)});
    result.texts.push_back(std::move(named.text));
  }
  if (result.curves.empty()) {
    result.mesh = std::move(mesh);
    return result;
  }
  NodesOnCurves placed = put_on_curves(mesh, result.complex, result.curves, corner_angle_deg);
  result.mesh = std::move(placed.mesh);
  result.complex = checked_complex(result.mesh);
  result.moved = std::move(placed.moved);
  TF_CHECK(result.moved.size() == result.curves.size());
  return result;
}

}  // namespace tetfarm
