// What the tasks say beside their files: numbers, texts, refusals.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "mesh/core/tet_quality.h"
#include "mesh/core/triangle_angles.h"
#include "mesh/decompose/planar_cut.h"
#include "tasks/failure_cause.h"
#include "tests/support/shapes.h"
#include "tests/support/voxel_surface.h"
#include "tests/worker/task_chain.h"
#include "worker/assimilate_task.h"
#include "worker/checked_input.h"
#include "worker/task_cost.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using TaskFigures = test::TaskChain;
using test::off_of;

TEST_F(TaskFigures, inspect_tells_what_the_surface_is_like) {
  JobFile job = job_of(3);
  job.groups = 2;
  job.across_cuts = false;
  const wire::Envelope result = inspect(job, shapes::unit_cube());
  ASSERT_TRUE(result.has_done()) << result.failed().message();
  const auto& numbers = result.done().numbers();
  EXPECT_EQ(numbers.at("input_triangles"), 12);
  EXPECT_EQ(numbers.at("shells"), 1);
  EXPECT_NEAR(numbers.at("input_smallest_angle_deg"), 45, 1e-9);
  EXPECT_NEAR(numbers.at("domain_volume"), 1, 1e-12);
  EXPECT_EQ(numbers.at("regions"), 1);
  EXPECT_EQ(numbers.at("parts"), 3);
  EXPECT_EQ(numbers.at("groups"), 2);
  EXPECT_EQ(numbers.at("most_bytes"), 0);
  EXPECT_EQ(numbers.at("needles"), 0);
  EXPECT_EQ(numbers.at("across_cuts"), 0);
  EXPECT_EQ(numbers.at("size_triangles"), 12);
  EXPECT_EQ(numbers.at("size_elements"), numbers.at("total_work"));
  EXPECT_FALSE(result.done().texts().contains("remarks"));
  const SpacingField spacing =
      SpacingField::from_bytes(bytes(output(result, "spacing")), "spacing");
  EXPECT_EQ(numbers.at("total_work"),
            estimated_elements(root_subdomain(shapes::unit_cube()), spacing));
  const SubdomainSize size{numbers.at("total_work"), 12,
                           static_cast<double>(output(result, "spacing").size()), 0};
  const auto input_bytes = static_cast<double>(off_of(shapes::unit_cube()).size());
  const JobForecast forecast = forecast_of(job, input_bytes, size, 3);
  EXPECT_EQ(numbers.at("forecast_bytes"), forecast.task_bytes);
  EXPECT_EQ(numbers.at("forecast_disk_bytes"), forecast.disk_bytes);
  EXPECT_EQ(numbers.at("forecast_seconds"), forecast.seconds);
  EXPECT_EQ(numbers.at("expected_bytes"), inspect_cost(input_bytes, size).bytes);
}

TEST_F(TaskFigures, inspect_needs_a_surface) {
  const wire::Envelope result = run(inspect_task, {{"job", publish(to_toml(job_of(1)))}});
  EXPECT_EQ(result.failed().message(), "the job has no surface");
}

TEST_F(TaskFigures, regions_are_what_the_job_says_of_them) {
  JobFile job;
  job.regions = {{{1, 2, 3}, "core", false}, {{4, 5, 6}, "", true}};
  const RegionRules inside = region_rules_of(job);
  EXPECT_FALSE(inside.is_outside_meshed);
  ASSERT_EQ(inside.wishes.size(), 2U);
  EXPECT_EQ(inside.wishes[0].at, (Vec3{1, 2, 3}));
  EXPECT_EQ(inside.wishes[0].name, "core");
  EXPECT_FALSE(inside.wishes[0].is_void);
  EXPECT_TRUE(inside.wishes[1].is_void);
  for (const char* kind : {"box", "sphere"}) {
    job.outer_kind = kind;
    EXPECT_TRUE(region_rules_of(job).is_outside_meshed) << kind;
  }
}

