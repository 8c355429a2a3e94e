#include "cli/address_probes.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>

#include "base/clock.h"
#include "base/counted.h"
#include "base/error.h"
#include "base/error_with_help.h"
#include "base/program_identity.h"
#include "base/program_version.h"
#include "cli/coordinator_connection.h"
#include "cli/folder_probes.h"
#include "cli/listening_process.h"
#include "cli/probe.h"
#include "cli/service_options.h"
#include "proto/local_endpoint.h"

namespace tetfarm {
namespace {

constexpr std::string_view tcp_scheme = "tcp://";
constexpr std::string_view ipc_scheme = "ipc://";

struct HostAndPort {
  std::string host;  ///< without the brackets of an IPv6 address
  std::uint16_t port = 0;
};

/// Of "tcp://HOST:PORT". @throws UsageError.
HostAndPort host_and_port(const std::string& endpoint) {
  HostAndPort parts;
  const std::size_t colon = endpoint.rfind(':');
  const bool is_tcp = endpoint.starts_with(tcp_scheme) && colon > tcp_scheme.size();
  const char* end = endpoint.data() + endpoint.size();
  const auto [stopped, error] =
      std::from_chars(endpoint.data() + std::min(colon + 1, endpoint.size()), end, parts.port);
  if (!is_tcp || error != std::errc() || stopped != end || parts.port == 0) {
    throw UsageError("is not an address such as tcp://HOST:PORT", endpoint);
  }
  parts.host = endpoint.substr(tcp_scheme.size(), colon - tcp_scheme.size());
  if (parts.host.starts_with("[") && parts.host.ends_with("]")) {
    parts.host = parts.host.substr(1, parts.host.size() - 2);
  }
  return parts;
}

struct FreeAddresses {
  void operator()(addrinfo* list) const { ::freeaddrinfo(list); }
};
using Addresses = std::unique_ptr<addrinfo, FreeAddresses>;

/// @throws Error when the name means nothing.
Addresses addresses_of(const HostAndPort& where, bool is_to_listen) {
  addrinfo hints{};
  hints.ai_family = is_to_listen && where.host == "*" ? AF_INET : AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = is_to_listen ? AI_PASSIVE : 0;
  addrinfo* found = nullptr;
  const char* name = where.host == "*" ? nullptr : where.host.c_str();
  const int error = ::getaddrinfo(name, std::to_string(where.port).c_str(), &hints, &found);
  if (error != 0) {
    throw ErrorWithHelp(ExitCode::not_found, where.host + ": " + ::gai_strerror(error),
                        "check the name, or give the host's address in numbers");
  }
  return Addresses(found);
}

class ProbeSocket {
 public:
  explicit ProbeSocket(const addrinfo& address)
      : fd_(::socket(address.ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    if (fd_ < 0) throw IoError("cannot make", "a socket", errno);
  }
  ~ProbeSocket() { ::close(fd_); }
  ProbeSocket(const ProbeSocket&) = delete;
  ProbeSocket& operator=(const ProbeSocket&) = delete;
  int fd() const { return fd_; }

 private:
  int fd_;
};

/// 0, or errno of the connection; a host that says nothing is given up by the caller.
int error_of_connecting(const HostAndPort& where) {
  const Addresses all = addresses_of(where, false);
  int error_number = EADDRNOTAVAIL;
  for (const addrinfo* one = all.get(); one != nullptr; one = one->ai_next) {
    const ProbeSocket socket(*one);
    if (::connect(socket.fd(), one->ai_addr, one->ai_addrlen) == 0) return 0;
    error_number = errno;
  }
  return error_number;
}

/// " (process 4711: nc -l 5555)"; "" when it cannot be told.
std::string holder_text(std::uint16_t port) {
  const std::optional<ListeningProcess> holder = process_that_listens(port);
  if (!holder) return "";
  constexpr std::size_t longest = 120;
  return " (process " + std::to_string(holder->process) + ": " +
         holder->command.substr(0, longest) + ")";
}

/// @throws ErrorWithHelp when nobody listens there.
void require_listener(const std::string& endpoint) {
  if (!endpoint.starts_with(tcp_scheme)) return;
  const int error_number = error_of_connecting(host_and_port(endpoint));
  if (error_number == 0) return;
  const bool is_refused = error_number == ECONNREFUSED;
  throw ErrorWithHelp(
      ExitCode::not_found,
      endpoint + ": " + (is_refused ? "nobody listens there" : std::strerror(error_number)),
      is_refused
          ? "start a coordinator there: `tetfarm coordinator --store DIR --listen " + endpoint + "`"
          : "check the address, and firewalls on the way");
}

std::string remedy_without_answer(const std::string& endpoint) {
  std::string holder;
  if (endpoint.starts_with(tcp_scheme) && is_local(endpoint)) {
    holder = holder_text(host_and_port(endpoint).port);
  }
  return "check that it is a coordinator that listens there" + holder + ", and the keys";
}

Finding finding_of_version(const wire::StatusReply& farm) {
  Finding finding;
  finding.check = "version";
  const std::string own = std::string("this program is ") + program_version;
  if (farm.program_version().empty()) {
    finding.verdict = Verdict::warning;
    finding.found = "the coordinator does not tell its own, so it is an older one; " + own;
  } else if (farm.program_version() != program_version) {
    finding.verdict = Verdict::warning;
    finding.found = "the coordinator is " + farm.program_version() + "; " + own;
  } else if (farm.program() != program_identity()) {
    finding.verdict = Verdict::warning;
    finding.found = "the coordinator is another build of " + farm.program_version();
  } else {
    finding.found = "the coordinator is this program, " + farm.program_version();
    return finding;
  }
  finding.remedy =
      "install the same program on all machines: what one program has computed does "
      "not serve another";
  return finding;
}

}  // namespace

Findings findings_of_coordinator(const std::string& endpoint, const wire::StatusReply& farm,
                                 const AskedWhen& asked) {
  Finding answer;
  answer.check = "coordinator";
  answer.found = endpoint + ": answered in " + std::to_string(asked.took_ms) + " ms; " +
                 counted(farm.workers(), "worker") + ", " +
                 counted(farm.connections(), "connection");
  if (!farm.security().empty()) answer.found += ", " + farm.security();
  if (!farm.trouble().empty()) {
    answer.verdict = Verdict::problem;
    answer.found = endpoint + ": " + farm.trouble();
    answer.remedy = "look into coordinator.log in its store";
  }
  Findings findings = {answer, finding_of_version(farm)};
  if (farm.wall_ms() != 0) {
    findings.push_back(
        finding_of_clock("the clock of the coordinator", farm.wall_ms() - asked.wall_ms));
  }
  return findings;
}

Findings look_at_coordinator(const ClientOptions& client, const std::string& store) {
  const std::string& endpoint = client.endpoint;
  require_listener(endpoint);
  const auto ask = [&] {
    CoordinatorConnection connection(
        endpoint, is_ipc(endpoint) ? std::nullopt : read_peer_keys(client.keys, store));
    const std::int64_t begun_ms = steady_ms();
    const wire::StatusReply farm = connection.farm(in_ms(client.timeout_s));
    const std::int64_t took_ms = steady_ms() - begun_ms;
    return findings_of_coordinator(endpoint, farm, {wall_ms() - took_ms / 2, took_ms});
  };
  return looked_at({"coordinator", ask, remedy_without_answer(endpoint)});
}

Finding look_at_listening(const std::string& endpoint) {
  Finding finding;
  finding.check = "address";
  if (endpoint.starts_with(ipc_scheme)) {
    const std::filesystem::path folder =
        std::filesystem::path(endpoint.substr(ipc_scheme.size())).parent_path();
    std::error_code ignored;
    const bool is_there = std::filesystem::is_directory(folder, ignored);
    finding.verdict = is_there ? Verdict::ok : Verdict::problem;
    finding.found = endpoint + ": its folder is " + (is_there ? "there" : "not there");
    if (!is_there) finding.remedy = "make the folder " + folder.string();
    return finding;
  }
  const HostAndPort where = host_and_port(endpoint);
  const Addresses all = addresses_of(where, true);
  const ProbeSocket socket(*all);
  const int yes = 1;
  ::setsockopt(socket.fd(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  if (::bind(socket.fd(), all->ai_addr, all->ai_addrlen) == 0) {
    finding.found = endpoint + ": free";
    return finding;
  }
  const int error_number = errno;
  finding.verdict = Verdict::problem;
  finding.found = endpoint + ": " + std::strerror(error_number);
  const std::string holder = error_number == EADDRINUSE ? holder_text(where.port) : "";
  if (holder.find(" coordinator ") != std::string::npos) {
    finding.verdict = Verdict::ok;
    finding.found = endpoint + ": a coordinator listens there" + holder;
  } else if (error_number == EADDRINUSE) {
    finding.found = endpoint + ": in use" + holder;
    finding.remedy = "end what listens there, or give the coordinator another port";
  } else if (error_number == EADDRNOTAVAIL) {
    finding.remedy = "give an address of this machine, or * for all of them";
  } else if (error_number == EACCES) {
    finding.remedy = "give a port from 1024 on";
  }
  return finding;
}

}  // namespace tetfarm
