#include "mesh/formats/tetgen/tetgen_lists.h"

namespace tetfarm {

std::size_t tetgen_count(InputScanner& in, std::string_view what) {
  constexpr std::size_t shortest_record = 6;
  return in.to_count(in.integer(what), shortest_record);
}

std::int64_t tetgen_option(InputScanner& in, std::int64_t otherwise) {
  const std::string_view word = in.word_in_line();
  return word.empty() ? otherwise : in.to_integer(word, "a number");
}

std::int64_t walk_tetgen_nodes(InputScanner& in, const std::function<void(const Vec3&)>& add_node) {
  const std::size_t nodes = tetgen_count(in, "the number of nodes");
  if (nodes > 0 && tetgen_option(in, 3) != 3) in.fail("the nodes are not three-dimensional");
  in.rest_of_line();
  std::int64_t first = 0;
  for (std::size_t i = 0; i < nodes; ++i) {
    const std::int64_t number = in.integer("a node number");
    if (i == 0) first = number;
    if ((first != 0 && first != 1) || number != first + static_cast<std::int64_t>(i)) {
      in.fail("nodes are not numbered consecutively from 0 or 1");
    }
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = in.coordinate_in_line();
    in.rest_of_line();
    add_node(p);
  }
  return first;
}

}  // namespace tetfarm
