// Meshes what a closed surface encloses, and prints how many elements that took and their volume.
// Built with CMake as examples/library/CMakeLists.txt says, or with
//   g++ -std=c++20 mesh_a_surface.cpp $(pkg-config --cflags --libs --static tetfarm)
#include <cstdio>
#include <exception>

#include "mesh/core/signed_volume.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/library/mesh_surface.h"

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "usage: mesh_a_surface SURFACE.stl\n");
    return 2;
  }
  try {
    tetfarm::MeshSurfaceOptions options;
    options.spacing.growth = 0.2;  // edges may be longer by a fifth of the way from the surface
    const tetfarm::MeshedSurface mesh =
        tetfarm::mesh_surface(tetfarm::read_surface(words[1]), options);
    double volume = 0;
    for (const auto& [a, b, c, d] : mesh.tets) {
      volume += tetfarm::signed_volume(mesh.nodes[a], mesh.nodes[b], mesh.nodes[c], mesh.nodes[d]);
    }
    std::printf("%zu nodes, %zu tets, volume %.9g\n", mesh.nodes.size(), mesh.tets.size(), volume);
    return 0;
  } catch (const std::exception& error) {  // says which triangles are wrong, and where they are
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
