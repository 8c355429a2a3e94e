/// Triangles with numbers on them as the text of a .vtp file (XML PolyData, ASCII), which ParaView
/// opens.
///
/// Source: VTK's documentation, "VTK XML formats".
#pragma once

#include <string>
#include <vector>

namespace tetfarm {

/// The shortest text that reads back as the same number.
std::string shortest_text(double x);

/// Numbers of the triangles: a line each.
struct VtpArray {
  std::string type;  ///< "Int64" or "Float64"
  std::string name;
  std::string values;
};

struct VtpTriangles {
  std::string legend;       ///< comments in XML
  std::size_t points = 0;   ///< how many
  std::string coordinates;  ///< three numbers a line
  std::size_t triangles = 0;
  std::string corners;           ///< three numbers a line
  std::vector<VtpArray> arrays;  ///< the first is shown
};

/// @pre there is an array. Cost: O(n).
std::string vtp_text(const VtpTriangles& triangles);

}  // namespace tetfarm
