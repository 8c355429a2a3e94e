#include "mesh/job_file/job_layers.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string before = "[geometry]\nsurface = \"a.stl\"\n[[layers]]\n";  // three lines

JobLayers layers_of(const std::string& keys) {
  const JobFile job = parse_job_file(before + keys, "job.toml");
  EXPECT_EQ(job.layers.size(), 1U);
  return job.layers.at(0);
}

std::string refusal(const std::string& keys) {
  return error_text_of<UsageError>([&] { parse_job_file(before + keys, "job.toml"); });
}

std::string refusal_of_option(const std::string& typed) {
  return error_text_of<UsageError>([&] { parse_layers_option(typed); });
}

const std::string of_wing = "patches = [\"wing\"]\n";  // line 4

JobPml pml_of(const std::string& keys) {
  const JobFile job =
      parse_job_file("[geometry]\nsurface = \"a.stl\"\n[[pml]]\n" + keys, "job.toml");
  return job.pml.value();
}

std::string refusal_of_pml(const std::string& keys) {
  return error_text_of<UsageError>([&] { pml_of(keys); });
}

TEST(JobPml, has_defaults_for_all_but_patches) {
  const JobPml pml = pml_of("patches = [\"far\"]");
  EXPECT_THAT(pml.patches, ElementsAre("far"));
  EXPECT_EQ(pml.layers, 10);
  EXPECT_EQ(pml.height, 0) << "the median edge";
  EXPECT_EQ(pml.elements, "tets");
  EXPECT_EQ(pml.side, "outside");
}

TEST(JobPml, takes_every_key_and_is_the_same_in_canonical_text) {
  const JobPml pml = pml_of(
      "patches = [\"far_*\", \"lid\"]\nlayers = 7\nheight = 0.25\ncorners = \"mitre\"\n"
      "elements = \"prisms\"\nside = \"inside\"");
  EXPECT_EQ(pml.side, "inside");
  EXPECT_EQ(pml.layers, 7);
  EXPECT_EQ(pml.height, 0.25);
  EXPECT_EQ(pml.elements, "prisms");
  JobFile job;
  job.name = "a";
  job.surface = "/a.stl";
  const JobPml blocks = pml_of("patches = [\"far\"]\ncorners = \"block\"");
  EXPECT_EQ(blocks.corners, "block");
  EXPECT_EQ(pml.corners, "mitre");
  for (const JobPml& one : {pml, pml_of("patches = [\"far\"]\nheight = \"spacing\""), blocks}) {
    job.pml = one;
    const JobFile again = parse_job_file(to_toml(job), "/job.toml");
    EXPECT_EQ(again.pml->patches, one.patches);
    EXPECT_EQ(again.pml->layers, one.layers);
    EXPECT_EQ(again.pml->height, one.height);
    EXPECT_EQ(again.pml->elements, one.elements);
    EXPECT_EQ(again.pml->side, one.side);
    EXPECT_EQ(again.pml->corners, one.corners);
  }
}

TEST(JobPml, refuses_what_it_cannot_be) {
  EXPECT_THAT(refusal_of_pml("layers = 3"), HasSubstr("patches"));
  const std::string far = "patches = [\"far\"]\n";
  EXPECT_THAT(refusal_of_pml(far + "layers = 0"), HasSubstr("layers"));
  EXPECT_THAT(refusal_of_pml(far + "height = 0"), HasSubstr("height"));
  EXPECT_THAT(refusal_of_pml(far + "height = \"edge\""), HasSubstr("spacing"));
  EXPECT_THAT(refusal_of_pml(far + "corners = \"blocks\""), HasSubstr("\"mitre\", \"block\""));
  const std::string blocks = far + "corners = \"block\"\n";
  EXPECT_THAT(refusal_of_pml(blocks + "elements = \"prisms\""), HasSubstr("leave it out"));
  EXPECT_THAT(refusal_of_pml(blocks + "side = \"inside\""), HasSubstr("corners = \"mitre\""));
  EXPECT_THAT(refusal_of_pml(far + "elements = \"hexes\""), HasSubstr("prisms"));
  EXPECT_THAT(refusal_of_pml(far + "side = \"within\""), HasSubstr("inside"));
  EXPECT_THAT(refusal_of_pml(far + "first_height = 1"), HasSubstr("first_height"));
  EXPECT_THAT(refusal_of_pml(far + "[[pml]]\n" + far), HasSubstr("one block"));
}

