#include "cli/job_input.h"

#include <gmock/gmock.h>

#include "base/error_with_help.h"
#include "base/file_system.h"
#include "mesh/job_file/toml_limits.h"
#include "tests/base/temp_folder.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A closed tetrahedron, as OFF.
constexpr const char* tet_off =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

RunOptions of_surface(const std::string& path) {
  RunOptions options;
  options.input = path;
  return options;
}

std::string refusal(const RunOptions& options) {
  try {
    describe_job(options);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::usage);
    return error.what();
  }
}

class JobOfAFile : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    write_file_atomically(folder_.path() / name, text);
    return (folder_.path() / name).string();
  }
  TempFolder folder_;
};

TEST(JobInput, of_a_surface_is_named_like_it_without_folder_and_endings) {
  for (const char* path : {"in/wing.stl", "in/wing.stl.gz"}) {
    const JobInput input = describe_job(of_surface(path));
    EXPECT_EQ(input.job.name, "wing");
    EXPECT_EQ(input.job.surface, "wing.stl") << "without the folder, and unpacked";
    EXPECT_EQ(input.path, path);
    EXPECT_EQ(input.surface, "");
  }
  EXPECT_EQ(describe_job(of_surface("a.b.off")).job.name, "a.b");
}

TEST(JobInput, without_options_has_the_defaults_of_a_job_file) {
  JobFile expected;
  expected.name = "wing";
  expected.surface = "wing.stl";
  EXPECT_EQ(to_toml(describe_job(of_surface("wing.stl")).job), to_toml(expected));
}

TEST(JobInput, takes_each_option_of_a_job) {
  RunOptions options = of_surface("wing.stl");
  options.subdomains = 8;
  options.groups = 4;
  options.size = 0.5;
  options.growth = 0.2;
  options.outer = "box:2.5";
  options.outer_size = 0.25;
  options.max_elements = 7;
  options.formats = {"su2", "vtkhdf"};
  options.keep = "needed";
  options.layers = {"wing_*:first=1e-4", "tip:first=2e-4,count=7"};
  const JobFile job = describe_job(options).job;
  ASSERT_EQ(job.layers.size(), 2U);
  EXPECT_THAT(job.layers[0].patches, ElementsAre("wing_*"));
  EXPECT_EQ(job.layers[1].count, 7);
  EXPECT_EQ(job.subdomains, 8);
  EXPECT_EQ(job.groups, 4);
  EXPECT_EQ(job.spacing_default, 0.5);
  EXPECT_EQ(job.growth, 0.2);
  EXPECT_EQ(job.outer_kind, "box");
  EXPECT_EQ(job.outer_factor, 2.5);
  EXPECT_EQ(job.outer_spacing, 0.25);
  EXPECT_EQ(job.max_elements, 7);
  EXPECT_THAT(job.formats, ElementsAre("su2", "vtkhdf"));
  EXPECT_EQ(job.keep, "needed");
  options.force = true;
  EXPECT_EQ(describe_job(options).job.max_elements, 0);
}

TEST(JobInput, has_types_and_sizes_of_patches_in_one_table_each) {
  RunOptions options = of_surface("wing.stl");
  options.patch_types = {"aft,mid=wall"};
  options.patch_sizes = {"mid=0.1:0.2", "tip=0.3"};
  const JobFile job = describe_job(options).job;
  ASSERT_EQ(job.patches.size(), 3U);
  EXPECT_EQ(job.patches[1].type, "wall");
  EXPECT_EQ(job.patches[1].size, 0.1);
  EXPECT_EQ(job.patches[1].growth, 0.2);
  EXPECT_EQ(job.patches[2].type, "");
  EXPECT_EQ(to_toml(parse_job_file(to_toml(job), "a.toml")), to_toml(job));
  options.patch_sizes = {"tip=0"};
  EXPECT_THAT(refusal(options), HasSubstr("--patch-size 'tip=0': \"0\" is no size"));
}

TEST(JobInput, is_in_the_unit_that_the_command_line_says) {
  RunOptions options = of_surface("wing.stl");
  EXPECT_EQ(describe_job(options).job.scale, 1);
  options.unit = "mm";
  EXPECT_EQ(describe_job(options).job.scale, 0.001);
  EXPECT_EQ(describe_job(options).job.unit, "mm");
  options.unit = "mn";
  EXPECT_EQ(refusal(options), "--unit: \"mn\" is no unit of length");
}

