/// Which files between its tasks a job that was submitted keeps, as its job file says.
#pragma once

#include "store/rows.h"

namespace tetfarm {

/// Whether it keeps all: loops do, and jobs whose text an earlier version took and this one does
/// not. Cost: reads the text.
bool keeps_all_files(const JobRow& job);

}  // namespace tetfarm