TEST(JobPml, is_said_in_one_word_on_the_command_line) {
  const JobPml pml = parse_pml_option("far_*,lid:layers=7,height=0.25,elements=prisms");
  EXPECT_THAT(pml.patches, ElementsAre("far_*", "lid"));
  EXPECT_EQ(pml.layers, 7);
  EXPECT_EQ(pml.height, 0.25);
  EXPECT_EQ(pml.elements, "prisms");
  EXPECT_THAT(parse_pml_option("far").patches, ElementsAre("far"));
  EXPECT_EQ(parse_pml_option("far:height=spacing").height, 0);
  EXPECT_THAT(error_text_of<UsageError>([] { parse_pml_option("far:layer=7"); }),
              HasSubstr("--pml 'far:layer=7'"));
}

TEST(JobLayers, have_defaults_for_all_but_patches_and_first_height) {
  const JobLayers layers = layers_of(of_wing + "first_height = 1e-4");
  EXPECT_THAT(layers.patches, ElementsAre("wing"));
  EXPECT_EQ(layers.first_height, 1e-4);
  EXPECT_EQ(layers.y_plus + layers.reynolds + layers.length, 0);
  EXPECT_EQ(layers.growth, 1.2);
  EXPECT_EQ(layers.growth_cap, 0);
  EXPECT_EQ(layers.acceleration, 1);
  EXPECT_EQ(layers.count, 0) << "until they are isotropic";
  EXPECT_EQ(layers.total_height, 0);
  EXPECT_EQ(layers.equal, 1);
  EXPECT_EQ(layers.room, "ratio");
  EXPECT_EQ(layers.elements, "prisms");
  EXPECT_EQ(layers.typed, "");
}

TEST(JobLayers, take_every_key) {
  const JobLayers counted = layers_of(
      "patches = [\"wing_*\", \"t?p\"]\nfirst_height = 2\ngrowth = 1.25\ncount = 20\nequal = 3\n"
      "growth_cap = 1.5\nacceleration = 1.05\nroom = \"stop\"\nstep = 5\n"
      "fan_angle = 45\nelements = \"tets\"");
  EXPECT_THAT(counted.patches, ElementsAre("wing_*", "t?p"));
  EXPECT_EQ(counted.first_height, 2);
  EXPECT_EQ(counted.growth, 1.25);
  EXPECT_EQ(counted.count, 20);
  EXPECT_EQ(counted.equal, 3);
  EXPECT_EQ(counted.growth_cap, 1.5);
  EXPECT_EQ(counted.acceleration, 1.05);
  EXPECT_EQ(counted.room, "stop");
  EXPECT_EQ(counted.step, 5);
  EXPECT_EQ(counted.fan_angle, 45);
  EXPECT_EQ(counted.elements, "tets");
  const JobLayers by_y_plus = layers_of(
      of_wing + "y_plus = 1\nreynolds = 6e6\nlength = 2.5\ntotal_height = 0.1\nroom = \"scale\"");
  EXPECT_EQ(by_y_plus.first_height, 0);
  EXPECT_EQ(by_y_plus.y_plus, 1);
  EXPECT_EQ(by_y_plus.reynolds, 6e6);
  EXPECT_EQ(by_y_plus.length, 2.5);
  EXPECT_EQ(by_y_plus.total_height, 0.1);
  EXPECT_EQ(by_y_plus.room, "scale");
  EXPECT_EQ(layers_of(of_wing + "first_height = 1\ncount = \"isotropic\"").count, 0);
  EXPECT_EQ(layers_of(of_wing + "first_height = 1\ncount = 1000\nequal = 1000").equal, 1000);
  EXPECT_EQ(layers_of(of_wing + "first_height = 1\ngrowth = 1\ncount = 5").growth, 1);
}

