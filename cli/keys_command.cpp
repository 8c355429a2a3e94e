#include <cstdio>
#include <filesystem>
#include <map>
#include <string>

#include "base/error_with_help.h"
#include "base/file_system.h"
#include "cli/commands.h"
#include "proto/authorized_keys.h"
#include "proto/key_file.h"
#include "proto/keys_folder.h"

namespace tetfarm {
namespace {

constexpr std::size_t digits_of_a_key = 64;
const std::string coordinator = "coordinator";

std::filesystem::path list_of(const KeysCommand& command) {
  const std::filesystem::path folder =
      command.folder.empty() ? default_keys_folder() : std::filesystem::path(command.folder);
  if (!size_of_file(public_key_path(folder, coordinator))) {
    throw UsageError(
        "has no coordinator.pub; give the coordinator's key folder with --keys, or make a key: "
        "`tetfarm keys new coordinator`",
        folder.string());
  }
  return authorized_keys_path(folder);
}

void make_key(const KeysCommand& command) {
  const std::filesystem::path standard =
      command.subject == coordinator ? default_keys_folder() : ".";
  const std::filesystem::path folder =
      command.folder.empty() ? standard : std::filesystem::path(command.folder);
  write_new_key(folder, command.subject);
  if (const std::filesystem::path store = store_round(folder); !store.empty()) {
    std::fprintf(stderr, "warning: %s is a store, which others can access: keep keys elsewhere\n",
                 store.c_str());
  }
  std::printf("%s\n%s\n", secret_key_path(folder, command.subject).c_str(),
              public_key_path(folder, command.subject).c_str());
}

void authorize_key(const KeysCommand& command) {
  AuthorizedPeer peer;
  const bool is_file = size_of_file(command.subject).has_value();
  if (!is_file && command.subject.size() != digits_of_a_key) {
    throw ErrorWithHelp(ExitCode::not_found, command.subject + ": no such file",
                        "give a .pub file, or the key's 64 hexadecimal digits");
  }
  peer.key = is_file ? read_public_key(command.subject)
                     : public_key_of_hex(command.subject, command.subject);
  peer.role = role_of_name(command.role).value();
  peer.name = command.name;
  if (peer.name.empty() && is_file) peer.name = std::filesystem::path(command.subject).stem();
  if (peer.name.empty())
    throw UsageError("is missing; a key given by its digits needs a name", "--name");
  authorize(list_of(command), peer);
  std::printf("%s is authorised as %s\n", peer.name.c_str(), name_of(peer.role));
}

void list_keys(const KeysCommand& command) {
  const AuthorizedKeys list = read_authorized_keys(list_of(command));
  std::map<std::string, const AuthorizedPeer*> by_name;
  for (const auto& [key, peer] : list.peers) by_name[peer.name] = &peer;
  for (const auto& [name, peer] : by_name) {
    // Names and keys need no quoting: is_key_name.
    std::printf(command.json ? "{\"type\":\"key\",\"key\":\"%s\",\"role\":\"%s\",\"name\":\"%s\"}\n"
                             : "%s %-9s %s\n",
                hex_of(peer->key).c_str(), name_of(peer->role), name.c_str());
  }
  for (const std::string& line : list.bad_lines)
    std::fprintf(stderr, "warning: %s\n", line.c_str());
}

}  // namespace

ExitCode keys_command(const KeysCommand& command) {
  switch (command.action) {
    case KeysCommand::Action::make:
      make_key(command);
      break;
    case KeysCommand::Action::authorize:
      authorize_key(command);
      break;
    case KeysCommand::Action::revoke:
      revoke(list_of(command), command.subject);
      std::printf("%s is revoked\n", command.subject.c_str());
      break;
    case KeysCommand::Action::list:
      list_keys(command);
      break;
  }
  return ExitCode::ok;
}

}  // namespace tetfarm
