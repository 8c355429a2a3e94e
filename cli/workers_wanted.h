/// How many workers a run has work for.
#pragma once

#include <cstddef>

#include "proto/messages.pb.h"

namespace tetfarm {

/// What the tasks that wait come to, and those that run: more workers than that have no work.
std::size_t workers_wanted(const wire::StatusReply& farm);

}  // namespace tetfarm
