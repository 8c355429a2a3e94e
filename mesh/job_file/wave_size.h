/// Edge lengths for solvers of waves: so many to the wavelength of a frequency.
///
/// Source: none in the thesis. size = speed / (frequency · per_wavelength). Units: hertz; the speed
/// in lengths of the surface's unit per second, which is metres only where nothing else is said.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tetfarm {

/// Of light in vacuum, in metres per second.
inline constexpr double speed_of_light = 299'792'458;

struct WaveSize {
  double frequency = 0;  ///< of the shortest waves that are to be resolved
  double speed = speed_of_light;
  double per_wavelength = 10;  ///< edges
};

double wavelength_of(const WaveSize& wave);

/// The longest edges that it allows; 0 or infinite where the numbers make no sense together.
double size_of(const WaveSize& wave);

/// Whether there are edges of that size: it is a finite number above 0.
bool has_size(const WaveSize& wave);

/// "0.0299792 (10 to a wavelength of 0.299792)"
std::string wave_size_text(const WaveSize& wave);

/// "1.2GHz", "300 MHz", "20kHz", "50Hz" or plain hertz: a number above 0 and Hz, kHz, MHz, GHz or
/// THz, written as SI has them; nothing for any other text.
std::optional<double> parse_frequency(std::string_view text);

/// What parse_frequency takes, for messages.
inline constexpr const char* frequency_examples = "a frequency such as 1.2GHz, 300MHz or 20000";

}  // namespace tetfarm
