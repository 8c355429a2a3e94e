#include "cli/key_probes.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <vector>

#include "base/counted.h"
#include "base/error.h"
#include "base/file_system.h"
#include "cli/probe.h"
#include "coordinator/start_rules.h"
#include "proto/authorized_keys.h"
#include "proto/key_file.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

const std::string check_of_keys = "keys";
const std::string name_of_coordinators_key = "coordinator";

Finding sound_keys(const std::string& found) { return {check_of_keys, Verdict::ok, found, ""}; }

void append_findings(Findings& findings, const Findings& more) {
  findings.insert(findings.end(), more.begin(), more.end());
}

/// Who may enter the folder.
Finding look_at_folder(const fs::path& folder) {
  struct stat about {};
  if (::stat(folder.c_str(), &about) != 0) throw IoError("cannot stat", folder.string(), errno);
  const std::string remedy = "chmod 700 " + folder.string();
  if ((about.st_mode & 022U) != 0) {
    return {check_of_keys, Verdict::problem,
            folder.string() + ": others may put keys there, or take them away", remedy};
  }
  if ((about.st_mode & 077U) != 0) {
    return {check_of_keys, Verdict::warning, folder.string() + ": others may look into it", remedy};
  }
  return sound_keys(folder.string() + ": only its owner may enter it");
}

/// That it is private, and that its public half, where it lies beside it, is of the same pair.
Finding look_at_secret_key(const fs::path& path) {
  const KeyPair pair = read_secret_key(path);
  fs::path other = path;
  other.replace_extension(".pub");
  if (!size_of_file(other)) return sound_keys(path.string() + ": private");
  if (read_public_key(other) == pair.public_key) {
    return sound_keys(path.string() + ": private, and of one pair with " +
                      other.filename().string());
  }
  return {check_of_keys, Verdict::problem,
          other.string() + ": is not the public half of " + path.filename().string(),
          "make a new pair with `tetfarm keys new` and hand out its public half"};
}

Finding look_at_list(const fs::path& folder) {
  const fs::path path = authorized_keys_path(folder);
  const AuthorizedKeys list = read_authorized_keys(path);
  Finding finding =
      sound_keys(path.string() + ": " + counted(list.peers.size(), "key") + " may connect");
  if (!list.bad_lines.empty()) {
    finding.verdict = Verdict::warning;
    finding.found += "; " + list.bad_lines.front();
    finding.remedy = "mend or remove the line: it lets nobody in";
  } else if (list.peers.empty()) {
    finding.verdict = Verdict::warning;
    finding.remedy = "let workers and users in: `tetfarm keys authorize NAME.pub --role ROLE`";
  }
  return finding;
}

std::vector<fs::path> secret_keys_in(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".key") found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

Findings look_at_each_secret_key(const std::vector<fs::path>& paths) {
  Findings findings;
  for (const fs::path& path : paths) {
    append_findings(
        findings, looked_at({check_of_keys, [&path] { return Findings{look_at_secret_key(path)}; },
                             "chmod 600 " + path.string() +
                                 ", as its owner; a new key if anyone has read it"}));
  }
  return findings;
}

/// Whether it is the key that the coordinator which uses the store has left there.
Findings look_at_key_of_store(const fs::path& store, const PublicKey& key,
                              const std::string& whose) {
  const fs::path published = published_key_path(store);
  if (store.empty() || !size_of_file(published)) return {};
  if (read_public_key(published) == key) {
    return {sound_keys(whose + ": that of the coordinator that uses " + store.string())};
  }
  return {{check_of_keys, Verdict::problem,
           whose + ": is not the key of the coordinator that uses " + store.string(),
           "use " + published.string() + ", or the folder of keys of that coordinator"}};
}

Findings look_at_folder_of_keys(const KeysToLookAt& keys) {
  const KeysInUse found =
      find_keys({keys.wanted, keys.standard, keys.old.empty() ? keys.standard : keys.old});
  if (found.folder.empty()) {
    return {sound_keys(found.remark + ": a coordinator speaks plain text, to this machine only")};
  }
  Findings findings = {look_at_folder(found.folder)};
  if (!found.warning.empty()) {
    findings.push_back(
        {check_of_keys, Verdict::warning, found.warning, "move it, and say where: --keys"});
  }
  append_findings(findings, look_at_each_secret_key(secret_keys_in(found.folder)));
  append_findings(
      findings, looked_at({check_of_keys, [&found] { return Findings{look_at_list(found.folder)}; },
                           "chmod 600 " + authorized_keys_path(found.folder).string()}));
  const fs::path own = public_key_path(found.folder, name_of_coordinators_key);
  if (!size_of_file(own)) return findings;
  append_findings(findings, looked_at({check_of_keys,
                                       [&] {
                                         return look_at_key_of_store(
                                             keys.store, read_public_key(own), own.string());
                                       },
                                       "make it anew from the coordinator's own copy"}));
  return findings;
}

Findings look_at_keys_of_peer(const KeysToLookAt& keys) {
  Findings findings;
  if (!keys.own.own.empty()) append_findings(findings, look_at_each_secret_key({keys.own.own}));
  if (keys.own.coordinator.empty()) return findings;
  append_findings(findings,
                  looked_at({check_of_keys,
                             [&keys] {
                               const fs::path path = keys.own.coordinator;
                               const PublicKey key = read_public_key(path);
                               Findings of_store =
                                   look_at_key_of_store(keys.store, key, path.string());
                               if (!of_store.empty()) return of_store;
                               return Findings{sound_keys(path.string() + ": a public key")};
                             },
                             "ask the coordinator's owner for coordinator.pub"}));
  return findings;
}

}  // namespace

Findings look_at_keys(const KeysToLookAt& keys) {
  Findings findings = looked_at({check_of_keys, [&keys] { return look_at_folder_of_keys(keys); },
                                 "say with --keys where the coordinator's keys lie"});
  append_findings(findings, look_at_keys_of_peer(keys));
  return findings;
}

}  // namespace tetfarm
