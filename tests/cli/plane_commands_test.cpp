// The commands for meshes of the plane, called as main calls them.
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/file_system.h"
#include "cli/commands.h"
#include "mesh/formats/plane/plane_files.h"
#include "tests/base/temp_folder.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class PlaneCommands : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    write_file_atomically(path(name), text);
    return path(name);
  }
  /// A square of edge 1, or the loops given, meshed with edges of the length.
  Said said_of(double size, const std::string& loops) const {
    PlaneCommand command;
    command.inputs = {write("loops.xy", loops)};
    command.output = path("plane.mesh");
    command.size = size;
    command.json = true;
    return said_by([&] { return plane_command(command); });
  }
  json meshed(double size, const std::string& loops = "0 0\n1 0\n1 1\n0 1\n") const {
    return json::parse(said_of(size, loops).out);
  }
  std::string refusal(const std::string& loops) const { return said_of(0.1, loops).error; }
  /// A field at the vertices of plane.mesh.
  template <class Field>
  std::string field(const std::string& name, const Field& value) const {
    const PlaneMesh mesh = read_plane_medit(path("plane.mesh"));
    std::string text = "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n" +
                       std::to_string(mesh.points.size()) + "\n1 1\n";
    for (const Vec2& p : mesh.points) text += std::to_string(value(p)) + "\n";
    return write(name, text);
  }
  AdaptCommand to_solution(const std::string& solution) const {
    AdaptCommand command;
    command.input = path("plane.mesh");
    command.solution = solution;
    command.output = path("adapted.mesh");
    command.json = true;
    return command;
  }
  static json adapted(const AdaptCommand& command) {
    return json::parse(said_by([&] { return adapt_command(command); }).out);
  }
  static std::string message_of(const AdaptCommand& command) {
    return said_by([&] { return adapt_command(command); }).error;
  }

  const TempFolder folder_;
};

double shock(const Vec2& p) { return std::tanh(20 * (p.x - 0.5)); }

TEST_F(PlaneCommands, fill_a_square_with_edges_of_the_size) {
  const json result = meshed(0.05);
  EXPECT_EQ(result["type"], "plane");
  // 2 / sqrt(3) vertices in a square of the size, and the boundary.
  EXPECT_NEAR(result["vertices"].get<double>(), 480, 60);
  EXPECT_GT(result["unit_edges_percent"], 99.5);
  EXPECT_GT(result["quality_min"], 0.6);
  const PlaneMesh mesh = read_plane_medit(path("plane.mesh"));
  EXPECT_EQ(mesh.points.size(), result["vertices"].get<std::size_t>());
  EXPECT_EQ(mesh.corners.size(), 4U);
}

TEST_F(PlaneCommands, leave_out_what_two_loops_enclose_whatever_way_they_run) {
  const std::string hole = "\n0.4 0.4\n0.6 0.4\n0.6 0.6\n0.4 0.6\n";
  const std::string turned = "\n0.4 0.4\n0.4 0.6\n0.6 0.6\n0.6 0.4\n";
  for (const std::string& inner : {hole, turned}) {
    meshed(0.1, "0 0\n1 0\n1 1\n0 1\n" + inner);
    const PlaneMesh mesh = read_plane_medit(path("plane.mesh"));
    double doubled = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec2& p = mesh.points[static_cast<std::size_t>(a)];
      const Vec2& q = mesh.points[static_cast<std::size_t>(b)];
      const Vec2& r = mesh.points[static_cast<std::size_t>(c)];
      doubled += (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    }
    EXPECT_NEAR(doubled / 2, 0.96, 1e-12);
  }
}

