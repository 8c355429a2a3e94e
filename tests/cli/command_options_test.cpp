// Every option of the commands of cli/command_line.cpp arrives where it belongs, and what is not
// given has the default that help tells.
#include <gmock/gmock.h>

#include "tests/cli/parsed.h"

namespace tetfarm {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using CommandOptions = PlainEnvironment;

/// What `run`, `plan` and `submit` take.
const std::vector<std::string> job_words = {
    "wing.stl",    "--size",       "0.5",          "--growth", "0.2",
    "--outer",     "box:3",        "--outer-size", "0.25",     "--max-elements",
    "7",           "--format",     "vtkhdf,su2",   "--layers", "wing_*,tip:first=1e-4,count=20",
    "--layers",    "[a]:first=1",  "--keep",       "needed",   "--patch-size",
    "a,b=0.1:0.2", "--patch-size", "c=1",          "--scale",  "0.001"};

void expect_job(const RunOptions& job) {
  EXPECT_EQ(job.input, "wing.stl");
  EXPECT_EQ(job.size, 0.5);
  EXPECT_EQ(job.growth, 0.2);
  EXPECT_EQ(job.outer, "box:3");
  EXPECT_EQ(job.outer_size, 0.25);
  EXPECT_EQ(job.max_elements, 7);
  EXPECT_THAT(job.formats, ElementsAre("vtkhdf", "su2"));
  EXPECT_EQ(job.keep, "needed");
  EXPECT_THAT(job.layers, ElementsAre("wing_*,tip:first=1e-4,count=20", "[a]:first=1"));
  EXPECT_THAT(job.patch_sizes, ElementsAre("a,b=0.1:0.2", "c=1"));
  EXPECT_EQ(job.scale, 0.001);
  EXPECT_EQ(job.unit, "");
  EXPECT_FALSE(job.force);
}

std::vector<std::string> joined(std::vector<std::string> words,
                                const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST_F(CommandOptions, of_a_run) {
  const auto run = parsed_as<RunOptions>(
      joined({"run", "-o", "d", "-j", "4096", "--database", "/db", "--grace", "0", "--json",
              "--progress", "plain", "--subdomains", "8", "--groups", "2"},
             job_words));
  expect_job(run);
  EXPECT_EQ(run.output, "d");
  EXPECT_EQ(run.workers, 4096);
  EXPECT_EQ(run.database, "/db");
  EXPECT_EQ(run.grace_s, 0);
  EXPECT_TRUE(run.json);
  EXPECT_EQ(run.progress, ProgressStyle::plain);
  EXPECT_EQ(run.subdomains, 8);
  EXPECT_EQ(run.groups, 2);
  EXPECT_EQ(parsed_as<RunOptions>({"run", "a", "--max-memory", "2GiB"}).max_memory, "2GiB");
  EXPECT_EQ(parsed_as<RunOptions>({"run", "a", "--progress", "auto"}).progress,
            ProgressStyle::automatic);
  EXPECT_EQ(parsed_as<RunOptions>({"run", "a", "--progress", "none"}).progress,
            ProgressStyle::none);
  EXPECT_EQ(parsed_as<RunOptions>({"run", "a", "--progress", "text"}).progress,
            ProgressStyle::automatic);
  EXPECT_EQ(parsed_as<RunOptions>({"run", "a", "--progress", "json"}).progress,
            ProgressStyle::json);
}

TEST_F(CommandOptions, of_a_run_that_says_nothing_else) {
  const auto run = parsed_as<RunOptions>({"run", "wing.stl"});
  EXPECT_EQ(run.output, "out");
  EXPECT_EQ(run.workers, 0);
  EXPECT_EQ(run.max_memory + run.store + run.database, "");
  EXPECT_FALSE(run.subdomains || run.groups || run.size || run.growth || run.outer);
  EXPECT_FALSE(run.outer_size || run.max_elements);
  EXPECT_FALSE(run.force || run.json);
  EXPECT_TRUE(run.formats.empty() && run.layers.empty());
  EXPECT_EQ(run.progress, ProgressStyle::automatic);
  EXPECT_EQ(run.grace_s, 5);
}

TEST_F(CommandOptions, of_a_plan) {
  const RunOptions job =
      parsed_as<PlanCommand>(
          joined({"plan", "--store", "/farm", "--database", "/db", "--json"}, job_words))
          .job;
  expect_job(job);
  EXPECT_EQ(job.store, "/farm");
  EXPECT_EQ(job.database, "/db");
  EXPECT_TRUE(job.json);
}

TEST_F(CommandOptions, of_a_submission) {
  const auto submit = parsed_as<SubmitCommand>(
      joined({"submit", "--store", "/farm", "--connect", "tcp://h:1", "--no-check", "--progress",
              "none", "--key", "k", "--coordinator-key", "c", "--timeout", "3", "--json"},
             job_words));
  expect_job(submit.job);
  EXPECT_EQ(submit.job.store, "/farm");
  EXPECT_FALSE(submit.check);
  EXPECT_FALSE(submit.coordinator_reads);
  EXPECT_EQ(submit.client.endpoint, "tcp://h:1");
  EXPECT_EQ(submit.client.keys.own, "k");
  EXPECT_EQ(submit.client.keys.coordinator, "c");
  EXPECT_EQ(submit.client.timeout_s, 3);
  EXPECT_EQ(submit.client.progress, ProgressStyle::none);
  EXPECT_TRUE(submit.client.json);
  const auto least = parsed_as<SubmitCommand>({"submit", "a", "--connect", "tcp://h:1"});
  EXPECT_TRUE(least.check);
  EXPECT_FALSE(least.coordinator_reads || least.client.json);
  EXPECT_EQ(least.client.timeout_s, 10);
  EXPECT_TRUE(
      parsed_as<SubmitCommand>({"submit", "a", "--connect", "tcp://h:1", "--coordinator-reads"})
          .coordinator_reads);
}

TEST_F(CommandOptions, of_a_check) {
  const auto of_surface = parsed_as<CheckOptions>({"check", "a.stl", "-o", "d.vtp", "--json"});
  EXPECT_EQ(of_surface.input, "a.stl");
  EXPECT_EQ(of_surface.defects_file, "d.vtp");
  EXPECT_TRUE(of_surface.json);
  EXPECT_EQ(of_surface.store + of_surface.database, "");
  const auto in_mm =
      parsed_as<CheckOptions>({"check", "--patch-size", "a=1", "--unit", "mm", "b.stl"});
  EXPECT_THAT(in_mm.patch_sizes, ElementsAre("a=1"));
  EXPECT_EQ(in_mm.unit, "mm");
  EXPECT_FALSE(in_mm.scale.has_value());
  const auto of_store = parsed_as<CheckOptions>({"check", "--store", "s", "--database", "d"});
  EXPECT_EQ(of_store.store, "s");
  EXPECT_EQ(of_store.database, "d");
  EXPECT_EQ(of_store.input, "");
  EXPECT_FALSE(of_store.json);
}

TEST_F(CommandOptions, of_layers_leave_the_words_after_them_to_others) {
  const auto run = parsed_as<RunOptions>({"run", "--layers", "a:first=1", "wing.stl"});
  EXPECT_EQ(run.input, "wing.stl");
  EXPECT_THAT(run.layers, ElementsAre("a:first=1"));
  const auto check = parsed_as<CheckOptions>(
      {"check", "--layers", "a:first=1", "--layers", "b:first=2", "wing.stl"});
  EXPECT_EQ(check.input, "wing.stl");
  EXPECT_THAT(check.layers, ElementsAre("a:first=1", "b:first=2"));
}

TEST_F(CommandOptions, of_gc) {
  const auto least = parsed_as<GcCommand>({"gc", "s"});
  EXPECT_EQ(least.store, "s");
  EXPECT_EQ(least.database, "");
  EXPECT_FALSE(least.dry_run || least.all_finished || least.json);
  const auto dry = parsed_as<GcCommand>({"gc", "s", "--database", "d", "--dry-run"});
  EXPECT_EQ(dry.database, "d");
  EXPECT_TRUE(dry.dry_run);
  EXPECT_FALSE(dry.all_finished || dry.json);
  EXPECT_TRUE(parsed_as<GcCommand>({"gc", "s", "--all-finished"}).all_finished);
  EXPECT_TRUE(parsed_as<GcCommand>({"gc", "s", "--json"}).json);
}

TEST_F(CommandOptions, of_quality) {
  const auto least = parsed_as<QualityOptions>({"quality", "m"});
  EXPECT_EQ(least.input, "m");
  EXPECT_EQ(least.run + least.scratch, "");
  EXPECT_TRUE(least.check_faces);
  EXPECT_EQ(least.memory, "256MiB");
  EXPECT_FALSE(least.json);
  const auto all = parsed_as<QualityOptions>(
      {"quality", "job-7", "--run", "out", "--no-face-check", "--memory", "1GiB", "--scratch",
       "/tmp", "--json", "--connect", "tcp://h:1", "--store", "s", "--database", "d"});
  EXPECT_EQ(all.input, "job-7");
  EXPECT_EQ(all.run, "out");
  EXPECT_FALSE(all.check_faces);
  EXPECT_EQ(all.memory, "1GiB");
  EXPECT_EQ(all.scratch, "/tmp");
  EXPECT_TRUE(all.json);
  EXPECT_EQ(all.source.client.endpoint, "tcp://h:1");
  EXPECT_EQ(all.source.store, "s");
  EXPECT_EQ(all.source.database, "d");
}

TEST_F(CommandOptions, of_an_export_and_a_conversion) {
  const auto least = parsed_as<ExportCommand>({"export", "m", "-o", "x.su2"});
  EXPECT_EQ(least.input, "m");
  EXPECT_EQ(least.output, "x.su2");
  EXPECT_EQ(least.format, "");
  EXPECT_EQ(least.partitions, 0);
  EXPECT_EQ(least.keep_columns, "yes");
  EXPECT_EQ(least.numbering, "as-meshed");
  EXPECT_FALSE(least.json);
  const auto all = parsed_as<ExportCommand>({"export", "job-7", "--output", "x", "--format", "cgns",
                                             "--partitions", "1048576", "--numbering", "rcm",
                                             "--keep-columns", "no", "--patch-type", "a,b=wall",
                                             "--patch-type", "c=slip", "--json", "--store", "s"});
  EXPECT_THAT(all.patch_types, ElementsAre("a,b=wall", "c=slip"));
  EXPECT_EQ(all.format, "cgns");
  EXPECT_EQ(all.partitions, 1 << 20);
  EXPECT_EQ(all.keep_columns, "no");
  EXPECT_THAT(refusal_of({"export", "m", "-o", "x", "--keep-columns", "no"}),
              HasSubstr("--partitions"));
  EXPECT_EQ(all.numbering, "rcm");
  EXPECT_TRUE(all.json);
  EXPECT_EQ(all.source.store, "s");
  EXPECT_EQ(parsed_as<ExportCommand>(
                {"export", "m", "-o", "x", "--numbering", "hilbert", "--partitions", "as-meshed"})
                .numbering,
            "hilbert");
  const auto convert = parsed_as<ConvertCommand>({"convert", "a.msh", "b.stl", "--json"});
  EXPECT_EQ(convert.input, "a.msh");
  EXPECT_EQ(convert.output, "b.stl");
  EXPECT_TRUE(convert.json);
  EXPECT_EQ(convert.scale, 1);
  EXPECT_EQ(convert.max_edge + convert.box + convert.box_size, 0);
  const auto boxed =
      parsed_as<ConvertCommand>({"convert", "a.msh", "b.stl", "--scale", "0.5", "--max-edge",
                                 "0.25", "--box", "3", "--box-size", "0.125"});
  EXPECT_EQ(boxed.scale, 0.5);
  EXPECT_EQ(boxed.max_edge, 0.25);
  EXPECT_EQ(boxed.box, 3);
  EXPECT_EQ(boxed.box_size, 0.125);
}

TEST_F(CommandOptions, of_remeshing) {
  const auto least = parsed_as<SurfaceCommand>({"surface", "a.stl"});
  EXPECT_EQ(least.input, "a.stl");
  EXPECT_EQ(least.output, "");
  EXPECT_EQ(least.angle, 0);
  EXPECT_EQ(least.size + least.min_size + least.tolerance + least.growth, 0);
  EXPECT_EQ(least.heal_tolerance + least.largest_hole, 0);
  EXPECT_FALSE(least.heal || least.heal_only);
  EXPECT_FALSE(least.json);
  const auto all = parsed_as<SurfaceCommand>(
      {"surface", "a.toml",           "-o",  "b.off",          "--size", "2",        "--min-size",
       "0.5",     "--angle",          "40",  "--tolerance",    "0.125",  "--growth", "0.25",
       "--heal",  "--heal-tolerance", "0.5", "--largest-hole", "3",      "--json"});
  EXPECT_TRUE(all.heal);
  EXPECT_EQ(all.heal_tolerance, 0.5);
  EXPECT_EQ(all.largest_hole, 3);
  EXPECT_TRUE(parsed_as<SurfaceCommand>({"surface", "a.stl", "--heal-only"}).heal_only);
  EXPECT_THAT(parsed_as<SurfaceCommand>({"surface", "--patch-size", "tip=1", "a.stl"}).patch_sizes,
              ElementsAre("tip=1"));
  EXPECT_EQ(all.output, "b.off");
  EXPECT_EQ(all.size, 2);
  EXPECT_EQ(all.min_size, 0.5);
  EXPECT_EQ(all.angle, 40);
  EXPECT_EQ(all.tolerance, 0.125);
  EXPECT_EQ(all.growth, 0.25);
  EXPECT_TRUE(all.json);
}

TEST_F(CommandOptions, of_a_picture) {
  const auto least = parsed_as<RenderCommand>({"render", "m", "-o", "p.png"});
  EXPECT_EQ(least.input, "m");
  EXPECT_EQ(least.output, "p.png");
  EXPECT_EQ(least.view, "surface");
  EXPECT_EQ(least.colour, "subdomain");
  EXPECT_EQ(least.size, "1600x1000");
  EXPECT_TRUE(least.from.empty());
  EXPECT_TRUE(least.centre.empty());
  EXPECT_THAT(least.up, ElementsAre(0, 0, 1));
  EXPECT_THAT(least.plane, ElementsAre(0, 1, 0));
  EXPECT_EQ(least.zoom, 1);
  EXPECT_TRUE(least.bodies.empty());
  EXPECT_TRUE(least.hidden.empty());
  EXPECT_FALSE(least.at);
  EXPECT_EQ(least.explode, 0.4);
  EXPECT_FALSE(least.edge_width);
  const auto all = parsed_as<RenderCommand>(
      {"render",    "m",     "-o",      "p.png", "--view",   "cut",   "--colour", "patch",
       "--size",    "80x60", "--from",  "1,2,3", "--up",     "4,5,6", "--plane",  "7,8,9",
       "--zoom",    "2.5",   "--body",  "a,b",   "--hide",   "c,d",   "--at",     "-0.5",
       "--explode", "0",     "--edges", "0",     "--centre", "-1,0,2"});
  EXPECT_FALSE(all.across);
  EXPECT_EQ(parsed_as<RenderCommand>({"render", "m", "-o", "p", "--across", "0.25"}).across, 0.25);
  EXPECT_EQ(all.view, "cut");
  EXPECT_EQ(all.colour, "patch");
  EXPECT_EQ(all.size, "80x60");
  EXPECT_THAT(all.from, ElementsAre(1, 2, 3));
  EXPECT_THAT(all.up, ElementsAre(4, 5, 6));
  EXPECT_THAT(all.plane, ElementsAre(7, 8, 9));
  EXPECT_EQ(all.zoom, 2.5);
  EXPECT_THAT(all.centre, ElementsAre(-1, 0, 2));
  EXPECT_THAT(all.bodies, ElementsAre("a", "b"));
  EXPECT_THAT(all.hidden, ElementsAre("c", "d"));
  EXPECT_EQ(all.at, -0.5);
  EXPECT_EQ(all.explode, 0);
  EXPECT_EQ(all.edge_width, 0);
  for (const char* view : {"surface", "exploded", "cut", "slice"}) {
    EXPECT_EQ(parsed_as<RenderCommand>({"render", "m", "-o", "p", "--view", view}).view, view);
  }
  for (const char* by : {"subdomain", "region", "patch", "layer"}) {
    EXPECT_EQ(parsed_as<RenderCommand>({"render", "m", "-o", "p", "--colour", by}).colour, by);
  }
}

TEST_F(CommandOptions, of_a_picture_of_the_plane) {
  const auto least = parsed_as<RenderCommand>({"render", "m.mesh", "-o", "p.png"});
  EXPECT_EQ(least.field, "");
  EXPECT_EQ(least.field_number, 1);
  EXPECT_EQ(least.levels, 20);
  EXPECT_TRUE(least.range.empty());
  EXPECT_EQ(least.metric, "");
  EXPECT_TRUE(least.along.empty());
  EXPECT_FALSE(least.reversed);
  EXPECT_TRUE(least.also.empty());
  const auto all = parsed_as<RenderCommand>({"render", "m.mesh", "-o", "p.png", "--field", "u.sol",
                                             "--field-number", "2", "--levels", "7", "--range",
                                             "-1,2.5", "--metric", "m.sol", "--centre", "-1,2"});
  EXPECT_EQ(all.field, "u.sol");
  EXPECT_EQ(all.field_number, 2);
  EXPECT_EQ(all.levels, 7);
  EXPECT_THAT(all.range, ElementsAre(-1, 2.5));
  EXPECT_EQ(all.metric, "m.sol");
  EXPECT_THAT(all.centre, ElementsAre(-1, 2));
  const auto chart = parsed_as<RenderCommand>({"render", "m.mesh", "-o", "c.svg", "--field",
                                               "u.sol", "--along", "1,3", "--reversed", "--also",
                                               "n.mesh,v.sol", "--also", "o.mesh,w.sol"});
  EXPECT_THAT(chart.along, ElementsAre(1, 3));
  EXPECT_TRUE(chart.reversed);
  EXPECT_THAT(chart.also, ElementsAre("n.mesh,v.sol", "o.mesh,w.sol"));
}

TEST_F(CommandOptions, of_a_shape) {
  const auto least = parsed_as<ShapeCommand>({"shape", "wing", "-o", "w.stl"});
  EXPECT_EQ(least.name, "wing");
  EXPECT_EQ(least.output, "w.stl");
  EXPECT_EQ(least.spacing, 0.1);
  EXPECT_EQ(least.growth, 0.2);
  const auto all =
      parsed_as<ShapeCommand>({"shape", "duct", "-o", "d", "--spacing", "0.5", "--growth", "0.7"});
  EXPECT_EQ(all.name, "duct");
  EXPECT_EQ(all.spacing, 0.5);
  EXPECT_EQ(all.growth, 0.7);
}

TEST_F(CommandOptions, of_a_mesh_of_the_plane) {
  const auto least = parsed_as<PlaneCommand>({"plane", "a.xy", "b.xy", "-o", "p.mesh"});
  EXPECT_THAT(least.inputs, ElementsAre("a.xy", "b.xy"));
  EXPECT_EQ(least.output, "p.mesh");
  EXPECT_FALSE(least.size.has_value() || least.vertices.has_value() || least.json);
  EXPECT_EQ(least.gradation + least.metric + least.sources, "");
  EXPECT_EQ(least.corner_angle_deg, 30);
  const auto all = parsed_as<PlaneCommand>({"plane", "a.xy", "-o", "p", "--size", "0.5",
                                            "--vertices", "7", "--gradation", "1.2", "--sources",
                                            "s.toml", "--corner-angle", "40", "--json"});
  EXPECT_EQ(all.sources, "s.toml");
  EXPECT_EQ(all.size, 0.5);
  EXPECT_EQ(all.vertices, 7);
  EXPECT_EQ(all.gradation, "1.2");
  EXPECT_EQ(all.corner_angle_deg, 40);
  EXPECT_TRUE(all.json);
}

TEST_F(CommandOptions, of_a_loop) {
  const auto least = parsed_as<LoopCommand>({"loop", "shock.toml"});
  EXPECT_EQ(least.input, "shock.toml");
  EXPECT_EQ(least.output, "out");
  EXPECT_EQ(least.workers, 1);
  EXPECT_EQ(least.grace_s, 5);
  EXPECT_FALSE(least.json);
  const auto all = parsed_as<LoopCommand>({"loop", "j.toml", "-o", "d", "-j", "2", "--database",
                                           "b", "--grace", "7", "--json", "--progress", "none"});
  EXPECT_EQ(all.output, "d");
  EXPECT_EQ(all.workers, 2);
  EXPECT_EQ(all.database, "b");
  EXPECT_EQ(all.grace_s, 7);
  EXPECT_TRUE(all.json);
  EXPECT_EQ(all.progress, ProgressStyle::none);
}

TEST_F(CommandOptions, of_a_transfer) {
  const auto least = parsed_as<PlaneTransferCommand>(
      {"transfer", "a.mesh", "--solution", "a.sol", "--to", "b.mesh", "-o", "b.sol"});
  EXPECT_EQ(least.input, "a.mesh");
  EXPECT_EQ(least.solution, "a.sol");
  EXPECT_EQ(least.to, "b.mesh");
  EXPECT_EQ(least.output, "b.sol");
  EXPECT_EQ(least.method, "conservative");
  EXPECT_FALSE(least.json);
  const auto all = parsed_as<PlaneTransferCommand>(
      {"transfer", "a", "--solution", "s", "--to", "b", "-o", "t", "--method", "linear", "--json"});
  EXPECT_EQ(all.method, "linear");
  EXPECT_TRUE(all.json);
}

TEST_F(CommandOptions, of_an_adaptation) {
  const auto least = parsed_as<AdaptCommand>({"adapt", "m.mesh", "-o", "n.mesh"});
  EXPECT_EQ(least.input, "m.mesh");
  EXPECT_EQ(least.output, "n.mesh");
  EXPECT_EQ(least.metric + least.solution + least.sources + least.gradation, "");
  EXPECT_TRUE(least.curves.empty());
  EXPECT_FALSE(least.vertices.has_value() || least.h_min.has_value() || least.h_max.has_value());
  EXPECT_EQ(least.norm, 2);
  EXPECT_EQ(least.aspect, 1e4);
  EXPECT_EQ(least.mode, "lp");
  EXPECT_EQ(least.corner_angle_deg, 30);
  EXPECT_FALSE(least.json);
  const auto all = parsed_as<AdaptCommand>(
      {"adapt",       "m",         "-o",       "n",       "--solution", "u.sol",   "--vertices",
       "9",           "--norm",    "1",        "--h-min", "0.1",        "--h-max", "2",
       "--gradation", "off",       "--aspect", "50",      "--mode",     "hessian", "--corner-angle",
       "20",          "--sources", "s.toml",   "--json"});
  EXPECT_EQ(all.sources, "s.toml");
  EXPECT_EQ(all.solution, "u.sol");
  EXPECT_EQ(all.vertices, 9);
  EXPECT_EQ(all.norm, 1);
  EXPECT_EQ(all.h_min, 0.1);
  EXPECT_EQ(all.h_max, 2);
  EXPECT_EQ(all.gradation, "off");
  EXPECT_EQ(all.aspect, 50);
  EXPECT_EQ(all.mode, "hessian");
  EXPECT_EQ(all.corner_angle_deg, 20);
  EXPECT_TRUE(all.json);
  EXPECT_EQ(parsed_as<AdaptCommand>({"adapt", "m", "-o", "n", "--metric", "m.sol"}).metric,
            "m.sol");
  const auto curved = parsed_as<AdaptCommand>({"adapt", "--curve", "1=naca0012", "m", "--curve",
                                               "2,3=circle", "-o", "n", "--mode", "thesis"});
  EXPECT_THAT(curved.curves, ::testing::ElementsAre("1=naca0012", "2,3=circle"));
  EXPECT_EQ(curved.input, "m");
  EXPECT_EQ(curved.mode, "thesis");
  EXPECT_THAT(parsed_as<PlaneCommand>({"plane", "--curve", "1=line", "a.xy", "-o", "n"}).curves,
              ::testing::ElementsAre("1=line"));
}

TEST_F(CommandOptions, of_a_spacing) {
  const auto least = parsed_as<SpacingCommand>({"spacing", "--reynolds", "6e6", "--length", "2.5"});
  EXPECT_EQ(least.y_plus, 1);
  EXPECT_EQ(least.reynolds, 6e6);
  EXPECT_EQ(least.length, 2.5);
  EXPECT_FALSE(least.json);
  const auto all = parsed_as<SpacingCommand>(
      {"spacing", "--y-plus", "30", "--reynolds", "1e3", "--length", "1", "--json"});
  EXPECT_EQ(all.y_plus, 30);
  EXPECT_TRUE(all.json);
}

TEST_F(CommandOptions, of_those_that_act_on_a_farm) {
  const auto wait =
      parsed_as<WaitCommand>({"wait", "job-7", "-o", "d", "--store", "s", "--connect", "tcp://h:1",
                              "--progress", "plain", "--timeout", "0.5", "--json"});
  EXPECT_EQ(wait.client.job, "job-7");
  EXPECT_EQ(wait.client.output, "d");
  EXPECT_EQ(wait.store, "s");
  EXPECT_EQ(wait.client.endpoint, "tcp://h:1");
  EXPECT_EQ(wait.client.progress, ProgressStyle::plain);
  EXPECT_EQ(wait.client.timeout_s, 0.5);
  EXPECT_TRUE(wait.client.json);
  const auto submit = parsed_as<SubmitCommand>(
      {"submit", "--after", "job-3", "a.stl", "--after", "job-5", "--connect", "tcp://h:1"});
  EXPECT_EQ(submit.after, (std::vector<std::string>{"job-3", "job-5"}));
  EXPECT_EQ(submit.job.input, "a.stl");
  const auto cancel = parsed_as<CancelCommand>({"cancel", "job-7", "--connect", "tcp://h:1"});
  EXPECT_EQ(cancel.client.job, "job-7");
  EXPECT_EQ(cancel.client.endpoint, "tcp://h:1");
  EXPECT_FALSE(cancel.client.json);
  const auto priority =
      parsed_as<PriorityCommand>({"priority", "job-7", "-5", "--connect", "tcp://h:1"});
  EXPECT_EQ(priority.client.job, "job-7");
  EXPECT_EQ(priority.priority, -5);
  const auto retry = parsed_as<RetryCommand>({"retry", "job-7", "31", "--connect", "tcp://h:1"});
  EXPECT_EQ(retry.client.job, "job-7");
  EXPECT_EQ(retry.task, 31U);
  EXPECT_EQ(retry.host, "");
  const auto of_host = parsed_as<RetryCommand>({"retry", "--host", "n", "--connect", "tcp://h:1"});
  EXPECT_EQ(of_host.host, "n");
  EXPECT_EQ(of_host.client.job, "");
  EXPECT_EQ(of_host.task, 0U);
  const auto drain = parsed_as<DrainCommand>({"drain", "worker-7", "--connect", "tcp://h:1"});
  EXPECT_EQ(drain.worker, "worker-7");
  EXPECT_FALSE(drain.all);
  EXPECT_TRUE(parsed_as<DrainCommand>({"drain", "--all", "--connect", "tcp://h:1"}).all);
}

TEST_F(CommandOptions, that_cannot_be_are_refused) {
  const auto run = [](const std::vector<std::string>& more) {
    return joined({"run", "a.stl"}, more);
  };
  const auto farm = [](std::vector<std::string> words) {
    return joined(std::move(words), {"--connect", "tcp://h:1"});
  };
  const std::string whole = ": must be a whole number from ";
  const std::string positive = ": must be a number above 0, not ";
  expect_refused({
      {{"run"}, "INPUT is required"},
      {run({"-j", "4097"}), "--workers" + whole + "1 to 4096, not 4097"},
      {run({"--subdomains", "0"}), "--subdomains" + whole + "1 to 1000000, not 0"},
      {run({"--subdomains", "1000001"}), "--subdomains" + whole + "1 to 1000000, not 1000001"},
      {run({"--groups", "0"}), "--groups" + whole + "1 to 1000000, not 0"},
      {run({"--size", "0"}), "--size" + positive + "0"},
      {run({"--growth", "0"}), "--growth" + positive + "0"},
      {run({"--outer-size", "-1"}), "--outer-size" + positive + "-1"},
      {run({"--grace", "-1"}), "--grace: must be a number, 0 or above, not -1"},
      {run({"--max-memory", "1GB", "--subdomains", "2"}), "--subdomains excludes --max-memory"},
      {run({"--max-memory", "1GB", "--groups", "2"}), "--groups excludes --max-memory"},
      {run({"--force", "--max-elements", "2"}), "--max-elements excludes --force"},
      {run({"--size", "1", "--frequency", "1GHz"}), "--size excludes --frequency"},
      {run({"--size", "1", "--wave-speed", "1"}), "--size excludes --wave-speed"},
      {run({"--size", "1", "--per-wavelength", "1"}), "--size excludes --per-wavelength"},
      {run({"--frequency", "1ghz"}),
       "--frequency: must be a frequency such as 1.2GHz, 300MHz or 20000, not 1ghz"},
      {run({"--frequency", "1GHz", "--per-wavelength", "0"}), "--per-wavelength" + positive + "0"},
      {run({"--frequency", "1GHz", "--wave-speed", "-3"}), "--wave-speed" + positive + "-3"},
      {{"surface", "a.stl", "--size", "1", "--frequency", "1GHz"}, "--size excludes --frequency"},
      {{"run", "a.stl", "--scale", "2", "--unit", "mm"}, "--scale excludes --unit"},
      {{"run", "a.stl", "--scale", "0"}, "--scale" + positive + "0"},
      {{"init"}, "SURFACE is required"},
      {{"init", "a.stl", "-o", ""}, "--output: must not be empty"},
      {{"plan", "a.stl", "--database", "d"}, "--database requires --store"},
      {{"check", "a.stl", "--store", "s"}, "INPUT excludes --store"},
      {{"check", "--database", "d"}, "--database requires --store"},
      {{"gc"}, "STORE is required"},
      {{"quality"}, "FILE is required"},
      {{"export", "m"}, "--output is required"},
      {{"export", "-o", "x"}, "FILE is required"},
      {{"export", "m", "-o", "x", "--partitions", "1048577"},
       "--partitions: must be as-meshed or a whole number from 1 to 1048576, not 1048577"},
      {{"convert", "a.stl"}, "OUT is required"},
      {{"convert"}, "IN is required"},
      {{"render", "m"}, "--output is required"},
      {{"render", "m", "-o", "p", "--zoom", "0"}, "--zoom" + positive + "0"},
      {{"render", "m", "-o", "p", "--explode", "-1"},
       "--explode: must be a number, 0 or above, not -1"},
      {{"render", "m", "-o", "p", "--edges", "-1"},
       "--edges: must be a number, 0 or above, not -1"},
      {{"render", "m", "-o", "p", "--levels", "5"}, "--levels requires --field"},
      {{"render", "m", "-o", "p", "--along", "1"}, "--along requires --field"},
      {{"render", "m", "-o", "p", "--field", "u", "--reversed"}, "--reversed requires --along"},
      {{"render", "m", "-o", "p", "--field", "u", "--levels", "0"},
       "--levels: must be a whole number from 1 to 1000, not 0"},
      {{"render", "m", "-o", "p", "--field", "u", "--field-number", "0"},
       "--field-number: must be a whole number above 0, not 0"},
      {{"convert", "a", "b", "--scale", "0"}, "--scale" + positive + "0"},
      {{"surface"}, "IN is required"},
      {{"surface", "a", "--size", "0"}, "--size" + positive + "0"},
      {{"convert", "a", "b", "--max-edge", "-1"}, "--max-edge" + positive + "-1"},
      {{"convert", "a", "b", "--box", "1"}, "--box requires --box-size"},
      {{"convert", "a", "b", "--box-size", "1"}, "--box-size requires --box"},
      {{"shape", "wing"}, "--output is required"},
      {{"shape", "wing", "-o", "w", "--spacing", "0"}, "--spacing" + positive + "0"},
      {{"shape", "wing", "-o", "w", "--growth", "0"}, "--growth" + positive + "0"},
      {{"plane", "a.xy"}, "--output is required"},
      {{"plane", "a.xy", "-o", "p", "--size", "0"}, "--size" + positive + "0"},
      {{"plane", "a.xy", "-o", "p", "--size", "1", "--metric", "m"}, "--size excludes --metric"},
      {{"adapt", "m"}, "--output is required"},
      {{"adapt", "m", "-o", "n", "--vertices", "2"},
       "--vertices: must be a whole number from 3 to 50000000, not 2"},
      {{"adapt", "m", "-o", "n", "--metric", "a", "--solution", "b"},
       "--metric excludes --solution"},
      {{"adapt", "m", "-o", "n", "--gradation", "1"},
       "--gradation: must be off or a number above 1, at most 100, not 1"},
      {{"adapt", "m", "-o", "n", "--norm", "0"}, "--norm: must be a number from 0.5 to 100, not 0"},
      {{"adapt", "m", "-o", "n", "--aspect", "0.5"},
       "--aspect: must be a number from 1 to 1e+07, not 0.5"},
      {{"adapt", "m", "-o", "n", "--corner-angle", "0"},
       "--corner-angle: must be a number from 1 to 180, not 0"},
      {{"loop", "-o", "d"}, "INPUT is required"},
      {{"transfer", "m", "--to", "n", "-o", "t"}, "--solution is required"},
      {{"transfer", "m", "--solution", "s", "-o", "t"}, "--to is required"},
      {{"transfer", "m", "--solution", "s", "--to", "n"}, "--output is required"},
      {{"spacing", "--length", "1"}, "--reynolds is required"},
      {{"spacing", "--reynolds", "6e6"}, "--length is required"},
      {{"spacing", "--reynolds", "10", "--length", "1"},
       "--reynolds: must be a number from 1000 to 1e+12, not 10"},
      {{"spacing", "--reynolds", "6e6", "--length", "0"}, "--length" + positive + "0"},
      {{"spacing", "--reynolds", "6e6", "--length", "1", "--y-plus", "0"},
       "--y-plus: must be a number from 0.001 to 10000, not 0"},
      {{"check", "--store", "s", "--layers", "a:first=1"}, "--layers excludes --store"},
      {{"submit", "a.stl"}, "--connect is required"},
      {farm({"submit", "a.stl", "--store", "s", "--coordinator-reads"}),
       "--store excludes --coordinator-reads"},
      {{"wait", "job-7"}, "--connect is required"},
      {farm({"wait"}), "JOB is required"},
      {farm({"cancel"}), "JOB is required"},
      {farm({"priority", "job-7"}), "N is required"},
      {farm({"priority", "job-7", "1001"}), "N: Value 1001 not in range -1000 to 1000"},
      {farm({"submit", "a.stl", "--priority", "-1001"}),
       "--priority: Value -1001 not in range -1000 to 1000"},
      {{"retry", "job-7"}, "--connect is required"},
      {farm({"retry", "job-7", "0"}), "TASK: must be a whole number above 0, not 0"},
      {farm({"retry", "job-7", "--host", "n"}), "JOB excludes --host"},
      {{"drain", "worker-7"}, "--connect is required"},
      {farm({"drain", "worker-7", "--all"}), "WORKER excludes --all"},
  });
  for (const auto& [words, value] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"render", "m", "-o", "p", "--view", "inside"}, "--view: inside not in {"},
           {{"render", "m", "-o", "p", "--colour", "red"}, "--colour: red not in {"},
           {{"export", "m", "-o", "x", "--numbering", "best"}, "--numbering: best not in {"},
           {{"shape", "teapot", "-o", "w"}, "KIND: teapot not in {"}}) {
    EXPECT_THAT(refusal_of(words), HasSubstr(value));
  }
}

