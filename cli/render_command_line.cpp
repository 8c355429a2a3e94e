#include "cli/render_command_line.h"

#include <vector>

#include "cli/client_options.h"
#include "cli/option_checks.h"

namespace tetfarm {
namespace {

CLI::Option* add_place(CLI::App& sub, const char* name, std::vector<double>& value,
                       const char* what) {
  return sub.add_option(name, value, what)->delimiter(',')->expected(3)->option_text("X,Y,Z");
}

void add_view(CLI::App& sub, RenderCommand& render) {
  sub.add_option(
         "--view", render.view,
         "The surface, the sub-domains pulled apart, the mesh cut open, or a plane through its "
         "cells (default surface)")
      ->check(CLI::IsMember({"surface", "exploded", "cut", "slice"}))
      ->option_text("surface|exploded|cut|slice");
  sub.add_option("--colour", render.colour, "Colour by (default subdomain)")
      ->check(CLI::IsMember({"subdomain", "region", "patch", "layer"}))
      ->option_text("subdomain|region|patch|layer");
  sub.add_option("--size", render.size, "Size in pixels (default 1600x1000)")->option_text("WxH");
  add_place(sub, "--from", render.from,
            "Direction from the mesh to the viewer (default -1,-2,1; of a slice, at right angles "
            "to it)");
  add_place(sub, "--up", render.up, "Direction that points up in the picture (default 0,0,1)");
  sub.add_option("--zoom", render.zoom, "Magnification; at 1 the mesh fits the picture (default 1)")
      ->check(positive_number())
      ->option_text("Z");
  sub.add_option("--across", render.across,
                 "Width of the picture, in units of the mesh at its centre, instead of --zoom")
      ->check(positive_number())
      ->excludes("--zoom")
      ->option_text("LENGTH");
  add_place(sub, "--centre", render.centre,
            "What is in the middle of the picture; of a mesh of the plane X,Y (default: the mesh)")
      ->expected(2, 3);
}

void add_parts(CLI::App& sub, RenderCommand& render) {
  sub.add_option("--body", render.bodies, "Patches to show whole (default: all but outer_*)")
      ->delimiter(',')
      ->option_text("PATCH,...");
  sub.add_option("--hide", render.hidden, "Patches to hide")
      ->delimiter(',')
      ->option_text("PATCH,...");
  add_place(sub, "--plane", render.plane, "Normal of the plane of a cut or slice (default 0,1,0)");
  sub.add_option("--at", render.at, "Position of the plane along its normal (default: the middle)")
      ->option_text("D");
  sub.add_option("--explode", render.explode, "How far to pull the sub-domains apart (default 0.4)")
      ->check(not_negative_number())
      ->option_text("SHARE");
  sub.add_option("--edges", render.edge_width,
                 "Width of the edges in pixels, 0 for none (default 0.9; over a field 0)")
      ->check(not_negative_number())
      ->option_text("W");
}

void add_fields(CLI::App& sub, RenderCommand& render) {
  CLI::Option* field = sub.add_option("--field", render.field,
                                      "On a mesh of the plane: numbers at its nodes (.sol), as "
                                      "bands of colour")
                           ->check(not_empty())
                           ->option_text("FILE");
  sub.add_option("--field-number", render.field_number,
                 "Which of several numbers at a node (default 1)")
      ->check(counting_number())
      ->needs(field)
      ->option_text("K");
  sub.add_option("--levels", render.levels, "How many bands (default 20)")
      ->check(whole_number(1, 1000))
      ->needs(field)
      ->option_text("N");
  sub.add_option("--range", render.range,
                 "Values of the lowest and the highest band (default: those of the field)")
      ->delimiter(',')
      ->expected(2)
      ->needs(field)
      ->option_text("LOW,HIGH");
  CLI::Option* along = sub.add_option("--along", render.along,
                                      "Instead of a picture, a chart of the field along patches "
                                      "over x (.svg)")
                           ->delimiter(',')
                           ->needs(field)
                           ->option_text("PATCH,...");
  sub.add_flag("--reversed", render.reversed, "The chart with small values on top, as of Cp")
      ->needs(along)
      ->option_text(" ");
  sub.add_option("--also", render.also,
                 "Another mesh and its field in the same chart; may be "
                 "repeated")
      ->allow_extra_args(false)
      ->needs(along)
      ->option_text("MESH,FIELD");
  sub.add_option("--metric", render.metric,
                 "On a mesh of the plane: metrics at its nodes (.sol), as ellipses")
      ->check(not_empty())
      ->excludes(along)
      ->option_text("FILE");
}

}  // namespace

void add_render(CLI::App& sub, const std::string& what_is_drawn, RenderCommand& render) {
  sub.add_option("FILE", render.input, what_is_drawn)->required();
  add_place_of_jobs(sub, render.source);
  sub.add_option("-o,--output", render.output, "The picture; with --along, the chart (.svg)")
      ->required()
      ->option_text("PNG");
  add_view(sub, render);
  add_parts(sub, render);
  add_fields(sub, render);
}

}  // namespace tetfarm
