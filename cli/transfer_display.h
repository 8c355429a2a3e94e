/// How far a file on its way is: for a person a bar on a terminal, otherwise a line now and then;
/// for programs lines of JSON. On standard error.
#pragma once

#include <cstdint>
#include <string>

#include "cli/command_line.h"

namespace tetfarm {

/// "812 B", "1.3 MB", "4.05 GB".
std::string bytes_text(std::uint64_t bytes);

/// "fetching wing.vtkhdf  1.3 GB of 4.05 GB  98.1 MB/s": `begun_at` were there `passed_ms` ago.
std::string transfer_text(const std::string& what, std::uint64_t there, std::uint64_t size,
                          std::uint64_t begun_at, std::int64_t passed_ms);

/// How much of `size` is there, as a bar.
std::string transfer_bar(std::uint64_t there, std::uint64_t size);

class TransferDisplay {
 public:
  explicit TransferDisplay(ProgressStyle style);
  TransferDisplay(const TransferDisplay&) = delete;
  TransferDisplay& operator=(const TransferDisplay&) = delete;
  /// Clears the bar.
  ~TransferDisplay() { end(); }

  void show(const std::string& what, std::uint64_t there, std::uint64_t size);
  /// Clears the bar, so that other lines may follow.
  void end();

 private:
  ProgressStyle style_;
  bool is_bar_;
  bool bar_is_drawn_ = false;
  std::string what_;
  std::int64_t begun_ms_ = 0;
  std::int64_t shown_ms_ = 0;
  std::uint64_t begun_at_ = 0;
};

}  // namespace tetfarm
