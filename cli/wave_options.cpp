#include "cli/wave_options.h"

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace tetfarm {
namespace {

std::string short_number(double number) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.6g", number);
  return text.data();
}

void require_within(const WaveSize& wave, double size, const std::string& option) {
  if (size <= size_of(wave)) return;
  throw UsageError("an edge length of " + short_number(size) +
                       " is more than --frequency ([spacing] frequency) allows, " +
                       wave_size_text(wave) + "; leave it out, or give --size instead",
                   option);
}

}  // namespace

bool is_given(const WaveOptions& typed) {
  return !typed.frequency.empty() || typed.speed || typed.per_wavelength;
}

std::optional<WaveSize> wave_of(const WaveOptions& typed, const std::optional<WaveSize>& of_job) {
  std::optional<WaveSize> wave = of_job;
  if (!typed.frequency.empty()) {
    const auto hertz = parse_frequency(typed.frequency);
    if (!hertz) {
      throw UsageError("must be " + std::string(frequency_examples) + ", not " + typed.frequency,
                       "--frequency");
    }
    if (!wave) wave.emplace();
    wave->frequency = *hertz;
  }
  if (!wave && is_given(typed)) {
    throw UsageError("there is no frequency; also give --frequency",
                     typed.speed ? "--wave-speed" : "--per-wavelength");
  }
  if (typed.speed) wave->speed = *typed.speed;
  if (typed.per_wavelength) wave->per_wavelength = *typed.per_wavelength;
  if (wave && !has_size(*wave)) {
    throw UsageError(
        "gives no edge length: --wave-speed / (--frequency · --per-wavelength) is out "
        "of range",
        "--frequency");
  }
  return wave;
}

void require_within_wave(const JobFile& job) {
  if (!job.wave) return;
  require_within(*job.wave, job.outer_spacing, "--outer-size ([domain] spacing)");
  if (job.remeshing)
    require_within(*job.wave, job.remeshing->size, "--size-on-body ([surface] size)");
}

std::string remark_on_long_edges(const JobFile& job, double longest_edge) {
  const bool is_short = !job.wave || longest_edge <= size_of(*job.wave);
  if (is_short || job.remeshing) return "";
  return "the surface has edges of up to " + short_number(longest_edge) + ", longer than the " +
         short_number(size_of(*job.wave)) +
         " that the frequency allows, and they stay as they are; --remesh makes shorter ones";
}

void tell_wave(const JobFile& job, ProgressStyle style) {
  if (!job.wave || style == ProgressStyle::none) return;
  std::fprintf(stderr, "size       %s\n", wave_size_text(*job.wave).c_str());
}

void put_wave(const std::optional<WaveSize>& wave, nlohmann::ordered_json& json) {
  if (!wave) return;
  json["size"] = size_of(*wave);
  json["wavelength"] = wavelength_of(*wave);
}

}  // namespace tetfarm
