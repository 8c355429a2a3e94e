// The tasks one after the other, without coordinator or processes: what each takes and gives.
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <sstream>

#include "mesh/artifacts/artifact_file.h"
#include "mesh/artifacts/surface_file.h"
#include "mesh/core/validate.h"
#include "mesh/formats/registry/read_global_mesh.h"
#include "mesh/job_file/job_file.h"
#include "tasks/failure_cause.h"
#include "tests/support/mesh_report.h"
#include "tests/support/shapes.h"
#include "tests/support/voxel_surface.h"
#include "tests/worker/task_chain.h"
#include "worker/assemble_task.h"
#include "worker/assimilate_task.h"
#include "worker/decompose_task.h"
#include "worker/evidence.h"
#include "worker/inspect_task.h"
#include "worker/mesh_task.h"
#include "worker/order_task.h"
#include "worker/run_task.h"
#include "worker/write_task.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

using Tasks = test::TaskChain;
using test::off_of;

TEST_F(Tasks, inspect_gives_surface_spacing_root_and_the_number_of_parts) {
  const wire::Envelope result = inspect(job_of(5), shapes::sphere({0, 0, 0}, 1, 2));
  ASSERT_TRUE(result.has_done()) << result.failed().message();
  EXPECT_EQ(result.done().numbers().at("parts"), 5);
  EXPECT_GT(result.done().numbers().at("total_work"), 100);
  const Subdomain root = subdomain_from_bytes(bytes(output(result, "root")), "root");
  EXPECT_EQ(root.path.heap, 1U);
  EXPECT_EQ(root.triangles.size(), 320U);
  EXPECT_EQ(surface_from_bytes(bytes(output(result, "surface")), "s").triangles.size(), 320U);
}

