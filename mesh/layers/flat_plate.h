/// How high the first layer has to be for a y+ that is asked for: the turbulent boundary layer on a
/// flat plate, as a guess before there is a flow.
///
/// Source: none in the thesis. F. M. White, Fluid Mechanics, 5th ed., 7.4, with the skin friction
/// 0.026 / Re^(1/7) that calculators of wall spacings take from it, and the thickness 0.16 L /
/// Re^(1/7). A step of Newton's method is + - * / alone, so that all machines have the same height.
/// Lengths in the unit of the input.
#pragma once

namespace tetfarm {

struct FlatPlate {
  double skin_friction = 0;  ///< of the place `length` behind the leading edge
  double first_height = 0;   ///< distance from the wall at which y+ is what was asked for
  double thickness = 0;      ///< of the boundary layer there
};

/// @param reynolds that of `length`. @pre all are positive.
FlatPlate flat_plate(double y_plus, double reynolds, double length);

/// x^(1/7), to within two units of the last digit. @pre x is positive and finite. Cost: up to 5000
/// steps for the largest numbers, about 150 for a Reynolds number.
double seventh_root(double x);

}  // namespace tetfarm
