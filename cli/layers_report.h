/// What the boundary layers of a job come to, for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "worker/job_layers.h"
#include "worker/job_pml.h"

namespace tetfarm {

/// "\"wing\": 20 layers, 0.0001 to 0.0032 high, 0.0187 together; …", without a line end.
std::string layers_text(const LayerFigures& figures);

/// "\"outer_sphere\": 10 layers, 0.1 high, 1 together; 320 triangles, 9600 tets", likewise.
std::string pml_text(const PmlFigures& figures);

/// An array, in the order of the job.
nlohmann::ordered_json layers_json(std::span<const LayerFigures> all);
nlohmann::ordered_json pml_json(const PmlFigures& figures);

}  // namespace tetfarm