TEST_F(Tasks, parts_follow_from_the_wanted_size_when_not_given) {
  JobFile job = job_of(0);
  job.target_elements = 100;
  EXPECT_EQ(wanted_parts(job, 1001, 1), 11);
  EXPECT_EQ(wanted_parts(job, 99, 1), 1);
  EXPECT_EQ(wanted_parts(job, 0, 1), 1);
  job.target_elements = 1'000'000;
  job.groups = 4;
  EXPECT_EQ(wanted_parts(job, 1e9, 1), 1000);
  EXPECT_EQ(wanted_parts(job, 1e6, 1), 64) << "sixteen to a group";
  EXPECT_EQ(wanted_parts(job, 20'000, 1), 20) << "but no leaves of a few hundred elements";
  EXPECT_EQ(wanted_parts(job, 100, 1), 4);
}

TEST_F(Tasks, a_job_is_cut_by_its_own_size_when_nobody_says_how) {
  const JobFile job = job_of(0);
  EXPECT_EQ(wanted_parts(job, 3.9e5, 1), 1);
  EXPECT_EQ(wanted_parts(job, 5e5, 1), 4) << "four workers have something to do";
  EXPECT_EQ(wanted_parts(job, 4.1e5, 1), 4);
  EXPECT_EQ(wanted_parts(job, 7.9e6, 1), 4);
  EXPECT_EQ(wanted_parts(job, 3.2e7, 1), 16);
  EXPECT_EQ(wanted_parts(job, 2e9, 1), 1000);
}

TEST_F(Tasks, inspect_refuses_more_elements_than_the_job_may_have_and_says_what_would_do) {
  const SurfaceMesh ball = shapes::sphere({0, 0, 0}, 1, 2);
  JobFile job = job_of(0);
  job.max_elements = 1'000'000;
  for (const double size : {2e-3, 1e-5, 1e-7, 1e-300}) {
    job.spacing_default = size;
    const wire::Envelope result = inspect(job, ball);
    ASSERT_TRUE(result.has_failed()) << size;
    EXPECT_EQ(result.failed().exit_code(), 2);
    EXPECT_EQ(result.failed().cause(), on_wire(FailureCause::for_good));
    EXPECT_THAT(result.failed().message(), HasSubstr("more than the 1.0 M that it may have"));
    EXPECT_THAT(result.failed().message(), HasSubstr("`--size 0.03"));
  }
}

TEST_F(Tasks, the_size_that_inspect_names_is_within_the_limit) {
  const SurfaceMesh ball = shapes::sphere({0, 0, 0}, 1, 2);
  JobFile job = job_of(0);
  job.max_elements = 300'000;
  job.spacing_default = 1e-4;
  const std::string message = inspect(job, ball).failed().message();
  const std::string before = "`--size ";
  const std::size_t at = message.find(before);
  ASSERT_NE(at, std::string::npos) << message;
  job.spacing_default = std::stod(message.substr(at + before.size()));
  const wire::Envelope result = inspect(job, ball);
  ASSERT_TRUE(result.has_done()) << result.failed().message();
  EXPECT_LE(result.done().numbers().at("total_work"), 300'000);
  EXPECT_GT(result.done().numbers().at("total_work"), 150'000) << "not far below it";
}

TEST_F(Tasks, inspect_refuses_what_the_disk_cannot_hold_unless_forced) {
  const SurfaceMesh ball = shapes::sphere({0, 0, 0}, 1, 2);
  JobFile job = job_of(1);
  job.spacing_default = 0.05;
  const auto inspect_with = [&](const std::string& free_bytes) {
    return run(inspect_task,
               {{"job", publish(to_toml(job))}, {"input_surface", publish(off_of(ball))}},
               {{"free_bytes", free_bytes}});
  };
  const wire::Envelope refused = inspect_with("9000000");
  ASSERT_TRUE(refused.has_failed());
  EXPECT_EQ(refused.failed().exit_code(), 6);
  EXPECT_EQ(refused.failed().cause(), on_wire(FailureCause::for_good)) << "other jobs may go on";
  EXPECT_THAT(refused.failed().message(), HasSubstr("of which only 9.0 MB is free"));
  EXPECT_THAT(refused.failed().message(), HasSubstr("`--size 0."));
  EXPECT_TRUE(inspect_with("900000000").has_done());
  EXPECT_TRUE(inspect_with("0").has_done()) << "not known";
  job.max_elements = 0;
  EXPECT_TRUE(inspect_with("9000000").has_done());
}

TEST_F(Tasks, inspect_forecasts_memory_disk_and_time) {
  const wire::Envelope result = inspect(job_of(4), shapes::sphere({0, 0, 0}, 1, 3));
  ASSERT_TRUE(result.has_done());
  const auto& numbers = result.done().numbers();
  EXPECT_GT(numbers.at("forecast_bytes"), 1e7);
  EXPECT_GT(numbers.at("forecast_disk_bytes"), 50 * numbers.at("total_work"));
  EXPECT_GT(numbers.at("forecast_seconds"), 0.1);
}

TEST_F(Tasks, sizes_asked_for_hold_on_the_outer_boundary) {
  JobFile job = job_of(1);
  job.outer_kind = "box";
  job.outer_factor = 1.3;
  const auto outer_triangles = [&](double size) {
    job.spacing_default = size;
    const wire::Envelope result = inspect(job, shapes::sphere({0, 0, 0}, 1, 2));
    return surface_from_bytes(bytes(output(result, "surface")), "s").triangles.size() - 320;
  };
  // A side of 2.6, in parts of no more than 0.08.
  EXPECT_EQ(outer_triangles(0.08), 12U * 33U * 33U);
  EXPECT_LT(outer_triangles(0), 12U * 33U * 33U);
}

TEST_F(Tasks, each_region_is_a_part_at_least) {
  EXPECT_EQ(wanted_parts(job_of(2), 1000, 5), 5);
  EXPECT_EQ(wanted_parts(job_of(0), 1000, 5), 5);
}

TEST_F(Tasks, inspect_refuses_an_open_surface_and_shows_it) {
  SurfaceMesh open = shapes::sphere({0, 0, 0}, 1, 1);
  open.triangles.pop_back();
  const wire::Envelope result = inspect(job_of(1), open);
  ASSERT_TRUE(result.has_failed());
  EXPECT_EQ(result.failed().exit_code(), 3);
  EXPECT_EQ(result.failed().cause(), on_wire(FailureCause::for_good));
  EXPECT_THAT(result.failed().message(), HasSubstr("open edge"));
  ASSERT_EQ(result.failed().evidence_size(), 1);
  EXPECT_EQ(result.failed().evidence(0).name(), "ball.defects.vtp");
}

TEST_F(Tasks, an_outer_box_makes_the_outside_the_domain) {
  JobFile job = job_of(1);
  job.outer_kind = "box";
  job.outer_factor = 2;
  const SurfaceMesh ball = shapes::sphere({0, 0, 0}, 1, 1);
  const wire::Envelope result = inspect(job, ball);
  ASSERT_TRUE(result.has_done()) << result.failed().message();
  EXPECT_NEAR(result.done().numbers().at("domain_volume"), 64 - domain_volume(ball), 1e-9);
}

TEST_F(Tasks, the_whole_chain_makes_a_valid_mesh_in_every_format) {
  const wire::Envelope assembled = chain(job_of(2), shapes::sphere({0, 0, 0}, 1, 2));
  ASSERT_TRUE(assembled.has_done()) << assembled.failed().message();
  EXPECT_EQ(assembled.done().numbers().at("boundary_triangles"), 320);
  EXPECT_EQ(assembled.done().numbers().at("subdomains"), 2);
  expect_right_files(assembled);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(store_.scratch_folder()), {}), 0)
      << "files were left behind";
}

TEST_F(Tasks, the_job_says_where_the_points_inside_come_from) {
  const auto mesh_hash = [this](const std::string& points) {
    JobFile job = job_of(1);
    job.points = points;
    const wire::Envelope inspected = inspect(job, shapes::sphere({0, 0, 0}, 1, 2));
    const wire::Envelope meshed = run(mesh_task,
                                      {{"job", publish(to_toml(job))},
                                       {"subdomain", output(inspected, "root")},
                                       {"spacing", output(inspected, "spacing")}},
                                      {{"work", "1000"}});
    return output(meshed, "mesh").hash();
  };
  EXPECT_NE(mesh_hash("lattice"), mesh_hash("sweeps"));
  EXPECT_EQ(mesh_hash("lattice"), mesh_hash(JobFile{}.points));
}

TEST_F(Tasks, every_region_is_meshed_and_conforms_to_its_neighbours) {
  const auto cubes = [](std::array<int, 3> size, const std::function<int(int, int, int)>& label) {
    return shapes::voxel_surface({size, label}).surface;
  };
  struct Case {
    const char* name;
    SurfaceMesh surface;
    int regions;
  };
  const Case cases[] = {
      {"two with a common face", cubes({2, 1, 1}, [](int x, int, int) { return x + 1; }), 2},
      {"four round an edge", cubes({2, 2, 1}, [](int x, int y, int) { return 1 + x + 2 * y; }), 4},
      {"two that share an edge", cubes({2, 2, 1}, [](int x, int y, int) { return x == y; }), 2},
      {"one in another, off its wall",
       cubes({3, 3, 3}, [](int x, int y, int z) { return x == 1 && y == 1 && z == 1 ? 2 : 1; }), 2},
      {"one in another, on its wall",
       cubes({3, 3, 2}, [](int x, int y, int z) { return x == 1 && y == 1 && z == 0 ? 2 : 1; }), 2},
      {"one that touches itself along an edge",
       cubes({2, 2, 2}, [](int x, int y, int z) { return x == y || z == 0 ? 1 : 2 + x; }), 3},
  };
  for (const Case& tried : cases) {
    JobFile job = job_of(1);
    if (tried.name == std::string_view("one in another, off its wall")) {
      job.regions = {{{1.5, 1.5, 1.5}, "core", false}};
    }
    const wire::Envelope assembled = chain(job, tried.surface);
    ASSERT_TRUE(assembled.has_done()) << tried.name << ": " << assembled.failed().message();
    EXPECT_EQ(assembled.done().numbers().at("subdomains"), tried.regions) << tried.name;
    expect_right_files(assembled);
  }
}

TEST_F(Tasks, the_job_says_which_planes_cut) {
  const auto left_hash = [this](const std::string& plane) {
    JobFile job = job_of(2);
    job.plane = plane;
    const wire::Envelope inspected = inspect(job, shapes::torus(0.4, 32, 16));
    return output(run(decompose_task,
                      {{"job", publish(to_toml(job))},
                       {"subdomain", output(inspected, "root")},
                       {"spacing", output(inspected, "spacing")}},
                      {{"left_parts", "1"}, {"right_parts", "1"}, {"work", "1000"}}),
                  "left")
        .hash();
  };
  EXPECT_NE(left_hash("axis"), left_hash("lattice"));
  EXPECT_EQ(left_hash("auto"), left_hash(JobFile{}.plane));
}

TEST_F(Tasks, leaves_of_different_regions_pass_no_elements_though_their_cuts_meet) {
  const auto neighbours_with_regions = [this](std::int32_t first, std::int32_t second) {
    Files files;
    for (const std::uint64_t heap : {4, 5}) {
      Subdomain leaf = root_subdomain(shapes::unit_cube());
      leaf.path = {heap};
      leaf.region = heap == 4 ? first : second;
      leaf.triangle_origin[0] = {heap / 2, 0};
      files["subdomain:" + std::to_string(heap)] = publish(subdomain_to_bytes(leaf));
    }
    return run(order_task, files).done().texts().at("order");
  };
  EXPECT_EQ(neighbours_with_regions(1, 1), "4 0 5\n5 1 4\n");
  EXPECT_EQ(neighbours_with_regions(1, 2), "4 0\n5 0\n");
}

TEST_F(Tasks, jobs_that_differ_in_their_subdomains_only_have_the_same_settings_and_files) {
  JobFile other = job_of(7);
  other.name = "other";
  other.groups = 2;
  other.formats = {"vtkhdf"};
  other.min_dihedral_deg = 3;
  const SurfaceMesh surface = shapes::sphere({0, 0, 0}, 1, 1);
  const wire::Envelope one = inspect(job_of(2), surface);
  const wire::Envelope two = inspect(other, surface);
  for (const char* name : {"surface", "spacing", "root", "settings"}) {
    EXPECT_EQ(output(one, name).hash(), output(two, name).hash()) << name;
  }
  other.points = "sweeps";
  EXPECT_NE(output(one, "settings").hash(), output(inspect(other, surface), "settings").hash());
}

TEST_F(Tasks, assimilated_leaves_are_meshed_and_assembled_as_one) {
  JobFile job = job_of(4);
  job.groups = 2;
  const wire::Envelope inspected = inspect(job, shapes::sphere({0, 0, 0}, 1, 3));
  EXPECT_EQ(inspected.done().numbers().at("groups"), 2);
  const wire::Artifact spacing = output(inspected, "spacing");
  Files leaves = {{"1", output(inspected, "root")}};
  std::ostringstream table;
  for (const int parent : {1, 2, 3}) {
    const std::string parts = parent == 1 ? "2" : "1";
    const wire::Envelope cut =
        run(decompose_task,
            {{"job", output(inspected, "settings")},
             {"subdomain", leaves.at(std::to_string(parent))},
             {"spacing", spacing}},
            {{"left_parts", parts}, {"right_parts", parts}, {"work", "1000"}});
    leaves.erase(std::to_string(parent));
    leaves[std::to_string(2 * parent)] = output(cut, "left");
    leaves[std::to_string(2 * parent + 1)] = output(cut, "right");
    table << "cut " << parent << " " << cut.done().numbers().at("interdomain_nodes") << "\n";
  }
  Files all = {{"job", publish(to_toml(job))}};
  for (const auto& [heap, leaf] : leaves) all["subdomain:" + heap] = leaf;
  // 4 and 6 are as heavy as 5 and 7 together.
  const wire::Envelope assimilated =
      run(assimilate_task, all, {{"table", "4 300\n5 200\n6 300\n7 200\n"}});
  ASSERT_TRUE(assimilated.has_done()) << assimilated.failed().message();
  const auto& figures = assimilated.done().numbers();
  EXPECT_EQ(figures.at("leaves"), 4);
  EXPECT_EQ(figures.at("groups"), 2);
  EXPECT_EQ(figures.at("estimated_max"), 500);
  EXPECT_EQ(figures.at("estimated_mean"), 500);
  EXPECT_EQ(figures.at("leaf_estimated_max"), 300);
  EXPECT_GT(figures.at("communication_nodes_max"), 0);
  EXPECT_LT(figures.at("faces_max"), 4 * figures.at("leaf_faces_max"));
  std::istringstream lines(assimilated.done().texts().at("groups"));
  std::string heap;
  std::string group;
  Files files = {{"job", all.at("job")}, {"surface", output(inspected, "surface")}};
  while (lines >> heap >> group) {
    if (heap != group) {
      table << "joined " << heap << " " << group << "\n";
      continue;
    }
    files["subdomain:" + heap] = output(assimilated, "group:" + heap);
    const wire::Envelope meshed = run(mesh_task,
                                      {{"job", output(inspected, "settings")},
                                       {"subdomain", files.at("subdomain:" + heap)},
                                       {"spacing", spacing}},
                                      {{"work", "1000"}});
    ASSERT_TRUE(meshed.has_done()) << meshed.failed().message();
    files["mesh:" + heap] = output(meshed, "mesh");
    table << "leaf " << heap << " " << meshed.done().numbers().at("interior_nodes") << " "
          << meshed.done().numbers().at("tets") << "\n";
  }
  const wire::Envelope numbered = run(
      number_task, {{"surface", files.at("surface")}, {"dropped", output(assimilated, "dropped")}},
      {{"table", table.str()}});
  files["numbering"] = output(numbered, "numbering");
  const wire::Envelope assembled = run(assemble_task, written(files));
  ASSERT_TRUE(assembled.has_done()) << assembled.failed().message();
  EXPECT_EQ(assembled.done().numbers().at("subdomains"), 2);
  const std::string path = folder_ + "/ball.lb8.ugrid";
  std::filesystem::copy_file(store_.path_of(output(assembled, "ball.lb8.ugrid").hash()), path);
  const MeshReport report = report_on(read_global_mesh(path));
  EXPECT_TRUE(report.complaints.empty()) << report.complaints.front();
}

TEST_F(Tasks, a_subdomain_that_no_plane_cuts_stays_whole_with_a_reason) {
  const SurfaceMesh tetrahedron = shapes::tetrahedron();
  const wire::Envelope result =
      run(decompose_task,
          {{"job", publish(to_toml(job_of(2)))},
           {"subdomain", publish(subdomain_to_bytes(root_subdomain(tetrahedron)))},
           {"spacing", publish(SpacingField(1.0).to_bytes())}},
          {{"left_parts", "1"}, {"right_parts", "1"}, {"work", "1000"}});
  ASSERT_TRUE(result.has_done()) << result.failed().message();
  EXPECT_EQ(result.done().outputs_size(), 0);
  EXPECT_FALSE(result.done().texts().at("reason").empty());
}

TEST_F(Tasks, the_same_inputs_give_the_same_bytes) {
  const wire::Envelope inspected = inspect(job_of(2), shapes::torus(0.4, 16, 10));
  const Files inputs = {{"job", publish(to_toml(job_of(2)))},
                        {"subdomain", output(inspected, "root")},
                        {"spacing", output(inspected, "spacing")}};
  const wire::Envelope once =
      run(decompose_task, inputs, {{"left_parts", "1"}, {"right_parts", "1"}, {"work", "1000"}});
  const wire::Envelope again =
      run(decompose_task, inputs, {{"left_parts", "1"}, {"right_parts", "1"}, {"work", "1000"}});
  EXPECT_EQ(once.done().SerializeAsString().size(), again.done().SerializeAsString().size());
  EXPECT_EQ(output(once, "left").hash(), output(again, "left").hash());
  EXPECT_EQ(output(once, "right").hash(), output(again, "right").hash());
}

/// While it lives, files of this process cannot grow beyond it, as on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::signal(SIGXFSZ, SIG_IGN);
    EXPECT_EQ(::getrlimit(RLIMIT_FSIZE, &before_), 0);
    const rlimit limit{bytes, before_.rlim_max};
    EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  }
  ~FileSizeLimit() {
    EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &before_), 0);
    ::signal(SIGXFSZ, SIG_DFL);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

