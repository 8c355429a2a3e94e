/// The maps of a job that a page can draw: triangles with a number on each, from the .vtp files
/// among its results or its evidence in the store. Maps of defects show which triangles were
/// refused, maps of layers how many layers stand on each triangle of the wall.
///
/// Bounded: 16 maps of a job, files of at most 64 MiB; 64 MiB of what was made of them are kept. A
/// file is read whole: about three times its size in memory, while its triangles are found.
#pragma once

#include <cstddef>
#include <string>

#include "dashboard/api_answer.h"
#include "dashboard/api_request.h"
#include "dashboard/farm_source.h"
#include "dashboard/kept_things.h"

namespace tetfarm {

class JobMaps {
 public:
  // Both: @throws as FarmSource; Error (not_found) when there is no such job; IoError.
  /// JSON: which there are, and what the numbers of maps of defects mean.
  std::string list(const std::string& job, FarmSource& source) const;
  /// The triangles of one, in the bytes of shown_surface.h; the piece that each is of is its
  /// number.
  /// @throws Error (not_found) too, when it or its file is not there (any more), (out_of_resources)
  /// when the file is too large; InvalidInput, CorruptFile when it is no map.
  ApiAnswer map(const ApiRequest& request, FarmSource& source);

 private:
  KeptThings<std::string> maps_{256, std::size_t{64} << 20U};
};

}  // namespace tetfarm
