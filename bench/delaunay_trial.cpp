// How fast the Delaunay kernel is, and what it holds: delaunay_trial [uniform|clustered|lattice]
// [points] [runs]. Times are CPU times, the median of the runs, so that a busy machine disturbs
// little; the sum over nodes and neighbours shows whether two builds give the same tets.
#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <iostream>

#include "bench/delaunay_points.h"
#include "mesh/geometry/bowyer_watson.h"

namespace tetfarm {
namespace {

std::uint64_t checksum(const TetComplex& complex) {
  std::uint64_t sum = 0;
  const auto mix = [&sum](std::int32_t value) {
    sum = (sum ^ static_cast<std::uint32_t>(value)) * 0x9e3779b97f4a7c15ULL;
    sum ^= sum >> 29U;
  };
  for (const Tet& tet : complex.nodes) std::for_each(tet.begin(), tet.end(), mix);
  for (const auto& faces : complex.neighbours) std::for_each(faces.begin(), faces.end(), mix);
  std::for_each(complex.node2tet.begin(), complex.node2tet.end(), mix);
  return sum;
}

std::size_t bytes_held(const TetComplex& complex) {
  return complex.points.capacity() * sizeof(Vec3) + complex.nodes.capacity() * sizeof(Tet) +
         complex.neighbours.capacity() * sizeof(Tet) +
         (complex.node2tet.capacity() + complex.free_tets.capacity()) * sizeof(std::int32_t);
}

int run(const std::string& kind, std::size_t count, std::size_t runs) {
  const std::vector<Vec3> points = delaunay_points(kind, count);
  std::vector<double> seconds;
  for (std::size_t i = 0; i < runs; ++i) {
    const std::clock_t start = std::clock();
    const DelaunayTets tets = bowyer_watson(points);
    seconds.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    if (i + 1 < runs) continue;
    std::sort(seconds.begin(), seconds.end());
    const auto live = static_cast<double>(tets.complex.live_tets());
    std::cout << kind << ": " << points.size() << " points, " << live << " tets, "
              << seconds[runs / 2] << " s, " << live / seconds[runs / 2] / 1e6 << " M tets/s, "
              << static_cast<double>(bytes_held(tets.complex)) / live << " bytes a tet, checksum "
              << std::hex << checksum(tets.complex) << std::endl;
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace tetfarm

int main(int argc, char** argv) {
  const std::string kind = argc > 1 ? argv[1] : "uniform";
  const std::size_t count = argc > 2 ? std::stoul(argv[2]) : 100000;
  return tetfarm::run(kind, count, argc > 3 ? std::stoul(argv[3]) : 3);
}
