#include "mesh/job_file/job_section.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/edit_distance.h"
#include "base/error.h"
#include "mesh/job_file/toml_limits.h"

namespace tetfarm {
namespace {

constexpr std::size_t longest_quoted = 100;

/// What somebody wrote, as far as a message has room for it.
std::string quotable(std::string_view text) {
  if (text.size() <= longest_quoted) return std::string(text);
  std::size_t end = longest_quoted;
  while ((static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return std::string(text.substr(0, end)) + "…";
}

std::string in_ticks(std::string_view word) { return "`" + quotable(word) + "`"; }

std::string did_you_mean(std::string_view word, Words known) {
  if (word.size() > longest_quoted) return {};
  const std::string_view nearest = nearest_word(word, known);
  return nearest.empty() ? "" : "; did you mean " + in_ticks(nearest) + "?";
}

std::string list_of(Words words) {
  std::string list;
  for (const std::string_view word : words)
    list += (list.empty() ? "\"" : ", \"") + std::string(word) + '"';
  return list;
}

std::string_view type_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& path) {
  check_toml_limits(text, path);
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw UsageError(std::string(error.description()),
                     path + ":" + std::to_string(at.line) + ":" + std::to_string(at.column));
  }
}

JobSection::JobSection(const toml::table& table, std::string name, Words keys,
                       const std::string& path)
    : table_(table), name_(std::move(name)), path_(path) {
  for (const auto& [key, value] : table_) {
    const std::string_view found = key.str();
    if (std::find(keys.begin(), keys.end(), found) != keys.end()) continue;
    fail(key.source(), "unknown key " + in_ticks(found) +
                           (name_.empty() ? "" : " in [" + name_ + "]") +
                           did_you_mean(found, keys));
  }
}

void JobSection::fail(const toml::source_region& source, const std::string& what) const {
  const toml::source_position at = source.begin;
  throw UsageError(
      what, path_ + (at ? ":" + std::to_string(at.line) + ":" + std::to_string(at.column) : ""));
}

void JobSection::fail(std::string_view key, const std::string& what) const {
  const toml::node* node = table_.get(key);
  fail((node != nullptr ? *node : table_).source(), in_ticks(key) + " " + what);
}

void JobSection::fail_type(std::string_view key, const std::string& wanted) const {
  fail(key, "must be " + wanted + ", not " + std::string(type_of(node(key))));
}

const toml::node& JobSection::node(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) fail(key, "is missing" + (name_.empty() ? "" : " in [" + name_ + "]"));
  return *node;
}

std::string JobSection::text(std::string_view key) const {
  const auto value = node(key).value_exact<std::string>();
  if (!value) fail_type(key, "a string");
  return *value;
}

std::string JobSection::one_of(std::string_view key, Words known) const {
  const std::string value = text(key);
  check_known(node(key), key, value, known);
  return value;
}

void JobSection::check_known(const toml::node& at, std::string_view key, std::string_view value,
                             Words known) const {
  if (std::find(known.begin(), known.end(), value) != known.end()) return;
  fail(at.source(), in_ticks(key) + " is \"" + quotable(value) + "\", not one of " +
                        list_of(known) + did_you_mean(value, known));
}

bool JobSection::boolean(std::string_view key) const {
  const auto value = node(key).value_exact<bool>();
  if (!value) fail_type(key, "true or false");
  return *value;
}

std::int64_t JobSection::integer(std::string_view key, std::int64_t least,
                                 std::int64_t most) const {
  const auto value = node(key).value_exact<std::int64_t>();
  if (!value) fail_type(key, "an integer");
  if (*value < least) fail(key, "must be at least " + std::to_string(least));
  if (*value > most) fail(key, "must be at most " + std::to_string(most));
  return *value;
}

double JobSection::finite(const toml::node& at, std::string_view key) const {
  const bool is_number = at.is_integer() || at.is_floating_point();
  if (!is_number) {
    fail(at.source(), in_ticks(key) + " must be a number, not " + std::string(type_of(at)));
  }
  const double value = at.value<double>().value_or(HUGE_VAL);
  if (!std::isfinite(value)) fail(at.source(), in_ticks(key) + " must be finite");
  return value;
}

double JobSection::positive(std::string_view key) const {
  const double value = finite(node(key), key);
  if (value <= 0) fail(key, "must be positive");
  return value;
}

double JobSection::not_negative(std::string_view key) const {
  const double value = finite(node(key), key);
  if (value < 0) fail(key, "must not be negative");
  return value;
}

const toml::array& JobSection::array(std::string_view key) const {
  const toml::array* value = node(key).as_array();
  if (value == nullptr) fail_type(key, "an array");
  return *value;
}

JobSection JobSection::table(std::string_view key, Words keys) const {
  static const toml::table empty;
  const std::string full_name = name_.empty() ? std::string(key) : name_ + "." + std::string(key);
  const toml::node* value = table_.get(key);
  if (value == nullptr) return {empty, full_name, keys, path_};
  if (!value->is_table()) fail_type(key, "a table");
  return {*value->as_table(), full_name, keys, path_};
}

JobSection JobSection::item(const toml::node& value, std::string_view key, Words keys) const {
  if (!value.is_table()) {
    fail(value.source(), in_ticks(key) + " must hold tables, not " + std::string(type_of(value)));
  }
  return {*value.as_table(), std::string(key), keys, path_};
}

}  // namespace tetfarm
