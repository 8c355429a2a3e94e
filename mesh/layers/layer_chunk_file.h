/// A chunk of layers as a file between tasks: all that it is grown from. The grammar is in
/// store/formats.md.
#pragma once

#include <string>
#include <string_view>

#include "mesh/layers/layer_chunks.h"

namespace tetfarm {

std::string layer_chunk_to_bytes(const LayerChunk& chunk);

/// @throws CorruptFile naming `name`, also where the invariants of a chunk do not hold or a line
/// has more than most_layers.
LayerChunk layer_chunk_from_bytes(std::string_view bytes, const std::string& name);

}  // namespace tetfarm
