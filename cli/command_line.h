/// The command line: what can be asked of the program, parsed into plain options.
///
/// The only unit that knows CLI11. Exit codes are those of base/error.h.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/declared_command.h"
#include "proto/peer_security.h"

namespace tetfarm {

/// `automatic`: a bar on a terminal, otherwise `plain`, which is lines of text.
enum class ProgressStyle { automatic, plain, none, json };

/// Edge lengths by the wavelength. What is not given is as the job file says, or as of WaveSize.
struct WaveOptions {
  std::string frequency;  ///< "1.2GHz"; "": none
  std::optional<double> speed;
  std::optional<double> per_wavelength;
};

struct RunOptions {
  std::string input;  ///< a surface, or a job file (.toml)
  std::string output = "out";
  int workers = 0;  ///< 0: one a core
  std::optional<std::int64_t> subdomains;
  std::optional<std::int64_t> groups;  ///< to assimilate the sub-domains into
  std::string max_memory;              ///< "2GiB"; "": no limit
  std::optional<double> size;
  WaveOptions wave;
  std::optional<double> growth;
  bool remesh = false;                 ///< the surface, before it is inspected
  std::optional<double> size_on_body;  ///< of the edges that remeshing makes
  std::optional<std::string> outer;    ///< "none", "box[:FACTOR]", "sphere[:FACTOR]"
  std::optional<double> outer_size;
  std::string symmetry;                  ///< "y=0"; "": as the job file says
  std::vector<std::string> layers;       ///< each "PATCH,...:KEY=VALUE,..."
  std::string pml;                       ///< the same, or "PATCH,..."; "": as the job file says
  std::vector<std::string> patch_types;  ///< each "PATCH,...=TYPE"
  std::vector<std::string> patch_sizes;  ///< each "PATCH,...=SIZE[:GROWTH]"
  std::optional<double> scale;           ///< of the surface's coordinates
  std::string unit;                      ///< in place of `scale`: of the surface, "mm"
  std::optional<std::int64_t> max_elements;
  bool force = false;  ///< any number of elements, whatever the disk holds
  std::vector<std::string> formats;
  std::string keep;  ///< "needed" or "all"; "": as the job file says
  bool json = false;
  ProgressStyle progress = ProgressStyle::automatic;
  std::string store;     ///< of submit: the daemon's store; of run: OUTPUT/.tetfarm
  std::string database;  ///< of run: folder of the database, "": the store
  double grace_s = 5;
  bool runs_solvers = false;                 ///< not for people: the job is a loop
  bool is_watched = false;                   ///< of run: browsers see it
  std::string http_address = "127.0.0.1:0";  ///< where; a free port
};

struct CheckOptions {
  std::string input;
  std::optional<double> size;  ///< this and what follows: as of RunOptions
  WaveOptions wave;
  std::optional<double> growth;
  bool remesh = false;
  std::optional<double> size_on_body;
  std::optional<std::string> outer;
  std::optional<double> outer_size;
  std::string symmetry;
  std::vector<std::string> layers;
  std::string pml;
  std::vector<std::string> patch_types;
  std::vector<std::string> patch_sizes;
  std::optional<double> scale;
  std::string unit;
  std::string defects_file;  ///< a file or a folder; "": NAME.defects.vtp here
  std::string store;         ///< instead of an input: a store or the folder of a run
  std::string database;      ///< of the store: the folder of its database, "": the store
  bool json = false;
};

/// What would run, without running it.
struct PlanCommand {
  RunOptions job;
};

/// status, wait, cancel and submit talk to a running coordinator.
struct ClientOptions {
  std::string endpoint;
  KeyFiles keys;
  std::string job;  ///< "": all
  bool json = false;
  double timeout_s = 10;
  std::string output;  ///< of wait: where the files go
  ProgressStyle progress = ProgressStyle::automatic;
};
/// Where to look: a coordinator, or the store's own rows when no coordinator answers.
struct ViewOptions {
  ClientOptions client;
  std::string store;      ///< "": only the coordinator
  std::string database;   ///< folder of the database; "": the store
  bool is_quiet = false;  ///< does not say on standard error who answered
};

struct QualityOptions {
  std::string input;   ///< a mesh, the folder of a run, or a job of `source`
  ViewOptions source;  ///< of a job
  std::string run;     ///< the folder of the run that made it; "": where it lies
  bool check_faces = true;
  std::string memory = "256MiB";  ///< for comparing what is apart in the file
  std::string scratch;            ///< a folder for what does not fit; "": the system's
  bool json = false;
};

/// A mesh in another format.
struct ExportCommand {
  std::string input;   ///< as of QualityOptions
  ViewOptions source;  ///< of a job
  std::string output;
  std::string format;                    ///< "": by the ending of the output
  int partitions = 0;                    ///< for solvers; 0: the sub-domains as they were meshed
  std::string keep_columns = "yes";      ///< yes or no: columns of prisms in one part
  std::string numbering = "as-meshed";   ///< as-meshed, hilbert or rcm
  std::vector<std::string> patch_types;  ///< as of RunOptions
  bool json = false;
};

/// A surface in another format.
struct ConvertCommand {
  std::string input;
  std::string output;
  double scale = 1;
  double max_edge = 0;  ///< 0: edges stay
  double box = 0;       ///< its distance from the surface; 0: no box
  double box_size = 0;
  bool json = false;
};

/// A job file for a surface.
struct InitCommand {
  std::string surface;
  std::string output;           ///< "": NAME.toml here; "-": standard output
  bool force = false;           ///< replaces a file
  std::optional<double> scale;  ///< this and the next: as of RunOptions
  std::string unit;
};

/// A surface remeshed.
struct SurfaceCommand {
  std::string input;         ///< a surface or a job file
  std::string output;        ///< empty: NAME.remeshed.stl
  std::string defects_file;  ///< as of CheckOptions
  // What is 0 is as the job says, or as with_defaults (mesh/remeshing/remesh_options.h).
  double size = 0;
  WaveOptions wave;
  double min_size = 0;
  double angle = 0;
  double tolerance = 0;
  double growth = 0;
  bool heal = false;          ///< mends it first
  bool heal_only = false;     ///< and does no more
  double heal_tolerance = 0;  ///< this and the next: as of HealOptions
  double largest_hole = 0;
  std::vector<std::string> patch_sizes;  ///< as of RunOptions
  bool json = false;
};

struct RenderCommand {
  std::string input;   ///< as of QualityOptions
  ViewOptions source;  ///< of a job
  std::string output;
  std::string view = "surface";      ///< surface, exploded, cut or slice
  std::string colour = "subdomain";  ///< subdomain, region, patch or layer
  std::string size = "1600x1000";
  std::vector<double> from;  ///< empty: along the plane's normal for a slice, else -1, -2, 1
  std::vector<double> up = {0, 0, 1};
  double zoom = 1;
  std::optional<double> across;  ///< width of the picture; nothing: as zoom says
  std::vector<double> centre;    ///< of the picture, two or three numbers; empty: the middle
  std::vector<std::string> bodies;
  std::vector<std::string> hidden;
  std::vector<double> plane = {0, 1, 0};
  std::optional<double> at;
  double explode = 0.4;
  std::optional<double> edge_width;  ///< nothing: 0.9, or 0 over a field
  std::string field;                 ///< .sol of a mesh of the plane; empty: none
  std::int64_t field_number = 1;     ///< of the numbers at a node
  int levels = 20;
  std::vector<double> range;        ///< lowest and highest; empty: of the field
  std::string metric;               ///< .sol of a mesh of the plane; empty: none
  std::vector<std::int32_t> along;  ///< patches; not empty: a chart
  bool reversed = false;            ///< the chart's y
  std::vector<std::string> also;    ///< "MESH,FIELD" in the same chart
};

struct ShapeCommand {
  std::string name;    ///< one of shape_names()
  std::string output;  ///< .off or .stl
  double spacing = 0.1;
  double growth = 0.2;
};

/// The height of the first layer by the y+ on a flat plate.
struct SpacingCommand {
  double y_plus = 1;
  double reynolds = 0;  ///< of the length
  double length = 0;
  bool json = false;
};

struct StatusCommand {
  ViewOptions view;
  bool workers = false;  ///< a line for each
};
struct WaitCommand {
  ClientOptions client;
  std::string store;
};
struct CancelCommand {
  ClientOptions client;
};
struct PriorityCommand {
  ClientOptions client;
  int priority = 0;
};
struct JobsCommand {
  ViewOptions view;
};
struct TasksCommand {
  ViewOptions view;
  std::string state;  ///< only those; "": all
  std::string kind;
};
struct WorkersCommand {
  ViewOptions view;
  bool all = false;  ///< also those that have left
};
struct EventsCommand {
  ViewOptions view;
  std::uint64_t task = 0;  ///< 0: all
  std::uint32_t last = 50;
  bool all = false;
};
struct LogsCommand {
  ViewOptions view;
  std::string target;  ///< "job-7", or a task's number
};
/// The farm on one screen, again and again.
struct TopCommand {
  ViewOptions view;
  bool once = false;  ///< also where there is a terminal
  double interval_s = 2;
};
/// The farm in browsers.
struct DashboardCommand {
  ViewOptions view;
  std::string http_address = "127.0.0.1:8470";
  std::string http_token;  ///< a file; "": none is asked for
  bool acts = false;       ///< browsers may cancel jobs, and so on
};
struct TraceCommand {
  ViewOptions view;
  std::string output;
};
/// One page about a finished job.
struct ReportCommand {
  ViewOptions view;  ///< its job: one of the store, the folder of a run, or a mesh
  std::string output;
};
/// Of the database, while it is in use or not.
struct BackupCommand {
  std::string store;
  std::string database;  ///< folder; "": the store
  std::string file;
  bool json = false;
};
struct RestoreCommand {
  BackupCommand from;
};
struct ExplainCommand {
  ViewOptions view;
  std::uint64_t task = 0;
};
/// Takes tasks, or a host, out of quarantine.
struct RetryCommand {
  ClientOptions client;
  std::uint64_t task = 0;  ///< 0: all of the job
  std::string host;        ///< instead of a job
};
struct DrainCommand {
  ClientOptions client;
  std::string worker;  ///< "worker-7"
  bool all = false;
};
struct SubmitCommand {
  ClientOptions client;
  RunOptions job;
  bool check = true;               ///< of the surface, before it is submitted
  bool coordinator_reads = false;  ///< the surface, by its path
  int priority = 0;
  std::vector<std::string> after;  ///< jobs that have to be done before
};

struct CoordinatorCommand {
  std::string store;
  std::string database;  ///< "": the store
  std::string keys;      ///< "": see find_keys
  std::vector<std::string> endpoints;
  std::vector<std::string> allowed_roots;
  std::size_t max_connections = 16384;
  std::size_t max_workers = 10'000;
  std::int64_t heartbeat_ms = 1000;
  std::int64_t lease_ms = 10000;
  double task_limit_s = 3600;
  double first_task_limit_s = 86400;
  std::string http_address;       ///< "": none
  std::string http_token;         ///< a file
  std::string on_job_end;         ///< a program that is told of it; "": none
  double keep_days = 0;           ///< of jobs that have ended, with their files; 0: for ever
  std::size_t jobs_per_user = 0;  ///< that may run and wait at once; 0: any number
  bool insecure = false;
  bool one_job = false;  ///< of `run`: a submission may replace the jobs before it
  bool quiet = false;
};

struct WorkerCommand {
  std::string endpoint;
  KeyFiles keys;
  std::string store;             ///< "": it sees none
  bool no_shared_store = false;  ///< takes `store` for the coordinator's key only
  std::string cache;             ///< "": default_cache_folder()
  std::uint64_t cache_bytes = std::uint64_t{10} << 30U;
  double grace_s = 30;
  std::uint64_t memory_bytes = 0;  ///< 0: what the machine has
  double walltime_s = 0;           ///< 0: as the batch system says, if it does
  std::string tag;
  std::uint64_t pool_memory_bytes = 0;
  bool solvers = false;  ///< it runs the solvers of loops
  bool quiet = false;
};

/// Removes from a store what no job needs.
struct GcCommand {
  std::string store;     ///< or the folder of a run
  std::string database;  ///< "": the store
  bool dry_run = false;
  bool all_finished = false;  ///< of done jobs only the results and their inputs stay
  bool json = false;
};

/// Looks whether a machine and a farm are in order.
struct DoctorCommand {
  ClientOptions client;      ///< without an endpoint: the coordinator of the store, if one runs
  std::string store;         ///< or the folder of a run; "": `folder` is looked at
  std::string database;      ///< "": the store
  std::string folder = ".";  ///< that a run is to work in
  std::vector<std::string> endpoints;  ///< that a coordinator is to listen on
  std::string keys;                    ///< folder of a coordinator's; "": see find_keys
  std::uint64_t memory_bytes = 0;      ///< that a worker is to be told of; 0: nothing is said
  std::string pool;                    ///< slurm, condor, lsf or ge; "": none need be there
};

struct KeysCommand {
  enum class Action { make, authorize, revoke, list };
  Action action = Action::list;
  std::string subject;  ///< make: a name; authorize: a .pub file or a key's digits; revoke: a name
  std::string name;     ///< of authorize; "": the file's
  std::string role;
  std::string folder;  ///< of the keys
  bool json = false;
};

/// Keeps workers at a batch system.
struct PoolCommand {
  std::string system;  ///< slurm, condor, lsf, ge, ssh or local
  std::string endpoint;
  KeyFiles keys;           ///< of the pool
  std::string worker_key;  ///< "": plain text
  std::string store;       ///< "": the workers' files come over their connections
  std::string cache;       ///< of theirs; "": in $TMPDIR
  std::string name;        ///< "": made from the endpoint
  std::string program;     ///< "": this one
  std::string logs = ".";
  std::size_t min = 0;
  std::size_t max = 1;
  std::uint64_t memory_bytes = std::uint64_t{4} << 30U;
  std::uint64_t max_memory_bytes = 0;  ///< 0: memory_bytes
  std::int64_t walltime_s = 8 * 3600;
  std::int64_t grace_s = 60;
  double idle_s = 120;
  double interval_s = 5;
  std::size_t rate = 60;
  std::vector<std::string> options;
  std::vector<std::string> hosts;
  bool solvers = false;  ///< its workers run the solvers of loops
  bool dry_run = false;
  bool stop = false;
  bool json = false;
};

/// Meshes the plane between closed loops.
struct PlaneCommand {
  std::vector<std::string> inputs;
  std::string output;
  std::optional<double> size;
  std::string metric;   ///< a file of metrics at the points; "": by the lengths of the loops' edges
  std::string sources;  ///< a file of point and line sources; "": none
  std::optional<std::int64_t> vertices;
  std::string gradation;  ///< "off" or a number above 1; "": off
  double corner_angle_deg = 30;
  std::vector<std::string> curves;  ///< "PATCH=KIND" each
  bool json = false;
};

/// Adapts a mesh of the plane to a metric or to a solution.
struct AdaptCommand {
  std::string input;
  std::string output;
  std::string metric;    ///< a file of metrics at the nodes; "": of a solution
  std::string solution;  ///< a file of numbers at the nodes; "": a metric
  std::string sources;   ///< a file of point and line sources; "": none
  std::optional<std::int64_t> vertices;
  double norm = 2;
  std::optional<double> h_min;
  std::optional<double> h_max;
  std::string gradation;  ///< "off" or a number above 1; "": off with a metric, 1.4 with a solution
  double aspect = 1e4;
  std::string mode = "lp";  ///< or "hessian", "thesis"
  double corner_angle_deg = 30;
  std::vector<std::string> curves;  ///< "PATCH=KIND" each
  bool json = false;
};

/// Cycles of solver and adaptation.
struct LoopCommand {
  std::string input;  ///< a job file (.toml)
  std::string output = "out";
  int workers = 1;
  bool json = false;
  ProgressStyle progress = ProgressStyle::automatic;
  std::string database;  ///< folder of the database, "": OUTPUT/.tetfarm
  double grace_s = 5;
};

/// Brings fields from one mesh of the plane to another.
struct PlaneTransferCommand {
  std::string input;  ///< the mesh of the solution
  std::string solution;
  std::string to;  ///< the other mesh
  std::string output;
  std::string method = "conservative";  ///< or "linear"
  bool json = false;
};

/// Prints the script that makes a shell complete what is typed.
struct CompletionCommand {
  std::string shell;  ///< bash, zsh or fish
};

/// Prints a page of the manual, or writes all of them.
struct ManCommand {
  std::string command;  ///< "": of the program
  std::string output;   ///< a folder for all pages; "": one is printed
};

struct VersionCommand {
  bool json = false;
};

/// What a worker starts for each task; not for people.
struct TaskCommand {
  std::string store;
};

/// What a worker starts once, and what then starts its tasks (worker/task_host.h); not for people.
struct TaskHostCommand {};

/// Help or the version was printed: nothing more to do.
struct NothingToDo {};

using Command =
    std::variant<NothingToDo, RunOptions, CheckOptions, PlanCommand, QualityOptions, ExportCommand,
                 ConvertCommand, SurfaceCommand, RenderCommand, ShapeCommand, StatusCommand,
                 WaitCommand, CancelCommand, PriorityCommand, RetryCommand, DrainCommand,
                 SubmitCommand, CoordinatorCommand, WorkerCommand, GcCommand, PoolCommand,
                 KeysCommand, TaskCommand, TaskHostCommand, JobsCommand, TasksCommand,
                 WorkersCommand, EventsCommand, LogsCommand, ExplainCommand, TopCommand,
                 DashboardCommand, TraceCommand, ReportCommand, BackupCommand, RestoreCommand,
                 SpacingCommand, PlaneCommand, AdaptCommand, PlaneTransferCommand, LoopCommand,
                 DoctorCommand, CompletionCommand, ManCommand, VersionCommand, InitCommand>;

/// @throws UsageError, ErrorWithHelp for a command line that is wrong.
Command parse_command_line(int argc, const char* const* argv);

/// All commands and options, for what tells of them.
DeclaredCommand declared_commands();

}  // namespace tetfarm
