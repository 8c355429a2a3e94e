#include "cli/plane_command_line.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/client_options.h"
#include "cli/option_checks.h"

namespace tetfarm {
namespace {

void add_corner_angle(CLI::App& sub, double& angle_deg) {
  sub.add_option("--corner-angle", angle_deg,
                 "Nodes at which the boundary turns by more degrees stay (default 30)")
      ->check(number_between(1, 180))
      ->option_text("DEG");
}

void add_curves(CLI::App& sub, std::vector<std::string>& curves) {
  sub.add_option("--curve", curves,
                 "The true curve of a patch, on which its nodes stay: naca00XX, circle, line or "
                 "spline:FILE.xy; may be repeated")
      ->check(not_empty())
      ->allow_extra_args(false)
      ->option_text("PATCH=KIND");
}

void add_sources(CLI::App& sub, std::string& sources) {
  sub.add_option("--sources", sources,
                 "Points and lines round which edges have the lengths and directions that it says "
                 "(.toml)")
      ->check(not_empty())
      ->option_text("FILE");
}

void add_vertices(CLI::App& sub, std::optional<std::int64_t>& vertices,
                  const std::string& otherwise) {
  sub.add_option("--vertices", vertices,
                 "How many vertices the new mesh is to have (default: " + otherwise + ")")
      ->check(whole_number(3, 50'000'000))
      ->option_text("N");
}

}  // namespace

void add_plane(CLI::App& sub, PlaneCommand& plane) {
  sub.add_option("BOUNDARY", plane.inputs,
                 "Closed loops: a line \"x y\" for each point, an empty line between two (.xy)")
      ->required();
  sub.add_option("-o,--output", plane.output, "The mesh (.mesh)")->required()->option_text("FILE");
  CLI::Option* size = sub.add_option("--size", plane.size,
                                     "Edge length (default: as the edges of the loops, growing "
                                     "from short ones to long ones)")
                          ->check(positive_number())
                          ->option_text("H");
  sub.add_option("--metric", plane.metric,
                 "Metrics at the points of the loops, in their order: symmetric tensors (.sol)")
      ->check(not_empty())
      ->excludes(size)
      ->option_text("FILE");
  add_sources(sub, plane.sources);
  add_vertices(sub, plane.vertices, "as the sizes say");
  sub.add_option("--gradation", plane.gradation,
                 "How fast sizes may grow from edge to edge (default 1.25 where the edges of the "
                 "loops say them, else off)")
      ->check(off_or_number_above(1, 100))
      ->option_text("G|off");
  add_corner_angle(sub, plane.corner_angle_deg);
  add_curves(sub, plane.curves);
  add_json(sub, plane.json);
}

void add_adapt(CLI::App& sub, AdaptCommand& adapt) {
  sub.add_option("MESH", adapt.input, "The mesh (.mesh)")->required();
  sub.add_option("-o,--output", adapt.output, "The new mesh (.mesh)")
      ->required()
      ->option_text("FILE");
  CLI::Option* metric = sub.add_option("--metric", adapt.metric,
                                       "Metrics at the nodes of MESH: symmetric tensors (.sol)")
                            ->check(not_empty())
                            ->option_text("FILE");
  sub.add_option("--solution", adapt.solution,
                 "Numbers at the nodes of MESH (.sol): edges become short where the field bends")
      ->check(not_empty())
      ->excludes(metric)
      ->option_text("FILE");
  add_sources(sub, adapt.sources);
  add_vertices(sub, adapt.vertices, "as the metric says; with a solution, as many as MESH");
  sub.add_option("--norm", adapt.norm,
                 "Norm of the error that is made small: low for weak features too, high for the "
                 "strongest alone (default 2)")
      ->check(number_between(0.5, 100))
      ->option_text("P");
  sub.add_option("--h-min", adapt.h_min, "Smallest size")
      ->check(positive_number())
      ->option_text("H");
  sub.add_option("--h-max", adapt.h_max, "Largest size")
      ->check(positive_number())
      ->option_text("H");
  sub.add_option("--gradation", adapt.gradation,
                 "How fast sizes may grow from edge to edge (default: off with --metric, 1.4 with "
                 "--solution)")
      ->check(off_or_number_above(1, 100))
      ->option_text("G|off");
  sub.add_option("--aspect", adapt.aspect, "Largest ratio of sizes at a point (default 10000)")
      ->check(number_between(1, 1e7))
      ->option_text("A");
  sub.add_option(
         "--mode", adapt.mode,
         "From a solution: lp weighs strong and weak features by --norm, hessian takes the "
         "second derivatives as they are, thesis does too and compares edges with their mean "
         "(default lp)")
      ->check(CLI::IsMember({"lp", "hessian", "thesis"}))
      ->option_text("lp|hessian|thesis");
  add_corner_angle(sub, adapt.corner_angle_deg);
  add_curves(sub, adapt.curves);
  add_json(sub, adapt.json);
}

void add_plane_transfer(CLI::App& sub, PlaneTransferCommand& transfer) {
  sub.add_option("MESH", transfer.input, "The mesh of the solution (.mesh)")->required();
  sub.add_option("--solution", transfer.solution,
                 "Numbers, vectors or metrics at the nodes of MESH (.sol)")
      ->required()
      ->check(not_empty())
      ->option_text("FILE");
  sub.add_option("--to", transfer.to, "The mesh to bring them to (.mesh)")
      ->required()
      ->check(not_empty())
      ->option_text("FILE");
  sub.add_option("-o,--output", transfer.output, "The solution on that mesh (.sol)")
      ->required()
      ->option_text("FILE");
  sub.add_option("--method", transfer.method,
                 "conservative keeps integrals, linear takes the value at each node (default "
                 "conservative)")
      ->check(CLI::IsMember({"conservative", "linear"}))
      ->option_text("conservative|linear");
  add_json(sub, transfer.json);
}

}  // namespace tetfarm
