#include "cli/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>

#include "base/error.h"
#include "cli/client_options.h"
#include "cli/keys_command_line.h"
#include "cli/option_checks.h"
#include "cli/pool_command_line.h"
#include "cli/service_command_line.h"
#include "cli/unknown_words.h"
#include "cli/view_command_line.h"
#include "mesh/shapes/make_shape.h"

namespace tetfarm {
namespace {

constexpr const char* exit_codes =
    "Exit codes: 0 done; 1 failed; 2 wrong command line or job file; 3 bad geometry;\n"
    "4 done, but below the quality gate; 5 not found or unreachable; 6 out of disk or memory;\n"
    "75 stopped at a checkpoint: the same command goes on.";

constexpr const char* a_mesh =
    "A mesh (.vtkhdf .ugrid .cgns .msh .su2 .meshb .pvtu .vtu .node .ele), the folder of a run, or "
    "a job (job-7)";

const std::map<std::string, ProgressStyle> progress_styles = {{"auto", ProgressStyle::automatic},
                                                              {"plain", ProgressStyle::plain},
                                                              {"none", ProgressStyle::none}};

void add_progress(CLI::App& app, ProgressStyle& style) {
  app.add_option("--progress", style, "auto: a bar on a terminal, else lines; plain; none")
      ->transform(CLI::CheckedTransformer(progress_styles))
      ->option_text("auto|plain|none");
}

void add_job(CLI::App& app, RunOptions& job) {
  app.add_option("INPUT", job.input,
                 "A closed surface (.stl .obj .off .msh .ply .ugrid .su2 .mesh .meshb .poly .smesh "
                 ".fro, also .gz) or a job.toml")
      ->required();
  app.add_option("--subdomains", job.subdomains, "Number of sub-domains (default: by size)")
      ->check(whole_number(1, std::int64_t{1} << 40))
      ->option_text("N");
  app.add_option("--groups", job.groups, "Join the sub-domains into this many, of even work")
      ->check(whole_number(1, std::int64_t{1} << 30))
      ->option_text("N");
  app.add_option("--max-memory", job.max_memory, "So many sub-domains that no task needs more")
      ->option_text("2GiB")
      ->excludes("--subdomains")
      ->excludes("--groups");
  app.add_option("--size", job.size,
                 "Target edge length away from the surface, and at most on an outer boundary")
      ->check(positive_number())
      ->option_text("H");
  app.add_option("--growth", job.growth, "Growth of the edge length per unit of length (0.3)")
      ->check(positive_number())
      ->option_text("G");
  app.add_option("--outer", job.outer, "Mesh the outside of the body, up to this boundary")
      ->option_text("box[:FACTOR]|sphere[:FACTOR]");
  app.add_option("--outer-size", job.outer_size,
                 "Edge length on the outer boundary (default: as growth and --size allow)")
      ->check(positive_number())
      ->option_text("H");
  CLI::Option* most = app.add_option("--max-elements", job.max_elements,
                                     "Refuse a job that would have more elements (2000000000)")
                          ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 40))
                          ->option_text("N");
  app.add_flag("--force", job.force,
               "Start it however many elements it has, and whatever room the disk has")
      ->excludes(most);
  app.add_option("--format", job.formats, "Formats to write, all that export knows (vtkhdf)")
      ->delimiter(',')
      ->option_text("F,...");
}

/// The parser with one sub-command for each Command, and room for what it reads.
class Parser {
 public:
  Parser() {
    app_.require_subcommand(1);
    app_.set_version_flag("--version", "tetfarm 0.1.0");
    app_.footer(exit_codes);
    add_run();
    add_check();
    add_gc();
    add_plan();
    add_quality();
    add_export();
    add_render();
    add_shape();
    add_clients();
    add_viewers();
    add_operators();
    add_services(app_, services_, [this](const Command& command) { command_ = command; });
    add_pool(app_, pool_, [this] { command_ = pool_; });
    add_keys(app_, keys_, [this] { command_ = keys_; });
    refuse_empty_paths(app_);
  }

