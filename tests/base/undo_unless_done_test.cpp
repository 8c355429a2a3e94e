#include "base/undo_unless_done.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace tetfarm {
namespace {

TEST(UndoUnlessDone, undoes_what_an_exception_cut_short) {
  int undone = 0;
  const auto fails = [&undone] {
    const UndoUnlessDone begun([&undone] { ++undone; });
    throw std::runtime_error("disk full");
  };
  EXPECT_THROW(fails(), std::runtime_error);
  EXPECT_EQ(undone, 1);
}

TEST(UndoUnlessDone, undoes_what_a_return_left_half_done) {
  int undone = 0;
  {
    const UndoUnlessDone begun([&undone] { ++undone; });
  }
  EXPECT_EQ(undone, 1);
}

TEST(UndoUnlessDone, leaves_alone_what_is_done) {
  int undone = 0;
  {
    UndoUnlessDone begun([&undone] { ++undone; });
    begun.done();
  }
  EXPECT_EQ(undone, 0);
}

}  // namespace
}  // namespace tetfarm