TEST_F(JobOfAFile, is_in_its_own_unit_unless_another_is_typed) {
  RunOptions options = of_surface(write("job.toml",
                                        "[geometry]\nsurface = \"tet.off\"\nunit = \"mm\"\n"
                                        "[patch.surface]\nsize = 2\n"));
  EXPECT_EQ(describe_job(options).job.unit, "mm");
  options.scale = 2;
  EXPECT_EQ(describe_job(options).job.unit, "");
  EXPECT_EQ(describe_job(options).job.scale, 2);
  options.scale.reset();
  options.unit = "ft";
  EXPECT_EQ(describe_job(options).job.scale, 0.3048);
  EXPECT_EQ(describe_job(options).job.patches.at(0).size, 2);
}

TEST_F(JobOfAFile, is_judged_in_the_lengths_of_the_job) {
  RunOptions options = of_surface(write("tet.off", tet_off));
  options.unit = "mm";
  options.patch_sizes = {"surface=1e-4"};
  options.layers = {"surface:first=1e-5,count=2"};
  require_readable(read_job(options));
  options.unit.clear();
  options.layers = {"surface:first=2,count=2"};
  EXPECT_THROW(require_readable(read_job(options)), UsageError);
  options.scale = 100;
  require_readable(read_job(options));
}

TEST(JobInput, an_outer_boundary_has_a_factor_of_its_kind_unless_one_is_given) {
  const auto outer = [](const char* text) {
    RunOptions options = of_surface("wing.stl");
    options.outer = text;
    const JobFile job = describe_job(options).job;
    return std::pair(job.outer_kind, job.outer_factor);
  };
  EXPECT_EQ(outer("none"), std::pair(std::string("none"), 0.0));
  EXPECT_EQ(outer("box"), std::pair(std::string("box"), 3.0));
  EXPECT_EQ(outer("sphere"), std::pair(std::string("sphere"), 5.0));
  EXPECT_EQ(outer("sphere:1.5"), std::pair(std::string("sphere"), 1.5));
}

TEST(JobInput, says_what_is_wrong_with_an_option) {
  const auto with = [](const auto& change) {
    RunOptions options = of_surface("wing.stl");
    change(options);
    return refusal(options);
  };
  const auto outer = [&](const char* text) {
    return with([text](RunOptions& options) { options.outer = text; });
  };
  for (const char* text : {"cube", "", "none:2", "boxes"}) {
    EXPECT_EQ(outer(text),
              "--outer: \"" + std::string(text) + "\" is not box[:FACTOR] or sphere[:FACTOR]");
  }
  for (const char* text : {"box:", "box:x", "box:1", "box:0.5", "box:2x", "box:nan", "box:inf"}) {
    EXPECT_EQ(outer(text),
              "--outer: the factor in \"" + std::string(text) + "\" must be a number above 1");
  }
  EXPECT_EQ(with([](RunOptions& options) { options.outer_size = 0.5; }),
            "--outer-size: there is no outer boundary; also give --outer box or --outer sphere");
  EXPECT_EQ(with([](RunOptions& options) { options.max_memory = "lots"; }),
            "--max-memory: \"lots\" is not an amount such as 2GiB or 500MB");
  EXPECT_EQ(with([](RunOptions& options) {
              options.subdomains = 3;
              options.groups = 4;
            }),
            "--groups: must not be more than the number of sub-domains");
  EXPECT_EQ(with([](RunOptions& options) {
              options.subdomains = 4;
              options.groups = 4;
            }),
            "");
  EXPECT_EQ(with([](RunOptions& options) { options.groups = 4; }), "") << "as many as come";
  EXPECT_EQ(with([](RunOptions& options) { options.layers = {"wing:frist=1"}; }),
            "--layers 'wing:frist=1': unknown key `frist`; did you mean `first`?");
  EXPECT_EQ(with([](RunOptions& options) { options.formats = {"su3"}; }),
            "--format su3: unknown format; did you mean `su2`?");
  EXPECT_THAT(refusal(of_surface("wing.xyz")), HasSubstr("unsupported file type `.xyz`"));
}

TEST_F(JobOfAFile, a_folder_is_no_surface) {
  const std::string folder = folder_.path().string();
  EXPECT_EQ(refusal(of_surface(folder)), folder + ": is a folder, not a surface or a job file");
}

