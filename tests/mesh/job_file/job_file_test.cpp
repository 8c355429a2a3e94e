#include "mesh/job_file/job_file.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "base/error.h"
#include "mesh/job_file/loop_job.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace fs = std::filesystem;

const fs::path project = TETFARM_SOURCE_DIR;

std::string contents(const fs::path& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file.is_open()) << path;
  return (std::ostringstream() << file.rdbuf()).str();
}

const std::string geometry = "[geometry]\nsurface = \"a.stl\"\n";  // two lines

const std::string everything = R"(
version = 1
name = "a \"quoted\" name"
[geometry]
surface = "../models/a.stl"
[domain]
outer = "box"
factor = 2.5
spacing = 1
[spacing]
default = 0.1
growth = 0.123456789012345678
surface = "ignore"
max_elements = 7000000000
[[source]]
kind = "point"
at = [1, -2.5, 1e-3]
spacing = 0.01
inner = 1
outer = 2
[[source]]
kind = "line"
from = { at = [0, 0, 0], spacing = 0.1, inner = 1, outer = 1 }
to = { at = [1, 0, 0], spacing = 0.2, inner = 2, outer = 3 }
[[source]]
kind = "triangle"
corner = [
  { at = [0, 0, 0], spacing = 0.1, inner = 1, outer = 4 },
  { at = [1, 0, 0], spacing = 0.2, inner = 2, outer = 5 },
  { at = [0, 1, 0], spacing = 0.3, inner = 3, outer = 6 },
]
[[layers]]
patches = ["wing_*", "tip"]
y_plus = 1
reynolds = 6e6
length = 1.5
growth = 1.1
growth_cap = 1.5
acceleration = 1.05
total_height = 0.01
equal = 2
room = "scale"
[decompose]
subdomains = 12
target_elements = 5000000000
plane = "lattice"
assimilate = { groups = 3, method = "k-way" }
[mesh]
points = "sweeps"
[cosmetics]
across_cuts = false
[quality]
min_dihedral = 5
min_unforced_dihedral = 7.5
[output]
formats = ["lb8.ugrid", "vtkhdf"]
)";

void expect_equal(const JobFile& a, const JobFile& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.surface, b.surface);
  EXPECT_EQ(a.outer_kind, b.outer_kind);
  EXPECT_EQ(a.outer_factor, b.outer_factor);
  EXPECT_EQ(a.outer_spacing, b.outer_spacing);
  EXPECT_EQ(a.spacing_default, b.spacing_default);
  EXPECT_EQ(a.growth, b.growth);
  EXPECT_EQ(a.inherit_surface, b.inherit_surface);
  EXPECT_EQ(a.max_elements, b.max_elements);
  EXPECT_EQ(a.subdomains, b.subdomains);
  EXPECT_EQ(a.target_elements, b.target_elements);
  EXPECT_EQ(a.plane, b.plane);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.across_cuts, b.across_cuts);
  EXPECT_EQ(a.groups, b.groups);
  EXPECT_EQ(a.assimilate_method, b.assimilate_method);
  EXPECT_EQ(a.min_dihedral_deg, b.min_dihedral_deg);
  EXPECT_EQ(a.min_unforced_dihedral_deg, b.min_unforced_dihedral_deg);
  EXPECT_EQ(a.formats, b.formats);
  ASSERT_EQ(a.sources.size(), b.sources.size());
  for (std::size_t i = 0; i < a.sources.size(); ++i) {
    ASSERT_EQ(a.sources[i].corners.size(), b.sources[i].corners.size());
    for (std::size_t k = 0; k < a.sources[i].corners.size(); ++k) {
      const JobSource::Corner& p = a.sources[i].corners[k];
      const JobSource::Corner& q = b.sources[i].corners[k];
      EXPECT_EQ(p.at, q.at);
      EXPECT_EQ(p.spacing, q.spacing);
      EXPECT_EQ(p.inner, q.inner);
      EXPECT_EQ(p.outer, q.outer);
    }
  }
}

TEST(ParseJobFile, fills_in_the_defaults) {
  const JobFile job = parse_job_file(geometry, "/jobs/wing.toml");
  JobFile expected;
  expected.name = "wing";
  expected.surface = "/jobs/a.stl";
  expect_equal(job, expected);
}

