/// The file of those who may speak with a coordinator: a line for each, "PUBLIC-KEY ROLE NAME".
///
/// It is replaced in one step, so that a coordinator which reads it at any time sees the old list
/// or the new one. Lines that cannot be read let nobody in; '#' begins a comment.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "proto/key_file.h"
#include "proto/roles.h"

namespace tetfarm {

struct AuthorizedPeer {
  PublicKey key;
  Role role = Role::viewer;
  std::string name;
};

/// Invariant: a name occurs once.
struct AuthorizedKeys {
  std::map<PublicKey, AuthorizedPeer> peers;
  std::vector<std::string> bad_lines;  ///< what is wrong with which; they are ignored

  const AuthorizedPeer* find(const PublicKey& key) const;
};

std::filesystem::path authorized_keys_path(const std::filesystem::path& keys_folder);

AuthorizedKeys parse_authorized_keys(std::string_view text);

/// A file that is not there is an empty list.
/// @throws UsageError when others than the owner may write the file, or it is another user's;
/// IoError.
AuthorizedKeys read_authorized_keys(const std::filesystem::path& path);

/// Adds a line, one change at a time on this host. @throws UsageError when the name or the key is
/// there already, IoError.
void authorize(const std::filesystem::path& path, const AuthorizedPeer& peer);

/// Removes the lines of a peer, by its name or the digits of its key. @throws Error (not_found),
/// IoError.
void revoke(const std::filesystem::path& path, const std::string& name_or_key);

}  // namespace tetfarm
