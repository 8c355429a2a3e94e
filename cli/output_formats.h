/// Which formats --format may name.
#pragma once

#include <string>
#include <vector>

namespace tetfarm {

/// @throws UsageError for one that is unknown, with the nearest that is, and for one named twice.
void require_known_formats(const std::vector<std::string>& formats);

}  // namespace tetfarm
