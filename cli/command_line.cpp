#include "cli/command_line.h"

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <map>

#include "base/error.h"
#include "base/program_version.h"
#include "cli/about_command_line.h"
#include "cli/client_options.h"
#include "cli/command_purposes.h"
#include "cli/doctor_command_line.h"
#include "cli/exit_codes.h"
#include "cli/keys_command_line.h"
#include "cli/option_checks.h"
#include "cli/plane_command_line.h"
#include "cli/pool_command_line.h"
#include "cli/render_command_line.h"
#include "cli/service_command_line.h"
#include "cli/unknown_words.h"
#include "cli/view_command_line.h"
#include "mesh/formats/registry/export_mesh.h"
#include "mesh/formats/registry/open_mesh.h"
#include "mesh/formats/surfaces/surface_formats.h"
#include "mesh/job_file/job_file.h"
#include "mesh/job_file/job_formats.h"
#include "mesh/shapes/make_shape.h"
#include "store/rows.h"

namespace tetfarm {
namespace {

std::string a_mesh() {
  return "A mesh (" + readable_meshes() + "), the output folder of a run, or a job (job-7)";
}

const std::map<std::string, ProgressStyle> progress_styles = {{"auto", ProgressStyle::automatic},
                                                              {"text", ProgressStyle::automatic},
                                                              {"plain", ProgressStyle::plain},
                                                              {"none", ProgressStyle::none},
                                                              {"json", ProgressStyle::json}};

void add_progress(CLI::App& app, ProgressStyle& style) {
  app.add_option("--progress", style,
                 "text: a bar on a terminal, otherwise plain; plain: lines; none: nothing; json: "
                 "JSON on standard error, one object per line (default text)")
      ->transform(CLI::CheckedTransformer(progress_styles))
      ->option_text("text|plain|none|json");
}

/// @param more of its help
CLI::Option* add_layers(CLI::App& app, std::vector<std::string>& layers, const std::string& more) {
  return app
      .add_option(
          "--layers", layers,
          "Boundary layers on patches, such as 'wing_*,tip:first=1e-4,growth=1.2,count=20'; "
          "quotes keep the shell from taking * for files; may be repeated" +
              more)
      ->allow_extra_args(false)
      ->option_text("PATCH,...:KEY=VALUE,...");
}

CLI::Option* add_pml(CLI::App& app, std::string& pml) {
  return app
      .add_option("--pml", pml,
                  "Absorbing layers outside of the outer boundary, such as 'outer:layers=10', with "
                  "height=H, elements=prisms or tets, corners=block for blocks round a box, and "
                  "side=inside to keep the boundary")
      ->option_text("PATCH,...[:KEY=VALUE,...]");
}

CLI::Option* add_patch_types(CLI::App& app, std::vector<std::string>& types) {
  return app
      .add_option("--patch-type", types,
                  "What patches are to a solver, such as 'wing_*,tip=wall': wall, slip, symmetry, "
                  "farfield, inflow, outflow, pec, pmc, absorbing or interface; may be repeated")
      ->allow_extra_args(false)
      ->option_text("PATCH,...=TYPE");
}

CLI::Option* add_patch_sizes(CLI::App& app, std::vector<std::string>& sizes) {
  return app
      .add_option("--patch-size", sizes,
                  "Target edge length at patches, such as 'wing_*,tip=0.01', or =0.01:0.2 with the "
                  "growth away from them (default --growth); may be repeated")
      ->allow_extra_args(false)
      ->option_text("PATCH,...=H[:G]");
}

/// What the coordinates of the surface are multiplied by, in two ways.
template <class Options>
std::array<CLI::Option*, 2> add_scale(CLI::App& app, Options& options) {
  CLI::Option* scale =
      app.add_option("--scale", options.scale,
                     "Multiply the surface's coordinates by this; all lengths are of the result")
          ->check(positive_number())
          ->option_text("F");
  return {scale, app.add_option("--unit", options.unit,
                                "The unit of the surface's file: the job, and the mesh, are in "
                                "metres then")
                     ->check(suggested(length_units()))
                     ->excludes(scale)
                     ->option_text("mm|cm|in|...")};
}

/// What says how long edges are in place of `size`.
std::array<CLI::Option*, 3> add_wave(CLI::App& app, WaveOptions& wave, CLI::Option& size) {
  return {app.add_option("--frequency", wave.frequency,
                         "In place of --size: a wavelength's share, for waves of this frequency")
              ->check(frequency())
              ->excludes(&size)
              ->option_text("1.2GHz"),
          app.add_option("--wave-speed", wave.speed,
                         "With --frequency: lengths of the surface's unit a second (default light "
                         "in metres, 299792458)")
              ->check(positive_number())
              ->excludes(&size)
              ->option_text("C"),
          app.add_option("--per-wavelength", wave.per_wavelength,
                         "With --frequency: edges to a wavelength (default 10)")
              ->check(positive_number())
              ->excludes(&size)
              ->option_text("N")};
}

/// How large the domain is and how fine.
template <class Options>
std::array<CLI::Option*, 13> add_domain(CLI::App& app, Options& job) {
  CLI::Option* size = app.add_option("--size", job.size,
                                     "Target edge length away from the surface, and largest on an "
                                     "outer boundary")
                          ->check(positive_number())
                          ->option_text("H");
  const std::array<CLI::Option*, 3> wave = add_wave(app, job.wave, *size);
  const std::array<CLI::Option*, 2> scale = add_scale(app, job);
  return {
      size,
      wave[0],
      wave[1],
      wave[2],
      scale[0],
      scale[1],
      add_patch_sizes(app, job.patch_sizes),
      app.add_option("--growth", job.growth,
                     "Growth of the edge length per unit of distance (default 0.3)")
          ->check(positive_number())
          ->option_text("G"),
      app.add_option("--outer", job.outer, "Mesh the space around the body, out to this boundary")
          ->option_text("box[:FACTOR]|sphere[:FACTOR]"),
      app.add_option("--outer-size", job.outer_size,
                     "Edge length on the outer boundary (default: as --growth and --size "
                     "allow)")
          ->check(positive_number())
          ->option_text("H"),
      app.add_option("--symmetry", job.symmetry,
                     "The surface is half a body that ends on this plane: mesh one side, closed by "
                     "the plane")
          ->option_text("y=0"),
      app.add_flag("--remesh", job.remesh,
                   "Mesh from even triangles made in place of the surface's (see `surface`)"),
      app.add_option("--size-on-body", job.size_on_body,
                     "With --remesh: edge length on the surface (default: --size, or 1/20 of its "
                     "diagonal)")
          ->check(positive_number())
          ->option_text("H")};
}

void add_job(CLI::App& app, RunOptions& job) {
  app.add_option("INPUT", job.input,
                 "A closed surface (" + readable_surfaces() + "; also .gz) or a job file (.toml)")
      ->required();
  app.add_option("--subdomains", job.subdomains, "Number of sub-domains (default: chosen by size)")
      ->check(whole_number(1, most_subdomains))
      ->option_text("N");
  app.add_option("--groups", job.groups, "Join the sub-domains into this many groups of even work")
      ->check(whole_number(1, most_subdomains))
      ->option_text("N");
  app.add_option("--max-memory", job.max_memory, "Split until each task fits in this much memory")
      ->option_text("2GiB")
      ->excludes("--subdomains")
      ->excludes("--groups");
  add_domain(app, job);
  add_layers(app, job.layers, "");
  add_pml(app, job.pml);
  add_patch_types(app, job.patch_types);
  CLI::Option* most =
      app.add_option("--max-elements", job.max_elements,
                     "Refuse a job that would have more elements (default 2000000000)")
          ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 40))
          ->option_text("N");
  app.add_flag("--force", job.force,
               "Start however many elements are expected and however little disk space is free")
      ->excludes(most);
  app.add_option("--format", job.formats,
                 "Formats to write, any that export writes (default vtkhdf)")
      ->check(suggested(job_output_formats()))
      ->delimiter(',')
      ->option_text("F,...");
  app.add_option("--keep", job.keep,
                 "Files between the tasks to keep: needed (each goes when no task needs it any "
                 "more) or all (default all)")
      ->check(CLI::IsMember({"needed", "all"}))
      ->option_text("needed|all");
}

