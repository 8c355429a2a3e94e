#include "proto/authorized_keys.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <set>
#include <sstream>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

const std::string head = "# Who may speak with this coordinator: public key, role, name.\n";

/// Two who change the list at once do so one after the other.
class ListLock {
 public:
  explicit ListLock(const fs::path& list) {
    const fs::path path = list.string() + ".lock";
    descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (descriptor_ < 0) throw IoError("cannot open", path.string(), errno);
    if (::flock(descriptor_, LOCK_EX) != 0) {
      const int error_number = errno;
      ::close(descriptor_);
      throw IoError("cannot lock", path.string(), error_number);
    }
  }
  ~ListLock() { ::close(descriptor_); }
  ListLock(const ListLock&) = delete;
  ListLock& operator=(const ListLock&) = delete;

 private:
  int descriptor_ = -1;
};

/// The words of a line before its comment.
std::vector<std::string> words_of(const std::string& line) {
  std::istringstream text(line.substr(0, line.find('#')));
  std::vector<std::string> words;
  for (std::string word; text >> word;) words.push_back(word);
  return words;
}

/// What is wrong with the line; empty when `list` has got its peer.
std::string take_line(const std::vector<std::string>& words, std::set<std::string>& names,
                      AuthorizedKeys& list) {
  if (words.size() != 3) return "not KEY ROLE NAME";
  AuthorizedPeer peer;
  try {
    peer.key = public_key_of_hex(words[0], "");
  } catch (const UsageError&) {
    return "the key is not 64 hexadecimal digits";
  }
  const auto role = role_of_name(words[1]);
  if (!role) return "no role '" + words[1] + "'";
  peer.role = *role;
  peer.name = words[2];
  if (!is_key_name(peer.name)) return "not a valid name";
  if (list.peers.contains(peer.key)) return "its key is on an earlier line";
  if (!names.insert(peer.name).second) return "its name is on an earlier line";
  list.peers.emplace(peer.key, std::move(peer));
  return {};
}

}  // namespace

const AuthorizedPeer* AuthorizedKeys::find(const PublicKey& key) const {
  const auto found = peers.find(key);
  return found == peers.end() ? nullptr : &found->second;
}

fs::path authorized_keys_path(const fs::path& keys_folder) {
  return keys_folder / "authorized_keys";
}

AuthorizedKeys parse_authorized_keys(std::string_view text) {
  AuthorizedKeys list;
  std::set<std::string> names;
  std::istringstream lines{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::vector<std::string> words = words_of(line);
    if (words.empty()) continue;
    const std::string wrong = take_line(words, names, list);
    if (!wrong.empty()) list.bad_lines.push_back("line " + std::to_string(number) + ": " + wrong);
  }
  return list;
}

AuthorizedKeys read_authorized_keys(const fs::path& path) {
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) {
    if (errno == ENOENT) return {};
    throw IoError("cannot stat", path.string(), errno);
  }
  if (about.st_uid != ::geteuid() && about.st_uid != 0) {
    throw UsageError("the list of authorised keys belongs to another user", path.string());
  }
  if ((about.st_mode & 022U) != 0) {
    throw UsageError("other users may write to the list of authorised keys: run chmod 644 on it",
                     path.string());
  }
  return parse_authorized_keys(read_file(path));
}

void authorize(const fs::path& path, const AuthorizedPeer& peer) {
  TF_CHECK(peer.key.bytes.size() == 32);
  if (!is_key_name(peer.name)) throw UsageError("is not a valid name for a key", peer.name);
  const ListLock lock(path);
  const AuthorizedKeys list = read_authorized_keys(path);
  if (const AuthorizedPeer* same = list.find(peer.key)) {
    throw UsageError("its key is already authorised, as " + same->name, peer.name);
  }
  for (const auto& [key, other] : list.peers) {
    if (other.name == peer.name) throw UsageError("is already authorised", peer.name);
  }
  std::string text = size_of_file(path) ? read_file(path) : head;
  if (!text.empty() && text.back() != '\n') text += '\n';
  write_file_atomically(
      path, text + hex_of(peer.key) + " " + name_of(peer.role) + " " + peer.name + "\n");
}

void revoke(const fs::path& path, const std::string& name_or_key) {
  const ListLock lock(path);
  std::istringstream lines(size_of_file(path) ? read_file(path) : head);
  std::string kept;
  bool is_there = false;
  for (std::string line; std::getline(lines, line);) {
    const std::vector<std::string> words = words_of(line);
    const bool is_meant = words.size() == 3 && (words[0] == name_or_key || words[2] == name_or_key);
    is_there = is_there || is_meant;
    if (!is_meant) kept += line + "\n";
  }
  if (!is_there) {
    throw Error(ExitCode::not_found, name_or_key + ": no such name or key in " + path.string());
  }
  write_file_atomically(path, kept);
}

}  // namespace tetfarm
