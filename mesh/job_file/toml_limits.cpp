#include "mesh/job_file/toml_limits.h"

#include <algorithm>

#include "base/check.h"
#include "base/error.h"

namespace tetfarm {
namespace {

/// Goes over the text as TOML reads it, as far as strings, comments and brackets are concerned.
/// Where the text is no TOML it may go wrong: the parser stops there.
class Scan {
 public:
  Scan(std::string_view text, const std::string& path) : text_(text), path_(path) {}

  void run() {
    while (at_ < text_.size()) step();
  }

 private:
  void step() {
    TF_CHECK(depth_ >= 0 && dots_ >= 0);
    switch (text_[at_]) {
      case '"':
      case '\'':
        return skip_string();
      case '#':
        at_ = std::min(text_.find('\n', at_), text_.size());
        return;
      case '[':
      case '{':
        if (++depth_ > deepest_toml) {
          fail("more than " + std::to_string(deepest_toml) + " nested arrays or tables");
        }
        dots_ = 0;
        break;
      case ']':
      case '}':
        if (depth_ > 0) --depth_;
        dots_ = 0;
        break;
      case '=':
      case ',':
      case '\n':
        dots_ = 0;
        break;
      case '.':
        if (++dots_ >= most_key_segments) {
          fail("a key of more than " + std::to_string(most_key_segments) + " parts");
        }
        break;
      default:
        break;
    }
    ++at_;
  }

  bool is_triple(char quote) const {
    return text_.substr(at_, 3) == std::string_view(quote == '"' ? "\"\"\"" : "'''");
  }

  void skip_string() {
    const char quote = text_[at_];
    TF_CHECK(quote == '"' || quote == '\'');
    const bool has_lines = is_triple(quote);
    at_ += has_lines ? 3 : 1;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '\\' && quote == '"') {
        ++at_;
      } else if (has_lines && is_triple(quote)) {
        at_ += 3;
        // One or two quotes before the last three are part of the string.
        for (int i = 0; i < 2 && at_ < text_.size() && text_[at_] == quote; ++i) ++at_;
        return;
      } else if (!has_lines && (c == quote || c == '\n')) {
        at_ += c == quote ? 1 : 0;
        return;
      }
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    std::size_t line = 1;
    std::size_t column = 1;
    for (const char c : text_.substr(0, at_)) {
      if (c == '\n') {
        ++line;
        column = 1;
      } else if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) {
        ++column;
      }
    }
    throw UsageError(what, path_ + ":" + std::to_string(line) + ":" + std::to_string(column));
  }

  std::string_view text_;
  const std::string& path_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int dots_ = 0;  ///< since something that ends a key
};

}  // namespace

void check_toml_limits(std::string_view text, const std::string& path) {
  if (text.size() > largest_job_file) {
    throw UsageError("more than " + std::to_string(largest_job_file) +
                         " bytes, the most that a job file may have",
                     path);
  }
  Scan(text, path).run();
}

}  // namespace tetfarm
