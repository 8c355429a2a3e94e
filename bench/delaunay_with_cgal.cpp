// CGAL's Delaunay triangulation of the same points, for comparison: delaunay_with_cgal
// [uniform|clustered|lattice] [points] [runs]. Built only where CGAL is installed.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <iostream>

#include "bench/delaunay_points.h"

int main(int argc, char** argv) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
  const std::string kind = argc > 1 ? argv[1] : "uniform";
  const std::size_t count = argc > 2 ? std::stoul(argv[2]) : 100000;
  const std::size_t runs = argc > 3 ? std::stoul(argv[3]) : 3;
  std::vector<Kernel::Point_3> points;
  for (const tetfarm::Vec3& p : tetfarm::delaunay_points(kind, count)) {
    points.emplace_back(p.x, p.y, p.z);
  }
  std::vector<double> seconds;
  double tets = 0;
  for (std::size_t i = 0; i < runs; ++i) {
    const std::clock_t start = std::clock();
    const Triangulation triangulation(points.begin(), points.end());
    seconds.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    tets = static_cast<double>(triangulation.number_of_cells());
  }
  std::sort(seconds.begin(), seconds.end());
  std::cout << "CGAL " << CGAL_VERSION_STR << " " << kind << ": " << points.size() << " points, "
            << tets << " tets, " << seconds[runs / 2] << " s, " << tets / seconds[runs / 2] / 1e6
            << " M tets/s" << std::endl;
  return EXIT_SUCCESS;
}