TEST_F(CommandOptions, that_give_a_size_by_a_wavelength) {
  const std::vector<std::string> words = {"a.stl", "--frequency",      "1.2GHz", "--wave-speed",
                                          "3e11",  "--per-wavelength", "15"};
  const auto expect_wave = [](const WaveOptions& wave) {
    EXPECT_EQ(wave.frequency, "1.2GHz");
    EXPECT_EQ(wave.speed, 3e11);
    EXPECT_EQ(wave.per_wavelength, 15);
  };
  expect_wave(parsed_as<RunOptions>(joined({"run"}, words)).wave);
  expect_wave(parsed_as<PlanCommand>(joined({"plan"}, words)).job.wave);
  expect_wave(parsed_as<CheckOptions>(joined({"check"}, words)).wave);
  expect_wave(parsed_as<SurfaceCommand>(joined({"surface"}, words)).wave);
  expect_wave(
      parsed_as<SubmitCommand>(joined({"submit", "--connect", "tcp://h:1"}, words)).job.wave);
}

TEST_F(CommandOptions, of_a_run_that_browsers_see) {
  EXPECT_FALSE(parsed_as<RunOptions>({"run", "a.stl"}).is_watched);
  const auto watched =
      parsed_as<RunOptions>({"run", "--watch", "a.stl", "--http", "127.0.0.1:8470"});
  EXPECT_TRUE(watched.is_watched);
  EXPECT_EQ(watched.input, "a.stl");
  EXPECT_EQ(watched.http_address, "127.0.0.1:8470");
  EXPECT_THAT(refusal_of({"run", "a.stl", "--http", "127.0.0.1:8470"}), HasSubstr("--watch"));
}