TEST(ParseJobFile, reads_every_key) {
  const JobFile job = parse_job_file(everything, "/jobs/wing.toml");
  EXPECT_EQ(job.name, "a \"quoted\" name");
  EXPECT_EQ(job.surface, "/models/a.stl");
  EXPECT_EQ(job.outer_kind, "box");
  EXPECT_EQ(job.outer_factor, 2.5);
  EXPECT_EQ(job.outer_spacing, 1);
  EXPECT_EQ(job.spacing_default, 0.1);
  EXPECT_EQ(job.growth, 0.123456789012345678);
  EXPECT_FALSE(job.inherit_surface);
  EXPECT_EQ(job.max_elements, 7000000000);
  EXPECT_EQ(job.subdomains, 12);
  EXPECT_EQ(job.target_elements, 5000000000);
  EXPECT_EQ(job.plane, "lattice");
  EXPECT_EQ(job.points, "sweeps");
  EXPECT_FALSE(job.across_cuts);
  EXPECT_EQ(job.groups, 3);
  EXPECT_EQ(job.assimilate_method, "k-way");
  EXPECT_EQ(job.min_dihedral_deg, 5);
  EXPECT_EQ(job.min_unforced_dihedral_deg, 7.5);
  EXPECT_THAT(job.formats, ElementsAre("lb8.ugrid", "vtkhdf"));
  ASSERT_EQ(job.sources.size(), 3U);
  ASSERT_EQ(job.sources[0].corners.size(), 1U);
  EXPECT_EQ(job.sources[0].line, 15);
  EXPECT_EQ(job.sources[0].corners[0].at, (Vec3{1, -2.5, 1e-3}));
  EXPECT_EQ(job.sources[0].corners[0].outer, 2);
  ASSERT_EQ(job.sources[1].corners.size(), 2U);
  EXPECT_EQ(job.sources[1].corners[1].spacing, 0.2);
  ASSERT_EQ(job.sources[2].corners.size(), 3U);
  EXPECT_EQ(job.sources[2].corners[2].inner, 3);
}

TEST(ParseJobFile, has_a_gate_only_for_what_the_surface_does_not_force) {
  const JobFile job = parse_job_file(geometry, "/jobs/wing.toml");
  EXPECT_EQ(job.min_dihedral_deg, 0);
  EXPECT_EQ(job.min_unforced_dihedral_deg, 0.1);
  const std::string off = std::string(geometry) + "[quality]\nmin_unforced_dihedral = 0\n";
  EXPECT_EQ(parse_job_file(off, "/jobs/wing.toml").min_unforced_dihedral_deg, 0);
}

TEST(ParseJobFile, an_outer_boundary_has_a_default_size) {
  const std::string domain = geometry + "[domain]\nouter = ";
  EXPECT_EQ(parse_job_file(domain + "\"box\"", "a.toml").outer_factor, 3);
  EXPECT_EQ(parse_job_file(domain + "\"sphere\"", "a.toml").outer_factor, 5);
  EXPECT_EQ(parse_job_file(domain + "\"none\"", "a.toml").outer_factor, 0);
}

TEST(ParseJobFile, takes_the_surface_from_the_folder_of_the_job_file) {
  const std::string absolute = "[geometry]\nsurface = \"/data/a.stl\"\n";
  EXPECT_EQ(parse_job_file(absolute, "job.toml").surface, "/data/a.stl");
  EXPECT_EQ(parse_job_file(geometry, "sub/job.toml").surface, "sub/a.stl");
  EXPECT_EQ(parse_job_file(geometry, "job.toml").surface, "a.stl");
}

TEST(ToToml, parsed_again_gives_the_same_job) {
  for (const std::string& text : {everything, geometry}) {
    const JobFile job = parse_job_file(text, "/jobs/wing.toml");
    const std::string written = to_toml(job);
    expect_equal(parse_job_file(written, "/elsewhere/job.toml"), job);
    EXPECT_EQ(to_toml(parse_job_file(written, "/elsewhere/job.toml")), written);
  }
}

TEST(ToToml, keeps_odd_names_and_extreme_numbers) {
  JobFile job = parse_job_file(geometry, "/jobs/wing.toml");
  job.name = "quote\" backslash\\ ünïcode";
  job.surface = "/a b/\"c\"/tab\t line\n bell\a del\x7f.stl";
  job.growth = 5e-324;
  job.spacing_default = 1.7976931348623157e308;
  job.sources = {{{{{0.1, -1e-300, 1e22}, 1.0 / 3, 2.0 / 3, 1e300}}}};
  expect_equal(parse_job_file(to_toml(job), "/x.toml"), job);
}

