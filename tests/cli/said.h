// What a command that is called as main calls it says and how it ends.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "base/error.h"
#include "base/error_with_help.h"

namespace tetfarm {

struct Said {
  ExitCode code = ExitCode::ok;
  std::string out;
  std::string err;
  std::string error;  ///< what was thrown
  std::string help;   ///< that the error has by itself
};

/// `act` returns an exit code or throws an Error.
template <class Act>
Said said_by(const Act& act) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  Said said;
  try {
    said.code = act();
  } catch (const ErrorWithHelp& error) {
    said.code = error.code();
    said.error = error.what();
    said.help = error.help();
  } catch (const Error& error) {
    said.code = error.code();
    said.error = error.what();
  }
  said.out = ::testing::internal::GetCapturedStdout();
  said.err = ::testing::internal::GetCapturedStderr();
  return said;
}

}  // namespace tetfarm