TEST(JobLayers, may_list_the_height_of_each) {
  const JobLayers layers = layers_of(
      of_wing + "heights = [1e-4, 2e-4, 1e-4]\nroom = \"stop\"\nstep = 2\nfan_angle = 40");
  EXPECT_THAT(layers.heights, ElementsAre(1e-4, 2e-4, 1e-4));
  EXPECT_EQ(layers.first_height, 1e-4);
  EXPECT_EQ(layers.count, 3);
  EXPECT_EQ(layers.room, "stop");
  EXPECT_THAT(layers_of(of_wing + "heights = [1, 2, 3.5]").heights, ElementsAre(1, 2, 3.5));
  const auto of_length = [](std::size_t count) {
    std::string text = of_wing + "heights = [1";
    for (std::size_t i = 1; i < count; ++i) text += ", 1";
    return text + "]";
  };
  EXPECT_EQ(layers_of(of_length(1000)).count, 1000);
  EXPECT_THAT(refusal(of_length(1001)), HasSubstr("`heights` may have at most 1000 heights"));
}

TEST(JobLayers, of_several_tables_keep_their_order) {
  const JobFile job = parse_job_file(
      before + of_wing + "first_height = 1\n[[layers]]\npatches = [\"tip\"]\nfirst_height = 2\n",
      "job.toml");
  ASSERT_EQ(job.layers.size(), 2U);
  EXPECT_EQ(job.layers[0].first_height, 1);
  EXPECT_EQ(job.layers[1].first_height, 2);
}

struct LayersMistake {
  std::string keys;
  std::string message;
};