/// The parser with one sub-command for each Command, and room for what it reads.
class Parser {
 public:
  Parser() {
    app_.require_subcommand(1);
    app_.set_version_flag("--version", std::string("tetfarm ") + program_version);
    app_.footer(exit_codes_text());
    add_run();
    add_check();
    add_plan();
    add_init();
    add_quality();
    add_export();
    add_render(add("render", "Draw a mesh as a PNG picture; no display is needed",
                   "tetfarm render out -o wing.png --view cut --plane 0,1,0 --at 0.5", render_),
               a_mesh() + "; a mesh of the plane (.mesh)", render_);
    add_shape();
    add_spacing();
    add_plane(add("plane", "Mesh the plane between closed loops",
                  "tetfarm plane airfoil.xy farfield.xy -o flow.mesh", plane_),
              plane_);
    add_adapt(
        add("adapt", "Adapt a mesh of the plane to a metric, a solution or sources",
            "tetfarm adapt flow.mesh --solution mach.sol --vertices 5000 -o next.mesh", adapt_),
        adapt_);
    add_loop();
    add_plane_transfer(
        add("transfer", "Bring a solution from one mesh of the plane to another",
            "tetfarm transfer flow.mesh --solution flow.sol --to next.mesh -o next.sol",
            plane_transfer_),
        plane_transfer_);
    add_clients();
    const auto chosen = [this](const Command& command) { command_ = command; };
    add_views(app_, views_, chosen);
    add_services(app_, services_, chosen);
    add_pool(app_, pool_, [this] { command_ = pool_; });
    add_drain();
    add_keys(app_, keys_, [this] { command_ = keys_; });
    add_doctor(
        add("doctor", "Check a machine, its folders, keys and coordinator, and say what to do",
            "tetfarm doctor --store /shared/farm --listen tcp://*:5555", doctor_),
        doctor_);
    add_gc();
    add_copies(app_, views_, chosen);
    add_about(app_, about_, chosen);
    refuse_empty_paths(app_);
    group_by_purpose(app_);
  }