struct Mistake {
  std::string text;
  std::string message;
};

TEST(ParseJobFile, says_where_and_what_is_wrong) {
  const std::string point =
      "[[source]]\nkind = \"point\"\nat = [0, 0, 0]\nspacing = 1\ninner = 1\n";
  const std::vector<Mistake> mistakes = {
      {"", "job.toml: `surface` is missing in [geometry]"},
      {"geometry = 3", "job.toml:1:12: `geometry` must be a table, not an integer"},
      {"[geometry]\nsurface = 3", "job.toml:2:11: `surface` must be a string, not an integer"},
      {"[geometry]\nsurface = \"\"", "`surface` must not be empty"},
      {"[geometry\n", "job.toml:1:"},
      {geometry + "[=]\n", "job.toml:3:2: "},
      {geometry + "a = [0, }\n", "job.toml:3:9: "},
      {"# ö\nname = 'ö \\'\n grö = 1", "job.toml:3:4: "},
      {"name = \"ö\\\"ö\"\n[\xc2\xa1]", "job.toml:2:2: "},
      {"name = \"\"\"ö\n\" ö\"\"\" ö", "job.toml:2:8: "},
      {"name = \"\"\"a\\\xef\xba\xbf\"\"\"", "job.toml:1:13: "},
      {"name = \"\"\"a \\ \n  ö\"\"\"", "`surface` is missing"},
      {"name = 0o\"ö\"", "job.toml:1:"},
      {geometry + "surface = \"b.stl\"", "job.toml:3:"},
      {geometry + "[spacing]\ngrwoth = 1",
       "job.toml:4:1: unknown key `grwoth` in [spacing]; did you mean `growth`?"},
      {geometry + "[[layer]]\n", "job.toml:3:3: unknown key `layer`; did you mean `layers`?"},
      {geometry + "[spacng]\n", "job.toml:3:2: unknown key `spacng`; did you mean `spacing`?"},
      {geometry + "[spacing]\nbanana = 1", "unknown key `banana` in [spacing]"},
      {geometry + "[spacing]\ngrowth = 0", "job.toml:4:10: `growth` must be positive"},
      {geometry + "[spacing]\ngrowth = nan", "`growth` must be finite"},
      {geometry + "[spacing]\ngrowth = \"1\"", "`growth` must be a number, not a string"},
      {geometry + "[spacing]\ndefault = -1", "`default` must not be negative"},
      {geometry + "[spacing]\nsurface = \"inherits\"",
       "`surface` is \"inherits\", not one of \"inherit\", \"ignore\"; did you mean `inherit`?"},
      {geometry + "[domain]\nouter = \"cube\"", "not one of \"none\", \"box\", \"sphere\""},
      {geometry + "[domain]\nouter = \"box\"\nfactor = 1.0", "`factor` must be more than 1"},
      {geometry + "[domain]\nfactor = 3", "job.toml:4:10: `factor` needs `outer`"},
      {geometry + "[decompose]\nsubdomains = -1", "`subdomains` must be at least 0"},
      {geometry + "[decompose]\nsubdomains = 1000001", "`subdomains` must be at most 1000000"},
      {geometry + "[decompose.assimilate]\ngroups = 1000001", "`groups` must be at most 1000000"},
      {geometry + "[decompose]\nsubdomains = 2.5", "must be an integer, not a number"},
      {geometry + "[decompose]\ntarget_elements = 10", "at least 1000"},
      {geometry + "[decompose]\ntarget_elements = -1", "at least 0"},
      {geometry + "[spacing]\nmax_elements = -1", "`max_elements` must be at least 0"},
      {geometry + "[cosmetics]\nacross_cuts = 1", "`across_cuts` must be true or false, not"},
      {geometry + "[decompose]\nplane = \"axes\"",
       "`plane` is \"axes\", not one of \"auto\", \"lattice\", \"axis\", \"inertia\"; "
       "did you mean `axis`?"},
      {geometry + "[mesh]\npoints = \"sweep\"",
       "`points` is \"sweep\", not one of \"lattice\", \"sweeps\"; did you mean `sweeps`?"},
      {geometry + "[decompose]\nmax_memory = 2", "`max_memory` must be a string"},
      {geometry + "[decompose]\nmax_memory = \"2 GibiBytes\"", "must be an amount like"},
      {geometry + "[decompose]\nmax_memory = \"2GiB\"\nsubdomains = 4",
       "`subdomains` cannot be given together with `max_memory`"},
      {geometry + "[decompose]\nmax_memory = \"2GiB\"\nassimilate = { groups = 4 }",
       "`assimilate` cannot be given together with `max_memory`"},
      {geometry + "[decompose]\nassimilate = 8", "`assimilate` must be a table"},
      {geometry + "[decompose.assimilate]\nmethod = \"k-way\"", "`groups` is missing"},
      {geometry + "[decompose.assimilate]\ngroups = 0", "`groups` must be at least 1"},
      {geometry + "[decompose.assimilate]\ngroups = 2\nmethod = \"k_way\"", "did you mean `k-way`"},
      {geometry + "[decompose]\nsubdomains = 4\nassimilate = { groups = 5 }",
       "must not be more than `subdomains`"},
      {geometry + "[quality]\nmin_dihedral = 75", "must be less than 70.5"},
      {geometry + "[output]\nformats = []", "`formats` must name at least one format"},
      {geometry + "[output]\nformats = \"vtkhdf\"", "`formats` must be an array, not a string"},
      {geometry + "[output]\nformats = [\"vtkhdff\"]", "did you mean `vtkhdf`?"},
      {geometry + "[output]\nformats = [\"vtkhdf\", \"vtkhdf\"]", "job.toml:4:22: "},
      {"version = 2\n" + geometry, "job.toml:1:11: `version` must be 1"},
      {"name = \"\"\n" + geometry, "`name` must not be empty"},
      {"name = \"../wing\"\n" + geometry, "job.toml:1:8: `name` must be a plain name"},
      {"name = \"..\"\n" + geometry, "`name` must not be `.` or `..`"},
      {"name = \"wing\\u0000\"\n" + geometry, "`name` must not contain control characters"},
      {geometry + "[source]\nkind = \"point\"", "`source` must be written [[source]]"},
      {geometry + "[[source]]\nat = [0, 0, 0]", "job.toml:3:1: `kind` is missing in [source]"},
      {geometry + "[[source]]\nkind = \"pont\"", "did you mean `point`?"},
      {geometry + point, "`outer` is missing in [source]"},
      {geometry + point + "outer = 0.5", "job.toml:8:9: `outer` must not be less than `inner`"},
      {geometry + point + "outer = 2\nfrom = 1", "job.toml:9:1: unknown key `from` in [source]"},
      {geometry + "[[source]]\nkind = \"point\"\nat = [0, 0]", "`at` must have three coordinates"},
      {geometry + "[[source]]\nkind = \"point\"\nat = [0, 0, \"x\"]",
       "job.toml:5:13: `at` must be"},
      {geometry + "[[source]]\nkind = \"line\"\nfrom = 2", "`from` must be a table"},
      {geometry + "[[source]]\nkind = \"line\"", "`from` is missing in [source]"},
      {geometry + "[[source]]\nkind = \"triangle\"\ncorner = []", "must hold three tables"},
      {geometry + "[[source]]\nkind = \"triangle\"\ncorner = [1, 2, 3]", "must hold tables"},
  };
  for (const Mistake& mistake : mistakes) {
    EXPECT_THAT([&] { parse_job_file(mistake.text, "job.toml"); },
                ThrowsMessage<UsageError>(HasSubstr(mistake.message)))
        << mistake.text;
  }
}