TEST_F(TaskFigures, settings_are_the_job_without_what_no_sub_domain_depends_on) {
  JobFile job;
  job.name = "wing";
  job.surface = "/data/wing.stl";
  job.regions = {{{1, 2, 3}, "core", false}};
  job.max_elements = 5;
  job.subdomains = 6;
  job.target_elements = 7;
  job.max_memory_bytes = 8'000'000;
  job.groups = 9;
  job.assimilate_method = "k-way";
  job.across_cuts = false;
  job.min_dihedral_deg = 10;
  job.min_unforced_dihedral_deg = 11;
  job.formats = {"ugrid"};
  job.outer_kind = "box";
  job.outer_factor = 4;
  job.outer_spacing = 2;
  job.spacing_default = 0.5;
  job.growth = 0.25;
  job.inherit_surface = false;
  job.sources = {{{{{1, 2, 3}, 0.125, 4, 5}}}};
  job.plane = "axis";
  job.points = "sweeps";
  JobFile expected;
  expected.name = "settings";
  expected.surface = "surface";
  expected.outer_kind = job.outer_kind;
  expected.outer_factor = job.outer_factor;
  expected.outer_spacing = job.outer_spacing;
  expected.spacing_default = job.spacing_default;
  expected.growth = job.growth;
  expected.inherit_surface = job.inherit_surface;
  expected.sources = job.sources;
  expected.plane = job.plane;
  expected.points = job.points;
  EXPECT_EQ(to_toml(mesh_settings_of(job)), to_toml(expected));
}

TEST_F(TaskFigures, memory_that_no_cutting_makes_enough_is_refused) {
  JobFile job;
  const SubdomainSize root{1e7, 2e5, 9e6};
  EXPECT_NO_THROW(require_room(job, 1e7, root)) << "no limit";
  EXPECT_EQ(parts_of_job(job, root, 1), wanted_parts(job, 1e7, 1));
  job.across_cuts = false;
  const double least = least_memory(1e7, root);
  job.max_memory_bytes = static_cast<std::int64_t>(std::ceil(least));
  EXPECT_NO_THROW(require_room(job, 1e7, root));
  EXPECT_EQ(parts_of_job(job, root, 1),
            parts_for_memory(root, static_cast<double>(job.max_memory_bytes)));
  EXPECT_EQ(parts_of_job(job, root, 2'000'000), 2'000'000) << "at least one for each region";
  job.max_memory_bytes -= 1;
  try {
    require_room(job, 1e7, root);
    ADD_FAILURE() << "it is too little";
  } catch (const UsageError& error) {
    EXPECT_EQ(error.what(), "[decompose] max_memory: this surface needs at least " +
                                std::to_string(std::llround(least / 1e6)) +
                                "MB however finely it is cut: to check it, make the first cuts, "
                                "order the sub-domains and assemble the mesh");
  }
}

TEST_F(TaskFigures, memory_has_to_do_for_the_order_of_so_many_sub_domains) {
  JobFile job;
  job.max_memory_bytes = 45'000'000;
  const SubdomainSize root{1e7, 1e4, 0};
  const auto parts = static_cast<double>(parts_for_memory(root, 4.5e7));
  const double triangles = triangles_of_leaves(root, parts);
  const double order = order_cost(triangles, triangles / parts).bytes;
  ASSERT_GT(order, 4.5e7);
  ASSERT_LT(least_memory(0, root), 4.5e7);
  try {
    require_room(job, 0, root);
    ADD_FAILURE() << "the order does not fit";
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("at least " + std::to_string(std::llround(order / 1e6)) + "MB"));
  }
  job.across_cuts = false;
  EXPECT_NO_THROW(require_room(job, 0, root)) << "there is no order";
}

