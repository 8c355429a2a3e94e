#include "pool/hosts.h"

#include <algorithm>
#include <map>

#include "base/check.h"
#include "base/error.h"
#include "pool/worker_job.h"

namespace tetfarm {
namespace {

constexpr const char* here = "here";

std::string folder_line(const PoolSettings& settings) {
  return "d=\"/tmp/tetfarm-pool-$(id -u)-" + settings.name + "\"\n";
}

/// Shell functions. `started PID` prints when that process started, in ticks since the machine did,
/// and nothing if it has ended. `is_ours FILE` sets $pid and $bytes and tells whether that worker
/// is there: a number that went to another process has another start. A command line would not do:
/// a process has none of its own until it has become its program.
constexpr const char* process_functions =
    "started() {\n  set -- $(sed 's/.*) //' \"/proc/$1/stat\" 2>/dev/null)\n"
    "  case \"$1\" in '' | Z | X) ;; *) echo \"${20}\" ;; esac\n}\n"
    "is_ours() {\n  read -r pid bytes start <\"$1\" || return 1\n"
    "  [ -n \"$start\" ] && [ \"$(started \"$pid\")\" = \"$start\" ]\n}\n";

std::string host_of(const std::string& job) { return job.substr(0, job.find('/')); }

}  // namespace

Hosts::Hosts(PoolSettings settings, std::size_t slots) : settings_(std::move(settings)) {
  for (const std::string& text : settings_.hosts) {
    const std::vector<std::string> parts = split(text, ':');
    const bool has_slots = parts.size() == 2 && is_number(parts[1]) && parts[1].size() < 6;
    const std::string name = parts.empty() ? "" : parts.front();
    const bool is_plain = name.find_first_not_of(
                              "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTU"
                              "VWXYZ0123456789._@-") == std::string::npos;
    if (name.empty() || name.front() == '-' || !is_plain || (parts.size() > 1 && !has_slots)) {
      throw UsageError("is not a host: give NAME or NAME:SLOTS", text);
    }
    hosts_.push_back({name, has_slots ? std::stoul(parts[1]) : 1, false});
  }
  if (hosts_.empty()) hosts_.push_back({here, slots, true});
  TF_CHECK(!hosts_.empty());
}

/// What runs `script` on a host, as a part of a script for this machine. All hosts are asked at the
/// same time; one that fails says so in a line "silent HOST".
std::string Hosts::on(const Host& host, const std::string& script) const {
  const std::string shell =
      host.is_here ? "sh -s" : "ssh -o BatchMode=yes -o ConnectTimeout=10 " + host.name + " sh -s";
  return "{ " + shell + " || echo silent " + host.name + "; } <<'end_of_script' &\n" + script +
         "end_of_script\n";
}

std::vector<ShellCommand> Hosts::submit(const WorkerOrder& order,
                                        const std::vector<PoolJob>& jobs) const {
  std::map<std::string, std::size_t> used;
  for (const PoolJob& job : jobs) ++used[host_of(job.id)];
  std::string script;
  std::size_t left = order.count;
  for (const Host& host : hosts_) {
    const std::size_t count = std::min(left, host.slots - std::min(used[host.name], host.slots));
    if (count == 0) continue;
    left -= count;
    const std::string job = host.name + "/$name";
    const std::string log = settings_.logs + "/tetfarm-" + settings_.name + "-" + host.name + "-";
    script +=
        on(host, folder_line(settings_) + process_functions +
                     "mkdir -p -m 700 \"$d\" && [ -O \"$d\" ] || exit 1\ni=0\nwhile [ $i -lt " +
                     std::to_string(count) +
                     " ]; do\n  i=$((i + 1))\n"
                     "  name=$(od -An -N6 -tx1 /dev/urandom | tr -d ' \\n')\n"
                     "  setsid nohup " +
                     shell_line(worker_words(settings_, order.bytes), settings_, job) + " >" +
                     quoted(log) + "$name.log 2>&1 </dev/null &\n  echo \"$! " +
                     std::to_string(order.bytes) +
                     " $(started $!)\" >\"$d/.$name\" && mv \"$d/.$name\" \"$d/$name\" &&\n"
                     "    echo \"started " +
                     job + "\"\ndone\n");
  }
  if (script.empty()) return {};
  return {{{"sh", "-s"}, script + "wait\n"}};
}

std::vector<std::string> Hosts::submitted(const WorkerOrder& /*order*/,
                                          const CommandOutcome& outcome) const {
  std::vector<std::string> ids;
  for (const std::string& line : lines_of(outcome.out)) {
    const std::vector<std::string> words = split(line, ' ');
    if (words.size() == 2 && words[0] == "started") ids.push_back(words[1]);
  }
  return ids;
}

std::vector<ShellCommand> Hosts::list() const {
  std::string script;
  for (const Host& host : hosts_) {
    script +=
        on(host, folder_line(settings_) + process_functions +
                     "for f in \"$d\"/*; do\n  case ${f##*/} in '*' | *.*) continue ;; esac\n"
                     "  if is_ours \"$f\"; then echo \"job " +
                     host.name + "/${f##*/} $bytes\"; else rm -f \"$f\" \"$f.told\"; fi\ndone\n" +
                     "echo listed " + host.name + "\n");
  }
  return {{{"sh", "-s"}, script + "wait\n"}};
}

std::optional<std::vector<PoolJob>> Hosts::listed(const CommandOutcome& outcome) const {
  if (outcome.code != 0) return std::nullopt;
  std::vector<PoolJob> jobs;
  std::map<std::string, bool> answered;
  for (const std::string& line : lines_of(outcome.out)) {
    const std::vector<std::string> words = split(line, ' ');
    if (words.size() == 2 && words[0] == "listed") answered[words[1]] = true;
    if (words.size() != 3 || words[0] != "job" || !is_number(words[2])) continue;
    jobs.push_back({words[1], PoolJobState::running, std::stoull(words[2])});
  }
  for (const Host& host : hosts_) {
    if (answered[host.name]) continue;
    std::erase_if(jobs, [&](const PoolJob& job) { return host_of(job.id) == host.name; });
    for (std::size_t slot = 0; slot < host.slots; ++slot) {
      jobs.push_back({host.name + "/?" + std::to_string(slot), PoolJobState::ending, 0});
    }
  }
  if (answered.empty() || std::none_of(answered.begin(), answered.end(),
                                       [](const auto& host) { return host.second; })) {
    return std::nullopt;
  }
  return jobs;
}

/// The first time SIGTERM, the second time SIGKILL.
std::vector<ShellCommand> Hosts::cancel(const std::vector<std::string>& jobs) const {
  std::string script;
  for (const Host& host : hosts_) {
    std::string names;
    for (const std::string& job : jobs) {
      if (host_of(job) == host.name) names += " " + quoted(job.substr(host.name.size() + 1));
    }
    if (names.empty()) continue;
    script += on(host, folder_line(settings_) + process_functions + "for name in" + names +
                           "; do\n  f=\"$d/$name\"\n  is_ours \"$f\" || continue\n"
                           "  if [ -f \"$f.told\" ]; then kill -KILL \"$pid\"; else kill -TERM "
                           "\"$pid\" && : >\"$f.told\"; fi\ndone\n");
  }
  if (script.empty()) return {};
  return {{{"sh", "-s"}, script + "wait\n"}};
}

}  // namespace tetfarm
