#include "cli/markdown_roff.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/text_lines.h"
#include "cli/roff_text.h"

namespace tetfarm {
namespace {

constexpr std::string_view fence = "```";

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  for (char& c : capitals) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return capitals;
}

/// The words of a link, "[words](place)", and how long all of it is; 0: it is none.
std::pair<std::string_view, std::size_t> link_at(std::string_view text) {
  const std::size_t middle = text.find("](");
  const std::size_t end = text.find(')', std::min(middle, text.size()));
  const bool is_link = text.starts_with('[') && middle != std::string_view::npos &&
                       end != std::string_view::npos &&
                       text.substr(1, middle - 1).find_first_of("[]") == std::string_view::npos;
  if (!is_link) return {{}, 0};
  return {text.substr(1, middle - 1), end + 1};
}

/// What stands between two marks at the beginning of a text, not blank next to the first.
std::pair<std::string_view, std::size_t> between(char mark, std::string_view text) {
  if (!text.starts_with(mark) || text.size() < 3 || text[1] == ' ') return {{}, 0};
  const std::size_t end = text.find(mark, 1);
  if (end == std::string_view::npos || end == 1) return {{}, 0};
  return {text.substr(1, end - 1), end + 1};
}

/// A text with code in bold, emphasis in italics, and the words of links.
std::string roff_of_words(std::string_view text) {
  std::string roff;
  std::string plain;
  const auto flush = [&] {
    if (!plain.empty()) roff += roff_text(plain);
    plain.clear();
  };
  while (!text.empty()) {
    const auto [code, code_size] = between('`', text);
    const auto [stressed, stressed_size] = between('*', text);
    const auto [words, link_size] = link_at(text);
    std::size_t size = 1;
    if (code_size > 0) {
      flush();
      roff += roff_bold(code);
      size = code_size;
    } else if (stressed_size > 0) {
      flush();
      roff += roff_italic(stressed);
      size = stressed_size;
    } else if (link_size > 0) {
      flush();
      roff += roff_of_words(words);
      size = link_size;
    } else {
      plain += text.front();
    }
    text.remove_prefix(size);
  }
  flush();
  return roff;
}

/// The cells of "| a | b |"; a bar in a cell is written "\|".
std::vector<std::string> cells_of_row(std::string_view line) {
  std::vector<std::string> cells;
  std::string cell;
  line.remove_prefix(1);
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line.substr(i).starts_with("\\|")) {
      cell += line[++i];
    } else if (line[i] == '|') {
      cells.emplace_back(trimmed(cell));
      cell.clear();
    } else {
      cell += line[i];
    }
  }
  return cells;
}

bool is_sentence(std::string_view cell) {
  return cell.starts_with("must ") || cell.starts_with("needed ");
}

std::string with_capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') {
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  }
  return text;
}

/// The first cell is the head, the last what it means, and those between say what they are called.
std::string entry_of(const std::vector<std::string>& names, const std::vector<std::string>& cells) {
  TF_CHECK(cells.size() == names.size() && cells.size() >= 2);
  std::string what = cells.back();
  if (!what.ends_with('.')) what += ".";
  for (std::size_t i = 1; i + 1 < cells.size(); ++i) {
    if (cells[i].empty() || cells[i] == "none") continue;
    what += is_sentence(cells[i]) ? " " + with_capital(cells[i]) + "."
                                  : " " + with_capital(names[i]) + ": " + cells[i] + ".";
  }
  return ".TP\n" + roff_of_words(cells.front()) + "\n" + roff_of_words(what) + "\n";
}

/// Turns lines into roff, one kind of thing after the other.
class Page {
 public:
  explicit Page(std::vector<std::string_view> lines) : lines_(std::move(lines)) {}

  std::string roff() {
    while (at_ < lines_.size()) take();
    return std::move(roff_);
  }

 private:
  void take() {
    const std::string_view line = lines_[at_];
    if (line.starts_with(fence)) return take_fenced();
    if (line.starts_with("|")) return take_table();
    if (line.starts_with("#")) return take_heading();
    if (line.empty()) {
      ++at_;
      return;
    }
    take_paragraph();
  }

  void take_heading() {
    const std::string_view line = lines_[at_++];
    const std::size_t level = line.find_first_not_of('#');
    const std::string_view words = trimmed(line.substr(std::min(level, line.size())));
    if (level == 1) return;
    roff_ += level == 2 ? ".SH " + roff_text(in_capitals(words)) + "\n"
                        : ".SS " + roff_text(words) + "\n";
    is_fresh_ = true;
  }

  void begin_paragraph() {
    if (!is_fresh_) roff_ += ".PP\n";
    is_fresh_ = false;
  }

  void take_paragraph() {
    std::string words;
    for (; at_ < lines_.size(); ++at_) {
      const std::string_view line = lines_[at_];
      const bool is_other =
          line.starts_with("|") || line.starts_with("#") || line.starts_with(fence);
      if (line.empty() || is_other) break;
      words += (words.empty() ? "" : " ") + std::string(trimmed(line));
    }
    begin_paragraph();
    roff_ += roff_of_words(words) + "\n";
  }

  void take_fenced() {
    std::string text;
    for (++at_; at_ < lines_.size() && !lines_[at_].starts_with(fence); ++at_) {
      text += std::string(lines_[at_]) + "\n";
    }
    ++at_;
    begin_paragraph();
    roff_ += roff_lines(text);
  }

  void take_table() {
    const std::vector<std::string> names = cells_of_row(lines_[at_]);
    for (at_ += 2; at_ < lines_.size() && lines_[at_].starts_with("|"); ++at_) {
      roff_ += entry_of(names, cells_of_row(lines_[at_]));
    }
    is_fresh_ = false;
  }

  std::vector<std::string_view> lines_;
  std::size_t at_ = 0;
  bool is_fresh_ = true;  ///< nothing stands below the last heading yet
  std::string roff_;
};

}  // namespace

std::string roff_of_markdown(std::string_view markdown) {
  return Page(lines_of_text(markdown)).roff();
}

std::string_view markdown_section(std::string_view markdown, std::string_view heading) {
  const std::string line = "\n## " + std::string(heading) + "\n";
  const std::size_t begin = markdown.find(line);
  TF_CHECK(begin != std::string_view::npos);
  const std::string_view rest = markdown.substr(begin + line.size());
  return rest.substr(0, std::min(rest.find("\n## "), rest.size()));
}

}  // namespace tetfarm
