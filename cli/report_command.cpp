#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/file_system.h"
#include "cli/commands.h"
#include "cli/mesh_input.h"
#include "cli/report_picture.h"
#include "cli/reported_cycles.h"
#include "cli/reported_layers.h"
#include "cli/run_folder.h"
#include "cli/small_patches.h"
#include "json/job_json.h"
#include "mesh/formats/registry/open_mesh.h"
#include "mesh/render/render_mesh.h"
#include "report/report_page.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

/// What there is of a job, or of a mesh alone.
struct Reported {
  std::string name;
  MeshInput input;  ///< keeps a mesh that came over the connection
  std::unique_ptr<MeshSource> mesh;
  std::optional<SpacingField> spacing;
  std::optional<std::string> layer_map;
  std::optional<ReportedWork> work;
};

ReportedWork work_of(FarmView& view, const std::string& job) {
  ReportedWork work;
  wire::Query query;
  query.set_job(job);
  query.set_subject(wire::Query::TASKS);
  view.ask(query, [&](const wire::QueryReply& page) {
    work.tasks.insert(work.tasks.end(), page.tasks().begin(), page.tasks().end());
  });
  query.set_subject(wire::Query::ATTEMPTS);
  view.ask(query, [&](const wire::QueryReply& page) {
    work.attempts.insert(work.attempts.end(), page.attempts().begin(), page.attempts().end());
  });
  const wire::StatusReply reply = view.status();
  if (reply.jobs_size() != 1) throw Error(ExitCode::not_found, "no job " + job);
  work.status = reply.jobs(0);
  return work;
}

/// Of a store at rest, or of a coordinator.
Reported of_job(ViewOptions options, const std::string& job, const fs::path& scratch_folder) {
  options.client.job = job;
  FarmView view(options);
  Reported reported;
  reported.work = work_of(view, job);
  const wire::JobStatus& status = reported.work->status;
  reported.name = status.name();
  reported.input = mesh_of_job(status, options, scratch_folder);
  reported.mesh = open_mesh(reported.input, scratch_folder);
  reported.spacing = spacing_of(reported.input, options);
  reported.layer_map = layer_map_of(status, options, scratch_folder);
  return reported;
}

/// A mesh by itself: what made it is not known, but its spacing where it lies beside.
Reported of_mesh(const fs::path& input) {
  const fs::path file = mesh_file(input);
  return {file.filename().string(), {},          open_mesh(file), spacing_beside(file),
          layer_map_of(file),       std::nullopt};
}

/// The folder of a run, a mesh, or a job.
Reported reported_of(const ReportCommand& command) {
  const std::string& subject = command.view.client.job;
  const fs::path scratch_folder = fs::absolute(command.output).parent_path();
  ViewOptions options = command.view;
  options.is_quiet = true;
  options.client.job.clear();
  if (fs::is_directory(subject) && options.client.endpoint.empty()) {
    const std::optional<fs::path> store = store_of(subject);
    if (!store) return of_mesh(subject);
    options.store = subject;
    FarmView view(options);
    const std::string job = last_done_job(view);
    return job.empty() ? of_mesh(subject) : of_job(options, job, scratch_folder);
  }
  if (fs::exists(subject)) return of_mesh(subject);
  if (options.store.empty() && options.client.endpoint.empty()) {
    throw Error(
        ExitCode::not_found,
        subject + ": no such folder or mesh; for a job, say where it is with --connect or --store");
  }
  return of_job(options, subject, scratch_folder);
}

std::vector<ReportPicture> pictures_of(const MeshSource& mesh) {
  RenderOptions options;
  options.width = 960;
  options.height = 640;
  options.bodies = small_patches(mesh);
  const bool has_colours = mesh.knows_subdomains();
  options.colour_by = has_colours ? ColourBy::subdomain : ColourBy::patch;
  const std::string by = has_colours ? ", coloured by sub-domain" : ", coloured by patch";
  std::vector<ReportPicture> pictures = {picture_of(mesh, options, "The surface" + by)};
  options.view = View::cut;
  pictures.push_back(picture_of(mesh, options, "The mesh cut open through its middle" + by));
  if (!has_colours || mesh.size() < 2) return pictures;
  options.view = View::exploded;
  pictures.push_back(picture_of(mesh, options, "The sub-domains, moved apart"));
  return pictures;
}

/// "12 tets", "12 tets, 8 prisms".
std::string text_of_cells(const MeshFigures& figures) {
  std::string text;
  const auto add = [&text](std::int64_t count, ElementType type) {
    if (count > 0) text += (text.empty() ? "" : ", ") + text_of_count(count, type);
  };
  add(figures.tets, ElementType::tet);
  for (const ElementType type : cell_block_types) add(figures.others[type].cells, type);
  return text.empty() ? "no elements" : text;
}

void tell_page(const ReportCommand& command, const std::string& contents) {
  if (command.view.client.json) {
    std::printf("%s\n", copy_json("report", command.output).c_str());
  } else {
    std::fprintf(stderr, "%s: %s\n", command.output.c_str(), contents.c_str());
  }
}

ExitCode report_loop_folder(const ReportCommand& command) {
  const CyclesContent content = reported_cycles(command.view.client.job);
  write_file_atomically(command.output, cycles_page(content));
  tell_page(command, std::to_string(content.cycles) + (content.cycles == 1 ? " cycle" : " cycles"));
  return ExitCode::ok;
}

}  // namespace

ExitCode report_command(const ReportCommand& command) {
  if (command.view.client.endpoint.empty() && is_loop_folder(command.view.client.job)) {
    return report_loop_folder(command);
  }
  Reported reported = reported_of(command);
  ReportContent content;
  content.name = reported.name;
  const std::optional<SpacingField>& spacing = reported.spacing;
  content.figures = figures_of(
      *reported.mesh,
      spacing ? SpacingAt([&spacing](const Vec3& p) { return spacing->at(p); }) : SpacingAt());
  content.pictures = pictures_of(*reported.mesh);
  if (reported.layer_map) {
    content.layers = reported_layers(*reported.layer_map, *reported.mesh,
                                     reported.work ? &reported.work->status : nullptr);
  }
  content.work = std::move(reported.work);
  write_file_atomically(command.output, report_page(content));
  tell_page(command, text_of_cells(content.figures));
  return ExitCode::ok;
}

}  // namespace tetfarm