TEST(JobLayers, say_where_and_what_is_wrong) {
  const std::string first = of_wing + "first_height = 1\n";  // lines 4 and 5
  const std::string by_y_plus = of_wing + "y_plus = 1\nreynolds = 6e6\nlength = 1\n";
  const std::vector<LayersMistake> mistakes = {
      {"", "job.toml:3:1: `patches` is missing in [layers]"},
      {"patches = \"wing\"", "job.toml:4:11: `patches` must be an array, not a string"},
      {"patches = []", "`patches` must name at least one patch; \"*\" is all of them"},
      {"patches = [3]", "job.toml:4:12: `patches` must hold strings"},
      {"patches = [\"a\", \"\"]", "job.toml:4:17: `patches` must not hold an empty name"},
      {"patches = [\"a\", \"a\"]", "job.toml:4:17: `patches` has \"a\" twice"},
      {"patches = [\"" + std::string(256, 'a') + "\"]", "may hold names of at most 255 bytes"},
      {of_wing,
       "job.toml:3:1: `first_height` is missing; give it, or `y_plus` with `reynolds` and "
       "`length`, or `heights`"},
      {first + "grwoth = 1.1",
       "job.toml:6:1: unknown key `grwoth` in [layers]; did you mean `growth`?"},
      {first + "elements = \"hexes\"",
       "job.toml:6:12: `elements` is \"hexes\", not one of \"tets\", \"prisms\""},
      {first + "fan_angel = 30", "unknown key `fan_angel` in [layers]; did you mean `fan_angle`?"},
      {first + "fan_angle = 29", "`fan_angle` must be from 30 to 180"},
      {first + "fan_angle = 181", "`fan_angle` must be from 30 to 180"},
      {first + "heights = [1, 2]",
       "job.toml:5:16: `first_height` cannot be given together with `heights`"},
      {of_wing + "heights = [1]\ny_plus = 1", "`y_plus` cannot be given together with `heights`"},
      {of_wing + "heights = [1]\nreynolds = 6e6", "`reynolds` cannot be given together with"},
      {of_wing + "heights = [1]\nlength = 1", "`length` cannot be given together with"},
      {of_wing + "heights = [1]\ngrowth = 1.2", "`growth` cannot be given together with"},
      {of_wing + "heights = [1]\ngrowth_cap = 2", "`growth_cap` cannot be given together with"},
      {of_wing + "heights = [1]\nacceleration = 1.2", "`acceleration` cannot be given together"},
      {of_wing + "heights = [1]\ntotal_height = 3", "`total_height` cannot be given together with"},
      {of_wing + "heights = [1]\ncount = 1", "`count` cannot be given together with `heights`"},
      {of_wing + "heights = [1]\nequal = 1", "`equal` cannot be given together with `heights`"},
      {of_wing + "heights = 1", "job.toml:5:11: `heights` must be an array, not an integer"},
      {of_wing + "heights = []", "job.toml:5:11: `heights` must have one height at least"},
      {of_wing + "heights = [1, \"a\"]", "job.toml:5:15: number 2 of `heights` must be a number"},
      {of_wing + "heights = [1, 1, 0]",
       "job.toml:5:18: number 3 of `heights` must be positive and finite"},
      {of_wing + "heights = [nan]", "number 1 of `heights` must be positive and finite"},
      {of_wing + "heights = [1, inf]", "number 2 of `heights` must be positive and finite"},
      {of_wing + "heights = [1, 2, 4.1]",
       "number 3 of `heights` is more than twice number 2; layers may not change so fast"},
      {of_wing + "heights = [1, 0.4]", "number 2 of `heights` is less than half of number 1"},
      {of_wing + "first_height = 0", "job.toml:5:16: `first_height` must be positive"},
      {of_wing + "first_height = inf", "`first_height` must be finite"},
      {first + "y_plus = 1",
       "job.toml:6:10: `y_plus` cannot be given together with `first_height`"},
      {of_wing + "y_plus = 1\nlength = 1", "job.toml:5:10: `y_plus` needs `reynolds`"},
      {of_wing + "y_plus = 1\nreynolds = 6e6", "job.toml:5:10: `y_plus` needs `length`"},
      {first + "reynolds = 6e6", "job.toml:6:12: `reynolds` needs `y_plus`"},
      {first + "length = 1", "job.toml:6:10: `length` needs `y_plus`"},
      {of_wing + "y_plus = 1\nreynolds = 10\nlength = 1", "`reynolds` must be from 1e3 to 1e12"},
      {of_wing + "y_plus = 0\nreynolds = 6e6\nlength = 1", "`y_plus` must be from 0.001 to 10000"},
      {of_wing + "y_plus = 1\nreynolds = 6e6\nlength = -1", "`length` must be positive"},
      {first + "growth = 0.9", "job.toml:6:10: `growth` must be from 1 to 2"},
      {first + "growth = 2.1", "`growth` must be from 1 to 2"},
      {first + "growth = 1",
       "job.toml:6:10: `growth` is 1: no layer becomes as high as the edges; "
       "give `count` or `total_height`"},
      {first + "growth = 1\ngrowth_cap = 1.5\nacceleration = 1", "`growth` is 1: no layer becomes"},
      {first + "growth_cap = 1.5", "`growth_cap` needs `acceleration`"},
      {first + "acceleration = 1.5", "`acceleration` needs `growth_cap`"},
      {first + "growth_cap = 1.1\nacceleration = 1.05", "`growth_cap` must be from `growth` to 2"},
      {first + "growth_cap = 1.5\nacceleration = 0.9", "`acceleration` must be from 1 to 2"},
      {first + "count = 0", "job.toml:6:9: `count` must be at least 1"},
      {first + "count = 1001", "`count` must be at most 1000"},
      {first + "count = 2.5", "`count` must be an integer, not a number"},
      {first + "count = \"isotropc\"",
       "`count` is \"isotropc\", not one of \"isotropic\"; did you mean `isotropic`?"},
      {first + "count = 3\ntotal_height = 1",
       "job.toml:7:16: `total_height` cannot be given together with `count`"},
      {first + "total_height = 0.5", "`total_height` must not be less than the first layer"},
      {first + "equal = 0", "`equal` must be at least 1"},
      {first + "step = 0", "`step` must be at least 1"},
      {first + "equal = 4\ncount = 3", "`equal` must not be more than `count`"},
      {first + "room = \"shrink\"",
       "`room` is \"shrink\", not one of \"ratio\", \"stop\", \"scale\""},
  };
  for (const LayersMistake& mistake : mistakes) {
    EXPECT_THAT(refusal(mistake.keys), HasSubstr(mistake.message)) << mistake.keys;
  }
  EXPECT_EQ(refusal(by_y_plus), "") << "or the mistakes above are others";
  EXPECT_THAT(error_text_of<UsageError>(
                  [] { parse_job_file("[geometry]\nsurface = \"a\"\n[layers]\n", "job.toml"); }),
              HasSubstr("`layers` must be written [[layers]]"));
}

