/// Point and line sources of a metric of the plane, as people write them: [[point]] and [[line]] in
/// a file of their own, or in the job file of an adaptation loop. Documented in docs/adaptation.md.
///
/// Source: thesis 3.2.2. Units: those of the mesh; angles in degrees.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/job_file/job_section.h"

namespace tetfarm {

struct PlaneSource {
  bool is_line = false;
  std::array<double, 2> from{};   ///< of a line; where a point is
  std::array<double, 2> to{};     ///< of a line
  std::array<double, 2> sizes{};  ///< in the direction of the angle, and across it
  double angle_deg = 0;
  double radius = 0;
  double growth = 1.4;  ///< 0: off
  int line = 0;         ///< of the file, for messages
  friend bool operator==(const PlaneSource&, const PlaneSource&) = default;
};

struct PlaneSources {
  std::optional<double> size;  ///< of the background
  std::vector<PlaneSource> sources;
};

inline constexpr std::size_t most_plane_sources = 1000;

/// @throws UsageError "file:line:column: …", with "did you mean" for an unknown key; also when
/// there is no source in it.
PlaneSources parse_plane_sources(std::string_view text, const std::string& path);

/// Those of the arrays `point` and `line` of a file, in the order in which they stand there; none
/// where it has no such arrays. @throws UsageError as above.
std::vector<PlaneSource> plane_sources_of(const JobSection& top);

/// As TOML, which parsed again gives the same sources, but for their lines.
std::string to_toml(const std::vector<PlaneSource>& sources);

/// Every key of a point or a line, as "point.at".
std::vector<std::string> plane_source_keys();

}  // namespace tetfarm
