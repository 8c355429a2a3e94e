// The command that brings a solution to another mesh, called as main calls it.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/file_system.h"
#include "cli/commands.h"
#include "mesh/formats/plane/plane_medit.h"
#include "tests/base/temp_folder.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class PlaneTransfer : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    write_file_atomically(path(name), text);
    return path(name);
  }
  /// A mesh between the loops with edges of the length.
  std::string meshed(const std::string& name, double size,
                     const std::string& loops = "0 0\n1 0\n1 1\n0 1\n") const {
    PlaneCommand command;
    command.inputs = {write("loops.xy", loops)};
    command.output = path(name);
    command.size = size;
    EXPECT_EQ(said_by([&] { return plane_command(command); }).error, "");
    return command.output;
  }
  /// Kinds, and a line for each node.
  template <class LineAt>
  std::string solution(const std::string& name, const std::string& mesh, const std::string& kinds,
                       const LineAt& line_at) const {
    const PlaneMesh nodes = read_plane_medit(mesh);
    std::string text = "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n" +
                       std::to_string(nodes.points.size()) + "\n" + kinds + "\n";
    for (const Vec2& p : nodes.points) text += std::string(line_at(p)) + "\n";
    return write(name, text + "End\n");
  }
  PlaneTransferCommand from_a_to_b(const std::string& sol) const {
    return {path("a.mesh"), sol, path("b.mesh"), path("b.sol"), "conservative", true};
  }
  static Said brought(const PlaneTransferCommand& command) {
    return said_by([&] { return plane_transfer_command(command); });
  }

  const TempFolder folder_;
};

std::string shock_line(const Vec2& p) { return std::to_string(std::tanh(20 * (p.x - 0.4))); }

TEST_F(PlaneTransfer, keeps_the_integral_or_interpolates) {
  meshed("a.mesh", 0.07);
  meshed("b.mesh", 0.05);
  PlaneTransferCommand command = from_a_to_b(solution("a.sol", path("a.mesh"), "1 1", shock_line));
  const json kept = json::parse(brought(command).out);
  EXPECT_EQ(kept["type"], "transfer");
  EXPECT_EQ(kept["method"], "conservative");
  EXPECT_EQ(kept["vertices"], read_plane_medit(path("b.mesh")).points.size());
  EXPECT_EQ(kept["nodes_outside"], 0);
  EXPECT_NEAR(kept["covered_percent"].get<double>(), 100, 1e-10);
  const json& field = kept["fields"][0];
  EXPECT_EQ(field["name"], "1");
  EXPECT_NEAR(field["gain"].get<double>(), 0, 1e-12);
  EXPECT_NEAR(field["integral"].get<double>(), field["integral_before"].get<double>(), 1e-12);
  EXPECT_GE(field["min"], field["min_before"]);
  EXPECT_LE(field["max"], field["max_before"]);
  command.method = "linear";
  const json interpolated = json::parse(brought(command).out);
  EXPECT_GT(std::abs(interpolated["fields"][0]["gain"].get<double>()), 1e-8);
  EXPECT_FALSE(interpolated.contains("covered_percent"));
}

TEST_F(PlaneTransfer, brings_fields_of_all_kinds_in_the_order_of_the_file) {
  meshed("a.mesh", 0.2);
  meshed("b.mesh", 0.3);
  const auto line = [](const Vec2& p) {
    const std::string x = std::to_string(p.x);
    const std::string y = std::to_string(p.y);
    return y + " 7 4 0 9 " + x + " " + x;
  };
  const PlaneTransferCommand command =
      from_a_to_b(solution("a.sol", path("a.mesh"), "4 2 3 1 1", line));
  const json result = json::parse(brought(command).out);
  std::vector<std::string> names;
  for (const json& field : result["fields"]) names.push_back(field["name"]);
  EXPECT_THAT(names, ElementsAre("1.x", "1.y", "3", "4"));
  EXPECT_EQ(result["metrics"], 1);
  const NodeFields fields = read_plane_sol(path("b.sol"));
  EXPECT_THAT(fields.order, ElementsAre(NodeFieldKind::vector, NodeFieldKind::metric,
                                        NodeFieldKind::scalar, NodeFieldKind::scalar));
  const PlaneMesh mesh = read_plane_medit(path("b.mesh"));
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    EXPECT_NEAR(fields.vectors[0][v].x, mesh.points[v].y, 1e-5);
    EXPECT_NEAR(fields.vectors[0][v].y, 7, 1e-12);
    EXPECT_NEAR(fields.metrics[0][v].yy, 9, 1e-12);
    EXPECT_NEAR(fields.scalars[1][v], mesh.points[v].x, 1e-5);
  }
}

