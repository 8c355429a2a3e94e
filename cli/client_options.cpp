#include "cli/client_options.h"

#include "cli/option_checks.h"

namespace tetfarm {

void add_json(CLI::App& app, bool& json) {
  app.add_flag("--json", json, "Print JSON on standard output, one object per line");
}

void add_keys_of_a_peer(CLI::App& app, KeyFiles& keys, StoreOption store) {
  app.add_option("--key", keys.own, "Secret key to authenticate with (default: none, plain text)")
      ->envname("TETFARM_KEY")
      ->option_text("NAME.key");
  const std::string by_default =
      store == StoreOption::yes ? " (default: coordinator.pub in the store)" : "";
  app.add_option("--coordinator-key", keys.coordinator, "The coordinator's public key" + by_default)
      ->envname("TETFARM_COORDINATOR_KEY")
      ->option_text("FILE.pub");
}

CLI::Option& add_peer(CLI::App& app, ClientOptions& client, StoreOption store) {
  CLI::Option* connect = app.add_option("--connect", client.endpoint, "Address of the coordinator")
                             ->envname("TETFARM_COORDINATOR")
                             ->option_text("tcp://HOST:PORT");
  add_keys_of_a_peer(app, client.keys, store);
  app.add_option("--timeout", client.timeout_s, "How long to wait for an answer (default 10)")
      ->check(positive_number())
      ->option_text("SECONDS");
  return *connect;
}

CLI::Option& add_connection(CLI::App& app, ClientOptions& client, StoreOption store) {
  CLI::Option& connect = add_peer(app, client, store);
  add_json(app, client.json);
  return connect;
}

void add_place_of_jobs(CLI::App& app, ViewOptions& view) {
  add_peer(app, view.client, StoreOption::yes);
  app.add_option("--store", view.store,
                 "A store, or the output folder of a run, to read a job's files from (default: "
                 "fetch them over the connection)")
      ->envname("TETFARM_STORE")
      ->option_text("DIR");
  app.add_option("--database", view.database, "Folder of the database (default: the store)")
      ->option_text("DIR");
}

void add_client(CLI::App& app, ClientOptions& client, StoreOption store) {
  add_connection(app, client, store).required();
}

}  // namespace tetfarm
