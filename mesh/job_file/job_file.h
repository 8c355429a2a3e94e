/// The job file (TOML): geometry, spacing, sources, decomposition, quality gate, output.
/// Every key is documented in docs/job_file.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/core/axis_plane.h"
#include "mesh/core/vec3.h"
#include "mesh/job_file/wave_size.h"

namespace tetfarm {

struct JobSource {
  struct Corner {
    Vec3 at;
    double spacing = 0;
    double inner = 0;
    double outer = 0;
  };
  enum class Shape : std::uint8_t {
    hull,     // by its corners: 1: point, 2: line, 3: triangle
    box,      // 2 corners, opposite ones, with inner radii of 0, and all else alike
    cylinder  // the same, the ends of its axis
  };
  std::vector<Corner> corners;
  int line = 0;  // in the job file, for messages
  Shape shape = Shape::hull;
  std::array<double, 2> radii{};  // of a cylinder, at its ends
};

/// What the job says of the region round a point.
struct JobRegion {
  Vec3 at;
  std::string name;
  bool is_void = false;
};

/// Faces do not turn away from each other by more: no edge has several lines.
inline constexpr double no_fan_angle = 180;

/// What the job says of the boundary layers on some patches.
struct JobLayers {
  std::vector<std::string> patches;  // names, in which * is any text and ? any letter
  double first_height = 0;           // 0: by y_plus
  double y_plus = 0;                 // with the next two: on a flat plate
  double reynolds = 0;               // of `length`
  double length = 0;
  double growth = 1.2;
  double growth_cap = 0;        // 0: none, and no acceleration
  double acceleration = 1;      // of the growth, from layer to layer
  std::int64_t count = 0;       // 0: by total_height
  double total_height = 0;      // 0 as well: until a layer is as high as most of the edges there
  std::int64_t equal = 1;       // layers at the wall that do not grow
  std::vector<double> heights;  // of each layer, in place of the eight before; empty: those count
  std::int64_t step = 1;        // layers by which lines of an edge may differ
  double fan_angle = 60;        // degrees between faces from which edges have several lines
  std::string elements = "prisms";  // "prisms", with pyramids and tets | "tets"
  std::string room = "ratio";       // "ratio" | "stop" | "scale"
  std::string typed;                // as --layers, for messages; canonical text does not have it
};

/// What the job says of absorbing layers outside of its outer boundary.
struct JobPml {
  std::vector<std::string> patches;  // as of JobLayers
  std::int64_t layers = 10;
  double height = 0;              // of each; 0: the median edge of the patches
  std::string elements = "tets";  // "tets" | "prisms"
  std::string side = "outside";   // of the patches: "outside" | "inside"
  std::string typed;              // as --pml, for messages; canonical text does not have it
  std::string corners = "mitre";  // "mitre" | "block"
};

/// What the job says of patches by name.
struct JobPatch {
  std::string glob;        // a name, in which * is any text and ? any letter
  std::string type;        // one of patch_type_words (mesh/core/patch_type.h); "": none is given
  std::string typed;       // as --patch-type, for messages; canonical text does not have it
  double size = 0;         // wanted edge length at it; 0: none
  double growth = 0;       // of edges with the distance from it; 0: [spacing] growth
  std::string typed_size;  // as --patch-size, for messages; canonical text does not have it
};

/// What the job says of the surface that is made in place of the given one, before anything else.
struct JobRemeshing {
  double size = 0;       // of its edges; 0: [spacing] default, or a part of the surface's size
  double min_size = 0;   // no edge need be shorter; 0: a part of `size`
  double angle = 30;     // degrees: sharper edges stay
  double tolerance = 0;  // its distance from the given one; 0: a part of the surface's size
};

/// The most layers that a job may ask for on a patch; mesh/layers/layer_request.h has the same
/// limit.
inline constexpr std::int64_t most_layers_of_job = 1000;

/// A height of a list is at most so many times the one before, which is at most so many times it;
/// mesh/layers/height_law.h has the same limit.
inline constexpr double most_height_ratio_of_job = 2;

/// The most sub-domains, or groups of them, that a job may ask for; tasks/task_contract.h has the
/// same limit for what tasks tell of them.
inline constexpr std::int64_t most_subdomains = 1'000'000;

/// A job as the user wrote it, with defaults filled in. Plain data: mesh/job_file may not see the
/// rooms that use it; the inspect task translates.
struct JobFile {
  std::string name;
  std::string surface;  // [geometry] surface, resolved against the job file's folder
  std::optional<JobRemeshing> remeshing;  // [surface] remesh = true
  std::string outer_kind = "none";        // [domain] outer = "none" | "box" | "sphere"
  double outer_factor = 0;                // [domain] factor
  double outer_spacing = 0;               // [domain] spacing
  std::vector<JobRegion> regions;         // [[region]]
  double spacing_default = 0;             // [spacing] default, 0: as large as growth allows
  double growth = 0.3;                    // [spacing] growth
  bool inherit_surface = true;            // [spacing] surface = "inherit" | "ignore"
  std::vector<JobSource> sources;         // [[source]] kind = point | line | triangle
  std::vector<JobLayers> layers;          // [[layers]]
  std::optional<JobPml> pml;              // [[pml]], one at most
  /// [spacing] sources: a file, resolved as the surface is. Who reads the job file puts what is in
  /// it into `sources` (read_flite_sources.h); canonical text does not name it.
  std::string sources_file;
  /// [spacing] frequency, wave_speed and per_wavelength. What they come to is `spacing_default`,
  /// and all that canonical text has of them.
  std::optional<WaveSize> wave;
  std::int64_t max_elements = 2'000'000'000;    // [spacing] max_elements, 0: as many as come
  std::int64_t subdomains = 0;                  // [decompose] subdomains, 0: by target_elements
  std::int64_t target_elements = 0;             // [decompose] target_elements, 0: by the job's size
  std::string plane = "auto";                   // [decompose] plane = "auto" | "lattice" | …
  std::string points = "lattice";               // [mesh] points = "lattice" | "sweeps"
  bool across_cuts = true;                      // [cosmetics] across_cuts
  std::int64_t max_memory_bytes = 0;            // [decompose] max_memory = "2GiB", 0: no limit
  std::int64_t groups = 0;                      // [decompose.assimilate] groups, 0: none
  std::string assimilate_method = "recursive";  // [decompose.assimilate] method
  double min_dihedral_deg = 0;                  // [quality] min_dihedral, a gate; 0: none
  double min_unforced_dihedral_deg = 0.1;       // [quality] min_unforced_dihedral, the same
  std::vector<std::string> formats = {"vtkhdf"};  // [output] formats
  std::string keep;                               // [output] keep = "needed" | "all", "": not said
  std::vector<JobPatch> patches;                  // [patch.NAME], by name
  std::optional<AxisPlane> symmetry;              // [domain] symmetry = "y=0"
  /// [geometry] scale: the job's lengths for one of the surface's file, whose coordinates are
  /// multiplied by it; what `unit` comes to where that is given.
  double scale = 1;
  std::string unit;  // [geometry] unit = "mm", of the file: the job is in metres; "": not said
};

/// Whether the files between the job's tasks stay until somebody removes them; otherwise each goes
/// when no task needs it any more.
bool keeps_all_files(const JobFile& job);

/// The factor of an outer boundary when none is given: 3 for a box, 5 for a sphere, 0 for "none".
double default_outer_factor(std::string_view outer_kind);

/// "y=0", "x = -1.5": a letter, an equals sign and a finite number; nothing for any other text.
std::optional<AxisPlane> parse_symmetry(std::string_view text);

/// What parse_symmetry takes, for messages.
inline constexpr const char* symmetry_examples = "a plane such as \"y=0\"";

/// What cannot be together with a plane of symmetry: "[pml]", or "" where nothing is in the way.
std::string obstacle_to_symmetry(const JobFile& job);

/// "2GiB", "500MB", "1.5 TiB" or plain bytes: a number and B, kB, MB, GB, TB, KiB, MiB, GiB or TiB,
/// in any case; nothing for any other text, for less than a byte and for more than 2^53.
std::optional<std::int64_t> parse_memory(std::string_view text);

/// @param typed the value of --layers, "wing_*,tip:first=1e-4,count=20": names of patches, a colon,
/// and keys of a table [[layers]], of which first_height may be called `first` and total_height
/// `total`. @throws UsageError "--layers 'TYPED': …"
JobLayers parse_layers_option(std::string_view typed);

/// @param typed the value of --pml, "outer:layers=10,height=0.1", or names of patches alone: the
/// same of a table [[pml]]. @throws UsageError "--pml 'TYPED': …"
JobPml parse_pml_option(std::string_view typed);

/// @param typed the value of --patch-type, "wing_*,tip=wall": one for each name. @throws UsageError
/// "--patch-type 'TYPED': …"
std::vector<JobPatch> parse_patch_type_option(std::string_view typed);

/// @param typed the value of --patch-size, "wing_*,tip=0.01" or "wing_*,tip=0.01:0.2", the growth
/// behind the colon: one for each name. @throws UsageError "--patch-size 'TYPED': …"
std::vector<JobPatch> parse_patch_size_option(std::string_view typed);

/// The units that a surface may be in: "m", "mm", …
std::span<const std::string_view> length_units();

/// How many metres such a unit has; nothing for any other text.
std::optional<double> metres_of(std::string_view unit);

/// A relative surface path is taken from the folder of `path`; without a name, the job is named
/// like `path` without its folder and ending.
/// @throws UsageError "file:line:column: …", with "did you mean" for an unknown key.
JobFile parse_job_file(std::string_view text, const std::string& path);

/// The same job as canonical TOML with absolute paths: what the store keeps. Parsed again it gives
/// the same job (but for the line numbers of the sources).
std::string to_toml(const JobFile& job);

/// Every key that the parser knows, as "spacing.growth"; for the test that docs/job_file.md has
/// them all.
std::vector<std::string> job_file_keys();

}  // namespace tetfarm
