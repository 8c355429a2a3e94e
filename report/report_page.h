/// One page about a finished job: how good the mesh is, how it was divided, how the work went.
///
/// Source: thesis chapter 5 judges its meshes by such figures; 4.3.4.1.3, table 1. The page needs
/// nothing beside itself: charts are SVG, pictures are in it, there are no scripts. What describes
/// the mesh comes first and is the same for the same mesh; what was measured while it was made
/// comes after `measured_part`.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/quality/histogram.h"
#include "mesh/quality/mesh_figures.h"
#include "proto/messages.pb.h"

namespace tetfarm {

struct ReportPicture {
  std::string caption;
  std::string png;  ///< the file's bytes
};

/// How the job went, as a coordinator or the rows of a store tell it.
struct ReportedWork {
  wire::JobStatus status;
  std::vector<wire::TaskLine> tasks;
  std::vector<wire::AttemptLine> attempts;
};

/// What the wall of boundary layers has.
struct ReportedLayers {
  std::int64_t full = 0;                          ///< triangles with all layers that were asked for
  std::map<std::string, std::int64_t> by_reason;  ///< those with fewer
  std::vector<std::int64_t> by_layers;            ///< triangles with 0, 1, … layers
  /// Of those with layers, the first height over what was asked for.
  Histogram first_heights = Histogram(0.4875, 1.5125, 41);
  /// How far the cells on top are from the last prisms, and the like: a name and a text each.
  std::vector<std::vector<std::string>> shapes;
  std::vector<ReportPicture> pictures;
};

struct ReportContent {
  std::string name;
  MeshFigures figures;
  std::vector<ReportPicture> pictures;
  std::optional<ReportedLayers> layers;
  std::optional<ReportedWork> work;  ///< nothing: only the mesh is known
};

/// Begins the part of the page that differs from run to run.
inline constexpr std::string_view measured_part = "<section id=\"work\">";

/// Texts of any bytes are escaped. Cost: O(n log n) in tasks and attempts.
std::string report_page(const ReportContent& content);

/// The parts of it. Without sections of their own: empty where there is nothing to tell.
std::string mesh_sections(const ReportContent& content);
std::string layers_section(const ReportedLayers& layers);
std::string pictures_row(const std::vector<ReportPicture>& pictures);
std::string work_section(const ReportedWork& work);

/// Estimated elements of each leaf in tree order; empty when tasks do not tell.
std::vector<double> estimated_elements_of_leaves(const ReportedWork& work);

}  // namespace tetfarm
