/// Who may have an answer over HTTP: the token, the name of the host that a request is for, and
/// where its page came from. Plain functions on texts; no sockets.
#pragma once

#include <filesystem>
#include <string>

namespace tetfarm {

/// The token in that file, without the end of its line; "" for no file. @throws UsageError when it
/// is short or others may read it, IoError.
std::string read_http_token(const std::filesystem::path& file);

/// Whether what the field Authorization says is the token: "Bearer TOKEN" of programs, or "Basic …"
/// of browsers, where the token is the password of any user. Takes as long for a wrong token as for
/// the right one. @pre `token` is not "".
bool has_http_token(const std::string& authorization, const std::string& token);

/// Whether what the field Host says names this host by a loopback name, with or without a port: a
/// page of a stranger must not read ours through a name that leads here. `host` in lower case.
bool is_loopback_name(const std::string& host);

/// Whether what the field Origin says is a page of this server, which the field Host calls `host`.
bool is_same_origin(const std::string& origin, const std::string& host);

/// In lower case, of ASCII.
std::string lower_case(std::string text);
/// Without the spaces and tabs at its ends.
std::string without_blanks(const std::string& text);

}  // namespace tetfarm
