// Nothing is tried out before a cut is taken: whatever leaves come of it have to be meshed.
#include <gtest/gtest.h>

#include "mesh/inspect/surface_check.h"
#include "tests/support/generated_surfaces.h"
#include "tests/worker/task_chain.h"

namespace tetfarm {
namespace {

class LeavesOfGeneratedSurfaces : public test::TaskChain,
                                  public testing::WithParamInterface<shapes::SurfaceGenerator> {
 protected:
  /// Leaves of the order of the surface's triangles: cuts run between needles, spikes and gaps.
  void expect_meshed(std::uint64_t seed, int size, std::int64_t subdomains) {
    const CheckedSurface checked =
        check_surface(shapes::moved_by_chance(GetParam().make(seed, size), seed));
    if (!checked.report.defects.empty()) return;
    JobFile job = job_of(subdomains);
    job.spacing_default = 0.1 * norm(bounding_box(checked.surface.vertices).size());
    const wire::Envelope assembled = chain(job, checked.surface);
    EXPECT_TRUE(assembled.has_done()) << "seed " << seed << ", size " << size << ", " << subdomains
                                      << " sub-domains: " << assembled.failed().message();
    ++meshed_;
  }

  int meshed_ = 0;
};

TEST_P(LeavesOfGeneratedSurfaces, are_all_meshed) {
  for (std::uint64_t seed = 8; seed < 14; ++seed) {
    expect_meshed(seed, 1, 4);
    expect_meshed(seed, 2, 16);
  }
  EXPECT_GT(meshed_, 8);
}

INSTANTIATE_TEST_SUITE_P(Generators, LeavesOfGeneratedSurfaces,
                         testing::ValuesIn(shapes::surface_generators().begin(),
                                           shapes::surface_generators().end()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace tetfarm
