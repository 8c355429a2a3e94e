/// One page about an adaptation loop: the meshes and solutions of its cycles side by side, what the
/// solution is along the walls, and the table of cycles.
///
/// Source: thesis 3.4.2, figs. 40 to 42, which show a loop in this way.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "report/report_page.h"

namespace tetfarm {

struct ReportedCycle {
  std::int64_t number = 1;
  ReportPicture mesh;
  ReportPicture solution;
  std::string last_words;  ///< of the solver; any bytes
};

struct CyclesContent {
  std::string name;
  std::int64_t cycles = 0;           ///< all, also those that are not shown
  std::vector<ReportedCycle> shown;  ///< in their order
  std::string chart;                 ///< an SVG file; empty: there is no wall
  std::vector<std::string> head;     ///< of the table
  std::vector<std::vector<std::string>> rows;
};

/// Texts of any bytes are escaped. The same content gives the same bytes.
std::string cycles_page(const CyclesContent& content);

}  // namespace tetfarm