  Command parse(int argc, const char* const* argv) {
    require_known_command(app_, argc, argv);
    try {
      app_.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
      std::printf("%s", app_.help().c_str());
      return NothingToDo{};
    } catch (const CLI::CallForVersion&) {
      std::printf("tetfarm 0.1.0\n");
      return NothingToDo{};
    } catch (const CLI::ParseError& error) {
      throw UsageError(what_is_wrong(app_, error), "");
    }
    return command_;
  }

 private:
  /// A sub-command whose options live in `options` and become the result.
  template <class Options>
  CLI::App& add(const std::string& name, const std::string& what, const std::string& example,
                Options& options) {
    return add_command(app_, name, what, example, options,
                       [this](const Command& chosen) { command_ = chosen; });
  }

  void add_run() {
    CLI::App& sub = add("run", "Mesh a surface with worker processes on this machine",
                        "tetfarm run wing.stl -o out -j 4 --outer sphere:10", run_);
    add_job(sub, run_);
    sub.add_option("-o,--output", run_.output, "Folder of the result; run again to go on (out)")
        ->option_text("DIR");
    sub.add_option("-j,--workers", run_.workers, "Worker processes (default: one a core)")
        ->check(whole_number(1, 4096))
        ->option_text("N");
    sub.add_option("--database", run_.database,
                   "Folder of the database, on a disk of this host (default: in the output)")
        ->option_text("DIR");
    sub.add_option("--grace", run_.grace_s, "How long running tasks may go on after Ctrl-C (5)")
        ->check(not_negative_number())
        ->option_text("SECONDS");
    add_json(sub, run_.json);
    add_progress(sub, run_.progress);
  }

  void add_check() {
    CLI::App& sub = add("check", "Say whether a surface can be meshed, and what is wrong where",
                        "tetfarm check wing.stl", check_);
    CLI::Option* input = sub.add_option("INPUT", check_.input, "A surface or a job.toml");
    CLI::Option* store =
        sub.add_option("--store", check_.store,
                       "Instead: are the files of this store (or folder of a run) there and whole?")
            ->option_text("DIR")
            ->excludes(input);
    sub.add_option("--database", check_.database, "Folder of the store's database")
        ->option_text("DIR")
        ->needs(store);
    sub.add_option("-o,--output", check_.defects_file,
                   "Where the bad triangles go (NAME.defects.vtp)")
        ->option_text("FILE");
    add_json(sub, check_.json);
  }

  void add_gc() {
    CLI::App& sub = add("gc", "Remove from a store what no job needs; no coordinator may run on it",
                        "tetfarm gc /shared/farm --dry-run", gc_);
    sub.add_option("STORE", gc_.store, "A store, or the folder of a run")->required();
    sub.add_option("--database", gc_.database, "Folder of its database (default: the store)")
        ->option_text("DIR");
    sub.add_flag("--dry-run", gc_.dry_run, "Only say what would be removed");
    sub.add_flag("--all-finished", gc_.all_finished,
                 "Of finished jobs keep the results and what they were made from only");
    add_json(sub, gc_.json);
  }

  void add_plan() {
    CLI::App& sub = add("plan", "Say what would be done, and what each task would take",
                        "tetfarm plan wing.stl --max-memory 500MB", plan_);
    add_job(sub, plan_.job);
    CLI::Option* store =
        sub.add_option("--store", plan_.job.store,
                       "Learn from what the tasks of this store (or folder of a run) took")
            ->option_text("DIR");
    sub.add_option("--database", plan_.job.database, "Folder of the store's database")
        ->option_text("DIR")
        ->needs(store);
    add_json(sub, plan_.job.json);
  }

  void add_quality() {
    CLI::App& sub = add("quality", "Read a mesh back, check it and show its quality",
                        "tetfarm quality out/wing.vtkhdf", quality_);
    sub.add_option("FILE", quality_.input, a_mesh)->required();
    sub.add_option("--run", quality_.run,
                   "The folder of the run that made it, for its spacing (default: where it lies)")
        ->option_text("DIR");
    sub.add_flag("!--no-face-check", quality_.check_faces,
                 "Leave out whether each face has two tets or is a boundary triangle");
    sub.add_option("--memory", quality_.memory,
                   "For the check, besides one sub-domain; the rest lies on disk (256MiB)")
        ->option_text("SIZE");
    sub.add_option("--scratch", quality_.scratch,
                   "Where that lies for the time (the system's folder for temporary files)")
        ->option_text("DIR");
    add_place_of_jobs(sub, quality_.source);
    add_json(sub, quality_.json);
  }

