#include "cli/client_options.h"

namespace tetfarm {

void add_json(CLI::App& app, bool& json) {
  app.add_flag("--json", json, "Print one JSON object a line on standard output");
}

void add_keys_of_a_peer(CLI::App& app, KeyFiles& keys) {
  app.add_option("--key", keys.own, "The secret key to be known by (default: none, plain text)")
      ->envname("TETFARM_KEY")
      ->option_text("NAME.key");
  app.add_option("--coordinator-key", keys.coordinator,
                 "The coordinator's public key (default: coordinator.pub of the store)")
      ->envname("TETFARM_COORDINATOR_KEY")
      ->option_text("FILE.pub");
}

CLI::Option& add_connection(CLI::App& app, ClientOptions& client) {
  CLI::Option* connect = app.add_option("--connect", client.endpoint, "The coordinator")
                             ->envname("TETFARM_COORDINATOR")
                             ->option_text("tcp://HOST:PORT");
  add_keys_of_a_peer(app, client.keys);
  app.add_option("--timeout", client.timeout_s, "How long to wait for an answer (10)")
      ->check(CLI::PositiveNumber)
      ->option_text("SECONDS");
  add_json(app, client.json);
  return *connect;
}

void add_client(CLI::App& app, ClientOptions& client) { add_connection(app, client).required(); }

}  // namespace tetfarm