TEST_F(PlaneTransfer, tells_people_the_figures) {
  meshed("a.mesh", 0.2);
  meshed("b.mesh", 0.3);
  PlaneTransferCommand command =
      from_a_to_b(solution("a.sol", path("a.mesh"), "1 1", [](const Vec2&) { return "2"; }));
  command.json = false;
  EXPECT_THAT(brought(command).out,
              AllOf(HasSubstr("field 1         from 2 to 2; before from 2 to 2"),
                    HasSubstr("integral      2; before 2, gain"),
                    HasSubstr("covered         100.0000 %"), HasSubstr("nodes outside   0")));
}

TEST_F(PlaneTransfer, takes_the_closest_values_beyond_a_curved_border) {
  std::string loops = "-2 -2\n2 -2\n2 2\n-2 2\n\n";
  for (int k = 0; k < 12; ++k) {
    const double angle = k * std::acos(-1.0) / 6;
    loops += std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + "\n";
  }
  const auto round = [&](const std::string& name, double size) { meshed(name, size, loops); };
  round("a.mesh", 0.5);
  round("b.mesh", 0.1);
  const PlaneTransferCommand command = from_a_to_b(solution(
      "a.sol", path("a.mesh"), "1 1", [](const Vec2& p) { return std::to_string(p.x + 3); }));
  const json result = json::parse(brought(command).out);
  EXPECT_GE(result["fields"][0]["min"], result["fields"][0]["min_before"]);
  EXPECT_LE(result["fields"][0]["max"], result["fields"][0]["max_before"]);
  EXPECT_GT(result["covered_percent"], 99);
  EXPECT_LT(result["farthest_outside"], 0.05);
  EXPECT_LT(std::abs(result["fields"][0]["gain"].get<double>()), 0.01);
}

TEST_F(PlaneTransfer, refuses_what_does_not_belong_together) {
  meshed("a.mesh", 0.3);
  meshed("b.mesh", 0.3, "5 0\n6 0\n6 1\n5 1\n");
  const auto refusal = [&](const std::string& sol) { return brought(from_a_to_b(sol)).error; };
  const std::string start = "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n";
  EXPECT_THAT(refusal(write("s.sol", start + "2\n1 1\n1\n2\nEnd\n")),
              HasSubstr("s.sol: gives values at 2 nodes; the mesh has "));
  EXPECT_THAT(refusal(write("s.sol", start + "2\n1 2\n1 1\n2 2\nEnd\n")),
              HasSubstr("s.sol: gives values at 2 nodes; the mesh has "));
  EXPECT_THAT(refusal(write("s.sol", start + "2\n1 1\n1\nnan\nEnd\n")), HasSubstr("s.sol:7"));
  EXPECT_THAT(refusal(write("s.sol", start + "2\n0\nEnd\n")), HasSubstr("s.sol: has no fields"));
  EXPECT_THAT(
      refusal(solution("s.sol", path("a.mesh"), "1 1", [](const Vec2&) { return "1e200"; })),
      AllOf(HasSubstr("s.sol: node 1 at ("), HasSubstr("1e+200")));
  EXPECT_THAT(
      refusal(solution("s.sol", path("a.mesh"), "1 3", [](const Vec2&) { return "1 0 -1"; })),
      AllOf(HasSubstr("s.sol: node 1 at ("), HasSubstr("not positive definite")));
  EXPECT_THAT(refusal(solution("s.sol", path("a.mesh"), "1 1", shock_line)),
              AllOf(HasSubstr("b.mesh: does not overlap"), HasSubstr("x from 5 to 6"),
                    HasSubstr("x from 0 to 1, y from 0 to 1")));
  PlaneTransferCommand command = from_a_to_b(path("s.sol"));
  command.output = "b.vtu";
  EXPECT_THAT(brought(command).error, HasSubstr("b.vtu: solutions are read and written as .sol"));
}

}  // namespace
}  // namespace tetfarm