  void add_export() {
    CLI::App& mesh = add("export", "Write a mesh in another format, a sub-domain at a time",
                         "tetfarm export out -o wing.lb8l.ugrid", export_);
    mesh.add_option("FILE", export_.input, a_mesh)->required();
    mesh.add_option("-o,--output", export_.output, "The file, or the folder of a format of many")
        ->required()
        ->option_text("OUT");
    mesh.add_option("--format", export_.format, "As docs/file_formats.md names it (by the ending)")
        ->option_text("F");
    mesh.add_option("--partitions", export_.partitions,
                    "Parts for a solver: the sub-domains, or N even ones by METIS (as-meshed)")
        ->transform(number_of_parts(1 << 20))
        ->option_text("as-meshed|N");
    mesh.add_option(
            "--numbering", export_.numbering,
            "Of nodes and tets: as it is; surface, borders, inside along the Hilbert curve; "
            "reverse Cuthill-McKee (as-meshed)")
        ->check(CLI::IsMember({"as-meshed", "hilbert", "rcm"}))
        ->option_text("as-meshed|hilbert|rcm");
    add_place_of_jobs(mesh, export_.source);
    add_json(mesh, export_.json);

    CLI::App& surface = add("convert", "Write a surface in another format",
                            "tetfarm convert wing.msh wing.stl", convert_);
    surface.add_option("IN", convert_.input, "A surface")->required();
    surface.add_option("OUT", convert_.output, "Its ending tells the format")->required();
    add_json(surface, convert_.json);
  }

  void add_render() {
    CLI::App& sub =
        add("render", "Draw a mesh into a PNG picture; no display is needed",
            "tetfarm render out -o wing.png --view cut --plane 0,1,0 --at 0.5", render_);
    const auto place = [&sub](const char* name, std::vector<double>& value, const char* what) {
      sub.add_option(name, value, what)->delimiter(',')->expected(3)->option_text("X,Y,Z");
    };
    sub.add_option("FILE", render_.input,
                   "A mesh (.vtkhdf, .lb8.ugrid), the folder of a run, or a job (job-7)")
        ->required();
    add_place_of_jobs(sub, render_.source);
    sub.add_option("-o,--output", render_.output, "The picture")->required()->option_text("PNG");
    sub.add_option("--view", render_.view,
                   "The surface, the sub-domains apart, or the mesh cut open")
        ->check(CLI::IsMember({"surface", "exploded", "cut"}))
        ->option_text("surface|exploded|cut");
    sub.add_option("--colour", render_.colour, "What has a colour each (subdomain)")
        ->check(CLI::IsMember({"subdomain", "region", "patch"}))
        ->option_text("subdomain|region|patch");
    sub.add_option("--size", render_.size, "In pixels (1600x1000)")->option_text("WxH");
    place("--from", render_.from, "Direction from the mesh to the eye (-1,-2,1)");
    place("--up", render_.up, "Direction that is up in the picture (0,0,1)");
    sub.add_option("--zoom", render_.zoom, "Larger than what fits (1)")
        ->check(positive_number())
        ->option_text("Z");
    sub.add_option("--body", render_.bodies, "Patches that are shown whole (all but outer_*)")
        ->delimiter(',')
        ->option_text("PATCH,...");
    sub.add_option("--hide", render_.hidden, "Patches that are not shown")
        ->delimiter(',')
        ->option_text("PATCH,...");
    place("--plane", render_.plane, "Normal of the plane of a cut (0,1,0)");
    sub.add_option("--at", render_.at, "Place of the plane along its normal (the middle)")
        ->option_text("D");
    sub.add_option("--explode", render_.explode, "How far apart the sub-domains go (0.4)")
        ->check(not_negative_number())
        ->option_text("SHARE");
    sub.add_option("--edges", render_.edge_width, "Width of the edges in pixels, 0: none (0.9)")
        ->check(not_negative_number())
        ->option_text("W");
  }

