#include "mesh/job_file/job_formats.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(JobFormats, that_tasks_write_are_theirs_alone) {
  EXPECT_THAT(formats_of_tasks({"lb8.ugrid"}), ElementsAre("lb8.ugrid"));
  EXPECT_THAT(formats_of_tasks({"lb8.ugrid", "vtkhdf"}), ElementsAre("lb8.ugrid", "vtkhdf"));
  EXPECT_THAT(formats_to_convert({"lb8.ugrid", "vtkhdf"}), IsEmpty());
}

TEST(JobFormats, that_are_converted_want_vtkhdf_once) {
  EXPECT_THAT(formats_of_tasks({"su2", "lb8.ugrid", "cgns"}), ElementsAre("lb8.ugrid", "vtkhdf"));
  EXPECT_THAT(formats_of_tasks({"vtkhdf", "su2"}), ElementsAre("vtkhdf"));
  EXPECT_THAT(formats_to_convert({"su2", "lb8.ugrid", "cgns"}), ElementsAre("su2", "cgns"));
}

}  // namespace
}  // namespace tetfarm
