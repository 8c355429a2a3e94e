/// The fields of a solution as lists of numbers, each component of vectors by itself, and back.
#pragma once

#include <string>
#include <vector>

#include "mesh/formats/plane/plane_medit.h"

namespace tetfarm {

/// A field of numbers, or a component of vectors.
struct NumberField {
  std::string name;  ///< as people call it: "2", or "3.x" of a vector
  bool is_component = false;
  std::vector<double> values;
};

/// Those of numbers and vectors, numbered from 1 in the order of the file. Cost: O(numbers).
std::vector<NumberField> number_fields(const NodeFields& fields);

/// Fields of the kinds and order of `like`. @pre `numbers` are as many lists as number_fields(like)
/// has, in its order, and `metrics` as many as those of `like`.
NodeFields assembled_fields(const NodeFields& like, std::vector<std::vector<double>> numbers,
                            std::vector<std::vector<Metric2>> metrics);

}  // namespace tetfarm