TEST_F(PlaneCommands, refuse_loops_that_are_none_with_the_place) {
  EXPECT_THAT(refusal("0 0\n1 0\n"), HasSubstr("loops.xy:1: a loop has at least three points"));
  EXPECT_THAT(refusal("0 0\n1 0\nx 1\n"), HasSubstr("loops.xy:3: a point is two numbers"));
  EXPECT_THAT(refusal("0 0\n1 0\n1 0\n0 1\n"),
              HasSubstr("loops.xy:3: the point is that of the line before"));
  EXPECT_THAT(refusal("0 0\n1 0\nnan 1\n"), HasSubstr("loops.xy:3"));
  EXPECT_THAT(refusal("0 0\n1 1\n1 0\n0 1\n"), HasSubstr("(0.5, 0.5)"));
  EXPECT_THAT(refusal(""), HasSubstr("has no points"));
}

TEST_F(PlaneCommands, take_a_first_line_without_numbers_for_a_title) {
  EXPECT_EQ(meshed(0.2, "a square\n0 0\n1 0\n1 1\n0 1\n0 0\n")["type"], "plane");
}

TEST_F(PlaneCommands, keep_the_names_of_patches_and_write_by_the_ending) {
  PlaneCommand command;
  command.inputs = {write("outer.xy", "0 0\n1 0\n1 1\n0 1\n"),
                    write("holes.xy", "0.2 0.2\n0.4 0.2\n0.4 0.4\n\n0.6 0.6\n0.8 0.6\n0.8 0.8\n")};
  command.output = path("plane.su2");
  said_by([&] { return plane_command(command); });
  const PlaneMesh mesh = read_plane_mesh(command.output);
  const std::map<std::int32_t, std::string> names = {{1, "outer"}, {2, "holes_1"}, {3, "holes_2"}};
  EXPECT_EQ(mesh.patch_names, names);
  AdaptCommand adapt;
  adapt.input = command.output;
  adapt.metric = path("metric.sol");
  write_plane_sol(std::vector<Metric2>(mesh.points.size(), {100, 0, 100}), adapt.metric);
  adapt.json = true;
  adapt.output = path("adapted.msh");
  adapted(adapt);
  EXPECT_EQ(read_plane_mesh(adapt.output).patch_names, names);
  adapt.output = path("adapted.stl");
  EXPECT_THAT(message_of(adapt),
              HasSubstr("adapted.stl: meshes of the plane are written to .mesh"));
  adapt.input = path("case");
  EXPECT_THAT(message_of(adapt), HasSubstr("case: meshes of the plane are read from .mesh"));
}

TEST_F(PlaneCommands, adapt_to_a_solution_with_the_number_of_vertices_asked_for) {
  meshed(0.05);
  AdaptCommand command = to_solution(field("u.sol", shock));
  command.vertices = 1000;
  const json result = adapted(command);
  EXPECT_EQ(result["type"], "adapt");
  EXPECT_NEAR(result["vertices"].get<double>(), 1000, 50);
  EXPECT_GT(result["unit_edges_percent"], 99);
  EXPECT_LT(result["edge_length_max"], 1.6);
  EXPECT_GT(result["limited"]["gradation"], 0);
  EXPECT_EQ(read_plane_medit(path("adapted.mesh")).points.size(),
            result["vertices"].get<std::size_t>());
}

TEST_F(PlaneCommands, adapt_to_the_same_bytes_again) {
  meshed(0.05);
  const AdaptCommand command = to_solution(field("u.sol", shock));
  const json first = adapted(command);
  const std::string bytes = read_file(path("adapted.mesh"));
  EXPECT_EQ(adapted(command)["digest"], first["digest"]);
  EXPECT_EQ(read_file(path("adapted.mesh")), bytes);
}

TEST_F(PlaneCommands, keep_sizes_and_aspect_within_the_limits) {
  meshed(0.05);
  AdaptCommand command = to_solution(field("u.sol", shock));
  command.vertices = 600;
  command.h_min = 0.02;
  command.h_max = 0.08;
  const json result = adapted(command);
  EXPECT_NEAR(result["vertices"].get<double>(), 600, 30);
  const PlaneMesh mesh = read_plane_medit(path("adapted.mesh"));
  for (const auto& [a, b, c] : mesh.triangles) {
    for (const auto& [from, to] : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) {
      const Vec2& p = mesh.points[static_cast<std::size_t>(from)];
      const Vec2& q = mesh.points[static_cast<std::size_t>(to)];
      EXPECT_GT(std::hypot(q.x - p.x, q.y - p.y), 0.02 * 0.6);
      EXPECT_LT(std::hypot(q.x - p.x, q.y - p.y), 0.08 * 1.6);
    }
  }
}