  const CLI::App& app() const { return app_; }

  Command parse(int argc, const char* const* argv) {
    if (argc < 2) std::fputs(commands_by_purpose(declared_command(app_)).c_str(), stderr);
    require_known_command(app_, argc, argv);
    try {
      app_.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
      std::printf("%s", app_.help().c_str());
      return NothingToDo{};
    } catch (const CLI::CallForVersion&) {
      std::printf("tetfarm %s\n", program_version);
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

  void add_loop() {
    CLI::App& sub = add("loop", "Solve and adapt in cycles, on this machine",
                        "tetfarm loop examples/adaptation/shock.toml -o out/shock", loop_);
    sub.add_option("INPUT", loop_.input, "A job file with a [solver] (.toml)")->required();
    sub.add_option("-o,--output", loop_.output, "Folder of the results (default: out)")
        ->option_text("DIR");
    sub.add_option("-j,--workers", loop_.workers, "Worker processes (default: 1)")
        ->check(whole_number(1, 1024))
        ->option_text("N");
    add_local_farm(sub, loop_);
  }

  /// What any command has that runs a job on this machine.
  template <class Options>
  static void add_local_farm(CLI::App& sub, Options& options) {
    sub.add_option("--database", options.database,
                   "Folder for the database, on a local disk (default: in the output folder)")
        ->option_text("DIR");
    sub.add_option("--grace", options.grace_s,
                   "How long running tasks may continue after Ctrl-C (default 5)")
        ->check(not_negative_number())
        ->option_text("SECONDS");
    add_json(sub, options.json);
    add_progress(sub, options.progress);
  }

  void add_run() {
    CLI::App& sub = add("run", "Mesh a surface with worker processes on this machine",
                        "tetfarm run wing.stl -o out -j 4 --outer sphere:10", run_);
    add_job(sub, run_);
    sub.add_option("-o,--output", run_.output,
                   "Output folder; run again to continue in it (default out)")
        ->option_text("DIR");
    sub.add_option("-j,--workers", run_.workers, "Worker processes (default: one per core)")
        ->check(whole_number(1, 4096))
        ->option_text("N");
    CLI::Option* watch =
        sub.add_flag("--watch", run_.is_watched,
                     "Show the run in browsers, as `tetfarm dashboard` does, until it ends");
    sub.add_option("--http", run_.http_address,
                   "With --watch: the address for browsers (default: a free port of this host)")
        ->needs(watch)
        ->option_text("127.0.0.1:8080");
    add_local_farm(sub, run_);
  }

  void add_check() {
    CLI::App& sub =
        add("check", "Check whether a surface can be meshed, and show what is wrong where",
            "tetfarm check wing.stl", check_);
    CLI::Option* input = sub.add_option("INPUT", check_.input, "A surface or a job file (.toml)");
    const std::array<CLI::Option*, 13> domain = add_domain(sub, check_);
    CLI::Option* layers = add_layers(sub, check_.layers, ": shows what they come to");
    CLI::Option* pml = add_pml(sub, check_.pml);
    CLI::Option* patch_types = add_patch_types(sub, check_.patch_types);
    CLI::Option* store = sub.add_option("--store", check_.store,
                                        "Instead, check that the files of this store (or output "
                                        "folder of a run) are present and intact")
                             ->option_text("DIR")
                             ->excludes(input)
                             ->excludes(layers)
                             ->excludes(pml)
                             ->excludes(patch_types);
    for (CLI::Option* option : domain) store->excludes(option);
    sub.add_option("--database", check_.database,
                   "Folder of the store's database (default: the store)")
        ->option_text("DIR")
        ->needs(store);
    sub.add_option("-o,--output", check_.defects_file,
                   "File for the bad triangles (default NAME.defects.vtp)")
        ->option_text("FILE");
    add_json(sub, check_.json);
  }

  void add_gc() {
    CLI::App& sub =
        add("gc", "Remove files that no job needs from a store; no coordinator may be using it",
            "tetfarm gc /shared/farm --dry-run", gc_);
    sub.add_option("STORE", gc_.store, "A store, or the output folder of a run")->required();
    sub.add_option("--database", gc_.database, "Folder of its database (default: the store)")
        ->option_text("DIR");
    sub.add_flag("--dry-run", gc_.dry_run, "Only show what would be removed");
    sub.add_flag("--all-finished", gc_.all_finished,
                 "Keep only the results and the inputs of finished jobs");
    add_json(sub, gc_.json);
  }

  void add_plan() {
    CLI::App& sub = add("plan", "Show what would be done, and what each task would need",
                        "tetfarm plan wing.stl --max-memory 500MB", plan_);
    add_job(sub, plan_.job);
    CLI::Option* store =
        sub.add_option("--store", plan_.job.store,
                       "Estimate times from the tasks of this store (or output folder of a run)")
            ->option_text("DIR");
    sub.add_option("--database", plan_.job.database,
                   "Folder of the store's database (default: the store)")
        ->option_text("DIR")
        ->needs(store);
    add_json(sub, plan_.job.json);
  }

  void add_init() {
    CLI::App& sub = add("init", "Write a job file for a surface, with remarks, to start from",
                        "tetfarm init wing.stl -o wing.toml", init_);
    sub.add_option("SURFACE", init_.surface,
                   "A closed surface (" + readable_surfaces() + "; also .gz)")
        ->required();
    sub.add_option("-o,--output", init_.output,
                   "The job file; - is standard output (default NAME.toml)")
        ->option_text("FILE");
    sub.add_flag("--force", init_.force, "Replace a file that exists");
    add_scale(sub, init_);
  }

  void add_quality() {
    CLI::App& sub = add("quality", "Read a mesh, check it and show its quality",
                        "tetfarm quality out/wing.vtkhdf", quality_);
    sub.add_option("FILE", quality_.input, a_mesh())->required();
    sub.add_option("--run", quality_.run,
                   "Output folder of the run that made the mesh, for its spacing (default: the "
                   "mesh's folder)")
        ->option_text("DIR");
    sub.add_flag("!--no-face-check", quality_.check_faces,
                 "Skip the check that each face has two tets or is a boundary triangle");
    sub.add_option(
           "--memory", quality_.memory,
           "Memory for the check, besides one sub-domain; the rest goes to disk (default 256MiB)")
        ->option_text("SIZE");
    sub.add_option("--scratch", quality_.scratch,
                   "Folder for temporary files (default: the system's)")
        ->option_text("DIR");
    add_place_of_jobs(sub, quality_.source);
    add_json(sub, quality_.json);
  }

  void add_export() {
    CLI::App& mesh = add("export", "Write a mesh in another format, one sub-domain at a time",
                         "tetfarm export out -o wing.lb8l.ugrid", export_);
    mesh.add_option("FILE", export_.input, a_mesh())->required();
    mesh.add_option("-o,--output", export_.output,
                    "The output file, or the folder for a format of several files")
        ->required()
        ->option_text("OUT");
    mesh.add_option("--format", export_.format,
                    "Format, one of those below (default: by the file extension)")
        ->check(suggested(job_output_formats()))
        ->option_text("F");
    mesh.footer("Formats, each with the file extension that selects it:\n" +
                written_formats_text() + mesh.get_footer());
    CLI::Option* partitions =
        mesh.add_option(
                "--partitions", export_.partitions,
                "Parts for a solver: the sub-domains, or N even parts by METIS (default as-meshed)")
            ->transform(number_of_parts(1 << 20))
            ->option_text("as-meshed|N");
    mesh.add_option("--keep-columns", export_.keep_columns,
                    "Whether prisms that stand on one another are in one part (default yes)")
        ->check(CLI::IsMember({"yes", "no"}))
        ->needs(partitions)
        ->option_text("yes|no");
    mesh.add_option("--numbering", export_.numbering,
                    "Numbering of nodes and tets: unchanged; surface, borders, interior along a "
                    "Hilbert curve; reverse Cuthill-McKee (default as-meshed)")
        ->check(CLI::IsMember({"as-meshed", "hilbert", "rcm"}))
        ->option_text("as-meshed|hilbert|rcm");
    add_patch_types(mesh, export_.patch_types);
    add_place_of_jobs(mesh, export_.source);
    add_json(mesh, export_.json);

    add_convert();
    add_surface();
  }

  void add_surface() {
    CLI::App& sub =
        add("surface", "Remesh a surface: even triangles instead of those that CAD wrote",
            "tetfarm surface part.stl -o part_fine.stl --size 2", surface_);
    sub.add_option("IN", surface_.input, "A surface, or a job file with its surface and sources")
        ->required();
    sub.add_option("-o,--output", surface_.output,
                   "The output file: " + writable_surfaces() + " (default NAME.remeshed.stl)")
        ->option_text("OUT");
    CLI::Option* size =
        sub.add_option("--size", surface_.size,
                       "Edge length away from features (default 1/20 of the surface's diagonal)")
            ->check(positive_number())
            ->option_text("H");
    add_wave(sub, surface_.wave, *size);
    add_patch_sizes(sub, surface_.patch_sizes);
    sub.add_option("--min-size", surface_.min_size,
                   "Shortest edge that curvature and narrow places may ask for (default H/16)")
        ->check(positive_number())
        ->option_text("H");
    sub.add_option("--angle", surface_.angle, "Sharper edges are kept, in degrees (default 30)")
        ->check(number_between(1, 179))
        ->option_text("A");
    sub.add_option("--tolerance", surface_.tolerance,
                   "Farthest from the input (default 1/1000 of the diagonal, less on small faces)")
        ->check(positive_number())
        ->option_text("T");
    sub.add_option("--growth", surface_.growth,
                   "Growth of the edge length for each unit of length (default 0.3)")
        ->check(positive_number())
        ->option_text("G");
    sub.add_flag(
        "--heal", surface_.heal,
        "Mend the surface first: cracks, small holes, triangles that are flat, double or in "
        "each other's way");
    sub.add_flag("--heal-only", surface_.heal_only, "Mend it, and keep all other triangles");
    sub.add_option("--heal-tolerance", surface_.heal_tolerance,
                   "Cracks up to this width are closed (default: a millionth of the diagonal)")
        ->check(positive_number())
        ->option_text("T");
    sub.add_option("--largest-hole", surface_.largest_hole,
                   "Fill holes with a border up to this length (default: a tenth of the diagonal)")
        ->check(positive_number())
        ->option_text("L");
    sub.add_option("--defects", surface_.defects_file,
                   "Where the triangles of a bad surface go (default NAME.defects.vtp)")
        ->option_text("FILE");
    add_json(sub, surface_.json);
  }

  void add_convert() {
    CLI::App& sub =
        add("convert", "Write a surface in another format, in finer triangles, or with a box",
            "tetfarm convert wing.msh wing.stl --scale 0.001 --max-edge 0.02", convert_);
    sub.add_option("IN", convert_.input, "The surface")->required();
    sub.add_option("OUT", convert_.output, "The output file: " + writable_surfaces())->required();
    sub.add_option("--scale", convert_.scale, "Multiply all coordinates (default 1)")
        ->check(positive_number())
        ->option_text("F");
    sub.add_option("--max-edge", convert_.max_edge,
                   "Halve edges, of the scaled surface, until none is longer")
        ->check(positive_number())
        ->option_text("H");
    CLI::Option* box =
        sub.add_option("--box", convert_.box,
                       "Put a box round the surface, so far from its bounding box: patch \"outer\"")
            ->check(positive_number())
            ->option_text("MARGIN");
    CLI::Option* box_size =
        sub.add_option("--box-size", convert_.box_size, "Edge length on the box")
            ->check(positive_number())
            ->needs(box)
            ->option_text("H");
    box->needs(box_size);
    add_json(sub, convert_.json);
  }

  void add_shape() {
    CLI::App& sub = add("shape", "Write a closed surface to try things out on",
                        "tetfarm shape wing -o wing.stl --spacing 0.05", shape_);
    sub.add_option("KIND", shape_.name, "The shape")
        ->required()
        ->check(CLI::IsMember(shape_names()));
    sub.add_option("-o,--output", shape_.output, "The output file: " + writable_surfaces())
        ->required()
        ->option_text("FILE");
    sub.add_option("--spacing", shape_.spacing,
                   "Edge length; for the wing, on the wing itself (default 0.1)")
        ->check(positive_number())
        ->option_text("H");
    sub.add_option("--growth", shape_.growth,
                   "Growth of the edge length away from the wing (default 0.2)")
        ->check(positive_number())
        ->option_text("G");
  }

  void add_spacing() {
    CLI::App& sub = add("spacing", "Show how high the first boundary layer has to be for a y+",
                        "tetfarm spacing --y-plus 1 --reynolds 6e6 --length 1", spacing_);
    sub.add_option("--y-plus", spacing_.y_plus,
                   "Wanted y+ of the first node off the wall (default 1)")
        ->check(number_between(1e-3, 1e4))
        ->option_text("Y");
    sub.add_option("--reynolds", spacing_.reynolds, "Reynolds number of the length")
        ->required()
        ->check(number_between(1e3, 1e12))
        ->option_text("RE");
    sub.add_option("--length", spacing_.length, "Distance from the leading edge of the flat plate")
        ->required()
        ->check(positive_number())
        ->option_text("L");
    add_json(sub, spacing_.json);
  }

  void add_clients() {
    CLI::App& submit =
        add("submit", "Submit a job to a coordinator",
            "tetfarm submit wing.stl --connect tcp://head:5555 --key anna.key", submit_);
    add_job(submit, submit_.job);
    submit
        .add_option("--store", submit_.job.store,
                    "The coordinator's store, as seen from here, to put the surface in (default: "
                    "send it over the connection)")
        ->envname("TETFARM_STORE")
        ->option_text("DIR");
    submit.add_flag("!--no-check", submit_.check, "Do not check the surface here: the farm will");
    submit
        .add_flag("--coordinator-reads", submit_.coordinator_reads,
                  "Send only the surface's path: the coordinator reads the file, which must be in "
                  "one of its --allow-root folders")
        ->excludes("--store");
    submit
        .add_option("--priority", submit_.priority,
                    "Tasks of jobs with a higher one are handed out first (-1000 to 1000, default "
                    "0)")
        ->check(CLI::Range(-most_priority, most_priority))
        ->option_text("N");
    submit
        .add_option("--after", submit_.after,
                    "Job that has to be done before this one begins, job-7 (default: none); may be "
                    "repeated")
        ->allow_extra_args(false)
        ->option_text("JOB");
    add_progress(submit, submit_.client.progress);
    add_client(submit, submit_.client, StoreOption::yes);

    CLI::App& wait = add("wait", "Wait until a job ends; the exit code is the job's",
                         "tetfarm wait job-7 -o out --connect tcp://head:5555", wait_);
    wait.add_option("JOB", wait_.client.job, "The job")->required();
    wait.add_option("-o,--output", wait_.client.output, "Folder to put the result in")
        ->option_text("DIR");
    wait.add_option(
            "--store", wait_.store,
            "The coordinator's store, as seen from here (default: fetch files over the connection)")
        ->envname("TETFARM_STORE")
        ->option_text("DIR");
    add_client(wait, wait_.client, StoreOption::yes);
    add_progress(wait, wait_.client.progress);

    CLI::App& cancel = add("cancel", "Cancel a job", "tetfarm cancel job-7", cancel_);
    cancel.add_option("JOB", cancel_.client.job, "The job")->required();
    add_client(cancel, cancel_.client, StoreOption::no);

    add_priority();
    add_retry();
  }

  void add_priority() {
    CLI::App& priority = add("priority", "Hand out a job's tasks before or after those of others",
                             "tetfarm priority job-7 10", priority_);
    priority.add_option("JOB", priority_.client.job, "The job")->required();
    priority
        .add_option(
            "N", priority_.priority,
            "Tasks of jobs with a higher one are handed out first (-1000 to 1000; jobs have "
            "0 unless submitted with --priority)")
        ->check(CLI::Range(-most_priority, most_priority))
        ->required();
    add_client(priority, priority_.client, StoreOption::no);
  }

  void add_retry() {
    CLI::App& retry = add("retry", "Take failed tasks, or a host, out of quarantine",
                          "tetfarm retry job-7 31", retry_);
    CLI::Option* job = retry.add_option("JOB", retry_.client.job, "The job");
    retry.add_option("TASK", retry_.task, "One task (default: all of the job)")
        ->check(counting_number());
    retry.add_option("--host", retry_.host, "A host instead of a job")
        ->excludes(job)
        ->option_text("NAME");
    add_client(retry, retry_.client, StoreOption::no);
  }

  void add_drain() {
    CLI::App& drain =
        add("drain", "Let workers finish their tasks and leave", "tetfarm drain worker-7", drain_);
    CLI::Option* worker = drain.add_option(
        "WORKER", drain_.worker, "A worker's name, as `tetfarm status --workers` shows it");
    drain.add_flag("--all", drain_.all, "All workers that are connected now")->excludes(worker);
    add_client(drain, drain_.client, StoreOption::no);
  }

  CLI::App app_{"Tetfarm: conforming tetrahedral meshes, made on many machines that may fail",
                "tetfarm"};
  Command command_;
  RunOptions run_;
  CheckOptions check_;
  GcCommand gc_;
  PlanCommand plan_;
  InitCommand init_;
  QualityOptions quality_;
  ExportCommand export_;
  ConvertCommand convert_;
  SurfaceCommand surface_;
  RenderCommand render_;
  ShapeCommand shape_;
  SpacingCommand spacing_;
  PlaneCommand plane_;
  AdaptCommand adapt_;
  LoopCommand loop_;
  PlaneTransferCommand plane_transfer_;
  SubmitCommand submit_;
  Views views_;
  WaitCommand wait_;
  CancelCommand cancel_;
  PriorityCommand priority_;
  RetryCommand retry_;
  DrainCommand drain_;
  Services services_;
  PoolCommand pool_;
  KeysCommand keys_;
  DoctorCommand doctor_;
  About about_;
};

}  // namespace

Command parse_command_line(int argc, const char* const* argv) { return Parser().parse(argc, argv); }

DeclaredCommand declared_commands() { return declared_command(Parser().app()); }

}  // namespace tetfarm
