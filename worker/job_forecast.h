/// What a job will come to before it starts: elements, memory, disk and time; and whether that may
/// be.
///
/// Source: none in the thesis, whose user knows what the machines hold. All is told by the job
/// alone, from the estimated elements and the triangles of the surface (task_cost.h). Units: bytes;
/// seconds of one core.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "base/error.h"
#include "mesh/job_file/job_file.h"
#include "worker/task_cost.h"

namespace tetfarm {

struct JobForecast {
  double elements = 0;
  double subdomains = 1;  ///< that it is cut into
  double task_bytes = 0;  ///< memory of the largest task
  double disk_bytes = 0;  ///< when most files are there: meshes of the sub-domains, and the result
  double seconds = 0;
};

JobForecast forecast_of(const JobFile& job, double input_bytes, const SubdomainSize& root,
                        double subdomains);

/// Adds layers, which are grown in so many tasks.
void add_layers(double cells, double tasks, JobForecast& forecast);

/// "about 1.2M elements in 8 sub-domains, 90 MB of memory a task, 130 MB of disk, 6 s of one core"
std::string forecast_text(const JobForecast& forecast);

/// No job has more elements, whatever it asks for.
inline constexpr double most_elements_of_all = 1e12;

/// The estimated elements of the job, had it that `default` spacing.
using ElementsWithSize = std::function<double(double size)>;

/// A spacing of two digits that keeps the job within so many elements, and what it then has;
/// nothing where no spacing does, as surface and sources ask for more. `volume` is the domain's.
struct FittingSize {
  double size = 0;
  double elements = 0;
};
std::optional<FittingSize> fitting_size(double volume, double most_elements,
                                        const ElementsWithSize& elements);

/// What a job lives in, and how to find out what a coarser one would come to.
struct JobLimits {
  double volume = 0;               ///< of the domain
  ElementsWithSize elements_with;  ///< asked when the job is too large only
  double free_bytes = 0;           ///< of the disk, for this job; 0: not known
};

/// @throws UsageError when the job has more elements than its max_elements, or than any job may,
/// with the size that would do.
void require_few_elements(const JobFile& job, double elements, const JobLimits& limits);

/// The disk cannot hold the job; trying again does not help.
class JobTooLarge : public Error {
 public:
  explicit JobTooLarge(const std::string& message) : Error(ExitCode::out_of_resources, message) {}
};

/// @throws JobTooLarge when the disk has too little room, with the size that would do; never when
/// the job may have any number of elements (max_elements 0, `--force`).
void require_disk(const JobFile& job, const JobForecast& forecast, const JobLimits& limits);

}  // namespace tetfarm
