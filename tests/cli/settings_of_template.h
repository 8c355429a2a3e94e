// The settings of a job file that are commented out, put into force one at a time, by the text
// alone: whoever adds one to the template need not say so anywhere else.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/cli/other_programs.h"

namespace tetfarm {

/// "#growth = 0.3", "##factor = 3", "#[[source]]"; no remark.
inline bool is_setting_left_out(const std::string& line) {
  return line.size() > 1 && line[0] == '#' && line[1] != ' ';
}

inline std::string text_of_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// A template with some of its settings in force, the last of them being `setting`.
struct SettingInForce {
  std::string setting;
  std::string text;
};

/// Each block of adjacent settings without its first #, then with each second # of it taken away
/// alone.
inline std::vector<SettingInForce> settings_in_force(const std::string& text) {
  const std::vector<std::string> lines = lines_of(text);
  std::vector<SettingInForce> all;
  for (std::size_t begin = 0; begin < lines.size();) {
    std::size_t end = begin;
    std::vector<std::string> changed = lines;
    while (end < lines.size() && is_setting_left_out(lines[end])) changed[end++].erase(0, 1);
    if (end > begin) all.push_back({changed[begin], text_of_lines(changed)});
    for (std::size_t i = begin; i < end; ++i) {
      if (!is_setting_left_out(changed[i])) continue;
      std::vector<std::string> once_more = changed;
      once_more[i].erase(0, 1);
      all.push_back({once_more[i], text_of_lines(once_more)});
    }
    begin = end + 1;
  }
  return all;
}

}  // namespace tetfarm
