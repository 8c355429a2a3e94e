#include "dashboard/surface_answers.h"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"
#include "dashboard/shown_surface.h"
#include "json/json_line.h"
#include "json/reply_values.h"
#include "mesh/artifacts/artifact_file.h"
#include "mesh/artifacts/surface_file.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;
using SurfaceJson = nlohmann::ordered_json;

constexpr std::size_t most_subdomains_told = 2'000;
constexpr std::size_t most_subdomains_read = 200'000;
constexpr std::size_t begin_of_surface = 16;
/// Of what never changes: it need not be made again.
constexpr FetchTime made_for_good{std::int64_t{1} << 60U, 0};

SubdomainsNow subdomains_now(const std::string& job, FarmSource& source) {
  wire::Query query;
  query.set_subject(wire::Query::TREE);
  query.set_job(job);
  SubdomainsNow now;
  std::size_t read = 0;
  while (true) {
    const wire::QueryReply page = source.page(query);
    if (page.has_surface()) now.surface = page.surface();
    read += static_cast<std::size_t>(page.subdomains_size());
    if (read > most_subdomains_read) {
      throw Error(ExitCode::out_of_resources, job + " has too many sub-domains to be drawn");
    }
    for (const wire::SubdomainLine& line : page.subdomains()) {
      if (line.state() != "open" && line.state() != "leaf") continue;
      if (now.lines.size() == most_subdomains_told) ++now.left_out;
      if (now.lines.size() < most_subdomains_told) now.lines.push_back(line);
    }
    if (page.next() <= query.after()) return now;
    query.set_after(page.next());
  }
}

wire::Artifact file_of(const wire::SubdomainLine& line) {
  wire::Artifact file;
  file.set_hash(line.hash());
  file.set_size(line.size());
  return file;
}

/// The job's surface, open; nothing where it is not there, or of a version that is only read whole.
std::optional<SurfaceFile> open_surface(const wire::Artifact& file, FarmSource& source) {
  if (file.hash().empty()) return std::nullopt;
  const std::optional<fs::path> path = source.find_file(file);
  if (!path) return std::nullopt;
  if (is_surface_without_blocks(read_part_of_file(*path, 0, begin_of_surface))) return std::nullopt;
  return SurfaceFile(*path, file.hash());
}

Subdomain read_subdomain(const wire::SubdomainLine& line, FarmSource& source) {
  const std::string name = subdomain_name(line.path());
  if (!source.sees_files()) {
    throw Error(ExitCode::not_found, "the dashboard does not see the store: start it with --store");
  }
  if (line.size() > largest_shown_file) {
    throw Error(ExitCode::out_of_resources, "sub-domain " + name + " is too large to be drawn");
  }
  const std::optional<fs::path> path = source.find_file(file_of(line));
  if (!path) {
    throw Error(ExitCode::not_found,
                "the file of sub-domain " + name + " is no longer in the store");
  }
  return subdomain_from_bytes(read_part_of_file(*path, 0, line.size()), line.hash());
}

std::vector<std::int32_t> pieces_of_file(const Subdomain& subdomain, const wire::Artifact& surface,
                                         FarmSource& source) {
  WantedPieces wanted;
  wanted.triangles = numbers_in_input(subdomain);
  std::vector<std::int32_t> patches;
  if (!wanted.triangles.empty()) {
    std::optional<SurfaceFile> file = open_surface(surface, source);
    if (file) patches = file->read(wanted).patches;
  }
  return pieces_of_boundary(subdomain, patches);
}

}  // namespace

SurfaceAnswers::Kept SurfaceAnswers::subdomains(const std::string& job, FarmSource& source) {
  const std::int64_t begin_ms = clock_();
  if (const Kept* kept = subdomains_.find(job, begin_ms)) return *kept;
  auto now = std::make_shared<const SubdomainsNow>(subdomains_now(job, source));
  const std::int64_t end_ms = clock_();
  Kept kept{job, {end_ms, end_ms - begin_ms}, now->lines.size(), now};
  subdomains_.keep(kept);
  return kept;
}

std::string SurfaceAnswers::list(const std::string& job, FarmSource& source) {
  const Kept kept = subdomains(job, source);
  SurfaceJson patches = SurfaceJson::array();
  if (const std::optional<SurfaceFile> surface = open_surface(kept.thing->surface, source)) {
    for (const std::string& name : surface->patch_names()) patches.push_back(name);
  }
  SurfaceJson lines = SurfaceJson::array();
  for (const wire::SubdomainLine& line : kept.thing->lines) {
    lines.push_back({{"path", line.path()},
                     {"place", subdomain_name(line.path())},
                     {"state", line.state()},
                     {"meshed", line.meshed()},
                     {"hash", line.hash()},
                     {"bytes", line.size()},
                     {"is_there", line.size() <= largest_shown_file &&
                                      source.find_file(file_of(line)).has_value()}});
  }
  return json_line({{"sees_files", source.sees_files()},
                    {"patches", patches},
                    {"left_out", kept.thing->left_out},
                    {"surfaces", lines}});
}

ApiAnswer SurfaceAnswers::surface(const ApiRequest& request, FarmSource& source) {
  TF_CHECK(request.number > 0 && request.triangles > 0 &&
           request.triangles <= most_shown_triangles);
  const Kept kept = subdomains(request.job, source);
  const auto& lines = kept.thing->lines;
  const auto line = std::find_if(lines.begin(), lines.end(), [&](const wire::SubdomainLine& other) {
    return other.path() == request.number;
  });
  if (line == lines.end()) {
    throw Error(ExitCode::not_found, request.job + " has no sub-domain " +
                                         std::to_string(request.number) + " to be drawn");
  }
  const std::string name =
      line->hash() + " " + kept.thing->surface.hash() + " " + std::to_string(request.triangles);
  if (const auto* made = surfaces_.find(name, 0)) return {200, made->thing, ApiForm::bytes};
  const Subdomain subdomain = read_subdomain(*line, source);
  auto bytes = std::make_shared<const std::string>(
      shown_surface(subdomain, pieces_of_file(subdomain, kept.thing->surface, source),
                    request.triangles, line->hash()));
  surfaces_.keep({name, made_for_good, bytes->size(), bytes});
  return {200, bytes, ApiForm::bytes};
}

}  // namespace tetfarm