TEST(ParseJobFile, quotes_of_a_long_word_whole_characters_only) {
  const std::string before(99, 'v');
  try {
    parse_job_file(geometry + "[domain]\nouter = \"" + before + "üvv\"\n", "/job/job.toml");
    FAIL() << "taken";
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("`outer` is \"" + before + "…\", not one of"));
  }
}

TEST(ParseJobFile, damaged_text_is_read_or_refused_but_never_crashes) {
  std::mt19937 random(7);
  for (int round = 0; round < 1000; ++round) {
    std::string text = everything;
    for (auto changes = 1 + random() % 3; changes > 0; --changes) {
      text[random() % text.size()] = static_cast<char>(random());
    }
    if (random() % 3 == 0) text.resize(random() % text.size());
    try {
      parse_job_file(text, "job.toml");
    } catch (const UsageError&) {
      continue;
    }
  }
}

TEST(JobFileDocument, has_every_key_that_the_parser_knows) {
  const std::string document = contents(project / "docs/job_file.md");
  for (const std::string& key : job_file_keys()) {
    EXPECT_THAT(document, HasSubstr("| `" + key + "` |"));
  }
}

TEST(JobFileDocument, and_the_examples_can_be_parsed) {
  const std::string document = contents(project / "docs/job_file.md");
  int blocks = 0;
  for (std::size_t at = 0; (at = document.find("```toml\n", at)) != document.npos; ++blocks) {
    at += 8;
    std::string block = document.substr(at, document.find("```", at) - at);
    if (block.find("[geometry]") == block.npos) block += geometry;
    EXPECT_NO_THROW(parse_job_file(block, "document.toml")) << block;
  }
  EXPECT_EQ(blocks, 14);
}

