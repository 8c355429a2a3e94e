/// A store whose coordinator does not answer: what its rows say, read and never changed. When no
/// coordinator can be there, a job that has not ended is "stopped", and its tasks do not run.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "proto/messages.pb.h"

namespace tetfarm {

class StoreAtRest {
 public:
  /// `database`: the folder of the database. @throws Error (not_found) when there is no store or
  /// no database, IoError, CorruptFile. Cost: reads all rows but history.
  StoreAtRest(const std::filesystem::path& store, const std::filesystem::path& database);
  ~StoreAtRest();

  /// One page, as a coordinator answers that nobody works for. @throws Error as answer_query does.
  wire::QueryReply answer(const wire::Query& query) const;
  /// One job or ("") all.
  wire::StatusReply status(const std::string& job) const;

 private:
  struct Rows;
  std::unique_ptr<Rows> rows_;
};

}  // namespace tetfarm
