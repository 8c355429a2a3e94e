/// What the program prints, made harmless in one place: names, hosts, messages and paths come from
/// files and from other machines, and must not steer the terminal that shows them.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace tetfarm {

/// Marks the words between them as urgent; the guard lets these two sequences pass, and no other.
inline constexpr std::string_view red_begins = "\033[31m";
inline constexpr std::string_view red_ends = "\033[0m";

/// From here on stdout and stderr write control characters, but ends of lines and tabs, and bytes
/// that are no UTF-8 as base/printable_text.h shows them, whoever prints. To be called once, before
/// anything is printed. Ends of lines within a text of others are for those who print it.
void guard_terminal();

/// Steers the terminal, past the guard: for the progress bar.
void steer_terminal(std::FILE* stream, std::string_view sequence);

/// From here on each line that is printed to stderr, with its end or at the end of what is printed
/// before write_error_line, goes out as `rewritten` gives it; lines without text are left out. To
/// be called after guard_terminal.
void rewrite_error_lines(std::string (*rewritten)(std::string_view line));

/// A line that is for programs, without its end: past the guard and past what rewrites lines. It is
/// written at once.
void write_error_line(std::string_view line);

/// How long its lines are; 0: not known, or it is no terminal.
std::size_t terminal_columns(std::FILE* stream);
/// How many lines it shows; likewise.
std::size_t terminal_lines(std::FILE* stream);

/// What the guard would write of a text, and what it keeps back: half a character at its end, which
/// the next text may complete.
struct Guarded {
  std::string shown;
  std::string kept_back;
};
Guarded guarded(std::string_view text);

}  // namespace tetfarm