TEST_F(TaskFigures, parts_change_at_the_sizes_that_are_told) {
  const JobFile job = job_of(0);
  EXPECT_EQ(wanted_parts(job, 399'999, 1), 1);
  EXPECT_EQ(wanted_parts(job, 400'000, 1), 4);
  EXPECT_EQ(wanted_parts(job, 8e6, 1), 4);
  EXPECT_EQ(wanted_parts(job, 8'000'001, 1), 5);
  EXPECT_EQ(wanted_parts(job, 1e18, 1), 1'000'000);
  EXPECT_EQ(wanted_parts(job, 1e18, 7), 1'000'000);
}

TEST_F(TaskFigures, planes_are_named_in_the_job) {
  JobFile job;
  for (const auto& [word, planes] :
       std::initializer_list<std::pair<const char*, CutPlanes>>{{"auto", CutPlanes::automatic},
                                                                {"lattice", CutPlanes::lattice},
                                                                {"axis", CutPlanes::axis},
                                                                {"inertia", CutPlanes::inertia}}) {
    job.plane = word;
    EXPECT_EQ(cut_planes_of(job), planes) << word;
  }
}

/// A box of 4 x 1 x 1 that is cut.
class CutBox : public test::TaskChain {
 protected:
  CutBox() {
    JobFile job = job_of(4);
    job.plane = "axis";
    job.spacing_default = 0.2;
    const wire::Envelope inspected = inspect(job, shapes::box({0, 0, 0}, {4, 1, 1}, 4));
    files_ = {{"job", publish(to_toml(job))},
              {"subdomain", output(inspected, "root")},
              {"spacing", output(inspected, "spacing")}};
    spacing_ = SpacingField::from_bytes(bytes(files_.at("spacing")), "spacing");
  }
  wire::Envelope cut(const char* left, const char* right, const char* most_bytes = nullptr) {
    std::map<std::string, std::string> parameters = {
        {"left_parts", left}, {"right_parts", right}, {"work", "12345"}};
    if (most_bytes != nullptr) parameters["most_bytes"] = most_bytes;
    return run(decompose_task, files_, parameters);
  }
  Subdomain half(const wire::Envelope& result, const char* side) {
    return subdomain_from_bytes(bytes(output(result, side)), side);
  }
  double counted(const Subdomain& half) const { return estimated_elements(half, spacing_, 16'000); }

  Files files_;
  SpacingField spacing_{1.0};
};

TEST_F(CutBox, halves_that_are_leaves_are_counted_and_their_parts_are_known) {
  const wire::Envelope result = cut("1", "3");
  ASSERT_TRUE(result.has_done()) << result.failed().message();
  const auto& numbers = result.done().numbers();
  const Subdomain left = half(result, "left");
  const Subdomain right = half(result, "right");
  EXPECT_EQ(left.path.heap, 2U);
  EXPECT_EQ(right.path.heap, 3U);
  EXPECT_EQ(numbers.at("left_work"), counted(left));
  EXPECT_NE(numbers.at("right_work"), counted(right)) << "what placing the cut found is enough";
  EXPECT_NEAR(numbers.at("right_work"), counted(right), 0.2 * counted(right));
  EXPECT_NEAR(numbers.at("left_work") / (numbers.at("left_work") + numbers.at("right_work")), 0.25,
              0.1);
  EXPECT_FALSE(numbers.contains("left_parts"));
  EXPECT_EQ(numbers.at("left_needles"),
            static_cast<double>(needle_count(left.vertices, left.triangles)));
  EXPECT_EQ(numbers.at("right_needles"),
            static_cast<double>(needle_count(right.vertices, right.triangles)));
  std::size_t on_cut = 0;
  for (const Origin& origin : left.node_origin) on_cut += origin.owner == 1 ? 1U : 0U;
  EXPECT_EQ(numbers.at("interdomain_nodes"), static_cast<double>(on_cut));
  EXPECT_GT(on_cut, 0U);
  EXPECT_GE(numbers.at("candidates_tried"), 1);
  EXPECT_EQ(numbers.at("size_elements"), 12345) << "as it was told";
  EXPECT_EQ(numbers.at("size_triangles"), 192);
}

TEST_F(CutBox, the_other_half_is_counted_when_it_is_the_leaf) {
  const wire::Envelope result = cut("3", "1");
  const auto& numbers = result.done().numbers();
  EXPECT_EQ(numbers.at("right_work"), counted(half(result, "right")));
  EXPECT_NE(numbers.at("left_work"), counted(half(result, "left")));
  EXPECT_GT(numbers.at("left_work"), 2 * numbers.at("right_work"));
}

TEST_F(CutBox, with_a_limit_of_memory_parts_follow_from_the_halves) {
  const auto spacing_bytes = static_cast<double>(files_.at("spacing").size());
  const double most_bytes = std::round(leaf_bytes({0, 0, spacing_bytes}) + 1e6);
  const std::string told = std::to_string(std::llround(most_bytes));
  const wire::Envelope result = cut("1", "3", told.c_str());
  ASSERT_TRUE(result.has_done()) << result.failed().message();
  const auto& numbers = result.done().numbers();
  for (const std::string side : {"left", "right"}) {
    const Subdomain part = half(result, side.c_str());
    const double work = numbers.at(side + "_work");
    EXPECT_EQ(work, counted(part)) << side;
    const TaskFile spacing{"", files_.at("spacing").size()};
    EXPECT_EQ(numbers.at(side + "_parts"),
              static_cast<double>(parts_for_memory(size_of(part, work, spacing), most_bytes)))
        << side;
  }
  EXPECT_GT(numbers.at("right_parts"), numbers.at("left_parts"));
}

TEST_F(TaskFigures, regions_are_divided_and_told_how_many_parts_each_half_becomes) {
  JobFile job = job_of(3);
  job.spacing_default = 0.2;
  const SurfaceMesh surface =
      shapes::voxel_surface({{3, 1, 1}, [](int x, int, int) { return x < 2 ? 1 : 2; }}).surface;
  const wire::Envelope inspected = inspect(job, surface);
  const wire::Envelope result = run(decompose_task,
                                    {{"job", publish(to_toml(job))},
                                     {"subdomain", output(inspected, "root")},
                                     {"spacing", output(inspected, "spacing")}},
                                    {{"left_parts", "1"}, {"right_parts", "2"}, {"work", "9"}});
  ASSERT_TRUE(result.has_done()) << result.failed().message();
  const auto& numbers = result.done().numbers();
  EXPECT_EQ(numbers.at("left_parts") + numbers.at("right_parts"), 3);
  EXPECT_EQ(numbers.at("interdomain_nodes"), 0);
  const SpacingField spacing =
      SpacingField::from_bytes(bytes(output(inspected, "spacing")), "spacing");
  for (const std::string side : {"left", "right"}) {
    const Subdomain half = subdomain_from_bytes(bytes(output(result, side)), side);
    EXPECT_EQ(numbers.at(side + "_work"), estimated_elements(half, spacing, 16'000)) << side;
    const double larger = half.region == 1 ? 2 : 1;
    EXPECT_EQ(numbers.at(side + "_parts"), larger) << side;
  }
}

TEST_F(TaskFigures, mesh_tells_its_counts_and_its_smallest_angle) {
  const wire::Envelope inspected = inspect(job_of(1), shapes::sphere({0, 0, 0}, 1, 2));
  const wire::Envelope meshed = run(mesh_task,
                                    {{"job", output(inspected, "settings")},
                                     {"subdomain", output(inspected, "root")},
                                     {"spacing", output(inspected, "spacing")}},
                                    {{"work", "777"}});
  ASSERT_TRUE(meshed.has_done()) << meshed.failed().message();
  const Subdomain root = subdomain_from_bytes(bytes(output(inspected, "root")), "root");
  const TetMesh mesh = tet_mesh_from_bytes(bytes(output(meshed, "mesh")), root, "mesh");
  double smallest = 180;
  for (const Tet& tet : mesh.tets) {
    const auto at = [&](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(tet[i])]; };
    const DihedralCosines cosines = dihedral_cosines(at(0), at(1), at(2), at(3));
    smallest = std::min(smallest, std::acos(cosines.of_smallest) * 180 / std::numbers::pi);
  }
  const auto& numbers = meshed.done().numbers();
  EXPECT_NEAR(numbers.at("min_dihedral_deg"), smallest, 1e-9);
  EXPECT_EQ(numbers.at("tets"), static_cast<double>(mesh.tets.size()));
  EXPECT_EQ(numbers.at("interior_nodes"), static_cast<double>(mesh.nodes.size() - 162));
  EXPECT_EQ(numbers.at("size_elements"), 777);
  EXPECT_EQ(numbers.at("size_triangles"), 320);
}

TEST_F(TaskFigures, mesh_refuses_two_vertices_in_one_place_as_bad_input) {
  SurfaceMesh cubes = shapes::unit_cube();
  const SurfaceMesh other = shapes::box({1, 1, 1}, {2, 2, 2}, 1);
  const auto first = static_cast<std::int32_t>(cubes.vertices.size());
  cubes.vertices.insert(cubes.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Triangle& t : other.triangles) {
    cubes.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  const wire::Envelope result =
      run(mesh_task,
          {{"job", publish(to_toml(job_of(1)))},
           {"subdomain", publish(subdomain_to_bytes(root_subdomain(cubes)))},
           {"spacing", publish(SpacingField(1.0).to_bytes())}},
          {{"work", "10"}});
  ASSERT_TRUE(result.has_failed());
  EXPECT_EQ(result.failed().exit_code(), 3);
  EXPECT_EQ(result.failed().cause(), on_wire(FailureCause::for_good));
  ASSERT_EQ(result.failed().evidence_size(), 1);
  EXPECT_EQ(result.failed().evidence(0).name(), "subdomain_root.defects.vtp");
}

TEST_F(TaskFigures, assimilate_refuses_a_table_that_is_none) {
  JobFile job = job_of(2);
  job.groups = 1;
  for (const char* table : {"", "4\n", "4 x\n", "x 4\n"}) {
    const wire::Envelope result =
        run(assimilate_task, {{"job", publish(to_toml(job))}}, {{"table", table}});
    EXPECT_EQ(result.failed().message(), "the table of leaves is wrong") << table;
  }
  const wire::Envelope missing =
      run(assimilate_task, {{"job", publish(to_toml(job))}}, {{"table", "4 100\n"}});
  EXPECT_EQ(missing.failed().message(), "a file of sub-domain 4 is missing");
}

TEST_F(TaskFigures, number_refuses_lines_of_dropped_nodes_that_are_none) {
  const wire::Envelope inspected = inspect(job_of(1), shapes::unit_cube());
  for (const char* lines : {"dropped 1 x 3\n", "dropped 1\nx"}) {
    const wire::Envelope result =
        run(number_task, {{"surface", output(inspected, "surface")}, {"dropped", publish(lines)}},
            {{"table", "leaf 1 0 6\n"}});
    EXPECT_EQ(result.failed().message(), "dropped: has an invalid line") << lines;
  }
}

TEST_F(TaskFigures, assemble_tells_the_figures_of_the_mesh_and_of_each_region) {
  JobFile job = job_of(2);
  job.spacing_default = 0.5;
  job.min_dihedral_deg = 3;
  job.min_unforced_dihedral_deg = 0.25;
  job.formats = {"vtkhdf", "lb8.ugrid", "msh41", "su2"};
  const SurfaceMesh surface =
      shapes::voxel_surface({{3, 1, 1}, [](int x, int, int) { return x < 2 ? 1 : 2; }}).surface;
  const wire::Envelope assembled = chain(job, surface);
  ASSERT_TRUE(assembled.has_done()) << assembled.failed().message();
  std::vector<std::string> names;
  for (const wire::Artifact& file : assembled.done().outputs()) names.push_back(file.name());
  EXPECT_THAT(names, testing::UnorderedElementsAre("ball.vtkhdf", "ball.lb8.ugrid", "ball.mapbc",
                                                   "ball.regions"));
  const auto& numbers = assembled.done().numbers();
  const auto& texts = assembled.done().texts();
  EXPECT_EQ(texts.at("formats_to_convert"), "msh41,su2");
  EXPECT_NEAR(numbers.at("volume"), 3, 1e-9);
  EXPECT_NEAR(numbers.at("region_1_volume"), 2, 1e-9);
  EXPECT_NEAR(numbers.at("region_2_volume"), 1, 1e-9);
  EXPECT_EQ(numbers.at("region_1_elements") + numbers.at("region_2_elements"),
            numbers.at("elements"));
  EXPECT_EQ(numbers.at("min_dihedral_gate_deg"), 3);
  EXPECT_EQ(numbers.at("min_unforced_dihedral_gate_deg"), 0.25);
  EXPECT_EQ(numbers.at("min_dihedral_deg"), std::min(numbers.at("region_1_min_dihedral_deg"),
                                                     numbers.at("region_2_min_dihedral_deg")));
  EXPECT_EQ(numbers.at("max_dihedral_deg"), std::max(numbers.at("region_1_max_dihedral_deg"),
                                                     numbers.at("region_2_max_dihedral_deg")));
  EXPECT_EQ(numbers.at("surface_triangles"), static_cast<double>(surface.triangles.size()));
  EXPECT_NEAR(numbers.at("surface_smallest_angle_deg"), 45, 1e-9);
  EXPECT_EQ(numbers.at("surface_triangles_below_1_deg"), 0);
  EXPECT_EQ(numbers.at("surface_triangles_below_5_deg"), 0);
  const auto of_first = std::to_string(static_cast<std::int64_t>(numbers.at("region_1_elements")));
  const auto second =
      std::to_string(static_cast<std::int64_t>(numbers.at("region_1_elements")) + 1);
  const auto all = std::to_string(static_cast<std::int64_t>(numbers.at("elements")));
  EXPECT_EQ(bytes(output(assembled, "ball.regions")),
            "1 1 " + of_first + " " + texts.at("region_1_name") + "\n2 " + second + " " + all +
                " " + texts.at("region_2_name") + "\n");
  const std::string histogram = texts.at("dihedral_histogram");
  std::istringstream counts(histogram);
  double sum = 0;
  for (double count = 0; counts >> count;) sum += count;
  EXPECT_EQ(sum, 6 * numbers.at("elements")) << "every tet has six angles";
}

TEST_F(TaskFigures, assemble_tells_where_the_worst_angles_are) {
  JobFile job = job_of(1);
  job.spacing_default = 10;
  job.formats = {"vtkhdf"};
  SurfaceMesh wedge;  // a tetrahedron with a small angle at its edge along x
  wedge.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 1, 0.05}};
  wedge.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const wire::Envelope assembled = chain(job, wedge);
  ASSERT_TRUE(assembled.has_done()) << assembled.failed().message();
  const auto& numbers = assembled.done().numbers();
  if (numbers.at("elements") == 1) {
    EXPECT_EQ(numbers.at("worst_x"), 0.5);
    EXPECT_NEAR(numbers.at("worst_y"), 0.5, 1e-12);
    EXPECT_NEAR(numbers.at("worst_z"), 0.0125, 1e-12);
  }
  EXPECT_NEAR(numbers.at("forced_dihedral_deg"), std::atan(0.05) * 180 / std::numbers::pi, 1e-3);
  EXPECT_NEAR(numbers.at("forced_y"), 0, 1e-12) << "at the edge along x";
  EXPECT_NEAR(numbers.at("forced_z"), 0, 1e-12);
  const double angle = std::atan(0.05 / std::sqrt(1.25)) * 180 / std::numbers::pi;
  EXPECT_NEAR(numbers.at("surface_smallest_angle_deg"), angle, 1e-3);
  EXPECT_NEAR(numbers.at("surface_worst_1_angle_deg"), angle, 1e-3);
  EXPECT_EQ(numbers.at("surface_triangles_below_5_deg"), 2);
  EXPECT_EQ(numbers.at("surface_triangles_below_1_deg"), 0);
  EXPECT_NEAR(numbers.at("smallest_height"), std::sin(std::atan(0.05)), 0.05);
}

}  // namespace
}  // namespace tetfarm
