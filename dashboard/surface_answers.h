/// The sub-domains that a page can draw, and the surface of each: from their files in the store,
/// where the dashboard sees it. What was made of a file serves all who ask, as files never change.
///
/// Bounded: 2,000 sub-domains of a job, the first by heap number, of at most 200,000 that are
/// looked through; files of at most 64 MiB; 64 MiB of surfaces, and the lists of four jobs, are
/// kept. A file is read whole: twice its size in memory, while its surface is made.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dashboard/api_answer.h"
#include "dashboard/api_request.h"
#include "dashboard/farm_source.h"
#include "dashboard/kept_things.h"

namespace tetfarm {

inline constexpr std::uint64_t largest_shown_file = std::uint64_t{64} << 20U;

/// The sub-domains of a job that nothing was made of yet: those that are not cut, nor joined.
struct SubdomainsNow {
  std::vector<wire::SubdomainLine> lines;
  std::size_t left_out = 0;  ///< beyond the most that are told of
  wire::Artifact surface;    ///< of the job; without a hash when it is not known
};

class SurfaceAnswers {
 public:
  using Clock = std::function<std::int64_t()>;  ///< steady, milliseconds
  explicit SurfaceAnswers(Clock clock) : clock_(std::move(clock)) {}

  // Both: @throws as FarmSource; Error (out_of_resources) for what is too large; CorruptFile,
  // IoError.
  /// JSON: which can be drawn.
  std::string list(const std::string& job, FarmSource& source);
  /// Bytes of one of them. @throws Error (not_found) too, when it or its file is not there (any
  /// more).
  ApiAnswer surface(const ApiRequest& request, FarmSource& source);

 private:
  using Kept = KeptThings<SubdomainsNow>::Kept;
  Kept subdomains(const std::string& job, FarmSource& source);

  Clock clock_;
  KeptThings<SubdomainsNow> subdomains_{4, 4 * 2'000};
  KeptThings<std::string> surfaces_{4'096, std::size_t{64} << 20U};
};

}  // namespace tetfarm
