/// The tasks or attempts of a job, kept in little memory, and pages of them in chosen columns: a
/// table of many rows is read by programs, which need not be told the names of columns in each.
#pragma once

#include <google/protobuf/message_lite.h>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "dashboard/api_request.h"

namespace tetfarm {

/// Rows with rising numbers, packed.
class RowTable {
 public:
  /// @pre `number` is higher than that of the row before.
  void add(std::uint64_t number, const google::protobuf::MessageLite& row);
  std::size_t size() const { return numbers_.size(); }
  std::uint64_t number(std::size_t row) const { return numbers_[row]; }
  std::string_view packed(std::size_t row) const;
  /// The first with a higher number; size() where there is none.
  std::size_t first_after(std::uint64_t number) const;

 private:
  std::vector<std::uint64_t> numbers_;
  std::vector<std::size_t> ends_;
  std::string bytes_;
};

enum class RowKind { task, attempt };

/// The keys of a row, without its type.
std::vector<std::string> columns_of(RowKind kind);

/// {"columns":[…],"rows":[[…]],"next":N}: the rows after request.after, at most request.limit; next
/// is 0 where they are the last. 400 for a column that rows do not have.
std::variant<std::string, ApiError> table_page(const RowTable& table, RowKind kind,
                                               const ApiRequest& request);

}  // namespace tetfarm
