/// A file that shows a person what healing has changed.
#pragma once

#include <string>
#include <vector>

#include "mesh/healing/heal_act.h"

namespace tetfarm {

/// The triangles that were made, or removed where none were made, as a .vtp file with the arrays
/// `kind` (of the act, named in a comment) and `act` (its number). @throws IoError.
void write_acts_vtp(const std::vector<HealAct>& acts, const std::string& path);

}  // namespace tetfarm
