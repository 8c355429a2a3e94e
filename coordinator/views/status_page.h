/// The page that a browser shows: jobs, the tree of the newest running job, workers, and who did
/// what when. One file without scripts, pictures or anything from elsewhere.
#pragma once

#include <string>

#include "coordinator/views/query_answers.h"

namespace tetfarm {

/// Cost: looks at every task, and at the newest 1500 attempts.
std::string status_page(const QueryContext& context);

/// Text as HTML shows it.
std::string in_html(const std::string& text);

}  // namespace tetfarm
