#include "proto/key_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zmq.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>

#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"
#include "base/hex_text.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t key_bytes = 32;
constexpr std::size_t z85_size = 41;  // with the zero at its end
constexpr std::size_t longest_key_file = 256;
constexpr std::size_t longest_name = 64;
const std::string secret_mark = "tetfarm secret key ";
const std::string public_mark = "tetfarm public key ";

/// Empty when `text` is not the hexadecimal digits of a key.
std::string from_hex(const std::string& text) {
  if (text.size() != 2 * key_bytes) return {};
  const auto value = [](char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return -1;
  };
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    const int high = value(text[i]);
    const int low = value(text[i + 1]);
    if (high < 0 || low < 0) return {};
    bytes += static_cast<char>(16 * high + low);
  }
  return bytes;
}

std::string from_z85(const char* text) {
  std::array<std::uint8_t, key_bytes> bytes{};
  if (zmq_z85_decode(bytes.data(), text) == nullptr) throw Error(ExitCode::failed, "not a key");
  return {bytes.begin(), bytes.end()};
}

/// What follows `mark` in the only line of `text`; empty when it is another text.
std::string after_mark(const std::string& text, const std::string& mark) {
  if (!text.starts_with(mark)) return {};
  const std::size_t end = text.find('\n');
  return text.substr(mark.size(), (end == std::string::npos ? text.size() : end) - mark.size());
}

class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags, mode_t mode = 0)
      : number_(::open(path.c_str(), flags | O_CLOEXEC, mode)) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

void write_secret(const fs::path& path, const std::string& text) {
  TF_CHECK(text.ends_with('\n'));
  const Descriptor file(path, O_WRONLY | O_CREAT | O_EXCL, 0600);
  if (file.number() < 0 && errno == EEXIST) {
    throw UsageError("there is already a key; a new one would lock out everyone who uses it",
                     path.string());
  }
  if (file.number() < 0) throw IoError("cannot create", path.string(), errno);
  // The umask may have taken more than it should give.
  if (::fchmod(file.number(), 0600) != 0) throw IoError("cannot chmod", path.string(), errno);
  const ssize_t written = ::write(file.number(), text.data(), text.size());
  if (written != static_cast<ssize_t>(text.size()) || ::fsync(file.number()) != 0) {
    const int error_number = errno;
    ::unlink(path.c_str());
    throw IoError("cannot write", path.string(), error_number);
  }
}

/// Looks at the open file, not at the path again, which may by then name another.
void require_private(const Descriptor& file, const fs::path& path) {
  struct stat about {};
  if (::fstat(file.number(), &about) != 0) throw IoError("cannot stat", path.string(), errno);
  if (!S_ISREG(about.st_mode)) throw UsageError("is not a file", path.string());
  if (about.st_uid != ::geteuid()) {
    throw UsageError("the secret key belongs to another user", path.string());
  }
  if ((about.st_mode & 077U) != 0) {
    throw UsageError(
        "other users may read this secret key: run chmod 600 on it, and make a new key if anyone "
        "has read it",
        path.string());
  }
}

void make_private_folder(const fs::path& folder) {
  if (folder.empty() || fs::is_directory(folder)) return;
  make_folders(folder);
  fs::permissions(folder, fs::perms::owner_all);
}

}  // namespace

std::string hex_of(const PublicKey& key) { return hex_of_bytes(key.bytes); }

PublicKey public_key_of_hex(const std::string& text, const std::string& where) {
  PublicKey key{from_hex(text)};
  if (key.bytes.empty()) throw UsageError("is not a public key of 64 hexadecimal digits", where);
  return key;
}

KeyPair make_key_pair() {
  std::array<char, z85_size> public_text{};
  std::array<char, z85_size> secret_text{};
  if (zmq_curve_keypair(public_text.data(), secret_text.data()) != 0) {
    throw Error(ExitCode::failed, "this libzmq was built without CURVE: no keys can be made");
  }
  return {{from_z85(public_text.data())}, from_z85(secret_text.data())};
}

fs::path secret_key_path(const fs::path& folder, const std::string& name) {
  return folder / (name + ".key");
}
fs::path public_key_path(const fs::path& folder, const std::string& name) {
  return folder / (name + ".pub");
}

bool is_key_name(const std::string& name) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '_' || c == '-' || c == '@';
  };
  return !name.empty() && name.size() <= longest_name && name.front() != '.' &&
         std::all_of(name.begin(), name.end(), is_plain);
}

KeyPair write_new_key(const fs::path& folder, const std::string& name) {
  if (!is_key_name(name)) {
    throw UsageError("a key's name may only have letters, digits, '.', '_', '-' and '@'", name);
  }
  make_private_folder(folder);
  KeyPair pair = make_key_pair();
  write_secret(secret_key_path(folder, name), secret_mark + hex_of_bytes(pair.secret_bytes) + "\n");
  TF_CHECK(pair.secret_bytes.size() == key_bytes);
  write_public_key(public_key_path(folder, name), pair.public_key);
  return pair;
}

KeyPair read_secret_key(const fs::path& path) {
  // Opening a pipe must not wait for somebody to write into it.
  const Descriptor file(path, O_RDONLY | O_NONBLOCK);
  if (file.number() < 0) throw IoError("cannot open", path.string(), errno);
  require_private(file, path);
  std::array<char, longest_key_file> text{};
  const ssize_t got = ::read(file.number(), text.data(), text.size());
  if (got < 0) throw IoError("cannot read", path.string(), errno);
  KeyPair pair;
  pair.secret_bytes =
      from_hex(after_mark({text.data(), static_cast<std::size_t>(got)}, secret_mark));
  if (pair.secret_bytes.empty()) throw UsageError("is not a secret key of tetfarm", path.string());
  std::array<char, z85_size> secret_text{};
  std::array<char, z85_size> public_text{};
  zmq_z85_encode(secret_text.data(),
                 reinterpret_cast<const std::uint8_t*>(pair.secret_bytes.data()), key_bytes);
  if (zmq_curve_public(public_text.data(), secret_text.data()) != 0) {
    throw Error(ExitCode::failed, "this libzmq was built without CURVE: keys cannot be used");
  }
  pair.public_key.bytes = from_z85(public_text.data());
  return pair;
}

PublicKey read_public_key(const fs::path& path) {
  const auto size = size_of_file(path);
  if (size && *size > longest_key_file) {
    throw UsageError("is not a public key of tetfarm", path.string());
  }
  const std::string bytes = from_hex(after_mark(read_file(path), public_mark));
  if (bytes.empty()) throw UsageError("is not a public key of tetfarm", path.string());
  return {bytes};
}

void write_public_key(const fs::path& path, const PublicKey& key) {
  TF_CHECK(key.bytes.size() == key_bytes);
  write_file_atomically(path, public_mark + hex_of(key) + "\n");
}

}  // namespace tetfarm