TEST(JobLayers, of_canonical_text_are_the_same_layers) {
  for (const std::string& keys :
       {of_wing + "first_height = 1e-4",
        of_wing + "y_plus = 1\nreynolds = 6e6\nlength = 2.5\ntotal_height = 0.1\nequal = 4",
        of_wing + "heights = [0.7, 1.1, 1, 2]\nroom = \"stop\"",
        std::string("patches = [\"a\\\"b\", \"*\"]\nfirst_height = 1\ngrowth = 1.1\ncount = 7\n"
                    "growth_cap = 1.5\nacceleration = 1.05\nroom = \"scale\"\nstep = 2\n"
                    "elements = \"tets\"")}) {
    const JobFile job = parse_job_file(before + keys, "/jobs/job.toml");
    const std::string written = to_toml(job);
    const JobFile again = parse_job_file(written, "/jobs/job.toml");
    EXPECT_EQ(to_toml(again), written);
    const JobLayers& a = job.layers.at(0);
    const JobLayers& b = again.layers.at(0);
    EXPECT_EQ(a.patches, b.patches);
    EXPECT_EQ(a.first_height, b.first_height);
    EXPECT_EQ(a.y_plus, b.y_plus);
    EXPECT_EQ(a.reynolds, b.reynolds);
    EXPECT_EQ(a.length, b.length);
    EXPECT_EQ(a.growth, b.growth);
    EXPECT_EQ(a.growth_cap, b.growth_cap);
    EXPECT_EQ(a.acceleration, b.acceleration);
    EXPECT_EQ(a.count, b.count);
    EXPECT_EQ(a.total_height, b.total_height);
    EXPECT_EQ(a.equal, b.equal);
    EXPECT_EQ(a.heights, b.heights);
    EXPECT_EQ(a.room, b.room);
    EXPECT_EQ(a.step, b.step);
    EXPECT_EQ(a.fan_angle, b.fan_angle);
    EXPECT_EQ(a.elements, b.elements);
  }
}

TEST(JobLayers, of_an_option_are_those_of_the_table_that_says_the_same) {
  const auto toml_of = [](const JobLayers& layers) {
    JobFile job;
    job.layers = {layers};
    return to_toml(job);
  };
  const JobLayers typed =
      parse_layers_option("wing_*,tip:first=1e-4,growth=1.25,count=20,room=stop");
  EXPECT_EQ(typed.typed, "wing_*,tip:first=1e-4,growth=1.25,count=20,room=stop");
  EXPECT_EQ(toml_of(typed),
            toml_of(layers_of("patches = [\"wing_*\", \"tip\"]\nfirst_height = 1e-4\n"
                              "growth = 1.25\ncount = 20\nroom = \"stop\"")));
  EXPECT_EQ(toml_of(parse_layers_option("a:y_plus=1,reynolds=6e6,length=2,total=1,equal=2")),
            toml_of(layers_of("patches = [\"a\"]\ny_plus = 1\nreynolds = 6e6\nlength = 2\n"
                              "total_height = 1\nequal = 2")));
  EXPECT_EQ(toml_of(parse_layers_option("a:heights=1e-4/2e-4/3.5e-4,room=stop")),
            toml_of(layers_of("patches = [\"a\"]\nheights = [1e-4, 2e-4, 3.5e-4]\n"
                              "room = \"stop\"")));
  EXPECT_THAT(parse_layers_option("a:heights=2").heights, ElementsAre(2));
  EXPECT_EQ(parse_layers_option("a:first_height=2,total_height=3").total_height, 3);
  EXPECT_EQ(parse_layers_option("a:first=2,count=isotropic").count, 0);
  EXPECT_EQ(parse_layers_option("a:first=2,elements=tets").elements, "tets");
  EXPECT_THAT(parse_layers_option("body:left:first=2").patches, ElementsAre("body:left"));
}

