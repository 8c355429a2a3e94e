#include "cli/option_checks.h"

#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

#include "mesh/job_file/wave_size.h"

namespace tetfarm {
namespace {

/// The whole of a text as a number; nothing for any other text, infinity included.
template <class Number>
std::optional<Number> number_of(const std::string& text) {
  Number number{};
  const char* end = text.data() + text.size();
  const char* begin = text.starts_with('+') ? text.data() + 1 : text.data();
  const auto [stopped, error] = std::from_chars(begin, end, number);
  if (error != std::errc() || stopped != end) return std::nullopt;
  if constexpr (std::is_floating_point_v<Number>) {
    if (!std::isfinite(number)) return std::nullopt;
  }
  return number;
}

/// Whatever does not hold is refused as "must be WANTED, not TEXT".
CLI::Validator must_be(const std::string& wanted,
                       const std::function<bool(const std::string&)>& holds) {
  const auto check = [wanted, holds](std::string& text) {
    return holds(text) ? "" : "must be " + wanted + ", not " + (text.empty() ? "\"\"" : text);
  };
  return CLI::Validator(check, "", "");
}

std::string text_of(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

}  // namespace

CLI::Validator positive_number() {
  return must_be("a number above 0",
                 [](const std::string& text) { return number_of<double>(text).value_or(0) > 0; });
}

CLI::Validator not_negative_number() {
  return must_be("a number, 0 or above",
                 [](const std::string& text) { return number_of<double>(text).value_or(-1) >= 0; });
}

CLI::Validator number_between(double least, double most) {
  return must_be("a number from " + text_of(least) + " to " + text_of(most),
                 [least, most](const std::string& text) {
                   const auto number = number_of<double>(text);
                   return number && *number >= least && *number <= most;
                 });
}

CLI::Validator whole_number(std::int64_t least, std::int64_t most) {
  return must_be("a whole number from " + std::to_string(least) + " to " + std::to_string(most),
                 [least, most](const std::string& text) {
                   const auto number = number_of<std::int64_t>(text);
                   return number && *number >= least && *number <= most;
                 });
}

CLI::Validator counting_number() {
  return must_be("a whole number above 0", [](const std::string& text) {
    return number_of<std::int64_t>(text).value_or(0) > 0;
  });
}

CLI::Validator off_or_number_above(double bound, double most) {
  return must_be("off or a number above " + text_of(bound) + ", at most " + text_of(most),
                 [bound, most](const std::string& text) {
                   const double number = number_of<double>(text).value_or(bound);
                   return text == "off" || (number > bound && number <= most);
                 });
}

CLI::Validator frequency() {
  return must_be(frequency_examples,
                 [](const std::string& text) { return parse_frequency(text).has_value(); });
}

CLI::Validator number_of_parts(std::int64_t most) {
  const auto translate = [most](std::string& text) -> std::string {
    const auto number = number_of<std::int64_t>(text);
    if (text == "as-meshed") {
      text = "0";
    } else if (!number || *number < 1 || *number > most) {
      return "must be as-meshed or a whole number from 1 to " + std::to_string(most) + ", not " +
             text;
    }
    return "";
  };
  return CLI::Validator(translate, "", "");
}

CLI::Validator suggested(std::span<const std::string_view> words) {
  const auto take_all = [](std::string& /*text*/) { return std::string(); };
  return CLI::Validator(take_all, "{" + CLI::detail::join(words, ", ") + "}", "");
}

CLI::Validator not_empty() {
  const auto check = [](std::string& text) {
    return std::string(text.empty() ? "must not be empty" : "");
  };
  return CLI::Validator(check, "", "");
}

/// Of `-o=out`, which many programs take as `-o out`: CLI11 has the value "=out" then.
CLI::Validator without_equals_sign() {
  const auto take_away = [](std::string& text) {
    if (text.starts_with('=')) text.erase(0, 1);
    return std::string();
  };
  return CLI::Validator(take_away, "", "");
}

void refuse_empty_paths(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    const bool is_path = option->get_positional() || option->check_name("--output");
    if (is_path) option->check(not_empty());
    if (option->check_name("-o")) option->transform(without_equals_sign());
  }
  for (CLI::App* sub : app.get_subcommands([](CLI::App*) { return true; }))
    refuse_empty_paths(*sub);
}

}  // namespace tetfarm