TEST_F(PlaneCommands, say_what_the_limits_allow_when_the_number_cannot_be_had) {
  meshed(0.1);
  AdaptCommand command = to_solution(field("u.sol", shock));
  command.vertices = 100'000;
  command.h_min = 0.1;
  EXPECT_THAT(message_of(command), HasSubstr("--vertices: with these limits a mesh has about "));
  EXPECT_THAT(message_of(command), HasSubstr("is --h-min too large?"));
}

TEST_F(PlaneCommands, refuse_metrics_that_are_none_with_the_vertex) {
  meshed(0.5);
  const PlaneMesh mesh = read_plane_medit(path("plane.mesh"));
  for (const char* bad : {"nan 0 1", "1 0 0", "1 2 1", "-1 0 -1", "0 0 0"}) {
    std::string text = "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n" +
                       std::to_string(mesh.points.size()) + "\n1 3\n";
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      text += v == 3 ? std::string(bad) + "\n" : "4 0 4\n";
    }
    AdaptCommand command;
    command.input = path("plane.mesh");
    command.metric = write("m.sol", text);
    command.output = path("adapted.mesh");
    EXPECT_THAT(message_of(command), HasSubstr("m.sol")) << bad;
  }
}

/// A loop of n points on a circle of radius 1 about (x, 0).
std::string circle_loop(int n, double x) {
  std::string text;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * k / n;
    text += std::to_string(x + std::cos(angle)) + " " + std::to_string(std::sin(angle)) + "\n";
  }
  return text;
}

TEST_F(PlaneCommands, keep_nodes_on_the_curve_of_their_patch) {
  meshed(0.2, circle_loop(48, 3));
  AdaptCommand command = to_solution(field("u.sol", shock));
  command.vertices = 400;
  command.curves = {"1=circle"};
  const json result = adapted(command);
  ASSERT_EQ(result["curves"].size(), 1U);
  EXPECT_EQ(result["curves"][0]["curve"], "radius 1 about (3, 0)");
  EXPECT_EQ(result["curves"][0]["patches"], json::array({1}));
  EXPECT_LT(result["curves"][0]["farthest_move"], 1e-4);
  const PlaneMesh mesh = read_plane_medit(path("adapted.mesh"));
  for (const auto& [a, b] : mesh.edges) {
    for (const std::int32_t v : {a, b}) {
      const Vec2& p = mesh.points[static_cast<std::size_t>(v)];
      EXPECT_NEAR(std::hypot(p.x - 3, p.y), 1, 1e-14);
    }
  }
}

TEST_F(PlaneCommands, make_the_first_mesh_on_a_curve) {
  PlaneCommand command;
  command.inputs = {write("circle.xy", circle_loop(30, 0))};
  command.output = path("plane.mesh");
  command.curves = {"1=circle:r=1"};
  command.size = 0.05;
  command.json = true;
  EXPECT_EQ(json::parse(said_by([&] { return plane_command(command); }).out)["curves"].size(), 1U);
  const PlaneMesh mesh = read_plane_medit(path("plane.mesh"));
  EXPECT_GT(mesh.edges.size(), 100U);
  for (const auto& edge : mesh.edges) {
    const Vec2& p = mesh.points[static_cast<std::size_t>(edge[0])];
    EXPECT_NEAR(std::hypot(p.x, p.y), 1, 1e-14);
  }
}

