#include "cli/picture_options.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>

#include "base/error_with_help.h"

namespace tetfarm {
namespace {

constexpr int most_pixels = 16384;

}  // namespace

std::pair<int, int> picture_size(std::string_view text) {
  const auto refuse = [text] {
    throw UsageError("\"" + std::string(text) + "\" is not WIDTHxHEIGHT, each from 1 to " +
                         std::to_string(most_pixels),
                     "--size");
  };
  const auto number = [&](std::string_view digits) {
    int value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool is_whole = error == std::errc() && end == digits.data() + digits.size();
    if (!is_whole || value < 1 || value > most_pixels) refuse();
    return value;
  };
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) refuse();
  return {number(text.substr(0, cross)), number(text.substr(cross + 1))};
}

bool has_ending(const std::string& file, std::string_view ending) {
  std::string of_file = std::filesystem::path(file).extension().string();
  std::transform(of_file.begin(), of_file.end(), of_file.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return of_file == ending;
}

void require_png(const std::string& output) {
  if (has_ending(output, ".png")) return;
  throw ErrorWithHelp(ExitCode::usage,
                      output + ": render writes only PNG pictures; give a name that ends in .png",
                      "");
}

}  // namespace tetfarm
