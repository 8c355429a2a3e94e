/// The pieces that the charts are made of.
#pragma once

#include <cstdio>
#include <string>

namespace tetfarm {

/// As printf, at most 400 characters.
template <class... Arguments>
std::string formatted(const char* pattern, Arguments... arguments) {
  char text[400];
  std::snprintf(text, sizeof text, pattern, arguments...);
  return text;
}

/// `anchor`: start, middle or end. The words are escaped.
std::string svg_text(double x, double y, const char* anchor, const std::string& words);

/// Of a class of the page's styles.
std::string svg_line(double x1, double y1, double x2, double y2, const char* kind);

}  // namespace tetfarm