TEST_F(CommandOptions, of_a_job_file_to_write) {
  const auto init = parsed_as<InitCommand>({"init", "a.stl", "-o", "a.toml", "--force"});
  EXPECT_EQ(init.surface, "a.stl");
  EXPECT_EQ(init.output, "a.toml");
  EXPECT_TRUE(init.force);
  EXPECT_EQ(parsed_as<InitCommand>({"init", "a.stl", "--unit", "in"}).unit, "in");
  EXPECT_EQ(parsed_as<InitCommand>({"init", "a.stl", "--scale", "2"}).scale, 2);
  EXPECT_EQ(parsed_as<InitCommand>({"init", "a.stl", "-o", "-"}).output, "-");
  EXPECT_FALSE(parsed_as<InitCommand>({"init", "a.stl"}).force);
}

TEST_F(CommandOptions, have_the_defaults_that_help_tells) {
  EXPECT_THAT(help_words({"run"}), AllOf(HasSubstr("unit of distance (default 0.3)"),
                                         HasSubstr("more elements (default 2000000000)"),
                                         HasSubstr("any that export writes (default vtkhdf)"),
                                         HasSubstr("continue in it (default out)"),
                                         HasSubstr("after Ctrl-C (default 5)")));
  EXPECT_THAT(help_words({"quality"}), HasSubstr("rest goes to disk (default 256MiB)"));
  EXPECT_THAT(help_words({"export"}), AllOf(HasSubstr("by METIS (default as-meshed)"),
                                            HasSubstr("Cuthill-McKee (default as-meshed)")));
  EXPECT_THAT(
      help_words({"render"}),
      AllOf(HasSubstr("its cells (default surface)"), HasSubstr("by (default subdomain)"),
            HasSubstr("pixels (default 1600x1000)"),
            HasSubstr("viewer (default -1,-2,1; of a slice"), HasSubstr("picture (default 0,0,1)"),
            HasSubstr("fits the picture (default 1)"), HasSubstr("cut or slice (default 0,1,0)"),
            HasSubstr("apart (default 0.4)"), HasSubstr("for none (default 0.9; over a field 0)"),
            HasSubstr("bands (default 20)"), HasSubstr("at a node (default 1)")));
  EXPECT_THAT(help_words({"shape"}), AllOf(HasSubstr("on the wing itself (default 0.1)"),
                                           HasSubstr("away from the wing (default 0.2)")));
  EXPECT_THAT(help_words({"convert"}), HasSubstr("all coordinates (default 1)"));
  EXPECT_THAT(help_words({"spacing"}), HasSubstr("off the wall (default 1)"));
  EXPECT_THAT(help_words({"submit"}), HasSubstr("wait for an answer (default 10)"));
}

TEST_F(CommandOptions, of_the_program_tell_its_exit_codes_and_commands) {
  const std::string help = help_words({});
  EXPECT_THAT(help, HasSubstr("Exit codes: 0 done; 1 failed; 2 invalid command line or job file; "
                              "3 bad geometry; 4 done, but below the quality gate; 5 not found or "
                              "unreachable; 6 out of disk or memory; 75 stopped at a checkpoint: "
                              "run the same command again to continue."));
  for (const char* command :
       {"run",      "check",  "gc",         "plan",    "quality", "export",   "convert",
        "surface",  "render", "shape",      "submit",  "wait",    "cancel",   "jobs",
        "priority", "status", "tasks",      "workers", "events",  "logs",     "explain",
        "trace",    "report", "backup",     "restore", "retry",   "drain",    "coordinator",
        "worker",   "pool",   "keys",       "spacing", "plane",   "adapt",    "transfer",
        "loop",     "man",    "completion", "version", "init",    "dashboard"}) {
    EXPECT_THAT(help, HasSubstr(std::string(" ") + command + " ")) << command;
    EXPECT_THAT(help_words({command}), AllOf(HasSubstr("--help"))) << command;
  }
}

}  // namespace
}  // namespace tetfarm