TEST_F(JobOfAFile, options_win_over_it) {
  RunOptions options = of_surface(
      write("job.toml",
            "name = \"mine\"\n[geometry]\nsurface = \"in/wing.off\"\n[spacing]\ndefault = 0.5\n"
            "growth = 0.1\n[decompose]\nmax_memory = \"2GiB\"\n[output]\nformats = [\"su2\"]\n"
            "keep = \"needed\"\n"));
  const JobInput plain = describe_job(options);
  EXPECT_EQ(plain.job.name, "mine");
  EXPECT_EQ(plain.job.surface, "wing.off");
  EXPECT_EQ(plain.path, (folder_.path() / "in" / "wing.off").string());
  EXPECT_EQ(plain.job.spacing_default, 0.5);
  EXPECT_EQ(plain.job.growth, 0.1);
  EXPECT_EQ(plain.job.max_memory_bytes, std::int64_t{2} << 30);
  EXPECT_THAT(plain.job.formats, ElementsAre("su2"));
  EXPECT_EQ(plain.job.keep, "needed");
  options.size = 0.25;
  options.formats = {"vtkhdf"};
  options.keep = "all";
  options.subdomains = 5;
  const JobFile changed = describe_job(options).job;
  EXPECT_EQ(changed.spacing_default, 0.25);
  EXPECT_EQ(changed.growth, 0.1);
  EXPECT_EQ(changed.subdomains, 5);
  EXPECT_EQ(changed.max_memory_bytes, 0) << "the number is asked for instead";
  EXPECT_THAT(changed.formats, ElementsAre("vtkhdf"));
  EXPECT_EQ(changed.keep, "all");
  RunOptions groups = of_surface(options.input);
  groups.groups = 2;
  EXPECT_EQ(describe_job(groups).job.max_memory_bytes, 0);
}

TEST_F(JobOfAFile, has_its_own_layers_unless_the_command_line_has_others) {
  RunOptions options =
      of_surface(write("job.toml",
                       "[geometry]\nsurface = \"wing.off\"\n[[layers]]\npatches = [\"a\"]\n"
                       "first_height = 1\n[[layers]]\npatches = [\"b\"]\nfirst_height = 2\n"));
  EXPECT_EQ(describe_job(options).job.layers.size(), 2U);
  options.layers = {"c:first=3"};
  const JobFile changed = describe_job(options).job;
  ASSERT_EQ(changed.layers.size(), 1U);
  EXPECT_EQ(changed.layers[0].first_height, 3);
}

TEST_F(JobOfAFile, of_layers_that_its_surface_has_no_place_for_is_refused_as_typed) {
  const auto refusals = [this](const std::string& layers) {
    RunOptions options = of_surface(write("tet.off", tet_off));
    options.layers = {layers};
    const JobInput input = read_job(options);
    const std::string said = error_text_of<UsageError>([&] { require_readable(input); });
    EXPECT_EQ(error_text_of<UsageError>([&] { require_meshable(input); }), said);
    return said;
  };
  EXPECT_EQ(refusals("*:first=0.1"), "");
  EXPECT_THAT(refusals("wing:first=0.1"),
              HasSubstr("--layers 'wing:first=0.1': \"wing\" matches no patch"));
  EXPECT_THAT(refusals("*:first=9"), HasSubstr("the first layer would be 9 high"));
  EXPECT_THAT(refusals("outer_box:first=0.1"), HasSubstr("matches no patch"));
  RunOptions outside = of_surface((folder_.path() / "tet.off").string());
  outside.outer = "box";
  outside.layers = {"outer_box:first=0.1"};
  EXPECT_NO_THROW(require_readable(read_job(outside)));
}

TEST_F(JobOfAFile, an_amount_of_memory_takes_the_place_of_numbers) {
  RunOptions options =
      of_surface(write("job.toml",
                       "[geometry]\nsurface = \"wing.off\"\n[decompose]\nsubdomains = 8\n"
                       "[decompose.assimilate]\ngroups = 4\n"));
  EXPECT_EQ(describe_job(options).job.subdomains, 8);
  EXPECT_EQ(describe_job(options).job.groups, 4);
  options.max_memory = "500MB";
  const JobFile job = describe_job(options).job;
  EXPECT_EQ(job.max_memory_bytes, 500'000'000);
  EXPECT_EQ(job.subdomains, 0);
  EXPECT_EQ(job.groups, 0);
}

TEST_F(JobOfAFile, carries_the_sources_of_another_file) {
  write("s.ba3", "t\n0 0 1 0 0\n*\n1\n0.5 0.5 0.5 0.05 0.2 0.4\n");
  const std::string text = "[geometry]\nsurface = \"wing.off\"\n[spacing]\nsources = \"s.ba3\"\n";
  const std::string own =
      "[[source]]\nkind = \"point\"\nat = [1, 2, 3]\nspacing = 0.1\n"
      "inner = 0.5\nouter = 1\n";
  const JobFile job = describe_job(of_surface(write("job.toml", text))).job;
  EXPECT_EQ(job.sources_file, "");
  ASSERT_EQ(job.sources.size(), 1U);
  EXPECT_EQ(job.sources[0].corners.at(0).spacing, 0.05);
  const JobFile both = describe_job(of_surface(write("both.toml", text + own))).job;
  ASSERT_EQ(both.sources.size(), 2U);
  EXPECT_EQ(both.sources[0].corners.at(0).spacing, 0.1) << "its own come first";
}