  void add_shape() {
    CLI::App& sub = add("shape", "Write a closed surface to try things on",
                        "tetfarm shape wing -o wing.stl --spacing 0.05", shape_);
    sub.add_option("KIND", shape_.name, "What to make")
        ->required()
        ->check(CLI::IsMember(shape_names()));
    sub.add_option("-o,--output", shape_.output, "A .stl, with patches, or a .off, without")
        ->required()
        ->option_text("FILE");
    sub.add_option("--spacing", shape_.spacing, "Edge length; of the wing: on it (0.1)")
        ->check(positive_number())
        ->option_text("H");
    sub.add_option("--growth", shape_.growth, "Of the edge length away from the wing (0.2)")
        ->check(positive_number())
        ->option_text("G");
  }

  void add_clients() {
    CLI::App& submit =
        add("submit", "Hand a job to a coordinator",
            "tetfarm submit wing.stl --connect tcp://head:5555 --key anna.key", submit_);
    add_job(submit, submit_.job);
    submit
        .add_option("--store", submit_.job.store,
                    "The coordinator's store, as seen from here, to put the surface into (default: "
                    "the surface goes over the connection)")
        ->envname("TETFARM_STORE")
        ->option_text("DIR");
    submit.add_flag("!--no-check", submit_.check,
                    "Leave it to the farm to find out whether the surface can be meshed");
    submit
        .add_flag("--coordinator-reads", submit_.coordinator_reads,
                  "Send only the surface's path: the coordinator reads the file, if it lies where "
                  "its --allow-root says")
        ->excludes("--store");
    add_progress(submit, submit_.client.progress);
    add_client(submit, submit_.client, StoreOption::yes);

    CLI::App& wait = add("wait", "Wait until a job ends; its exit code is the job's",
                         "tetfarm wait job-7 -o out --connect tcp://head:5555", wait_);
    wait.add_option("JOB", wait_.client.job, "The job")->required();
    wait.add_option("-o,--output", wait_.client.output, "Folder to bring the result to")
        ->option_text("DIR");
    wait.add_option("--store", wait_.store,
                    "The coordinator's store, as seen from here (default: files come over the "
                    "connection)")
        ->envname("TETFARM_STORE")
        ->option_text("DIR");
    add_client(wait, wait_.client, StoreOption::yes);
    add_progress(wait, wait_.client.progress);

    CLI::App& cancel = add("cancel", "Cancel a job", "tetfarm cancel job-7", cancel_);
    cancel.add_option("JOB", cancel_.client.job, "The job")->required();
    add_client(cancel, cancel_.client, StoreOption::no);
  }

  void add_viewers() {
    add_views(app_, views_, [this](const Command& command) { command_ = command; });
  }

  void add_operators() {
    CLI::App& retry = add("retry", "Take failed tasks, or a host, out of quarantine",
                          "tetfarm retry job-7 31", retry_);
    CLI::Option* job = retry.add_option("JOB", retry_.client.job, "The job");
    retry.add_option("TASK", retry_.task, "One task (default: all of the job)")
        ->check(counting_number());
    retry.add_option("--host", retry_.host, "A host instead of a job")
        ->excludes(job)
        ->option_text("NAME");
    add_client(retry, retry_.client, StoreOption::no);

    CLI::App& drain = add("drain", "Let workers finish what they do, and leave",
                          "tetfarm drain worker-7", drain_);
    CLI::Option* worker =
        drain.add_option("WORKER", drain_.worker, "As `status --workers` names it");
    drain.add_flag("--all", drain_.all, "Every worker that is here now")->excludes(worker);
    add_client(drain, drain_.client, StoreOption::no);
  }

  CLI::App app_{"Tetfarm: conforming tetrahedral meshes on many machines that may fail", "tetfarm"};
  Command command_;
  RunOptions run_;
  CheckOptions check_;
  GcCommand gc_;
  PlanCommand plan_;
  QualityOptions quality_;
  ExportCommand export_;
  ConvertCommand convert_;
  RenderCommand render_;
  ShapeCommand shape_;
  SubmitCommand submit_;
  Views views_;
  WaitCommand wait_;
  CancelCommand cancel_;
  RetryCommand retry_;
  DrainCommand drain_;
  Services services_;
  PoolCommand pool_;
  KeysCommand keys_;
};

}  // namespace

Command parse_command_line(int argc, const char* const* argv) { return Parser().parse(argc, argv); }

}  // namespace tetfarm
