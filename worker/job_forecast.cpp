#include "worker/job_forecast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "mesh/spacing/spacing_field.h"

namespace tetfarm {
namespace {

/// Of a tet, and of a triangle of a sub-domain, when most files are there, and of a tet where files
/// between tasks go (docs/measurements/2026-11-subdomains_and_workers.md).
constexpr double disk_bytes_per_element = 67;
constexpr double disk_bytes_per_element_of_needed = 46;
constexpr double disk_bytes_per_triangle = 250;
/// Of a cell of layers, nearly always a prism, in its portion, its cells and the result.
constexpr double disk_bytes_per_layer_cell = 145;
constexpr int most_trials = 8;

std::string with_prefix(double amount, const char* unit) {
  constexpr std::array<const char*, 7> prefixes = {"", "k", "M", "G", "T", "P", "E"};
  std::size_t prefix = 0;
  for (; amount >= 999.5 && prefix + 1 < prefixes.size(); amount /= 1000) ++prefix;
  std::array<char, 48> text{};
  const int decimals = prefix > 0 && amount < 99.95 ? 1 : 0;
  std::snprintf(text.data(), text.size(), "%.*f %s%s", decimals, amount, prefixes[prefix], unit);
  std::string result = text.data();
  while (result.ends_with(' ')) result.pop_back();
  return result;
}

std::string duration(double seconds) {
  constexpr std::array<std::pair<double, const char*>, 3> units = {
      {{86400, "days"}, {3600, "h"}, {60, "min"}}};
  std::array<char, 48> text{};
  for (const auto& [length, name] : units) {
    if (seconds < 2 * length) continue;
    std::snprintf(text.data(), text.size(), "%.3g %s", seconds / length, name);
    return text.data();
  }
  std::snprintf(text.data(), text.size(), "%.0f s", std::ceil(seconds));
  return text.data();
}

/// The least number of two digits that is not less.
double rounded_up(double x) {
  const double digit = std::pow(10.0, std::floor(std::log10(x)) - 1);
  return std::ceil(x / digit - 1e-9) * digit;
}

std::string short_number(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", x);
  return text.data();
}

std::string advice(double most_elements, const JobLimits& limits) {
  const auto fitting = fitting_size(limits.volume, most_elements, limits.elements_with);
  if (!fitting) {
    return "no size is large enough, because the surface's own edges or the sources ask for more: "
           "make them coarser, or set `[spacing] surface = \"ignore\"` and a size";
  }
  return "`--size " + short_number(fitting->size) + "` would give about " +
         with_prefix(fitting->elements, "");
}

double seconds_of_cuts(const SubdomainSize& root, double subdomains) {
  double seconds = 0;
  for (double nodes = 1; nodes < subdomains; nodes *= 2) {
    const double cuts = std::min(nodes, subdomains - nodes);
    const SubdomainSize node{root.elements / nodes, triangles_of_leaves(root, nodes) / nodes,
                             root.spacing_bytes, root.needles / nodes};
    seconds += cuts * decompose_cost(node).seconds;
  }
  return seconds;
}

}  // namespace

JobForecast forecast_of(const JobFile& job, double input_bytes, const SubdomainSize& root,
                        double subdomains) {
  const double triangles = triangles_of_leaves(root, subdomains);
  const SubdomainSize leaf{root.elements / subdomains, triangles / subdomains, root.spacing_bytes,
                           root.needles / subdomains};
  const TaskCost inspect = inspect_cost(input_bytes, root);
  const TaskCost assemble = assemble_cost(root.triangles, root.elements, leaf);
  JobForecast forecast;
  forecast.elements = root.elements;
  forecast.subdomains = subdomains;
  forecast.task_bytes = std::max({inspect.bytes, assemble.bytes, mesh_cost(leaf).bytes});
  forecast.seconds = inspect.seconds + seconds_of_cuts(root, subdomains) + assemble.seconds +
                     subdomains * (mesh_cost(leaf).seconds + write_cost(leaf.elements).seconds);
  if (subdomains > 1) {
    forecast.task_bytes = std::max(forecast.task_bytes, decompose_cost(root).bytes);
    if (job.across_cuts) {
      const TaskCost order = order_cost(triangles, leaf.triangles);
      forecast.task_bytes = std::max({forecast.task_bytes, leaf_bytes(leaf), order.bytes});
      forecast.seconds +=
          order.seconds +
          subdomains * (extract_cost(leaf.elements, leaf.triangles).seconds +
                        cosmetic_cost(turn_elements(leaf), leaf.spacing_bytes).seconds);
    }
  }
  const double per_element =
      keeps_all_files(job) ? disk_bytes_per_element : disk_bytes_per_element_of_needed;
  forecast.disk_bytes = input_bytes + 2 * root.spacing_bytes + disk_bytes_per_triangle * triangles +
                        per_element * root.elements;
  return forecast;
}

void add_layers(double cells, double tasks, JobForecast& forecast) {
  if (tasks == 0) return;
  const TaskCost grow = grow_cost(cells / tasks);
  forecast.elements += cells;
  forecast.task_bytes = std::max(forecast.task_bytes, grow.bytes);
  forecast.disk_bytes += disk_bytes_per_layer_cell * cells;
  forecast.seconds += tasks * grow.seconds;
}

std::string forecast_text(const JobForecast& forecast) {
  const std::string parts =
      forecast.subdomains > 1 ? " in " + with_prefix(forecast.subdomains, "") + " sub-domains" : "";
  return "about " + with_prefix(forecast.elements, "") + " elements" + parts + ", " +
         with_prefix(forecast.task_bytes, "B") + " of memory per task, " +
         with_prefix(forecast.disk_bytes, "B") + " of disk, " + duration(forecast.seconds) +
         " on one core";
}

std::optional<FittingSize> fitting_size(double volume, double most_elements,
                                        const ElementsWithSize& elements_with) {
  double size = rounded_up(std::cbrt(volume * SpacingField::elements_per_h3 / most_elements));
  for (int trial = 0; trial < most_trials; ++trial) {
    const double elements = elements_with(size);
    if (elements <= most_elements) return FittingSize{size, elements};
    size = rounded_up(std::max(1.02, std::cbrt(elements / most_elements)) * size);
  }
  return std::nullopt;
}

void require_few_elements(const JobFile& job, double elements, const JobLimits& limits) {
  const bool has_limit =
      job.max_elements > 0 && static_cast<double>(job.max_elements) <= most_elements_of_all;
  const double most = has_limit ? static_cast<double>(job.max_elements) : most_elements_of_all;
  if (elements <= most) return;
  std::string message = "the job would have about " + with_prefix(elements, "") +
                        " elements, more than the " + with_prefix(most, "") +
                        (has_limit ? " that it may have" : " that any job may have");
  if (has_limit) {
    message += " (`--max-elements` sets the limit, `--force` lifts it)";
  }
  throw UsageError(message + "; " + advice(most, limits), "spacing");
}

void require_disk(const JobFile& job, const JobForecast& forecast, const JobLimits& limits) {
  if (job.max_elements == 0 || limits.free_bytes <= 0) return;
  if (forecast.disk_bytes <= limits.free_bytes) return;
  const double most = forecast.elements * (limits.free_bytes / forecast.disk_bytes);
  throw JobTooLarge("the job would have about " + with_prefix(forecast.elements, "") +
                    " elements and need " + with_prefix(forecast.disk_bytes, "B") +
                    " of disk, of which only " + with_prefix(limits.free_bytes, "B") +
                    " is free; `--force` starts it anyway; " + advice(most, limits));
}

}  // namespace tetfarm
