// Pictures and charts of meshes of the plane, drawn as main draws them.
#include <gmock/gmock.h>

#include <functional>

#include "base/file_system.h"
#include "cli/commands.h"
#include "mesh/formats/plane/plane_medit.h"
#include "tests/base/temp_folder.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

/// A square of two triangles with a patch on each side, and a field that grows with x.
class RenderPlane : public ::testing::Test {
 protected:
  RenderPlane() {
    const PlaneMesh mesh{"",
                         {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                         {{0, 1, 2}, {0, 2, 3}},
                         {1, 2},
                         {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
                         {1, 2, 3, 4},
                         {},
                         {},
                         {}};
    command_.input = path("square.mesh");
    command_.output = path("picture.png");
    command_.size = "200x150";
    write_plane_medit(mesh, command_.input);
    write_plane_sol(std::vector<Metric2>(4, Metric2{16, 0, 64}), path("metric.sol"));
    field_ = write("field.sol", "4 1 1\n0 2 2 0\n");
  }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string write(const std::string& name, const std::string& values) const {
    write_file_atomically(
        path(name), "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n" + values + "End\n");
    return path(name);
  }
  using Change = std::function<void(RenderCommand&)>;
  std::string drawn(const Change& change = {}) const {
    RenderCommand command = command_;
    if (change) change(command);
    EXPECT_EQ(render_command(command), ExitCode::ok);
    return read_file(command.output);
  }
  std::string chart(const Change& change = {}) const {
    return drawn([&](RenderCommand& command) {
      command.field = field_;
      command.along = {1};
      command.output = path("chart.svg");
      if (change) change(command);
    });
  }
  std::string trouble(const Change& change) const {
    RenderCommand command = command_;
    change(command);
    return said_by([&] { return render_command(command); }).error;
  }

  const TempFolder folder_;
  RenderCommand command_;
  std::string field_;
};

TEST_F(RenderPlane, looks_otherwise_with_each_option_and_the_same_twice) {
  const std::string plain = drawn();
  EXPECT_EQ(drawn(), plain);
  EXPECT_NE(drawn([](RenderCommand& c) { c.edge_width = 0; }), plain);
  EXPECT_NE(drawn([](RenderCommand& c) { c.zoom = 2; }), plain);
  EXPECT_NE(drawn([](RenderCommand& c) { c.across = 0.2; }), plain);
  EXPECT_NE(drawn([](RenderCommand& c) { c.centre = {0.2, 0.3}; }), plain);
  EXPECT_NE(drawn([&](RenderCommand& c) { c.metric = path("metric.sol"); }), plain);
  const auto with_field = [&](const Change& change) {
    return drawn([&](RenderCommand& c) {
      c.field = field_;
      change(c);
    });
  };
  const std::string field = with_field([](RenderCommand&) {});
  EXPECT_NE(field, plain);
  EXPECT_EQ(with_field([](RenderCommand& c) { c.edge_width = 0; }), field);
  EXPECT_EQ(with_field([](RenderCommand& c) { c.range = {0, 2}; }), field);
  EXPECT_NE(with_field([](RenderCommand& c) { c.range = {0, 3}; }), field);
  EXPECT_NE(with_field([](RenderCommand& c) { c.levels = 3; }), field);
}

TEST_F(RenderPlane, takes_the_number_at_a_node_that_is_asked_for) {
  const std::string two = write("two.sol", "4 2 1 1\n0 5 2 6 2 7 0 8\n");
  const auto of_number = [&](std::int64_t number) {
    return drawn([&](RenderCommand& c) {
      c.field = two;
      c.field_number = number;
    });
  };
  EXPECT_EQ(of_number(1), drawn([&](RenderCommand& c) { c.field = field_; }));
  EXPECT_NE(of_number(2), of_number(1));
  EXPECT_THAT(trouble([&](RenderCommand& c) {
                c.field = two;
                c.field_number = 3;
              }),
              HasSubstr("--field-number 3: " + two + " has 2 numbers at a node"));
}

TEST_F(RenderPlane, charts_the_values_of_a_patch_over_x) {
  const std::string svg = chart();
  EXPECT_THAT(svg, HasSubstr("<svg xmlns="));
  EXPECT_EQ(chart(), svg);
  EXPECT_NE(chart([](RenderCommand& c) { c.reversed = true; }), svg);
  EXPECT_NE(chart([](RenderCommand& c) { c.along = {2}; }), svg);
  const std::string two =
      chart([&](RenderCommand& c) { c.also = {c.input + "," + path("field.sol")}; });
  EXPECT_NE(two.find("<polyline"), two.rfind("<polyline"));
}

TEST_F(RenderPlane, refuses_what_does_not_fit_the_mesh) {
  EXPECT_THAT(trouble([&](RenderCommand& c) { c.field = write("short.sol", "3 1 1\n0 1 2\n"); }),
              HasSubstr("gives values at 3 nodes; " + command_.input + " has 4"));
  EXPECT_THAT(trouble([&](RenderCommand& c) { c.field = path("metric.sol"); }),
              HasSubstr("has no numbers at the nodes"));
  EXPECT_THAT(trouble([&](RenderCommand& c) { c.metric = field_; }),
              HasSubstr("has no symmetric tensors"));
  EXPECT_THAT(trouble([&](RenderCommand& c) {
                c.metric = write("flat.sol", "4 1 3\n1 0 1 1 0 1 1 2 1 1 0 1\n");
              }),
              HasSubstr("(1, 1)"));
  EXPECT_THAT(trouble([&](RenderCommand& c) {
                c.field = field_;
                c.along = {9};
                c.output = path("c.svg");
              }),
              HasSubstr("--along: " + command_.input + " has no patch 9; its patches are 1, 2, 3"));
}

TEST_F(RenderPlane, refuses_options_of_the_other_kind_of_mesh) {
  EXPECT_THAT(trouble([](RenderCommand& c) { c.view = "cut"; }),
              HasSubstr("--view: is for meshes of space"));
  EXPECT_THAT(trouble([](RenderCommand& c) { c.colour = "layer"; }), HasSubstr("--colour"));
  EXPECT_THAT(trouble([](RenderCommand& c) { c.at = 1; }), HasSubstr("--at"));
  EXPECT_THAT(trouble([](RenderCommand& c) {
                c.centre = {1, 2, 3};
              }),
              HasSubstr("--centre: a place in the plane has two numbers"));
  EXPECT_THAT(trouble([](RenderCommand& c) {
                c.input = "out.vtkhdf";
                c.field = "u.sol";
              }),
              HasSubstr("--field: is for meshes of the plane"));
  EXPECT_THAT(trouble([](RenderCommand& c) {
                c.input = "out.vtkhdf";
                c.centre = {1, 2};
              }),
              HasSubstr("--centre: a place in space has three numbers"));
}

TEST_F(RenderPlane, refuses_names_of_other_kinds_of_pictures) {
  EXPECT_THAT(trouble([](RenderCommand& c) { c.output = "p.svg"; }), HasSubstr("only PNG"));
  EXPECT_THAT(trouble([&](RenderCommand& c) {
                c.field = field_;
                c.along = {1};
              }),
              HasSubstr("a chart is written as SVG"));
  EXPECT_THAT(trouble([&](RenderCommand& c) {
                c.field = field_;
                c.along = {1};
                c.output = path("c.svg");
                c.also = {"other.mesh"};
              }),
              HasSubstr("--also: \"other.mesh\" is not MESH,FIELD"));
}

}  // namespace
}  // namespace tetfarm
