// `plane` and `adapt` with point and line sources, called as main calls them.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/file_system.h"
#include "cli/commands.h"
#include "cli/error_help.h"
#include "mesh/formats/plane/plane_files.h"
#include "tests/base/temp_folder.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* line_of_sizes = R"([[line]]
from = [0.2, 0.2]
to = [0.8, 0.8]
sizes = [0.08, 0.02]
radius = 0.05
)";
constexpr const char* point_outside = R"([[point]]
at = [50, 50]
sizes = [0.1, 0.01]
radius = 1
)";

class PlaneSourcesCommand : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    write_file_atomically(path(name), text);
    return path(name);
  }
  PlaneCommand plane_with(const std::string& sources) const {
    PlaneCommand command;
    command.inputs = {write("loops.xy", "0 0\n1 0\n1 1\n0 1\n")};
    command.output = path("plane.mesh");
    command.sources = write("sources.toml", sources);
    command.json = true;
    return command;
  }
  AdaptCommand adapt_with(const std::string& sources) const {
    PlaneCommand first = plane_with(line_of_sizes);
    first.sources.clear();
    first.size = 0.2;
    said_by([&] { return plane_command(first); });
    AdaptCommand command;
    command.input = first.output;
    command.output = path("adapted.mesh");
    command.sources = write("sources.toml", sources);
    command.json = true;
    return command;
  }
  static json result_of(const PlaneCommand& command) {
    return json::parse(said_by([&] { return plane_command(command); }).out);
  }
  static json result_of(const AdaptCommand& command) {
    return json::parse(said_by([&] { return adapt_command(command); }).out);
  }
  static Said said_of(const PlaneCommand& command) {
    return said_by([&] { return plane_command(command); });
  }
  static std::string error_of(const AdaptCommand& command) {
    return said_by([&] { return adapt_command(command); }).error;
  }

  const TempFolder folder_;
};

TEST_F(PlaneSourcesCommand, makes_a_first_mesh_that_has_what_the_sources_say) {
  const json result = result_of(plane_with(std::string("size = 0.2\n") + line_of_sizes));
  EXPECT_GT(result["unit_edges_percent"], 99);
  EXPECT_GT(result["quality_min"], 0.5);
  EXPECT_EQ(result["sources"], 1);
  EXPECT_TRUE(result["sources_without_effect"].empty());
  const PlaneMesh mesh = read_plane_medit(path("plane.mesh"));
  int near = 0;
  for (const Vec2& p : mesh.points) near += std::abs(p.x - p.y) < 0.05 ? 1 : 0;
  EXPECT_GT(near, 40);
  EXPECT_EQ(result_of(plane_with(std::string("size = 0.2\n") + line_of_sizes))["digest"],
            result["digest"]);
}

TEST_F(PlaneSourcesCommand, takes_the_size_of_the_command_before_that_of_the_file) {
  PlaneCommand command = plane_with(std::string("size = 0.2\n") + line_of_sizes);
  const json by_file = result_of(command);
  command.size = 0.03;
  EXPECT_GT(result_of(command)["vertices"], 2 * by_file["vertices"].get<int>());
  EXPECT_GT(result_of(plane_with(line_of_sizes))["vertices"], 50)
      << "without any, as the edges of the loops";
}

TEST_F(PlaneSourcesCommand, tells_which_sources_have_no_effect) {
  const std::string sources = std::string("size = 0.2\n") + point_outside + line_of_sizes;
  PlaneCommand command = plane_with(sources);
  EXPECT_THAT(result_of(command)["sources_without_effect"], ElementsAre(2));
  command.json = false;
  EXPECT_THAT(said_of(command).out, HasSubstr("sources.toml:2: this source has no effect"));
}