TEST_F(JobOfAFile, has_the_bytes_of_its_surface_unpacked_when_it_is_read) {
  const JobInput input = read_job(of_surface(write("tet.off", tet_off)));
  EXPECT_EQ(input.surface, tet_off);
  EXPECT_THROW(read_job(of_surface((folder_.path() / "none.off").string())), IoError);
}

TEST_F(JobOfAFile, of_a_surface_that_is_open_or_unreadable_is_refused_by_the_path_as_typed) {
  JobInput input = read_job(of_surface(write("tet.off", tet_off)));
  require_readable(input);
  require_meshable(input);
  input.path = "in/tet.off";
  input.surface = "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n";
  require_readable(input);
  try {
    require_meshable(input);
    FAIL() << "took an open surface";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_geometry);
    EXPECT_THAT(error.what(), HasSubstr("in/tet.off: the surface cannot be meshed"));
  }
  input.surface = "OFF\n1 zero";
  EXPECT_THROW(require_readable(input), InvalidInput);
}

TEST(JobInput, is_submitted_only_with_a_name_that_a_job_may_have) {
  JobInput input = describe_job(of_surface("wing.off"));
  EXPECT_NO_THROW(check_submittable(input));
  input.job.name = "a\nb";
  try {
    check_submittable(input);
    FAIL() << "took a name of two lines";
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(),
                 "wing.off: the job takes its name from this file, and a job's name must not "
                 "contain control characters; rename the file, or give a job file with a `name`");
  }
}

