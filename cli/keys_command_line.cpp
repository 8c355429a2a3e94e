#include "cli/keys_command_line.h"

namespace tetfarm {
namespace {

CLI::App& add_action(CLI::App& keys, const char* name, const char* what, const char* example,
                     KeysCommand::Action action, KeysCommand& command,
                     const std::function<void()>& chosen) {
  CLI::App& sub = *keys.add_subcommand(name, what);
  sub.footer(std::string("Example: ") + example);
  sub.callback([action, &command, chosen] {
    command.action = action;
    chosen();
  });
  return sub;
}

void add_folder(CLI::App& sub, KeysCommand& command, const char* what) {
  sub.add_option("--keys", command.folder, what)->envname("TETFARM_KEYS")->option_text("DIR");
}

constexpr const char* farm_folder =
    "The coordinator's key folder (default: /etc/tetfarm/keys for root, tetfarm/keys in "
    "$XDG_CONFIG_HOME or ~/.config for others)";

}  // namespace

void add_keys(CLI::App& app, KeysCommand& keys, const std::function<void()>& chosen) {
  CLI::App& all =
      *app.add_subcommand("keys", "Make keys, and manage who may connect to a coordinator");
  all.require_subcommand(1);
  using Action = KeysCommand::Action;

  CLI::App& make =
      add_action(all, "new", "Make a key pair: NAME.key (secret) and NAME.pub (public)",
                 "tetfarm keys new coordinator", Action::make, keys, chosen);
  make.add_option("NAME", keys.subject, "Name of the key files; for a coordinator, \"coordinator\"")
      ->required();
  add_folder(make, keys,
             "Folder to write to (default: the current one; for \"coordinator\" /etc/tetfarm/keys "
             "for root, tetfarm/keys in $XDG_CONFIG_HOME or ~/.config for others)");

  CLI::App& authorize = add_action(all, "authorize", "Authorise a key; takes effect at once",
                                   "tetfarm keys authorize anna.pub --role submitter",
                                   Action::authorize, keys, chosen);
  authorize.add_option("KEY", keys.subject, "A .pub file, or the key's 64 hexadecimal digits")
      ->required();
  authorize.add_option("--role", keys.role, "What the key's holder may do")
      ->required()
      ->check(CLI::IsMember({"worker", "submitter", "viewer"}))
      ->option_text("worker|submitter|viewer");
  authorize.add_option("--name", keys.name, "Name for the key (default: the file's name)")
      ->option_text("NAME");
  add_folder(authorize, keys, farm_folder);

  CLI::App& revoke = add_action(all, "revoke", "Revoke a key; takes effect at once",
                                "tetfarm keys revoke anna", Action::revoke, keys, chosen);
  revoke.add_option("NAME", keys.subject, "A name from the list, or a key's 64 hexadecimal digits")
      ->required();
  add_folder(revoke, keys, farm_folder);

  CLI::App& list = add_action(all, "list", "List the authorised keys", "tetfarm keys list --json",
                              Action::list, keys, chosen);
  add_folder(list, keys, farm_folder);
  list.add_flag("--json", keys.json, "Print JSON on standard output, one object per line");
}

}  // namespace tetfarm
