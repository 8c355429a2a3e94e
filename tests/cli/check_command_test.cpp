// What `check` says of surfaces, called as main calls it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "base/file_system.h"
#include "cli/commands.h"
#include "tests/base/temp_folder.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* tet_off =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
constexpr const char* open_off =
    "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n";

class Checked : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    write_file_atomically(folder_.path() / name, text);
    return (folder_.path() / name).string();
  }
  Said check(const std::string& input, bool as_json = false,
             const std::string& defects_file = "") const {
    CheckOptions options;
    options.input = input;
    options.json = as_json;
    options.defects_file = defects_file;
    return said_by([&] { return check_command(options); });
  }

  const TempFolder folder_;
};

TEST_F(Checked, a_sound_surface_is_told_with_its_figures) {
  const Said said = check(write("tet.off", tet_off));
  EXPECT_EQ(said.code, ExitCode::ok);
  EXPECT_EQ(said.error, "");
  EXPECT_THAT(said.out, StartsWith("triangles       4\nvertices        4\npatches         1\n"
                                   "shells          1\nvolume          0.166666667\n"
                                   "edges           1 shortest, 1.414 median, 1.414 longest\n"
                                   "smallest angle  45.00 deg\nelements        about "));
  EXPECT_THAT(said.out, ::testing::EndsWith(", in 1 sub-domain\n"));
}

TEST_F(Checked, a_sound_surface_is_told_to_programs_with_its_figures) {
  const Said said = check(write("tet.off", tet_off), true);
  EXPECT_EQ(std::count(said.out.begin(), said.out.end(), '\n'), 1);
  json told = json::parse(said.out);
  EXPECT_GT(told["estimated_elements"], 0);
  EXPECT_EQ(told["subdomains"], 1);
  EXPECT_EQ(told["angles"]["smallest_angle_deg"], 45);
  EXPECT_NEAR(told["longest_edge"].get<double>(), 1.41421356, 1e-8);
  for (const char* key : {"estimated_elements", "subdomains", "angles", "volume", "median_edge",
                          "longest_edge", "smallest_angle_deg"}) {
    EXPECT_TRUE(told.contains(key));
    told.erase(key);
  }
  EXPECT_EQ(told, json::parse(R"({"type":"check","can_be_meshed":true,"triangles":4,"vertices":4,
                "patches":["surface"],"shells":1,"shortest_edge":1.0,"remarks":[],
                "regions":[],"defects":[]})"));
}

TEST_F(Checked, a_surface_in_another_unit_is_told_in_metres) {
  CheckOptions options;
  options.input = write("tet.off", tet_off);
  options.unit = "cm";
  const Said said = said_by([&] { return check_command(options); });
  EXPECT_THAT(said.out, StartsWith("lengths         m, of a surface in cm\ntriangles       4\n"));
  EXPECT_THAT(said.out, HasSubstr("volume          1.66666667e-07 m^3\n"
                                  "edges           0.01 m shortest, 0.01414 m median, "));
  options.json = true;
  const json told = json::parse(said_by([&] { return check_command(options); }).out);
  EXPECT_EQ(told["unit"], "m");
  EXPECT_EQ(told["scale"], 0.01);
  EXPECT_EQ(told["shortest_edge"], 0.01);
}

TEST_F(Checked, sizes_at_patches_count_in_what_the_job_comes_to) {
  CheckOptions options;
  options.input = write("tet.off", tet_off);
  options.json = true;
  const auto elements = [&options] {
    return json::parse(said_by([&] { return check_command(options); }).out)["estimated_elements"]
        .get<double>();
  };
  const double plain = elements();
  options.patch_sizes = {"surface=0.02"};
  EXPECT_GT(elements(), 20 * plain);
  options.patch_sizes = {"wing=0.1"};
  EXPECT_THAT(said_by([&] { return check_command(options); }).error,
              HasSubstr("--patch-size 'wing=0.1': \"wing\" matches no patch"));
}

TEST_F(Checked, defects_are_an_error_and_lie_in_a_file) {
  const std::string surface = write("open.off", open_off);
  const std::string file = (folder_.path() / "bad.vtp").string();
  const Said said = check(surface, true, file);
  EXPECT_EQ(said.code, ExitCode::bad_geometry);
  EXPECT_THAT(said.error, StartsWith(surface + ": the surface cannot be meshed"));
  EXPECT_THAT(said.error, ::testing::EndsWith("\n  see " + file));
  EXPECT_THAT(read_file(file), HasSubstr("PolyData"));
  const json told = json::parse(said.out);
  EXPECT_EQ(told["can_be_meshed"], false);
  EXPECT_FALSE(told["defects"].empty());
  EXPECT_FALSE(told["defects"][0]["kind"].empty());
  EXPECT_FALSE(told["defects"][0]["message"].empty());
  EXPECT_FALSE(told.contains("estimated_elements"));
  const Said in_folder = check(surface, false, folder_.path());
  EXPECT_THAT(in_folder.error,
              HasSubstr("\n  see " + (folder_.path() / "open.defects.vtp").string()));
  EXPECT_THAT(in_folder.out, StartsWith("triangles       3\n"));
  EXPECT_EQ(in_folder.out.find("elements  "), std::string::npos);
}

