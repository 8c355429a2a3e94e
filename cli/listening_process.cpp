#include "cli/listening_process.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <system_error>

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

const std::string listens = "0A";  // TCP_LISTEN of the kernel

/// Adds the sockets that listen at the port, by the numbers of their inodes, of /proc/net/tcp.
void add_sockets(const char* table, std::uint16_t port, std::set<std::string>& inodes) {
  std::ifstream file(table);
  std::string line;
  std::getline(file, line);  // its head
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string number, address, other, state, queues, timer, tries, user, timeout, inode;
    if (!(words >> number >> address >> other >> state >> queues >> timer >> tries >> user >>
          timeout >> inode)) {
      continue;
    }
    const std::size_t colon = address.rfind(':');
    std::uint16_t here = 0;
    std::from_chars(address.data() + colon + 1, address.data() + address.size(), here, 16);
    if (colon != std::string::npos && here == port && state == listens) inodes.insert(inode);
  }
}

bool has_one_of(const fs::path& process, const std::set<std::string>& inodes) {
  constexpr std::string_view begin = "socket:[";
  std::error_code error;
  for (fs::directory_iterator entry(process / "fd", error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code unseen;
    const std::string target = fs::read_symlink(entry->path(), unseen).string();
    if (unseen || !target.starts_with(begin)) continue;
    if (inodes.contains(target.substr(begin.size(), target.size() - begin.size() - 1))) return true;
  }
  return false;
}

std::string command_of(const fs::path& process) {
  std::ifstream file(process / "cmdline", std::ios::binary);
  std::string command{std::istreambuf_iterator<char>(file), {}};
  while (!command.empty() && command.back() == '\0') command.pop_back();
  std::replace(command.begin(), command.end(), '\0', ' ');
  return command;
}

}  // namespace

std::optional<ListeningProcess> process_that_listens(std::uint16_t port) {
  std::set<std::string> inodes;
  for (const char* table : {"/proc/net/tcp", "/proc/net/tcp6"}) add_sockets(table, port, inodes);
  if (inodes.empty()) return std::nullopt;
  std::error_code error;
  for (fs::directory_iterator entry("/proc", error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    pid_t process = 0;
    const auto [stopped, wrong] = std::from_chars(name.data(), name.data() + name.size(), process);
    if (wrong != std::errc() || stopped != name.data() + name.size()) continue;
    if (has_one_of(entry->path(), inodes))
      return ListeningProcess{process, command_of(entry->path())};
  }
  return std::nullopt;
}

}  // namespace tetfarm
