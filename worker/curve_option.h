/// `--curve PATCH=KIND`: the true curves of the boundary, as they are written on the command line.
///
/// PATCH is a number of the mesh, or several with commas; KIND is naca00XX, circle, line or
/// spline:FILE, the first two with their numbers (`circle:x=0,y=0,r=2`) or without, to be found
/// from the nodes.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "mesh/adaptation/nodes_on_curves.h"

namespace tetfarm {

/// The curves that were asked for, and the mesh with its nodes on them.
struct CurvesOfMesh {
  PlaneMesh mesh;
  TriangleComplex complex;  ///< checked_complex() of it
  std::vector<PatchCurve> curves;
  std::vector<std::string> texts;  ///< what each is: "radius 2 about (0, 0)"
  std::vector<MovedNodes> moved;
};

/// Where the file lies that an option names as `typed`.
using PlaceOfSpline = std::function<std::filesystem::path(const std::string& typed)>;

/// @throws UsageError for a word of the option that is wrong, before anything is read.
void check_curve_options(const std::vector<std::string>& options);

/// The files that options name, each once, in their order. @throws UsageError as above.
std::vector<std::string> spline_files(const std::vector<std::string>& options);

/// @throws UsageError as above; InvalidInput for a mesh that is wrong, a patch that is not there, a
/// file of loops that is none, nodes that lie on no such curve.
CurvesOfMesh curves_of_options(const std::vector<std::string>& options, PlaneMesh mesh,
                               double corner_angle_deg, const PlaceOfSpline& place);

/// Of files that lie where the options say.
CurvesOfMesh curves_of_options(const std::vector<std::string>& options, PlaneMesh mesh,
                               double corner_angle_deg);

}  // namespace tetfarm
