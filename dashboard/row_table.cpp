#include "dashboard/row_table.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "json/json_line.h"
#include "json/query_json.h"
#include "proto/messages.pb.h"

namespace tetfarm {
namespace {

using Json = nlohmann::ordered_json;

Json values_of(RowKind kind, std::string_view packed) {
  const auto size = static_cast<int>(packed.size());
  if (kind == RowKind::task) {
    wire::TaskLine line;
    const bool is_read = line.ParseFromArray(packed.data(), size);
    TF_CHECK(is_read);
    return task_values(line);
  }
  wire::AttemptLine line;
  const bool is_read = line.ParseFromArray(packed.data(), size);
  TF_CHECK(is_read);
  return attempt_values(line);
}

/// A column that is none; "" when all are.
std::string unknown_column(const std::vector<std::string>& wanted,
                           const std::vector<std::string>& known) {
  for (const std::string& name : wanted) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      return name.empty() ? "''" : name;
  }
  return {};
}

Json chosen_values(const Json& values, const std::vector<std::string>& columns) {
  Json row = Json::array();
  for (const std::string& column : columns) row.push_back(values.at(column));
  return row;
}

std::string with_commas(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

void RowTable::add(std::uint64_t number, const google::protobuf::MessageLite& row) {
  TF_CHECK(numbers_.empty() || number > numbers_.back());
  numbers_.push_back(number);
  row.AppendToString(&bytes_);
  ends_.push_back(bytes_.size());
}

std::string_view RowTable::packed(std::size_t row) const {
  TF_CHECK(row < ends_.size());
  const std::size_t begin = row == 0 ? 0 : ends_[row - 1];
  return std::string_view(bytes_).substr(begin, ends_[row] - begin);
}

std::size_t RowTable::first_after(std::uint64_t number) const {
  const auto found = std::upper_bound(numbers_.begin(), numbers_.end(), number);
  return static_cast<std::size_t>(found - numbers_.begin());
}

std::vector<std::string> columns_of(RowKind kind) {
  std::vector<std::string> names;
  const Json values = values_of(kind, {});
  for (const auto& item : values.items()) {
    if (item.key() != "type") names.push_back(item.key());
  }
  return names;
}

std::variant<std::string, ApiError> table_page(const RowTable& table, RowKind kind,
                                               const ApiRequest& request) {
  const std::vector<std::string> known = columns_of(kind);
  if (const std::string wrong = unknown_column(request.columns, known); !wrong.empty()) {
    return ApiError{400, "no such column: " + wrong, "the columns are " + with_commas(known)};
  }
  const std::vector<std::string>& columns = request.columns.empty() ? known : request.columns;
  const std::size_t begin = table.first_after(request.after);
  const std::size_t end = std::min(table.size(), begin + request.limit);
  std::string rows;
  for (std::size_t row = begin; row < end; ++row) {
    if (row > begin) rows += ',';
    rows += json_line(chosen_values(values_of(kind, table.packed(row)), columns));
  }
  const std::uint64_t next = end < table.size() ? table.number(end - 1) : 0;
  return "{\"columns\":" + json_line(Json(columns)) + ",\"rows\":[" + rows +
         "],\"next\":" + std::to_string(next) + "}";
}

}  // namespace tetfarm
