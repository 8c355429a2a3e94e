#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "base/file_system.h"
#include "base/program_identity.h"
#include "base/program_version.h"
#include "cli/address_probes.h"
#include "cli/batch_probes.h"
#include "cli/commands.h"
#include "cli/folder_probes.h"
#include "cli/key_probes.h"
#include "cli/machine_probes.h"
#include "cli/probe.h"
#include "cli/run_folder.h"
#include "cli/service_options.h"
#include "coordinator/server.h"
#include "coordinator/start_rules.h"
#include "proto/keys_folder.h"
#include "proto/wire.h"
#include "worker/machine.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

/// As a person would write it: "." and a slash at the end are left out.
fs::path plain_path(const fs::path& path) {
  const fs::path plain = fs::absolute(path).lexically_normal();
  return plain.has_filename() ? plain : plain.parent_path();
}

/// Beside the time that an answer may take.
constexpr std::int64_t own_time_ms = 2'000;

/// What to look at, and how many answers of others that takes at most, one after the other.
struct PlannedProbe {
  Probe probe;
  int answers = 1;
};

/// One that finds one thing.
PlannedProbe planned(const std::string& check, const std::string& remedy,
                     std::function<Finding()> look) {
  return {{check, [look = std::move(look)] { return Findings{look()}; }, remedy}};
}

Finding finding_of_program() {
  return {"program", Verdict::ok,
          std::string("tetfarm ") + program_version + ", " + program_identity().substr(0, 12) +
              ", protocol " + std::to_string(protocol_version),
          ""};
}

/// What the folder that the user named is, or has in it. In a process of its own, too: a network
/// file system whose server is gone keeps whoever looks at it.
PlannedProbe store_named(const std::string& folder) {
  return planned("store", "mount the file system that it lies on", [folder] {
    const std::optional<fs::path> store = store_of(folder);
    return Finding{"store", Verdict::ok, store ? store->string() : folder, ""};
  });
}

Findings found_by(const PlannedProbe& planned, const DoctorCommand& command) {
  return looked_at_within(planned.probe,
                          planned.answers * in_ms(command.client.timeout_s) + own_time_ms);
}

void plan_machine(const DoctorCommand& command, std::vector<PlannedProbe>& plan) {
  plan.push_back(planned("program", "", finding_of_program));
  plan.push_back(planned("memory", "", [bytes = command.memory_bytes] {
    return finding_of_memory({machine_memory(), available_memory()}, bytes);
  }));
  plan.push_back(planned("open files", "", look_at_open_files));
}

void plan_folders(const DoctorCommand& command, const fs::path& store,
                  std::vector<PlannedProbe>& plan) {
  const fs::path work = plain_path(store.empty() ? fs::path(command.folder) : store);
  const fs::path database = plain_path(database_folder(work, command.database));
  const std::string remedy = "let this user write there, or use another folder";
  std::vector<fs::path> folders = {work};
  if (database != work) folders.push_back(database);
  for (const fs::path& folder : folders) {
    plan.push_back(planned("disk", remedy, [folder] { return look_at_room(folder); }));
    plan.push_back(planned("files", remedy, [folder] { return look_at_files(folder); }));
  }
  plan.push_back(planned("database", remedy, [database] { return look_at_database(database); }));
  plan.push_back(planned("clock", remedy, [work] { return look_at_times_of_files(work); }));
}

void plan_keys(const DoctorCommand& command, const fs::path& store,
               std::vector<PlannedProbe>& plan) {
  KeysToLookAt keys;
  keys.wanted = command.keys;
  keys.standard = default_keys_folder();
  keys.store = store;
  if (!store.empty()) keys.old = database_folder(store, command.database) / "keys";
  keys.own = command.client.keys;
  plan.push_back({{"keys", [keys] { return look_at_keys(keys); }, ""}});
}

/// The coordinator that is named, or the one that uses the store.
Findings look_at_coordinator_of(ClientOptions client, const fs::path& store) {
  if (client.endpoint.empty() && size_of_file(endpoints_file(store))) {
    std::istringstream lines(read_file(endpoints_file(store)));
    std::getline(lines, client.endpoint);
  }
  if (!client.endpoint.empty()) return look_at_coordinator(client, store.string());
  return {{"coordinator", Verdict::ok, "none is using " + store.string(), ""}};
}

void plan_farm(const DoctorCommand& command, const fs::path& store,
               std::vector<PlannedProbe>& plan) {
  if (!command.client.endpoint.empty() || !store.empty()) {
    plan.push_back(
        {{"coordinator",
          [client = command.client, store] { return look_at_coordinator_of(client, store); },
          "check the address and the keys"}});
  }
  for (const std::string& endpoint : command.endpoints) {
    plan.push_back(planned("address", "give an address of this machine, such as tcp://*:5555",
                           [endpoint] { return look_at_listening(endpoint); }));
  }
  constexpr int batch_systems = 4;
  plan.push_back({{"batch system",
                   [pool = command.pool, timeout_ms = in_ms(command.client.timeout_s)] {
                     const char* path = std::getenv("PATH");
                     return look_at_batch_systems(path == nullptr ? "" : path, pool, timeout_ms);
                   },
                   "check that the batch system runs"},
                  batch_systems});
}

}  // namespace

ExitCode doctor_command(const DoctorCommand& command) {
  Findings findings;
  fs::path store = command.store;
  if (!command.store.empty()) {
    findings = found_by(store_named(command.store), command);
    if (findings.front().verdict == Verdict::ok) {
      store = findings.front().found;
      findings.clear();
    }
  }
  std::vector<PlannedProbe> plan;
  plan_machine(command, plan);
  plan_folders(command, store, plan);
  plan_keys(command, store, plan);
  plan_farm(command, store, plan);
  for (const PlannedProbe& planned : plan) {
    const Findings more = found_by(planned, command);
    findings.insert(findings.end(), more.begin(), more.end());
  }
  std::fputs((command.client.json ? findings_json(findings) : findings_text(findings)).c_str(),
             stdout);
  const bool is_well = std::none_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.verdict == Verdict::problem;
  });
  return is_well ? ExitCode::ok : ExitCode::failed;
}

}  // namespace tetfarm
