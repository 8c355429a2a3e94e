/// The bytes of artifacts that tasks exchange and read whole: sub-domain and tet mesh. Little
/// endian, a magic and a version first, an XXH3-128 of all before it last; the grammar is in
/// store/formats.md.
///
/// from_bytes functions validate lengths, indices and checksum, and throw CorruptFile naming
/// `name`.
#pragma once

#include <string>
#include <string_view>

#include "mesh/core/subdomain.h"
#include "mesh/core/tet_mesh.h"

namespace tetfarm {

std::string subdomain_to_bytes(const Subdomain& subdomain);
Subdomain subdomain_from_bytes(std::string_view bytes, const std::string& name);

/// Holds the nodes after `boundary_nodes` only: the first are those of the sub-domain.
std::string tet_mesh_to_bytes(const TetMesh& mesh);
/// `subdomain` gives the boundary nodes.
TetMesh tet_mesh_from_bytes(std::string_view bytes, const Subdomain& subdomain,
                            const std::string& name);

}  // namespace tetfarm