TEST(JobLayers, of_an_option_have_the_same_checks_in_the_words_that_were_typed) {
  const std::vector<LayersMistake> mistakes = {
      {"wing", "--layers 'wing': must be PATCH,...:first=HEIGHT,..."},
      {":first=1", "--layers ':first=1': the list of patches must not hold an empty name"},
      {"a,a:first=1", "the list of patches has \"a\" twice"},
      {"a\xff:first=1", "the list of patches must hold UTF-8"},
      {"a:", "--layers 'a:': \"\" is not KEY=VALUE"},
      {"a:first", "\"first\" is not KEY=VALUE"},
      {"a:first=", "\"first=\" is not KEY=VALUE"},
      {"a:=1", "\"=1\" is not KEY=VALUE"},
      {"a:first=1,first=2", "`first` is given twice"},
      {"a:frist=1", "--layers 'a:frist=1': unknown key `frist`; did you mean `first`?"},
      {"a:first=1,patches=b", "unknown key `patches`"},
      {"a:first=1,first_height=1", "unknown key `first`"},
      {"a:count=3", "--layers 'a:count=3': `first` is missing; give it, or `y_plus`"},
      {"a:first=1mm", "`first` must be a number, not a string"},
      {"a:first=-1", "`first` must be positive"},
      {"a:first=nan", "`first` must be finite"},
      {"a:first=1,count=0", "`count` must be at least 1"},
      {"a:first=1,count=many", "`count` is \"many\", not one of \"isotropic\""},
      {"a:first=1,total=0.5", "`total` must not be less than the first layer"},
      {"a:first=1,total=5,count=3", "`total` cannot be given together with `count`"},
      {"a:first=1,growth=1", "give `count` or `total`"},
      {"a:first=1,growth=3", "`growth` must be from 1 to 2"},
      {"a:y_plus=1", "`y_plus` needs `reynolds`"},
      {"a:first=1,room=none", "`room` is \"none\", not one of"},
      {"a:first=1,heights=1/2",
       "--layers 'a:first=1,heights=1/2': `first` cannot be given together with `heights`"},
      {"a:heights=1/2,total=3", "`total` cannot be given together with `heights`"},
      {"a:heights=1//2", "number 2 of `heights` must be a number"},
      {"a:heights=1/2mm", "number 2 of `heights` must be a number"},
      {"a:heights=1/2/5", "number 3 of `heights` is more than twice number 2"},
      {"a:first=1/2", "`first` must be a number, not a string"},
  };
  for (const LayersMistake& mistake : mistakes) {
    EXPECT_THAT(refusal_of_option(mistake.keys), HasSubstr(mistake.message)) << mistake.keys;
  }
}

TEST(JobLayers, may_name_many_patches_but_not_without_end) {
  std::string keys = "patches = [";
  for (int i = 0; i < 1001; ++i) keys += "\"p" + std::to_string(i) + "\",";
  EXPECT_THAT(refusal(keys + "]\nfirst_height = 1"), HasSubstr("may hold at most 1000 names"));
}

}  // namespace
}  // namespace tetfarm
