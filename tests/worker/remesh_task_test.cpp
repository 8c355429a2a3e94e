#include "worker/remesh_task.h"

#include <gmock/gmock.h>

#include "mesh/artifacts/surface_file.h"
#include "mesh/inspect/surface_check.h"
#include "tasks/failure_cause.h"
#include "tests/support/shapes.h"
#include "tests/support/voxel_surface.h"
#include "tests/worker/task_chain.h"
#include "worker/job_remeshing.h"

namespace tetfarm {
namespace {

using test::off_of;
using ::testing::HasSubstr;

class RemeshTask : public test::TaskChain {
 protected:
  static JobFile job_that_remeshes(double size) {
    JobFile job = job_of(1);
    job.remeshing.emplace().size = size;
    return job;
  }
  wire::Envelope remesh(const JobFile& job, const SurfaceMesh& surface) {
    return run(remesh_task,
               {{"job", publish(to_toml(job))}, {"input_surface", publish(off_of(surface))}});
  }
  wire::Envelope inspect_remeshed(const JobFile& job, const wire::Artifact& surface) {
    return run(inspect_task, {{"job", publish(to_toml(job))}, {"remeshed_surface", surface}});
  }
};

TEST_F(RemeshTask, makes_a_surface_of_the_size_asked_for_which_is_then_inspected) {
  const SurfaceMesh ball = shapes::sphere({0, 0, 0}, 1, 2);
  const JobFile job = job_that_remeshes(0.2);
  const wire::Envelope result = remesh(job, ball);
  ASSERT_TRUE(result.has_done()) << result.failed().message();
  const SurfaceMesh made = surface_from_bytes(bytes(output(result, "surface")), "s");
  EXPECT_GT(made.triangles.size(), 500U);
  EXPECT_LT(made.triangles.size(), 1500U);
  EXPECT_TRUE(check_surface(made).report.defects.empty());
  const auto& numbers = result.done().numbers();
  EXPECT_EQ(numbers.at("remesh_triangles"), static_cast<double>(made.triangles.size()));
  EXPECT_EQ(numbers.at("remesh_triangles_before"), 320);
  EXPECT_GT(numbers.at("remesh_smallest_angle_deg"), 20);
  EXPECT_LT(numbers.at("remesh_distance_to_input"), 0.01);
  EXPECT_GT(numbers.at("expected_bytes"), 1e7);

  const wire::Envelope inspected = inspect_remeshed(job, output(result, "surface"));
  ASSERT_TRUE(inspected.has_done()) << inspected.failed().message();
  const SurfaceMesh surface = surface_from_bytes(bytes(output(inspected, "surface")), "s");
  EXPECT_EQ(surface.triangles, made.triangles);
  EXPECT_EQ(surface.vertices, made.vertices);
}

TEST_F(RemeshTask, gives_what_commands_make_of_the_same_job) {
  const SurfaceMesh ball = shapes::sphere({0, 0, 0}, 1, 2);
  const JobFile job = job_that_remeshes(0.25);
  const wire::Envelope result = remesh(job, ball);
  const SurfaceMesh made = surface_from_bytes(bytes(output(result, "surface")), "s");
  const CheckedSurface told = surface_to_mesh(job, check_surface(ball));
  EXPECT_EQ(told.surface.vertices, made.vertices);
  EXPECT_EQ(told.surface.triangles, made.triangles);
  JobFile plain = job;
  plain.remeshing.reset();
  EXPECT_EQ(surface_to_mesh(plain, check_surface(ball)).surface.triangles, ball.triangles);
}

TEST_F(RemeshTask, keeps_regions_and_their_names) {
  const auto cubes =
      shapes::voxel_surface({{4, 2, 2}, [](int x, int, int) { return x < 2 ? 1 : 2; }});
  JobFile job = job_that_remeshes(0.5);
  job.regions = {{{0.5, 0.5, 0.6}, "steel", false}};
  const wire::Envelope result = remesh(job, cubes.surface);
  ASSERT_TRUE(result.has_done()) << result.failed().message();
  const wire::Envelope inspected = inspect_remeshed(job, output(result, "surface"));
  ASSERT_TRUE(inspected.has_done()) << inspected.failed().message();
  EXPECT_EQ(inspected.done().numbers().at("regions"), 2);
  const SurfaceMesh surface = surface_from_bytes(bytes(output(inspected, "surface")), "s");
  EXPECT_EQ(surface.region_names.at(0), "steel");
}

TEST_F(RemeshTask, refuses_a_bad_surface_with_its_defects) {
  SurfaceMesh open = shapes::sphere({0, 0, 0}, 1, 1);
  open.triangles.pop_back();
  open.patch_of_triangle.pop_back();
  const wire::Envelope result = remesh(job_that_remeshes(0.2), open);
  ASSERT_TRUE(result.has_failed());
  EXPECT_EQ(result.failed().exit_code(), 3);
  EXPECT_EQ(result.failed().cause(), on_wire(FailureCause::for_good));
  EXPECT_THAT(result.failed().message(), HasSubstr("open"));
  ASSERT_EQ(result.failed().evidence_size(), 1);
  EXPECT_THAT(result.failed().evidence(0).name(), HasSubstr(".defects.vtp"));
}

TEST_F(RemeshTask, a_shortest_edge_above_the_size_is_refused) {
  JobFile job = job_that_remeshes(0);
  job.spacing_default = 0.1;
  job.remeshing->min_size = 0.2;
  const wire::Envelope result = remesh(job, shapes::sphere({0, 0, 0}, 1, 1));
  ASSERT_TRUE(result.has_failed());
  EXPECT_EQ(result.failed().exit_code(), 2);
}

TEST_F(RemeshTask, a_remeshed_surface_with_a_defect_is_our_fault) {
  SurfaceMesh open = shapes::sphere({0, 0, 0}, 1, 1);
  open.triangles.pop_back();
  open.patch_of_triangle.pop_back();
  const wire::Envelope result =
      inspect_remeshed(job_that_remeshes(0.2), publish(surface_to_bytes(open)));
  ASSERT_TRUE(result.has_failed());
  EXPECT_EQ(result.failed().exit_code(), 1);
  EXPECT_THAT(result.failed().message(), HasSubstr("the remeshed surface is not sound"));
}

}  // namespace
}  // namespace tetfarm
