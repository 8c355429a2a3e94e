/// The folder of the store's scratch folder in which an attempt keeps its files in the making.
///
/// Whoever finds that an attempt is over removes the folder with all in it: the task itself, the
/// worker when the task's process was killed, the coordinator when the worker is gone, and the next
/// coordinator when it starts. A disk that filled up is not kept full by what was left.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>

#include "base/ids.h"
#include "store/artifact_store.h"

namespace tetfarm {

/// scratch/attempt-7; it is there only when the attempt has put something in it.
std::filesystem::path attempt_scratch(const ArtifactStore& store, AttemptId attempt);

/// One that is not there is fine; what cannot be removed now is swept later.
void remove_attempt_scratch(const ArtifactStore& store, AttemptId attempt) noexcept;

/// Removes what attempts that are over, workers that are gone and publications that were cut short
/// have left: folders of other attempts than those that run, all probes of workers (who lives makes
/// a new one), and temporary files that were last touched before `untouchable_since_ms` (since
/// 1970). Cost: one look at each entry of the scratch folder.
void sweep_leftovers(const ArtifactStore& store, const std::set<AttemptId>& running,
                     std::int64_t untouchable_since_ms);

}  // namespace tetfarm
