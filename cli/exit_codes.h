/// What the exit codes of base/error.h mean, in words for help and for the manual.
#pragma once

#include <span>
#include <string>

#include "base/error.h"

namespace tetfarm {

struct MeaningOfCode {
  ExitCode code = ExitCode::ok;
  const char* meaning = "";
};

/// All, from 0 on.
std::span<const MeaningOfCode> exit_codes();

/// "Exit codes: 0 done; 1 failed; …" in lines of at most 80 letters.
std::string exit_codes_text();

}  // namespace tetfarm
