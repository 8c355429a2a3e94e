#include "dashboard/row_table.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "proto/messages.pb.h"

namespace tetfarm {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

/// Tasks 10, 20, …
RowTable tasks(std::uint64_t count) {
  RowTable table;
  for (std::uint64_t i = 1; i <= count; ++i) {
    wire::TaskLine task;
    task.set_task(10 * i);
    task.set_kind("mesh");
    task.set_state(i % 2 == 0 ? "done" : "ready");
    table.add(task.task(), task);
  }
  return table;
}

nlohmann::json page_of(const RowTable& table, const ApiRequest& request) {
  const auto page = table_page(table, RowKind::task, request);
  EXPECT_TRUE(std::holds_alternative<std::string>(page));
  return nlohmann::json::parse(std::get<std::string>(page));
}

TEST(RowTable, pages_lead_through_all_rows_once) {
  const RowTable table = tasks(5);
  ApiRequest request;
  request.columns = {"task", "state"};
  request.limit = 2;
  std::vector<int> seen;
  do {
    const nlohmann::json page = page_of(table, request);
    EXPECT_EQ(page["columns"], (nlohmann::json{"task", "state"}));
    for (const auto& row : page["rows"]) seen.push_back(row[0]);
    request.after = page["next"];
  } while (request.after != 0 && seen.size() < 10);
  EXPECT_EQ(seen, (std::vector<int>{10, 20, 30, 40, 50}));
}

TEST(RowTable, a_page_after_the_last_row_is_empty_and_the_last) {
  ApiRequest request;
  request.after = 50;
  const nlohmann::json page = page_of(tasks(5), request);
  EXPECT_TRUE(page["rows"].empty());
  EXPECT_EQ(page["next"], 0);
  EXPECT_TRUE(page_of(RowTable(), ApiRequest())["rows"].empty());
}

TEST(RowTable, has_all_keys_of_a_row_as_columns_unless_some_are_chosen) {
  const std::vector<std::string> columns = columns_of(RowKind::task);
  for (const char* name : {"task", "kind", "path", "state", "share", "doing"}) {
    EXPECT_THAT(columns, Contains(name));
  }
  EXPECT_THAT(columns, Not(Contains("type")));
  EXPECT_THAT(columns_of(RowKind::attempt), Not(Contains("log")));
  const nlohmann::json page = page_of(tasks(1), ApiRequest());
  EXPECT_EQ(page["columns"].size(), columns.size());
  EXPECT_EQ(page["rows"][0].size(), columns.size());
}

TEST(RowTable, an_unknown_column_is_named_with_those_that_there_are) {
  ApiRequest request;
  request.columns = {"task", "colour"};
  const auto page = table_page(tasks(1), RowKind::task, request);
  ASSERT_TRUE(std::holds_alternative<ApiError>(page));
  EXPECT_EQ(std::get<ApiError>(page).status, 400);
  EXPECT_THAT(std::get<ApiError>(page).error, HasSubstr("colour"));
  EXPECT_THAT(std::get<ApiError>(page).help, HasSubstr("task, job, kind"));
}

}  // namespace
}  // namespace tetfarm
