/// Reads the real geometries that TETFARM_DATA points to.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "mesh/formats/surfaces/read_surface.h"

namespace tetfarm {

/// A test on real data; skipped when TETFARM_DATA is not set.
class RealSurfaces : public testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("TETFARM_DATA");
    if (folder == nullptr) GTEST_SKIP() << "TETFARM_DATA is not set";
    folder_ = folder;
  }
  SurfaceMesh read(const std::string& name) const { return read_surface(folder_ + "/" + name); }

 private:
  std::string folder_;
};

}  // namespace tetfarm
