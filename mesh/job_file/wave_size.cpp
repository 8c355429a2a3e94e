#include "mesh/job_file/wave_size.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace tetfarm {
namespace {

struct FrequencyUnit {
  std::string_view name;
  double hertz;
};

constexpr std::array<FrequencyUnit, 6> frequency_units = {
    {{"", 1}, {"Hz", 1}, {"kHz", 1e3}, {"MHz", 1e6}, {"GHz", 1e9}, {"THz", 1e12}}};

}  // namespace

double wavelength_of(const WaveSize& wave) { return wave.speed / wave.frequency; }

double size_of(const WaveSize& wave) { return wavelength_of(wave) / wave.per_wavelength; }

bool has_size(const WaveSize& wave) {
  const double size = size_of(wave);
  return std::isfinite(size) && size > 0;
}

std::string wave_size_text(const WaveSize& wave) {
  std::array<char, 100> text{};
  std::snprintf(text.data(), text.size(), "%.6g (%.6g to a wavelength of %.6g)", size_of(wave),
                wave.per_wavelength, wavelength_of(wave));
  return text.data();
}

std::optional<double> parse_frequency(std::string_view text) {
  double amount = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), amount);
  if (error != std::errc()) return std::nullopt;
  std::string_view name = text.substr(static_cast<std::size_t>(end - text.data()));
  if (name.size() > 1 && name.front() == ' ') name.remove_prefix(1);
  const auto unit = std::find_if(frequency_units.begin(), frequency_units.end(),
                                 [name](const FrequencyUnit& u) { return u.name == name; });
  if (unit == frequency_units.end()) return std::nullopt;
  const double hertz = amount * unit->hertz;
  if (!std::isfinite(hertz) || hertz <= 0) return std::nullopt;
  return hertz;
}

}  // namespace tetfarm
