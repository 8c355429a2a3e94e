/// Answers for which the farm has to be asked: of single jobs and tasks, tables, old events, and
/// what changes something. Used by one thread; what was fetched is kept for others who ask.
///
/// Surfaces of sub-domains and maps have bounds of their own (surface_answers.h, job_maps.h); of
/// the rest, at most two million rows of four tables and 64 MiB of 256 answers are kept.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "dashboard/api_answer.h"
#include "dashboard/farm_look.h"
#include "dashboard/farm_source.h"
#include "dashboard/job_maps.h"
#include "dashboard/kept_things.h"
#include "dashboard/row_table.h"
#include "dashboard/surface_answers.h"

namespace tetfarm {

class FetchedAnswers {
 public:
  using Clock = std::function<LookTime()>;
  explicit FetchedAnswers(Clock clock) : clock_(std::move(clock)) {}

  /// @pre what it asks for is not in every snapshot. @throws NoAnswer.
  ApiAnswer answer(const ApiRequest& request, FarmSource& source, FarmLook& look);

 private:
  std::string fetched(const ApiRequest& request, FarmSource& source, FarmLook& look);
  ApiAnswer page(const ApiRequest& request, FarmSource& source);
  KeptThings<RowTable>::Kept table(const ApiRequest& request, FarmSource& source);

  Clock clock_;
  KeptThings<RowTable> tables_{4, 2'000'000};
  SurfaceAnswers surfaces_{[clock = clock_] { return clock().steady_ms; }};
  JobMaps maps_;
  KeptThings<std::string> answers_{256, std::size_t{64} << 20U};
};

/// Something that has been asked for already: the same for the same request.
std::string name_of_request(const ApiRequest& request);

}  // namespace tetfarm