TEST_F(Tasks, that_fail_for_a_full_disk_leave_no_file_in_the_making) {
  JobFile job = job_of(1);
  job.formats = {"vtkhdf"};
  const wire::Envelope inspected = inspect(job, shapes::sphere({0, 0, 0}, 1, 1));
  Files files = {{"job", publish(to_toml(job))}, {"surface", output(inspected, "surface")}};
  std::string table;
  ASSERT_TRUE(settle(output(inspected, "root"), 1, 1, output(inspected, "spacing"), table, files));
  const wire::Envelope numbered =
      run(number_task, {{"surface", files["surface"]}}, {{"table", table}});
  files["numbering"] = output(numbered, "numbering");
  const Files inputs = {{"job", files["job"]},
                        {"surface", files["surface"]},
                        {"numbering", files["numbering"]},
                        {"subdomain", files["subdomain:1"]},
                        {"mesh", files["mesh:1"]}};
  // In a process of its own, as tasks are: HDF5 does not forget a file that could not be closed.
  const auto fails_for_a_full_disk = [&] {
    const FileSizeLimit full_disk(1000);
    return run(write_task, inputs).has_failed();
  };
  EXPECT_EXIT(::_exit(fails_for_a_full_disk() ? 0 : 1), testing::ExitedWithCode(0), "");
  for (const auto& entry : std::filesystem::directory_iterator(store_.scratch_folder())) {
    ADD_FAILURE() << "left behind: " << entry.path();
  }
  EXPECT_TRUE(run(write_task, inputs).has_done()) << "with room it is done";
}

TEST(Evidence, names_triangles_of_the_input_and_of_cuts_with_their_place) {
  Subdomain half = root_subdomain(shapes::unit_cube());
  half.path = TreePath{6};
  half.triangle_origin[1] = {3, 17};
  const std::string message = subdomain_message(half, "an edge is missing", {0, 1});
  EXPECT_THAT(message, HasSubstr("sub-domain RL: an edge is missing"));
  EXPECT_EQ(message, subdomain_message(half, "sub-domain RL: an edge is missing", {0, 1}));
  EXPECT_THAT(message, HasSubstr("triangle 0 of the input at ("));
  EXPECT_THAT(message, HasSubstr("triangle 17 of the cut of sub-domain R at ("));
}

}  // namespace
}  // namespace tetfarm