TEST_F(PlaneSourcesCommand, refuses_sources_of_which_none_has_any_effect) {
  const PlaneCommand command = plane_with(std::string("size = 0.2\n") + point_outside);
  const Said said = said_of(command);
  EXPECT_EQ(said.code, ExitCode::bad_geometry);
  EXPECT_THAT(said.error, HasSubstr("sources.toml: no source has any effect: none is near"));
  EXPECT_FALSE(size_of_file(command.output).has_value());
}

TEST_F(PlaneSourcesCommand, refuses_a_file_that_is_wrong_with_its_place) {
  const Said said = said_of(plane_with("[[point]]\nat = [0, 0]\nsize = [1, 1]\n"));
  EXPECT_EQ(said.code, ExitCode::usage);
  EXPECT_THAT(said.error,
              HasSubstr("sources.toml:3:1: unknown key `size` in [point]; did you mean `sizes`?"));
  EXPECT_THAT(help_for(UsageError("wrong", "a.toml:1:1"), "plane"), HasSubstr("adaptation.md"));
  PlaneCommand command = plane_with(line_of_sizes);
  command.sources = path("none.toml");
  EXPECT_EQ(said_of(command).code, ExitCode::not_found);
  command.sources = "/dev/zero";
  EXPECT_THAT(said_of(command).error, HasSubstr("/dev/zero: more than 1048576 bytes"));
  EXPECT_THAT(
      said_of(plane_with("[[point]]\nat = [0.5, 0.5]\nsizes = [1e-9, 1e-9]\nradius = 1\n")).error,
      HasSubstr("triangles; the most that can be had are 1e+08"));
}

TEST_F(PlaneSourcesCommand, adapts_a_mesh_that_stays_as_fine_as_it_is_elsewhere) {
  const json result = result_of(adapt_with(line_of_sizes));
  EXPECT_GT(result["unit_edges_percent"], 98);
  const PlaneMesh mesh = read_plane_medit(path("adapted.mesh"));
  int near = 0;
  int in_a_corner = 0;
  for (const Vec2& p : mesh.points) {
    near += std::abs(p.x - p.y) < 0.05 ? 1 : 0;
    in_a_corner += p.x > 0.7 && p.y < 0.3 ? 1 : 0;
  }
  EXPECT_GT(near, 40);
  EXPECT_LT(in_a_corner, 15);
}

TEST_F(PlaneSourcesCommand, counts_beside_a_metric_and_a_solution) {
  AdaptCommand command = adapt_with(line_of_sizes);
  const std::size_t nodes = read_plane_medit(command.input).points.size();
  command.metric = path("metric.sol");
  write_plane_sol(std::vector<Metric2>(nodes, {2500, 0, 16}), command.metric);
  const int with_both = result_of(command)["vertices"];
  const std::string sources = command.sources;
  command.sources.clear();
  const int with_metric = result_of(command)["vertices"];
  EXPECT_GT(with_both, with_metric + 50);
  command.metric.clear();
  std::string text =
      "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n" + std::to_string(nodes) + "\n1 1\n";
  for (const Vec2& p : read_plane_medit(command.input).points) {
    text += std::to_string(p.x * p.x) + "\n";
  }
  command.solution = write("u.sol", text);
  command.sources = sources;
  command.vertices = 600;
  const json result = result_of(command);
  EXPECT_NEAR(result["vertices"].get<double>(), 600, 30) << "those near the source among them";
  EXPECT_EQ(result["sources"], 1);
}

TEST_F(PlaneSourcesCommand, refuses_what_does_not_go_with_sources) {
  AdaptCommand command = adapt_with(std::string("size = 1\n") + line_of_sizes);
  command.solution = "u.sol";
  EXPECT_THAT(error_of(command), HasSubstr("sources.toml: `size` is the size where nothing else"));
  command.mode = "thesis";
  EXPECT_THAT(error_of(command), HasSubstr("--sources: --mode thesis"));
  command.sources.clear();
  command.solution.clear();
  EXPECT_THAT(error_of(command), HasSubstr("--solution FILE or --sources FILE"));
}

}  // namespace
}  // namespace tetfarm
