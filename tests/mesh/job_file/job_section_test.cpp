#include "mesh/job_file/job_section.h"

#include <gtest/gtest.h>

#include <array>

#include "base/error.h"
#include "mesh/job_file/job_file.h"

namespace tetfarm {
namespace {

const std::string geometry_lines = "[geometry]\nsurface = \"a.stl\"\n";

/// What is said of the job file, wholly.
std::string said_of(const std::string& text) {
  try {
    parse_job_file(text, "j");
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

struct Said {
  std::string text;  ///< behind the geometry
  std::string message;
};

TEST(JobSections, say_all_of_what_is_wrong_and_where) {
  const std::string planes = "\"auto\", \"lattice\", \"axis\", \"inertia\"";
  for (const auto& [text, message] : std::vector<Said>{
           {"", ""},
           {"[spacing]\ngrowth = true", "j:4:10: `growth` must be a number, not a boolean"},
           {"[spacing]\ngrowth = [1]", "j:4:10: `growth` must be a number, not an array"},
           {"[spacing]\ngrowth = {}", "j:4:10: `growth` must be a number, not a table"},
           {"[spacing]\ngrowth = 2026-11-25",
            "j:4:10: `growth` must be a number, not a date or time"},
           {"[spacing]\ngrowth = inf", "j:4:10: `growth` must be finite"},
           {"[spacing]\ngrowth = -0.1", "j:4:10: `growth` must be positive"},
           {"[spacing]\ngrowth = 0", "j:4:10: `growth` must be positive"},
           {"[spacing]\ngrowth = 1e-9", ""},
           {"[spacing]\ndefault = -1e-9", "j:4:11: `default` must not be negative"},
           {"[spacing]\ndefault = 0", ""},
           {"[spacing]\nsources = \"\"", "j:4:11: `sources` must not be empty"},
           {"[spacing]\nsources = 1", "j:4:11: `sources` must be a string, not an integer"},
           {"[spacing]\nmax_elements = 1.5",
            "j:4:16: `max_elements` must be an integer, not a number"},
           {"[domain]\nouter = \"box\"\nfactor = 1", "j:5:10: `factor` must be more than 1"},
           {"[domain]\nouter = \"box\"\nfactor = 1.001", ""},
           {"[domain]\nouter = \"sphere\"\nspacing = -1", "j:5:11: `spacing` must not be negative"},
           {"[domain]\nspacing = 1", "j:4:11: `spacing` needs `outer` = \"box\" or \"sphere\""},
           {"[domain]\nouter = \"none\"\nfactor = 3",
            "j:5:10: `factor` needs `outer` = \"box\" or \"sphere\""},
           {"[decompose]\nplane = \"axes\"",
            "j:4:9: `plane` is \"axes\", not one of " + planes + "; did you mean `axis`?"},
           {"[decompose]\nplane = \"something\"",
            "j:4:9: `plane` is \"something\", not one of " + planes},
           {"[decompose]\nsubdomains = 1000000", ""},
           {"[decompose]\ntarget_elements = 999",
            "j:4:19: `target_elements` must be at least 1000, or 0 to choose it by the job's size"},
           {"[decompose]\ntarget_elements = 1000", ""},
           {"[decompose]\ntarget_elements = 0", ""},
           {"[decompose]\nmax_memory = \"2\\u00a0GB\"",
            "j:4:14: `max_memory` must be an amount like \"2GiB\" or \"500MB\""},
           {"[decompose]\nmax_memory = \"2GB\"\nsubdomains = 0", ""},
           {"[decompose]\nmax_memory = \"2GB\"\nsubdomains = 1",
            "j:5:14: `subdomains` cannot be given together with `max_memory`, which decides it"},
           {"[decompose]\nmax_memory = \"2GB\"\ntarget_elements = 0",
            "j:5:19: `target_elements` cannot be given together with `max_memory`, which decides "
            "it"},
           {"[decompose]\nsubdomains = 4\nassimilate = { groups = 4 }", ""},
           {"[decompose]\nsubdomains = 4\nassimilate = { groups = 5 }",
            "j:5:25: `groups` must not be more than `subdomains`, the leaves to join"},
           {"[decompose]\nsubdomains = 0\nassimilate = { groups = 5 }", ""},
           {"[decompose.assimilate]\ngroups = 1\nmethod = \"x\"",
            "j:5:10: `method` is \"x\", not one of \"recursive\", \"k-way\", \"k-way-volume\""},
           {"[decompose.assimilate]\nmethod = \"k-way\"",
            "j:3:1: `groups` is missing in [decompose.assimilate]"},
           {"[decompose.assimilate]\ngroup = 1",
            "j:4:1: unknown key `group` in [decompose.assimilate]; did you mean `groups`?"},
           {"[quality]\nmin_dihedral = 70.5",
            "j:4:16: `min_dihedral` must be less than 70.5, the angle of the regular tetrahedron"},
           {"[quality]\nmin_dihedral = 70.4", ""},
           {"[quality]\nmin_unforced_dihedral = -1",
            "j:4:25: `min_unforced_dihedral` must not be negative"},
           {"[output]\nformats = [1]", "j:4:12: `formats` must hold strings"},
           {"[output]\nformats = [\"su2\", \"su2\"]", "j:4:19: `formats` has \"su2\" twice"},
           {"[output]\nformats = []", "j:4:11: `formats` must name at least one format"},
           {"[cosmetics]\nacross_cuts = \"no\"",
            "j:4:15: `across_cuts` must be true or false, not a string"},
           {"[region]\nat = [0, 0, 0]", "j:3:1: `region` must be written [[region]]"},
           {"[[region]]\nname = \"a\"", "j:3:1: `at` is missing in [region]"},
           {"[[region]]\nat = 1", "j:4:6: `at` must be an array, not an integer"},
           {"[[region]]\nat = [0, 0, 0, 0]", "j:4:6: `at` must have three coordinates"},
           {"[[region]]\nat = [0, 0, 0]\nvoid = 1",
            "j:5:8: `void` must be true or false, not an integer"},
           {"[[region]]\nat = [0, 0, 0]\nname = 1",
            "j:5:8: `name` must be a string, not an integer"},
           {"[[source]]\nkind = \"triangle\"\ncorner = [1, 2]",
            "j:5:10: `corner` must hold three tables"},
           {"[[source]]\nkind = \"triangle\"\ncorner = [1, 2, 3]",
            "j:5:11: `corner` must hold tables, not an integer"},
           {"[[source]]\nkind = \"line\"\nfrom = { at = [0, 0, 0], spacing = 1, inner = 1, outer = "
            "1 }",
            "j:3:1: `to` is missing in [source]"},
           {"[[source]]\nkind = \"line\"\nfrom = { at = [0, 0, 0], spacing = 1, inner = 1, outer = "
            "1, "
            "size = 1 }",
            "j:5:61: unknown key `size` in [source.from]"},
           {"[[source]]\nkind = \"point\"\nat = [0, 0, 0]\nspacing = 1\ninner = 2\nouter = 1",
            "j:8:9: `outer` must not be less than `inner`"},
           {"[[source]]\nkind = \"point\"\nat = [0, 0, 0]\nspacing = 1\ninner = 2\nouter = 2", ""},
           {"[[source]]\nkind = \"point\"\nat = [0, 0, 0]\nspacing = 0\ninner = 2\nouter = 2",
            "j:6:11: `spacing` must be positive"}}) {
    EXPECT_EQ(said_of(geometry_lines + text), message) << text;
  }
}

TEST(JobSections, say_all_of_what_is_wrong_at_the_top) {
  EXPECT_EQ(said_of(""), "j: `surface` is missing in [geometry]");
  EXPECT_EQ(said_of("version = 1\n" + geometry_lines), "");
  EXPECT_EQ(said_of("version = 0\n" + geometry_lines), "j:1:11: `version` must be at least 1");
  EXPECT_EQ(said_of("version = 2\n" + geometry_lines),
            "j:1:11: `version` must be 1: this Tetfarm knows no newer version of job files");
  EXPECT_EQ(said_of("nam = \"a\"\n" + geometry_lines),
            "j:1:1: unknown key `nam`; did you mean `name`?");
  const std::string word(101, 'n');
  EXPECT_EQ(said_of(word + " = 1\n" + geometry_lines),
            "j:1:1: unknown key `" + word.substr(0, 100) + "…`");
  EXPECT_EQ(said_of(word.substr(0, 100) + " = 1\n" + geometry_lines),
            "j:1:1: unknown key `" + word.substr(0, 100) + "`");
}

TEST(ParseJobFileOf, regions_and_files_of_sources_has_what_they_say) {
  const JobFile job =
      parse_job_file(geometry_lines +
                         "[spacing]\nsources = \"../a.bac\"\n[[region]]\nat = [1, 2, 3]\n"
                         "[[region]]\nat = [4, 5, 6.5]\nname = \"air\"\nvoid = true\n",
                     "/jobs/wing.toml");
  EXPECT_EQ(job.sources_file, "/a.bac");
  ASSERT_EQ(job.regions.size(), 2U);
  EXPECT_EQ(job.regions[0].at, (Vec3{1, 2, 3}));
  EXPECT_EQ(job.regions[0].name, "");
  EXPECT_FALSE(job.regions[0].is_void);
  EXPECT_EQ(job.regions[1].at, (Vec3{4, 5, 6.5}));
  EXPECT_EQ(job.regions[1].name, "air");
  EXPECT_TRUE(job.regions[1].is_void);
}

TEST(JobFileKeys, are_each_there_once) {
  std::string all;
  for (const std::string& key : job_file_keys()) all += key + " ";
  EXPECT_EQ(
      all,
      "version name geometry.surface geometry.scale geometry.unit surface.remesh surface.size "
      "surface.min_size surface.angle "
      "surface.tolerance domain.outer domain.factor domain.spacing domain.symmetry region.at "
      "region.name region.void spacing.default spacing.frequency spacing.wave_speed "
      "spacing.per_wavelength spacing.growth spacing.surface spacing.sources "
      "spacing.max_elements source.kind source.at source.spacing source.inner source.outer "
      "source.from source.to source.corner source.radius source.low source.high source.corner.at "
      "source.corner.spacing "
      "source.corner.inner source.corner.outer layers.patches layers.first_height "
      "layers.y_plus layers.reynolds layers.length layers.growth layers.growth_cap "
      "layers.acceleration layers.total_height layers.count layers.equal layers.heights "
      "layers.room layers.step "
      "layers.fan_angle layers.elements patch.type patch.size patch.growth "
      "patch.layers "
      "pml.patches pml.layers pml.height pml.corners pml.elements pml.side "
      "decompose.subdomains decompose.target_elements "
      "decompose.plane decompose.max_memory decompose.assimilate decompose.assimilate.groups "
      "decompose.assimilate.method mesh.points cosmetics.across_cuts quality.min_dihedral "
      "quality.min_unforced_dihedral output.formats output.keep ");
}

}  // namespace
}  // namespace tetfarm
