/// What the folder of a run, or a store, still knows of a mesh that was made there.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/farm_view.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

/// DIR/.tetfarm when DIR is the output of a run, DIR when it is a store; nothing else.
std::optional<std::filesystem::path> store_of(const std::filesystem::path& folder);
/// The same, of a folder that the user named. @throws Error (not_found) when it is neither.
std::filesystem::path require_store_of(const std::filesystem::path& folder);

/// The last job of the store that is done; with a name, the last of that name. "": there is none.
std::string last_done_job(FarmView& view, const std::string& name = "");

/// The spacing that the job's tasks read; nothing when the store has it no more. @throws Error,
/// IoError, CorruptFile.
std::optional<SpacingField> spacing_of_job(FarmView& view, const std::filesystem::path& store,
                                           const std::string& job);

/// Of a mesh that lies in the folder of a run, by its name; nothing when no run is known of it.
std::optional<SpacingField> spacing_beside(const std::filesystem::path& mesh);

}  // namespace tetfarm
