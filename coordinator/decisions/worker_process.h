/// Who holds an attempt: a process, whatever its connections. Whoever has only the nonce, or only
/// the key, is another.
#pragma once

#include <compare>
#include <string>

#include "store/rows.h"

namespace tetfarm {

struct WorkerProcess {
  std::string key;         ///< public key of its connection, "": plain
  std::string nonce_hash;  ///< "": it has none

  friend auto operator<=>(const WorkerProcess&, const WorkerProcess&) = default;
};

inline WorkerProcess process_of(const AttemptRow& attempt) {
  return {attempt.key, attempt.nonce_hash};
}

}  // namespace tetfarm
