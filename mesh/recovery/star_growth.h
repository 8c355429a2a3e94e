/// Gives a node more room: tets beyond the faces that hem it in become part of its star.
///
/// A node between a boundary face and faces nearly in one plane with it may have less room than
/// doubles tell, however it moves. What lies beyond those faces is taken in, one tet at a time,
/// each time the one that leaves the node most room. Source: the cavity of constrained insertion
/// (P. L. George, H. Borouchaki, "Delaunay Triangulation and Meshing", 1998), grown by room in
/// place of spheres. Cost: as the square of the star, for each tet taken in.
#pragma once

#include <cstdint>

#include "mesh/recovery/local_remeshing.h"

namespace tetfarm {

/// True when the node now lies at a place of plain doubles, with all its tets positive. False:
/// nothing has changed. @pre the node came by add_point and no face at it is constrained.
bool grow_star(LocalRemeshing& mesh, std::int32_t node);

}  // namespace tetfarm