TEST_F(PlaneCommands, take_the_spline_of_a_file_for_a_curve) {
  const std::string loop = write("circle.xy", circle_loop(48, 3));
  meshed(0.2, circle_loop(48, 3));
  AdaptCommand command = to_solution(field("u.sol", shock));
  command.curves = {"1=spline:" + loop};
  EXPECT_LT(adapted(command)["curves"][0]["farthest_move"], 1e-14);
}

TEST_F(PlaneCommands, refuse_a_curve_that_is_none_in_the_words_of_the_option) {
  meshed(0.5);
  AdaptCommand command = to_solution(field("u.sol", shock));
  const auto message_with = [&](const std::vector<std::string>& curves) {
    command.curves = curves;
    return message_of(command);
  };
  EXPECT_THAT(message_with({"circle"}),
              HasSubstr("--curve circle: is PATCH=KIND, and KIND one of"));
  EXPECT_THAT(message_with({"1=square"}),
              HasSubstr("there is no curve \"square\"; there are naca"));
  EXPECT_THAT(message_with({"wall=line"}), HasSubstr("are numbers, not \"wall\""));
  EXPECT_THAT(message_with({"1=line", "2,1=line"}), HasSubstr("patch 1 has a curve already"));
  EXPECT_THAT(message_with({"1=circle:q=1"}), HasSubstr("there is no \"q\"; it has r, x, y"));
  EXPECT_THAT(message_with({"1=circle:r=-1"}), HasSubstr("r must be a number above 0"));
  EXPECT_THAT(message_with({"1=circle:r=1,r=2"}), HasSubstr("r is there twice"));
  EXPECT_THAT(message_with({"1=circle:x=1"}), HasSubstr("a circle has a radius r"));
  EXPECT_THAT(message_with({"1=naca2412"}), HasSubstr("only symmetric profiles"));
  EXPECT_THAT(message_with({"1=naca12"}), HasSubstr("is naca and four digits"));
  EXPECT_THAT(message_with({"1=naca0012:angle=x"}), HasSubstr("angle must be a number"));
  EXPECT_THAT(message_with({"1=spline:"}), HasSubstr("spline:FILE.xy"));
  EXPECT_THAT(message_with({"1=spline:none.xy"}), HasSubstr("none.xy"));
  EXPECT_THAT(message_with({"7=line"}),
              HasSubstr("there is no patch 7; " + path("plane.mesh") + " has 1"));
  EXPECT_THAT(message_with({"1=naca0012"}), HasSubstr("--curve 1=naca0012: "));
  EXPECT_THAT(message_with({"1=circle"}), HasSubstr("away from the curve"));
}

TEST_F(PlaneCommands, adapt_by_the_rules_of_the_thesis) {
  meshed(0.05);
  AdaptCommand command = to_solution(field("u.sol", shock));
  command.mode = "thesis";
  command.h_min = 0.005;
  command.h_max = 0.2;
  const json result = adapted(command);
  const double before = result["mean_length_before"];
  const double after = result["mean_length_after"];
  EXPECT_GT(before, 0);
  EXPECT_NEAR(after / before, 1, 0.3);
  EXPECT_LT(result["edge_length_max"], 1.5);
  command.vertices = 100;
  EXPECT_THAT(message_of(command), HasSubstr("--vertices: --mode thesis keeps the mean length"));
}

TEST_F(PlaneCommands, refuse_what_does_not_belong_together) {
  meshed(0.5);
  AdaptCommand command = to_solution(
      write("short.sol", "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n2\n1 1\n1\n2\n"));
  EXPECT_THAT(message_of(command), HasSubstr("gives values at 2 nodes; the mesh has "));
  command.solution.clear();
  EXPECT_THAT(message_of(command), HasSubstr("--metric FILE, --solution FILE or --sources FILE"));
  command.solution = "u.sol";
  command.output = "m.vtx";
  EXPECT_THAT(message_of(command), HasSubstr("m.vtx: meshes of the plane are written to .mesh"));
}

}  // namespace
}  // namespace tetfarm
