/// What healing did to a surface, or would do, in the words of the command line.
#pragma once

#include <nlohmann/json.hpp>

#include "mesh/healing/heal_surface.h"

namespace tetfarm {

/// "healed          2 holes filled: …", a line for each kind of act.
void print_healing(const HealedSurface& healed);

/// {"mends_all": …, "acts": [{"kind", "count", "first": [x, y, z]}], "left":
/// ["self-intersection"]}.
nlohmann::ordered_json healing_json(const HealedSurface& healed);

/// What `surface --heal` would do: "healing         mends it: …", or what it would leave.
void print_prospect_of_healing(const HealedSurface& healed, const std::string& input);

}  // namespace tetfarm
