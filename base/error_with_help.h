/// An error that knows its own remedy, where the one that goes with its exit code would not fit.
#pragma once

#include <string>
#include <utility>

#include "base/error.h"

namespace tetfarm {

/// `help` is what to do about it, one line; "": the message says it all, and nothing is added.
class ErrorWithHelp : public Error {
 public:
  ErrorWithHelp(ExitCode code, const std::string& message, std::string help)
      : Error(code, message), help_(std::move(help)) {}
  const std::string& help() const { return help_; }

 private:
  std::string help_;
};

}  // namespace tetfarm
