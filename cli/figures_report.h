/// The figures of a mesh (mesh/quality/mesh_figures.h) as text for people and as JSON for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "mesh/quality/mesh_figures.h"

namespace tetfarm {

/// With line ends: histograms, the time step, the worst tets, the balance.
std::string figures_text(const MeshFigures& figures);

/// The keys that `quality --json` has besides those of its report: docs/command_line.md.
nlohmann::ordered_json figures_json(const MeshFigures& figures);

}  // namespace tetfarm