TEST(Examples, are_jobs_whose_surfaces_exist_or_can_be_made) {
  int jobs = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(project / "examples")) {
    if (entry.path().extension() != ".toml") continue;
    const std::string text = contents(entry.path());
    ++jobs;
    if (is_loop_job(text, entry.path())) {
      for (const std::string& file : parse_loop_job(text, entry.path()).solver.files) {
        EXPECT_TRUE(fs::exists(entry.path().parent_path() / file)) << file;
      }
      continue;
    }
    if (text.find("[[line]]") != text.npos) {
      EXPECT_FALSE(parse_plane_sources(text, entry.path()).sources.empty());
      continue;
    }
    const JobFile job = parse_job_file(text, entry.path());
    // Those that are too large to lie here say which command makes them.
    const std::string surface = fs::path(job.surface).filename();
    EXPECT_TRUE(fs::exists(job.surface) || text.find(" -o " + surface + "\n") != text.npos ||
                text.find(".gz " + surface + " --scale") != text.npos)
        << job.surface;
  }
  EXPECT_GE(jobs, 5);
}

TEST(ParseMemory, knows_decimal_and_binary_units) {
  EXPECT_EQ(parse_memory("2GiB"), std::int64_t{2} << 30);
  EXPECT_EQ(parse_memory("500MB"), 500'000'000);
  EXPECT_EQ(parse_memory("1.5 kib"), 1536);
  EXPECT_EQ(parse_memory("77"), 77);
  EXPECT_EQ(parse_memory("77B"), 77);
  for (const char* wrong :
       {"", "GB", "-1GB", "0", "1 GB ", "1  GB", "1GBit", "nan", "inf", "1e30", "8193TiB"}) {
    EXPECT_EQ(parse_memory(wrong), std::nullopt) << wrong;
  }
}

