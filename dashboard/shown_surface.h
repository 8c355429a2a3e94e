/// The boundary of a sub-domain in the bytes that pages draw: few triangles, numbers of 32 bits.
///
/// Little endian: 8 bytes "TFSHOWN\n"; u32 version, 1; u32 V; u32 T; u32 triangles of the whole
/// boundary; f64[3] origin; f32[3][V] vertices, seen from the origin; u32[3][T] triangles; i32[T]
/// what each is a piece of: a patch by its number, or a ShownPiece. At most 64 + 52 T bytes.
/// docs/api.md says the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "mesh/core/subdomain.h"

namespace tetfarm {

/// What a triangle is a piece of when it is of no patch that is known.
enum class ShownPiece : std::int32_t { cut = -1, top = -2, unknown_patch = -3 };

inline constexpr std::size_t shown_surface_head = 48;

/// Of each triangle of the sub-domain, in its order; of the input surface, what `patches` says, the
/// patch of each triangle of `numbers_in_input()`; where that is empty, unknown.
std::vector<std::int32_t> pieces_of_boundary(const Subdomain& subdomain,
                                             std::span<const std::int32_t> patches);

/// The numbers in the input surface of those triangles that are from there, in their order.
std::vector<std::uint32_t> numbers_in_input(const Subdomain& subdomain);

/// @pre one piece for each triangle. @throws CorruptFile naming `name` when a coordinate is not a
/// number below 1e30.
/// Cost: as fewer_triangles().
std::string shown_surface(const Subdomain& subdomain, std::span<const std::int32_t> pieces,
                          std::size_t most, const std::string& name);

}  // namespace tetfarm
