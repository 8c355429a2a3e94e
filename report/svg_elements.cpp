#include "report/svg_elements.h"

#include "report/html_text.h"

namespace tetfarm {

std::string svg_text(double x, double y, const char* anchor, const std::string& words) {
  return formatted("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">", x, y, anchor) +
         escaped(words) + "</text>";
}

std::string svg_line(double x1, double y1, double x2, double y2, const char* kind) {
  return formatted("<line class=\"%s\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>", kind, x1,
                   y1, x2, y2);
}

}  // namespace tetfarm
