#include "http/http_access.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>

#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"

namespace tetfarm {
namespace {

constexpr std::size_t shortest_token = 16;

bool is_same_secret(const std::string& said, const std::string& secret) {
  TF_CHECK(!secret.empty());
  unsigned difference = said.size() == secret.size() ? 0 : 1;
  for (std::size_t i = 0; i < said.size(); ++i) {
    difference |=
        static_cast<unsigned char>(said[i]) ^ static_cast<unsigned char>(secret[i % secret.size()]);
  }
  return difference == 0;
}

std::string from_base64(const std::string& text) {
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    static const std::string alphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::size_t value = alphabet.find(c);
    if (value == std::string::npos) break;
    bits = (bits << 6U | static_cast<unsigned>(value)) & 0xFFFFFFU;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 0xFFU);
  }
  return bytes;
}

}  // namespace

std::string read_http_token(const std::filesystem::path& file) {
  if (file.empty()) return {};
  struct stat about {};
  if (::stat(file.c_str(), &about) != 0) throw IoError("cannot read", file.string(), errno);
  if ((about.st_mode & 077U) != 0) {
    throw UsageError("other users may read this token: run chmod 600 on it", file.string());
  }
  std::string token = read_file(file);
  while (!token.empty() && (token.back() == '\n' || token.back() == ' ')) token.pop_back();
  if (token.size() < shortest_token) {
    throw UsageError("a token must have at least " + std::to_string(shortest_token) +
                         " characters; make one with `head -c 24 /dev/urandom | base64`",
                     file.string());
  }
  return token;
}

bool has_http_token(const std::string& authorization, const std::string& token) {
  const std::size_t space = authorization.find(' ');
  if (space == std::string::npos) return false;
  const std::string scheme = lower_case(authorization.substr(0, space));
  const std::string said = without_blanks(authorization.substr(space));
  if (scheme == "bearer") return is_same_secret(said, token);
  if (scheme != "basic") return false;
  const std::string pair = from_base64(said);
  const std::size_t colon = pair.find(':');
  return colon != std::string::npos && is_same_secret(pair.substr(colon + 1), token);
}

bool is_loopback_name(const std::string& host) {
  if (host.starts_with("[")) return host.starts_with("[::1]");
  const std::string name = host.substr(0, host.find(':'));
  return name == "localhost" ||
         (name.starts_with("127.") && name.find_first_not_of("0123456789.") == std::string::npos);
}

bool is_same_origin(const std::string& origin, const std::string& host) {
  if (host.empty()) return false;
  const std::string said = lower_case(origin);
  return said == "http://" + host || said == "https://" + host;
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

std::string without_blanks(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace tetfarm