TEST_F(Checked, voids_and_regions_are_told_apart) {
  std::string two = "OFF\n8 8 0\n0 0 0\n9 0 0\n0 9 0\n0 0 9\n1 1 1\n2 1 1\n1 2 1\n1 1 2\n";
  for (const int base : {0, 4}) {
    for (const auto& t : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
      two += "3 " + std::to_string(base + t[0]) + " " + std::to_string(base + t[1]) + " " +
             std::to_string(base + t[2]) + "\n";
    }
  }
  write("two.off", two);
  const std::string job =
      write("job.toml",
            "[geometry]\nsurface = \"two.off\"\n[[region]]\nat = [1.1, 1.1, 1.1]\nvoid = true\n");
  const Said said = check(job);
  EXPECT_EQ(said.error, "");
  EXPECT_THAT(said.out, HasSubstr("\nshells          2\n"));
  EXPECT_THAT(said.out, HasSubstr("\nvoid            "));
  EXPECT_THAT(said.out, HasSubstr("\nregion 1        "));
  EXPECT_THAT(said.out, HasSubstr(", volume 121.333333\n")) << "without the void";
}

TEST_F(Checked, absorbing_layers_round_an_outer_boundary_of_the_command_line_are_told) {
  CheckOptions options;
  options.input = write("tet.off", tet_off);
  options.outer = "box";
  options.outer_size = 2;
  options.pml = "outer:layers=3,height=0.5,elements=prisms";
  options.json = true;
  const json told = json::parse(said_by([&] { return check_command(options); }).out);
  EXPECT_EQ(told["pml"]["patches"], json({"outer_box"}));
  EXPECT_EQ(told["pml"]["thickness"], 1.5);
  const std::string job = write("job.toml",
                                "[geometry]\nsurface = \"tet.off\"\n"
                                "[domain]\nouter = \"box\"\nspacing = 2\n"
                                "[[pml]]\npatches = [\"outer\"]\nlayers = 3\nheight = 0.5\n"
                                "elements = \"prisms\"\n");
  EXPECT_EQ(json::parse(check(job, true).out), told);
  options.outer_size = 1;
  const json finer = json::parse(said_by([&] { return check_command(options); }).out);
  EXPECT_GT(finer["pml"]["prisms"], told["pml"]["prisms"]);
}

TEST_F(Checked, layers_are_told_with_what_they_come_to) {
  CheckOptions options;
  options.input = write("tet.off", tet_off);
  options.layers = {"*:first=0.125,growth=2,count=3"};
  const Said said = said_by([&] { return check_command(options); });
  EXPECT_EQ(said.error, "");
  EXPECT_THAT(said.out,
              HasSubstr("\nlayers          \"surface\": 3 layers, 0.125 to 0.5 high, 0.875 "
                        "together; median edge 1.414, isotropic from layer 5\n"));
  options.json = true;
  const json told = json::parse(said_by([&] { return check_command(options); }).out);
  ASSERT_EQ(told["layers"].size(), 1U);
  EXPECT_EQ(told["layers"][0]["total_height"], 0.875);
  options.layers = {"wing:first=0.1"};
  const Said refused = said_by([&] { return check_command(options); });
  EXPECT_EQ(refused.code, ExitCode::usage);
  EXPECT_THAT(refused.error, HasSubstr("\"wing\" matches no patch"));
}

TEST_F(Checked, layers_of_a_job_file_are_told_as_well) {
  write("tet.off", tet_off);
  const Said said = check(write("job.toml",
                                "[geometry]\nsurface = \"tet.off\"\n[[layers]]\n"
                                "patches = [\"*\"]\nfirst_height = 0.1\n"));
  EXPECT_THAT(said.out, HasSubstr("\nlayers          \"surface\": 15 layers, 0.1 to "));
}

TEST_F(Checked, something_is_to_be_named) {
  const Said said = check("");
  EXPECT_EQ(said.code, ExitCode::usage);
  EXPECT_EQ(said.error, "check: give a surface, a job file, or --store DIR");
}

TEST_F(Checked, a_bad_surface_is_told_what_healing_would_do) {
  const std::string twice = std::string(tet_off).replace(4, 3, "4 5") + "3 0 2 1\n";
  const Said said = check(write("twice.off", twice), false, folder_.path());
  EXPECT_EQ(said.code, ExitCode::bad_geometry);
  EXPECT_THAT(said.out, HasSubstr("healing         would mend it: tetfarm surface "));
  EXPECT_THAT(said.out, HasSubstr("1 duplicate triangle removed"));
  const json told = json::parse(check(write("twice.off", twice), true, folder_.path()).out);
  EXPECT_EQ(told["healing"]["mends_all"], true);
  EXPECT_EQ(told["healing"]["acts"][0]["count"], 1);
  const json open = json::parse(check(write("open.off", open_off), true, folder_.path()).out);
  EXPECT_EQ(open["healing"]["mends_all"], false);
  EXPECT_EQ(open["healing"]["left"], json({"too few triangles", "open edge"}));
  EXPECT_THAT(check(write("open.off", open_off), false, folder_.path()).out,
              HasSubstr("healing         would leave: too few triangles, open edge\n"));
}

TEST_F(Checked, a_surface_for_a_frequency_is_told_with_its_size_and_its_longer_edges) {
  CheckOptions options;
  options.input = write("tet.off", tet_off);
  options.wave.frequency = "299792458";
  const Said said = said_by([&] { return check_command(options); });
  EXPECT_THAT(said.out, HasSubstr("size            0.1 (10 to a wavelength of 1)\n"));
  EXPECT_THAT(said.out, HasSubstr("remark          the surface has edges of up to 1.41421, longer "
                                  "than the 0.1 that the frequency allows"));
  options.json = true;
  const json told = json::parse(said_by([&] { return check_command(options); }).out);
  EXPECT_DOUBLE_EQ(told["size"].get<double>(), 0.1);
  EXPECT_EQ(told["wavelength"], 1);
  options.remesh = true;
  options.json = false;
  EXPECT_THAT(said_by([&] { return check_command(options); }).out,
              ::testing::Not(HasSubstr("the surface has edges")));
}

}  // namespace
}  // namespace tetfarm
