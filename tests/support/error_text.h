/// What is said of something that goes wrong.
#pragma once

#include <string>

#include "base/error.h"

namespace tetfarm {

/// The message of the error that the action throws; "" when it throws none.
template <class Thrown = Error, class Action>
std::string error_text_of(const Action& action) {
  try {
    action();
  } catch (const Thrown& error) {
    return error.what();
  }
  return "";
}

}  // namespace tetfarm
