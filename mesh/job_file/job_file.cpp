#include "mesh/job_file/job_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/check.h"
#include "base/job_name.h"
#include "mesh/job_file/job_formats.h"
#include "mesh/job_file/job_layers.h"
#include "mesh/job_file/job_patches.h"
#include "mesh/job_file/job_section.h"

namespace tetfarm {
namespace {

constexpr std::array<std::string_view, 16> top_keys = {
    "version", "name",  "geometry", "surface",   "domain", "region",    "spacing", "source",
    "layers",  "patch", "pml",      "decompose", "mesh",   "cosmetics", "quality", "output"};
constexpr std::array<std::string_view, 3> geometry_keys = {"surface", "scale", "unit"};
constexpr std::array<std::string_view, 5> surface_keys = {"remesh", "size", "min_size", "angle",
                                                          "tolerance"};
constexpr std::array<std::string_view, 4> domain_keys = {"outer", "factor", "spacing", "symmetry"};
constexpr std::array<std::string_view, 3> region_keys = {"at", "name", "void"};
constexpr std::array<std::string_view, 8> spacing_keys = {
    "default", "frequency", "wave_speed", "per_wavelength",
    "growth",  "surface",   "sources",    "max_elements"};
constexpr std::array<std::string_view, 5> point_keys = {"kind", "at", "spacing", "inner", "outer"};
constexpr std::array<std::string_view, 5> sphere_keys = {"kind", "at", "radius", "spacing",
                                                         "outer"};
constexpr std::array<std::string_view, 5> box_keys = {"kind", "low", "high", "spacing", "outer"};
constexpr std::array<std::string_view, 6> cylinder_keys = {"kind",   "from",    "to",
                                                           "radius", "spacing", "outer"};
constexpr std::array<std::string_view, 3> line_keys = {"kind", "from", "to"};
constexpr std::array<std::string_view, 2> triangle_keys = {"kind", "corner"};
constexpr std::array<std::string_view, 4> corner_keys = {"at", "spacing", "inner", "outer"};
constexpr std::array<std::string_view, 1> mesh_keys = {"points"};
constexpr std::array<std::string_view, 1> cosmetics_keys = {"across_cuts"};
constexpr std::array<std::string_view, 5> decompose_keys = {"subdomains", "target_elements",
                                                            "plane", "max_memory", "assimilate"};
constexpr std::array<std::string_view, 2> assimilate_keys = {"groups", "method"};
constexpr std::array<std::string_view, 2> quality_keys = {"min_dihedral", "min_unforced_dihedral"};
constexpr std::array<std::string_view, 2> output_keys = {"formats", "keep"};
constexpr std::array<std::string_view, 2> kinds_of_keeping = {"needed", "all"};

constexpr std::array<std::string_view, 3> outer_kinds = {"none", "box", "sphere"};
constexpr std::array<std::string_view, 2> surface_roles = {"inherit", "ignore"};
constexpr std::array<std::string_view, 6> source_kinds = {"point",  "line", "triangle",
                                                          "sphere", "box",  "cylinder"};
constexpr std::array<std::string_view, 4> kinds_of_planes = {"auto", "lattice", "axis", "inertia"};
constexpr std::array<std::string_view, 2> kinds_of_points = {"lattice", "sweeps"};
constexpr std::array<std::string_view, 3> assimilate_methods = {"recursive", "k-way",
                                                                "k-way-volume"};

/// No tet mesh reaches the angles of the regular tet, 70.53 degrees, everywhere.
constexpr double regular_dihedral_deg = 70.5;

constexpr std::int64_t least_target_elements = 1000;

Vec3 parse_place(const JobSection& section, std::string_view key = "at") {
  const toml::array& at = section.array(key);
  if (at.size() != 3) section.fail(key, "must have three coordinates");
  Vec3 place;
  for (int axis = 0; axis < 3; ++axis) {
    place[axis] = section.finite(at[static_cast<std::size_t>(axis)], key);
  }
  return place;
}

JobRegion parse_region(const JobSection& section) {
  JobRegion region;
  region.at = parse_place(section);
  if (section.has("name")) region.name = section.text("name");
  if (section.has("void")) region.is_void = section.boolean("void");
  return region;
}

JobSource::Corner parse_corner(const JobSection& section) {
  JobSource::Corner corner;
  corner.at = parse_place(section);
  corner.spacing = section.positive("spacing");
  corner.inner = section.positive("inner");
  corner.outer = section.positive("outer");
  if (corner.outer < corner.inner) section.fail("outer", "must not be less than `inner`");
  return corner;
}

Words keys_of_source(std::string_view kind) {
  if (kind == "point") return point_keys;
  if (kind == "line") return line_keys;
  if (kind == "sphere") return sphere_keys;
  if (kind == "box") return box_keys;
  return kind == "cylinder" ? Words(cylinder_keys) : Words(triangle_keys);
}

/// Constant within the radius; `outer` counts from there.
JobSource::Corner parse_sphere(const JobSection& section) {
  JobSource::Corner corner;
  corner.at = parse_place(section);
  corner.spacing = section.positive("spacing");
  corner.inner = section.positive("radius");
  corner.outer = corner.inner + section.positive("outer");
  return corner;
}

/// Its two corners, with what both say of the spacing; `outer` counts from its outside.
std::vector<JobSource::Corner> parse_solid(const JobSection& section, std::string_view first,
                                           std::string_view second) {
  JobSource::Corner corner;
  corner.spacing = section.positive("spacing");
  corner.outer = section.positive("outer");
  std::vector<JobSource::Corner> corners(2, corner);
  corners[0].at = parse_place(section, first);
  corners[1].at = parse_place(section, second);
  return corners;
}

/// A number, or an array of one for each end.
std::array<double, 2> parse_radii(const JobSection& section) {
  if (!section.node("radius").is_array()) {
    const double radius = section.positive("radius");
    return {radius, radius};
  }
  const toml::array& ends = section.array("radius");
  if (ends.size() != 2) section.fail("radius", "must be a number, or two: one for each end");
  const std::array<double, 2> radii = {section.finite(ends[0], "radius"),
                                       section.finite(ends[1], "radius")};
  if (std::min(radii[0], radii[1]) < 0 || std::max(radii[0], radii[1]) <= 0) {
    section.fail("radius", "must not be negative, nor 0 at both ends");
  }
  return radii;
}

JobSource parse_cylinder(const JobSection& section) {
  JobSource source;
  source.shape = JobSource::Shape::cylinder;
  source.corners = parse_solid(section, "from", "to");
  source.radii = parse_radii(section);
  if (source.corners[0].at == source.corners[1].at) {
    section.fail("to", "must not be the same point as `from`");
  }
  return source;
}

JobSource parse_box(const JobSection& section) {
  JobSource source;
  source.shape = JobSource::Shape::box;
  source.corners = parse_solid(section, "low", "high");
  for (int axis = 0; axis < 3; ++axis) {
    if (source.corners[0].at[axis] > source.corners[1].at[axis]) {
      section.fail("high", "must not be below `low` along any axis");
    }
  }
  return source;
}

JobSource parse_source(const JobSection& top, const toml::node& node) {
  // The kind first: it decides which other keys there may be.
  std::vector<std::string_view> any_key;
  for (const std::string_view kind : source_kinds) {
    const Words keys = keys_of_source(kind);
    any_key.insert(any_key.end(), keys.begin(), keys.end());
  }
  const std::string kind = top.item(node, "source", any_key).one_of("kind", source_kinds);
  const JobSection section = top.item(node, "source", keys_of_source(kind));
  if (kind == "box" || kind == "cylinder") {
    JobSource solid = kind == "box" ? parse_box(section) : parse_cylinder(section);
    solid.line = section.line();
    return solid;
  }
  JobSource source;
  source.line = section.line();
  if (kind == "point" || kind == "sphere") {
    source.corners = {kind == "point" ? parse_corner(section) : parse_sphere(section)};
  } else if (kind == "line") {
    for (const std::string_view end : {"from", "to"}) {
      section.node(end);
      source.corners.push_back(parse_corner(section.table(end, corner_keys)));
    }
  } else {
    const toml::array& corners = section.array("corner");
    if (corners.size() != 3) section.fail("corner", "must hold three tables");
    for (const toml::node& corner : corners) {
      source.corners.push_back(parse_corner(section.item(corner, "corner", corner_keys)));
    }
  }
  TF_CHECK(source.corners.size() >= 1 && source.corners.size() <= 3);
  return source;
}

/// Each table of an array that is written [[key]]; none when there is no such array.
template <class Visit>
void for_each_table(const JobSection& top, std::string_view key, const Visit& visit) {
  if (!top.has(key)) return;
  if (top.node(key).is_table()) top.fail(key, "must be written [[" + std::string(key) + "]]");
  for (const toml::node& node : top.array(key)) visit(node);
}

/// What the coordinates of the surface's file are multiplied by.
void parse_scale(const JobSection& section, JobFile& job) {
  if (section.has("unit")) {
    job.unit = section.one_of("unit", length_units());
    job.scale = metres_of(job.unit).value();
  }
  if (!section.has("scale")) return;
  if (section.has("unit")) {
    section.fail("scale",
                 "cannot be given together with `unit`: each says what coordinates are multiplied "
                 "by");
  }
  job.scale = section.positive("scale");
}

/// Faces that turn back on each other are at 180 degrees.
constexpr double straight_deg = 180;

void parse_surface(const JobSection& section, JobFile& job) {
  if (!section.has("remesh") || !section.boolean("remesh")) {
    for (const std::string_view key : surface_keys) {
      if (key != "remesh" && section.has(key)) section.fail(key, "needs `remesh` = true");
    }
    return;
  }
  JobRemeshing& remeshing = job.remeshing.emplace();
  if (section.has("size")) remeshing.size = section.positive("size");
  if (section.has("min_size")) remeshing.min_size = section.positive("min_size");
  if (section.has("angle")) remeshing.angle = section.positive("angle");
  if (section.has("tolerance")) remeshing.tolerance = section.positive("tolerance");
  if (remeshing.angle >= straight_deg) section.fail("angle", "must be less than 180 degrees");
  if (remeshing.size > 0 && remeshing.min_size > remeshing.size) {
    section.fail("min_size", "must not be more than `size`");
  }
}

void parse_domain(const JobSection& section, JobFile& job) {
  if (section.has("symmetry")) {
    job.symmetry = parse_symmetry(section.text("symmetry"));
    if (!job.symmetry) section.fail("symmetry", std::string("must be ") + symmetry_examples);
  }
  if (section.has("outer")) job.outer_kind = section.one_of("outer", outer_kinds);
  if (job.outer_kind == "none") {
    for (const std::string_view key : {"factor", "spacing"}) {
      if (section.has(key)) section.fail(key, "needs `outer` = \"box\" or \"sphere\"");
    }
    return;
  }
  job.outer_factor = section.has("factor") ? section.finite(section.node("factor"), "factor")
                                           : default_outer_factor(job.outer_kind);
  if (job.outer_factor <= 1) section.fail("factor", "must be more than 1");
  if (section.has("spacing")) job.outer_spacing = section.not_negative("spacing");
}

/// In hertz: a number, or a text with a unit.
double parse_frequency_of(const JobSection& section) {
  if (!section.node("frequency").is_string()) return section.positive("frequency");
  const auto hertz = parse_frequency(section.text("frequency"));
  if (!hertz) section.fail("frequency", std::string("must be ") + frequency_examples);
  return *hertz;
}

void parse_wave(const JobSection& section, JobFile& job) {
  if (!section.has("frequency")) {
    for (const std::string_view key : {"wave_speed", "per_wavelength"}) {
      if (section.has(key)) section.fail(key, "needs `frequency`");
    }
    return;
  }
  if (job.spacing_default > 0) {
    section.fail("frequency",
                 "cannot be given together with `default`: each says how long edges "
                 "may be");
  }
  WaveSize& wave = job.wave.emplace();
  wave.frequency = parse_frequency_of(section);
  if (section.has("wave_speed")) wave.speed = section.positive("wave_speed");
  if (section.has("per_wavelength")) wave.per_wavelength = section.positive("per_wavelength");
  if (!has_size(wave)) {
    section.fail("frequency",
                 "gives no edge length: `wave_speed` / (`frequency` · "
                 "`per_wavelength`) is out of range");
  }
  job.spacing_default = size_of(wave);
}

void parse_spacing(const JobSection& section, JobFile& job) {
  if (section.has("default")) job.spacing_default = section.not_negative("default");
  parse_wave(section, job);
  if (section.has("growth")) job.growth = section.positive("growth");
  if (section.has("surface")) {
    job.inherit_surface = section.one_of("surface", surface_roles) == "inherit";
  }
  if (section.has("max_elements")) job.max_elements = section.integer("max_elements", 0);
}

void parse_decompose(const JobSection& section, JobFile& job) {
  if (section.has("subdomains")) job.subdomains = section.integer("subdomains", 0, most_subdomains);
  if (section.has("target_elements")) {
    job.target_elements = section.integer("target_elements", 0);
    if (job.target_elements > 0 && job.target_elements < least_target_elements) {
      section.fail("target_elements", "must be at least 1000, or 0 to choose it by the job's size");
    }
  }
  if (section.has("plane")) job.plane = section.one_of("plane", kinds_of_planes);
  if (section.has("max_memory")) {
    const auto bytes = parse_memory(section.text("max_memory"));
    if (!bytes) section.fail("max_memory", "must be an amount like \"2GiB\" or \"500MB\"");
    job.max_memory_bytes = *bytes;
    for (const std::string_view key : {"subdomains", "target_elements", "assimilate"}) {
      const bool counts = section.has(key) && (key != "subdomains" || job.subdomains > 0);
      if (counts) section.fail(key, "cannot be given together with `max_memory`, which decides it");
    }
  }
  if (!section.has("assimilate")) return;
  const JobSection assimilate = section.table("assimilate", assimilate_keys);
  job.groups = assimilate.integer("groups", 1, most_subdomains);
  if (assimilate.has("method")) {
    job.assimilate_method = assimilate.one_of("method", assimilate_methods);
  }
  if (job.subdomains > 0 && job.subdomains < job.groups) {
    assimilate.fail("groups", "must not be more than `subdomains`, the leaves to join");
  }
}

void parse_mesh(const JobSection& section, JobFile& job) {
  if (section.has("points")) job.points = section.one_of("points", kinds_of_points);
}

void parse_cosmetics(const JobSection& section, JobFile& job) {
  if (section.has("across_cuts")) job.across_cuts = section.boolean("across_cuts");
}

/// Of an angle that a mesh must not be below; 0: no gate.
void parse_gate(const JobSection& section, const char* key, double& gate_deg) {
  if (!section.has(key)) return;
  gate_deg = section.not_negative(key);
  if (gate_deg >= regular_dihedral_deg) {
    section.fail(key, "must be less than 70.5, the angle of the regular tetrahedron");
  }
}

void parse_quality(const JobSection& section, JobFile& job) {
  parse_gate(section, "min_dihedral", job.min_dihedral_deg);
  parse_gate(section, "min_unforced_dihedral", job.min_unforced_dihedral_deg);
}

void parse_formats(const JobSection& section, JobFile& job) {
  if (!section.has("formats")) return;
  job.formats.clear();
  for (const toml::node& node : section.array("formats")) {
    const auto format = node.value_exact<std::string>();
    if (!format) section.fail(node.source(), "`formats` must hold strings");
    section.check_known(node, "formats", *format, job_output_formats());
    if (std::find(job.formats.begin(), job.formats.end(), *format) != job.formats.end()) {
      section.fail(node.source(), "`formats` has \"" + *format + "\" twice");
    }
    job.formats.push_back(*format);
  }
  if (job.formats.empty()) section.fail("formats", "must name at least one format");
}

void parse_output(const JobSection& section, JobFile& job) {
  parse_formats(section, job);
  if (section.has("keep")) job.keep = section.one_of("keep", kinds_of_keeping);
}

/// `file` as named in the job file at `path`, as a person would type it: relative where `path` is.
std::string beside(const std::string& path, const std::string& file) {
  return (std::filesystem::path(path).parent_path() / file).lexically_normal().string();
}

}  // namespace

double default_outer_factor(std::string_view outer_kind) {
  if (outer_kind == "box") return 3;
  return outer_kind == "sphere" ? 5 : 0;
}

std::string obstacle_to_symmetry(const JobFile& job) {
  if (!job.symmetry) return {};
  if (job.remeshing) return "remeshing, which wants a closed surface";
  if (job.pml && job.pml->corners != "block") {
    return "absorbing layers whose corners are mitres; take `corners = \"block\"`";
  }
  return {};
}

bool keeps_all_files(const JobFile& job) { return job.keep != "needed"; }

JobFile parse_job_file(std::string_view text, const std::string& path) {
  namespace fs = std::filesystem;
  const toml::table table = parse_toml(text, path);
  const JobSection top(table, "", top_keys, path);
  if (top.has("version") && top.integer("version", 1) != 1) {
    top.fail("version", "must be 1: this Tetfarm knows no newer version of job files");
  }
  JobFile job;
  job.name = top.has("name") ? top.text("name") : fs::path(path).stem().string();
  // It names the files of the result: it must not lead them out of their folder.
  const std::string problem = problem_with_job_name(job.name);
  if (!problem.empty()) top.fail("name", problem);
  const JobSection geometry = top.table("geometry", geometry_keys);
  const std::string surface = geometry.text("surface");
  if (surface.empty()) geometry.fail("surface", "must not be empty");
  job.surface = beside(path, surface);
  parse_scale(geometry, job);
  parse_surface(top.table("surface", surface_keys), job);
  parse_domain(top.table("domain", domain_keys), job);
  for_each_table(top, "region", [&](const toml::node& node) {
    job.regions.push_back(parse_region(top.item(node, "region", region_keys)));
  });
  const JobSection spacing = top.table("spacing", spacing_keys);
  parse_spacing(spacing, job);
  if (spacing.has("sources")) {
    const std::string sources = spacing.text("sources");
    if (sources.empty()) spacing.fail("sources", "must not be empty");
    job.sources_file = beside(path, sources);
  }
  for_each_table(top, "source",
                 [&](const toml::node& node) { job.sources.push_back(parse_source(top, node)); });
  for_each_table(top, "layers",
                 [&](const toml::node& node) { job.layers.push_back(parse_layers(top, node)); });
  PatchTables said_of_patches = parse_patch_tables(top, job.layers);
  job.patches = std::move(said_of_patches.patches);
  for (JobLayers& layers : said_of_patches.layers) job.layers.push_back(std::move(layers));
  for_each_table(top, "pml", [&](const toml::node& node) {
    if (job.pml) {
      top.fail(node.source(),
               "a second `[[pml]]`: a job has one block of absorbing layers; name "
               "all of its patches in one");
    }
    job.pml = parse_pml(top, node);
  });
  parse_decompose(top.table("decompose", decompose_keys), job);
  parse_mesh(top.table("mesh", mesh_keys), job);
  parse_cosmetics(top.table("cosmetics", cosmetics_keys), job);
  parse_quality(top.table("quality", quality_keys), job);
  parse_output(top.table("output", output_keys), job);
  TF_CHECK(!job.formats.empty());
  const std::string obstacle = obstacle_to_symmetry(job);
  if (!obstacle.empty()) {
    top.table("domain", domain_keys).fail("symmetry", "cannot be given together with " + obstacle);
  }
  return job;
}

std::vector<std::string> job_file_keys() {
  const std::array<std::pair<std::string_view, Words>, 21> sections = {
      {{"geometry", geometry_keys},
       {"surface", surface_keys},
       {"domain", domain_keys},
       {"region", region_keys},
       {"spacing", spacing_keys},
       {"source", point_keys},
       {"source", line_keys},
       {"source", triangle_keys},
       {"source", sphere_keys},
       {"source", box_keys},
       {"source", cylinder_keys},
       {"source.corner", corner_keys},
       {"layers", layers_keys()},
       {"patch", patch_keys()},
       {"pml", pml_keys()},
       {"decompose", decompose_keys},
       {"decompose.assimilate", assimilate_keys},
       {"mesh", mesh_keys},
       {"cosmetics", cosmetics_keys},
       {"quality", quality_keys},
       {"output", output_keys}}};
  std::vector<std::string> all = {"version", "name"};
  for (const auto& [section, keys] : sections) {
    for (const std::string_view key : keys) {
      std::string full = std::string(section) + "." + std::string(key);
      if (std::find(all.begin(), all.end(), full) == all.end()) all.push_back(std::move(full));
    }
  }
  return all;
}

}  // namespace tetfarm
