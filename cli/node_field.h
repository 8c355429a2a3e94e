/// A field of numbers at the nodes of a mesh of the plane, from its file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tetfarm {

/// @param values how many the file has. @param mesh what it is called in the message.
/// @throws InvalidInput when there is not one for each node.
void require_value_for_each_node(std::size_t values, std::size_t nodes, const std::string& mesh,
                                 const std::string& file);

/// The scalar field of that number, from 1. @throws UsageError when the file has fewer;
/// InvalidInput when it has none, or as above; IoError.
std::vector<double> node_field(const std::string& file, std::int64_t number, std::size_t nodes,
                               const std::string& mesh);

}  // namespace tetfarm
