#include "base/error.h"

#include <cerrno>
#include <cstring>

namespace tetfarm {
namespace {

ExitCode exit_code_of(int error_number) {
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
    case ENOMEM:
      return ExitCode::out_of_resources;
    case ENOENT:
      return ExitCode::not_found;
    default:
      return ExitCode::failed;
  }
}

}  // namespace

IoError::IoError(const std::string& what, const std::string& path, int error_number)
    : Error(exit_code_of(error_number), path + ": " + what + ": " + std::strerror(error_number)),
      error_number_(error_number) {}

}  // namespace tetfarm