TEST(JobInput, is_submitted_only_when_its_sources_fit_into_a_job_file) {
  JobInput input = describe_job(of_surface("wing.off"));
  JobSource source;
  source.corners.push_back({{0.125, 0.25, 0.5}, 0.125, 0.25, 0.5});
  input.job.sources.assign(20'000, source);
  const std::size_t size = to_toml(input.job).size();
  ASSERT_GT(size, largest_job_file);
  try {
    check_submittable(input);
    FAIL() << "took too large a job";
  } catch (const UsageError& error) {
    EXPECT_EQ(std::string(error.what()),
              "wing.off: the job with its sources has " + std::to_string(size) +
                  " bytes, more than the 1048576 allowed: use fewer sources");
  }
}

TEST(JobInput, has_a_key_of_its_job_file_and_the_bytes_of_its_surface_not_of_its_path) {
  JobInput input = describe_job(of_surface("in/wing.off"));
  input.surface = tet_off;
  const std::string key = key_of(input);
  JobInput elsewhere = describe_job(of_surface("out/wing.off"));
  elsewhere.surface = tet_off;
  EXPECT_EQ(key_of(elsewhere), key);
  elsewhere.surface += "\n";
  EXPECT_NE(key_of(elsewhere), key);
  input.job.growth = 0.25;
  EXPECT_NE(key_of(input), key);
}

TEST_F(JobOfAFile, has_the_background_of_its_sources_unless_it_has_its_own) {
  write("s.ba3",
        "t\n1 0 1 0 0\n1 0 0 0\n1 0 0 0.7\n0 1 0 0.7\n0 0 1 0.7\n* points\n1\n"
        "0.5 0.5 0.5 0.05 0.2 0.4\n");
  const std::string text = "[geometry]\nsurface = \"wing.off\"\n[spacing]\nsources = \"s.ba3\"\n";
  EXPECT_EQ(describe_job(of_surface(write("job.toml", text))).job.spacing_default, 0.7);
  EXPECT_EQ(
      describe_job(of_surface(write("own.toml", text + "default = 0.3\n"))).job.spacing_default,
      0.3);
}

TEST(JobInput, a_surface_is_remeshed_where_the_command_line_asks_for_it) {
  RunOptions options = of_surface("wing.stl");
  EXPECT_FALSE(describe_job(options).job.remeshing.has_value());
  options.size_on_body = 0.25;
  EXPECT_THAT(refusal(options), HasSubstr("--size-on-body: "));
  EXPECT_THAT(refusal(options), HasSubstr("also give --remesh"));
  options.remesh = true;
  const JobFile job = describe_job(options).job;
  ASSERT_TRUE(job.remeshing.has_value());
  EXPECT_EQ(job.remeshing->size, 0.25);
  EXPECT_EQ(job.spacing_default, 0) << "the volume's own size is another";
}

TEST_F(JobOfAFile, keeps_its_own_words_of_remeshing_but_for_those_typed) {
  RunOptions options = of_surface(write(
      "job.toml", "[geometry]\nsurface = \"tet.off\"\n[surface]\nremesh = true\nmin_size = 0.5\n"));
  options.size_on_body = 1;
  const JobFile job = describe_job(options).job;
  EXPECT_EQ(job.remeshing->size, 1);
  EXPECT_EQ(job.remeshing->min_size, 0.5);
  options.size_on_body = 0.25;
  EXPECT_THAT(refusal(options), HasSubstr("[surface] min_size: must not be more than"));
}

RunOptions with_frequency(const std::string& input, const std::string& frequency) {
  RunOptions options = of_surface(input);
  options.wave.frequency = frequency;
  return options;
}

TEST(JobInput, with_a_frequency_is_the_job_with_the_equal_size) {
  RunOptions by_wave = with_frequency("wing.stl", "1.5GHz");
  by_wave.wave.per_wavelength = 20;
  RunOptions by_size = of_surface("wing.stl");
  by_size.size = 299792458 / 1.5e9 / 20;
  EXPECT_EQ(key_of(describe_job(by_wave)), key_of(describe_job(by_size)));
  EXPECT_NE(key_of(describe_job(by_wave)), key_of(describe_job(of_surface("wing.stl"))));
}

TEST(JobInput, takes_a_wave_speed_and_a_share_with_a_frequency_only) {
  RunOptions options = with_frequency("wing.stl", "2kHz");
  options.wave.speed = 340;
  options.wave.per_wavelength = 17;
  EXPECT_DOUBLE_EQ(describe_job(options).job.spacing_default, 0.01);
  options.wave.frequency = "";
  EXPECT_EQ(refusal(options), "--wave-speed: there is no frequency; also give --frequency");
  options.wave.speed.reset();
  EXPECT_EQ(refusal(options), "--per-wavelength: there is no frequency; also give --frequency");
}

TEST_F(JobOfAFile, has_its_own_frequency_but_for_the_words_typed) {
  const std::string file = write("job.toml",
                                 "[geometry]\nsurface = \"wing.stl\"\n[spacing]\n"
                                 "frequency = 2\nwave_speed = 40\nper_wavelength = 5\n");
  RunOptions options = of_surface(file);
  EXPECT_DOUBLE_EQ(describe_job(options).job.spacing_default, 4);
  options.wave.per_wavelength = 10;
  EXPECT_DOUBLE_EQ(describe_job(options).job.spacing_default, 2);
  options.wave.frequency = "4";
  EXPECT_DOUBLE_EQ(describe_job(options).job.spacing_default, 1);
  options.wave = {};
  options.size = 7;
  EXPECT_EQ(describe_job(options).job.spacing_default, 7);
  EXPECT_FALSE(describe_job(options).job.wave.has_value()) << "that counts no longer";
}

TEST_F(JobOfAFile, with_a_size_of_its_own_gives_way_to_a_frequency_that_is_typed) {
  const std::string file =
      write("job.toml", "[geometry]\nsurface = \"wing.stl\"\n[spacing]\ndefault = 7\n");
  EXPECT_DOUBLE_EQ(describe_job(with_frequency(file, "299792458")).job.spacing_default, 0.1);
}

TEST(JobInput, no_other_size_is_above_what_a_frequency_allows) {
  RunOptions options = with_frequency("wing.stl", "299792458");  // 0.1
  options.outer = "box";
  options.outer_size = 0.1;
  EXPECT_EQ(refusal(options), "");
  options.outer_size = 0.11;
  EXPECT_EQ(refusal(options),
            "--outer-size ([domain] spacing): an edge length of 0.11 is more than --frequency "
            "([spacing] frequency) allows, 0.1 (10 to a wavelength of 1); leave it out, or give "
            "--size instead");
  options.outer_size.reset();
  options.remesh = true;
  options.size_on_body = 0.2;
  EXPECT_THAT(refusal(options),
              HasSubstr("--size-on-body ([surface] size): an edge length of 0.2 is more"));
  options.size_on_body = 0.05;
  EXPECT_EQ(refusal(options), "");
}

TEST(JobInput, a_frequency_must_give_a_size) {
  RunOptions options = with_frequency("wing.stl", "1GHz");
  options.wave.speed = 1e-310;
  options.wave.per_wavelength = 1e300;
  EXPECT_THAT(refusal(options), HasSubstr("--frequency: gives no edge length"));
}

}  // namespace
}  // namespace tetfarm
