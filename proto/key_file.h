/// Keys of coordinator, workers and clients, and the files they lie in.
///
/// A key pair is of Curve25519, as ZeroMQ's CURVE uses them. `NAME.key` holds the secret half and
/// only its owner may read it; `NAME.pub` holds the public half, for the coordinator to authorise.
/// Both are one line of text: what it is, then 64 hexadecimal digits.
#pragma once

#include <compare>
#include <filesystem>
#include <string>

namespace tetfarm {

/// The public half of a key pair: 32 bytes.
struct PublicKey {
  std::string bytes;

  friend auto operator<=>(const PublicKey&, const PublicKey&) = default;
};

/// Its 64 hexadecimal digits.
std::string hex_of(const PublicKey& key);
/// @throws UsageError naming `where` when `text` is not 64 hexadecimal digits.
PublicKey public_key_of_hex(const std::string& text, const std::string& where);

struct KeyPair {
  PublicKey public_key;
  std::string secret_bytes;
};

/// A new pair, from the kernel's randomness. @throws Error when libzmq was built without CURVE.
KeyPair make_key_pair();

/// Where the halves of the key `name` lie in `folder`.
std::filesystem::path secret_key_path(const std::filesystem::path& folder, const std::string& name);
std::filesystem::path public_key_path(const std::filesystem::path& folder, const std::string& name);

/// Writes both files, the secret one with mode 0600; a folder that is not there is made with mode
/// 0700. Never replaces a key. @throws UsageError when there is one, or for a name that is no plain
/// file name; IoError.
KeyPair write_new_key(const std::filesystem::path& folder, const std::string& name);

/// @throws UsageError when the file is no secret key, does not belong to the user, or may be read
/// or written by others; IoError.
KeyPair read_secret_key(const std::filesystem::path& path);

/// @throws UsageError when the file is no public key, IoError.
PublicKey read_public_key(const std::filesystem::path& path);
void write_public_key(const std::filesystem::path& path, const PublicKey& key);

/// Whether `name` may name a key: 1 to 64 letters, digits, '.', '_', '-', '@', not '.' first.
bool is_key_name(const std::string& name);

}  // namespace tetfarm