TEST(ToToml, keeps_a_limit_of_memory) {
  const JobFile job = parse_job_file(
      "geometry.surface = \"a.stl\"\ndecompose.max_memory = \"1.5GiB\"", "/x/a.toml");
  EXPECT_EQ(job.max_memory_bytes, 1'610'612'736);
  EXPECT_EQ(parse_job_file(to_toml(job), "/x/b.toml").max_memory_bytes, job.max_memory_bytes);
}

TEST(ToToml, says_which_files_are_kept_where_the_job_does) {
  const JobFile silent = parse_job_file("geometry.surface = \"a.stl\"", "/x/a.toml");
  EXPECT_TRUE(keeps_all_files(silent));
  EXPECT_EQ(to_toml(silent).find("keep"), std::string::npos);
  for (const std::string word : {"all", "needed"}) {
    const JobFile job =
        parse_job_file("geometry.surface = \"a.stl\"\noutput.keep = \"" + word + "\"", "/x/a.toml");
    EXPECT_EQ(keeps_all_files(job), word == "all");
    EXPECT_EQ(parse_job_file(to_toml(job), "/x/b.toml").keep, word);
  }
  EXPECT_THROW(parse_job_file("geometry.surface = \"a.stl\"\noutput.keep = \"none\"", "/x/a.toml"),
               UsageError);
}

TEST(JobFile, says_how_the_surface_is_remeshed) {
  EXPECT_FALSE(parse_job_file(geometry, "job.toml").remeshing.has_value());
  EXPECT_FALSE(parse_job_file(geometry + "[surface]\nremesh = false\n", "j.toml").remeshing);
  const JobFile plain = parse_job_file(geometry + "[surface]\nremesh = true\n", "job.toml");
  ASSERT_TRUE(plain.remeshing.has_value());
  EXPECT_EQ(plain.remeshing->size, 0) << "as the spacing says";
  EXPECT_EQ(plain.remeshing->angle, 30);
  const JobFile full = parse_job_file(geometry +
                                          "[surface]\nremesh = true\nsize = 0.5\n"
                                          "min_size = 0.125\nangle = 45\ntolerance = 1e-3\n",
                                      "job.toml");
  for (const JobFile& job : {full, parse_job_file(to_toml(full), "job.toml")}) {
    ASSERT_TRUE(job.remeshing.has_value());
    EXPECT_EQ(job.remeshing->size, 0.5);
    EXPECT_EQ(job.remeshing->min_size, 0.125);
    EXPECT_EQ(job.remeshing->angle, 45);
    EXPECT_EQ(job.remeshing->tolerance, 1e-3);
  }
}

TEST(JobFile, refuses_remeshing_that_cannot_be_meant) {
  const auto refusal = [](const std::string& keys) {
    return error_text_of<UsageError>(
        [&] { parse_job_file(geometry + "[surface]\n" + keys, "job.toml"); });
  };
  EXPECT_THAT(refusal("size = 1\n"), HasSubstr("job.toml:4:8: `size` needs `remesh` = true"));
  EXPECT_THAT(refusal("remesh = false\nangle = 1\n"), HasSubstr("`angle` needs `remesh`"));
  EXPECT_THAT(refusal("remesh = true\nsize = 0\n"), HasSubstr("`size`"));
  EXPECT_THAT(refusal("remesh = true\nangle = 180\n"), HasSubstr("less than 180"));
  EXPECT_THAT(refusal("remesh = true\nsize = 1\nmin_size = 2\n"),
              HasSubstr("must not be more than `size`"));
  EXPECT_THAT(refusal("remesh = 1\n"), HasSubstr("`remesh`"));
  EXPECT_THAT(refusal("remsh = true\n"), HasSubstr("did you mean"));
}

/// Of a job with this after its geometry.
JobFile job_with_spacing(const std::string& spacing) {
  return parse_job_file(geometry + "[spacing]\n" + spacing + "\n", "j.toml");
}

std::string refusal_of_spacing(const std::string& spacing) {
  try {
    job_with_spacing(spacing);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "it was taken";
}

TEST(JobFile, has_a_size_by_the_wavelength_of_light_in_metres) {
  for (const std::string frequency : {"1e9", "1_000_000_000", "\"1GHz\"", "\"1000 MHz\""}) {
    const JobFile job = job_with_spacing("frequency = " + frequency);
    EXPECT_DOUBLE_EQ(job.spacing_default, 0.0299792458) << frequency;
  }
}

TEST(JobFile, has_a_size_by_any_wave_speed_and_share) {
  const JobFile job =
      job_with_spacing("frequency = \"2kHz\"\nwave_speed = 340\nper_wavelength = 17");
  EXPECT_DOUBLE_EQ(job.spacing_default, 0.01);
}

TEST(JobFile, with_a_frequency_is_the_same_as_with_that_size) {
  const JobFile by_wave = job_with_spacing("frequency = 3\nwave_speed = 6");
  EXPECT_EQ(to_toml(by_wave), to_toml(job_with_spacing("default = 0.2")));
}

TEST(JobFile, says_what_is_wrong_with_a_frequency) {
  EXPECT_EQ(refusal_of_spacing("default = 1\nfrequency = 1"),
            "j.toml:5:13: `frequency` cannot be given together with `default`: each says how long "
            "edges may be");
  EXPECT_EQ(refusal_of_spacing("wave_speed = 1"), "j.toml:4:14: `wave_speed` needs `frequency`");
  EXPECT_EQ(refusal_of_spacing("per_wavelength = 1"),
            "j.toml:4:18: `per_wavelength` needs `frequency`");
  EXPECT_EQ(refusal_of_spacing("frequency = \"1ghz\""),
            "j.toml:4:13: `frequency` must be a frequency such as 1.2GHz, 300MHz or 20000");
  EXPECT_EQ(refusal_of_spacing("frequency = -1"), "j.toml:4:13: `frequency` must be positive");
  EXPECT_THAT(refusal_of_spacing("frequency = true"), HasSubstr("must be a number"));
  EXPECT_EQ(refusal_of_spacing("frequency = 1\nwave_speed = 0"),
            "j.toml:5:14: `wave_speed` must be positive");
  EXPECT_THAT(refusal_of_spacing("frequency = 1e-300\nwave_speed = 1e300"),
              HasSubstr("`frequency` gives no edge length"));
  EXPECT_EQ(refusal_of_spacing("default = 0\nfrequency = 1"), "it was taken");
}

}  // namespace
}  // namespace tetfarm
