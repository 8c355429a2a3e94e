/// What `tetfarm doctor` looks at of keys: that nobody else can read or replace them, that the
/// halves of a pair belong together, and that they are those of the coordinator that uses a store.
#pragma once

#include <filesystem>
#include <string>

#include "cli/findings.h"
#include "proto/peer_security.h"

namespace tetfarm {

struct KeysToLookAt {
  std::filesystem::path wanted;    ///< folder of a coordinator's keys; "": the standard one
  std::filesystem::path standard;  ///< see default_keys_folder
  std::filesystem::path store;     ///< "": none
  std::filesystem::path old;       ///< beside its database; "": there is no store
  KeyFiles own;                    ///< of a worker or a client
};

/// The folder, each secret key in it, the list of those who may connect, and the key that the store
/// has of its coordinator; then the keys of a worker or a client. Nothing of another user's.
/// @throws Error, IoError for what cannot be read.
Findings look_at_keys(const KeysToLookAt& keys);

}  // namespace tetfarm
