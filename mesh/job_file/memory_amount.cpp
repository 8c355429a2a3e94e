#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "mesh/job_file/job_file.h"

namespace tetfarm {
namespace {

struct Unit {
  std::string_view name;
  double bytes;
};

constexpr double binary = 1024;
constexpr std::array<Unit, 10> units = {{{"", 1},
                                         {"b", 1},
                                         {"kb", 1e3},
                                         {"mb", 1e6},
                                         {"gb", 1e9},
                                         {"tb", 1e12},
                                         {"kib", binary},
                                         {"mib", binary* binary},
                                         {"gib", binary* binary* binary},
                                         {"tib", binary* binary* binary* binary}}};
constexpr double most_bytes = 0x1p53;

}  // namespace

std::optional<std::int64_t> parse_memory(std::string_view text) {
  double amount = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), amount);
  if (error != std::errc()) return std::nullopt;
  std::string name(end, text.data() + text.size());
  if (name.starts_with(' ')) name.erase(0, 1);
  std::transform(name.begin(), name.end(), name.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  const auto unit =
      std::find_if(units.begin(), units.end(), [&name](const Unit& u) { return u.name == name; });
  if (unit == units.end()) return std::nullopt;
  const double bytes = std::floor(amount * unit->bytes);
  if (!(bytes >= 1 && bytes <= most_bytes)) return std::nullopt;
  return static_cast<std::int64_t>(bytes);
}

}  // namespace tetfarm
