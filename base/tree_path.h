/// Places in a binary tree that is numbered as a heap, in words: the root is 1, the children of p
/// are 2p (left) and 2p + 1 (right).
#pragma once

#include <cstdint>
#include <string>

namespace tetfarm {

/// "root", "L", "LR"…: the way from the root. @pre heap > 0.
std::string tree_path(std::uint64_t heap);

}  // namespace tetfarm
