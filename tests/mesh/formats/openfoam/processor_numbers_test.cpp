#include "mesh/formats/openfoam/processor_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "base/error.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

ProcessorPatch patch(std::int32_t neighbour,
                     const std::vector<std::array<std::int32_t, 3>>& triangles) {
  ProcessorPatch patch;
  patch.neighbour = neighbour;
  for (const auto& triangle : triangles) patch.faces.emplace_back(triangle);
  return patch;
}

/// What is said of processors with four nodes each.
std::string refusal(const std::vector<std::vector<ProcessorPatch>>& processors) {
  ProcessorNumbers numbers("case");
  try {
    for (const auto& patches : processors) numbers.add(4, patches);
    numbers.finish();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(ProcessorNumbers, nodes_of_faces_between_have_the_number_of_the_first_processor) {
  ProcessorNumbers numbers("case");
  numbers.add(5, {patch(1, {{3, 1, 2}})});
  numbers.add(4, {patch(0, {{0, 3, 1}})});  // 0 is 3, 3 is 2, 1 is 1
  numbers.finish();
  EXPECT_THAT(numbers.local2global(0), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(numbers.local2global(1), ElementsAre(3, 1, 5, 2));
}

TEST(ProcessorNumbers, a_node_that_a_later_processor_joins_is_one_in_all) {
  ProcessorNumbers numbers("case");
  // Node 0 of 0 is node 1 of 2, which is node 2 of 1; 0 and 1 share no face.
  numbers.add(4, {patch(2, {{0, 1, 2}})});
  numbers.add(4, {patch(2, {{2, 1, 0}})});
  numbers.add(5, {patch(0, {{1, 2, 3}}), patch(1, {{1, 0, 4}})});
  numbers.finish();
  EXPECT_THAT(numbers.local2global(0), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(numbers.local2global(1), ElementsAre(4, 5, 0, 6));
  EXPECT_THAT(numbers.local2global(2), ElementsAre(4, 0, 2, 1, 5));
}

TEST(ProcessorNumbers, processors_without_a_face_between_them_share_no_node) {
  ProcessorNumbers numbers("case");
  numbers.add(2, {});
  numbers.add(1, {});
  numbers.finish();
  EXPECT_THAT(numbers.local2global(1), ElementsAre(2));
}

TEST(ProcessorNumbers, refuses_sides_that_do_not_fit) {
  EXPECT_EQ(refusal({{patch(1, {{0, 1, 2}})}, {patch(0, {{0, 2, 1}})}}), "");
  EXPECT_THAT(refusal({{patch(1, {{0, 1, 2}})}, {}}),
              HasSubstr("case: processors 0 and 1 do not have"));
  EXPECT_THAT(refusal({{}, {patch(0, {{0, 1, 2}})}}),
              HasSubstr("0 and 1 do not have exactly one patch"));
  EXPECT_THAT(refusal({{patch(0, {{0, 1, 2}})}}),
              HasSubstr("0 and 0 do not have exactly one patch"));
  EXPECT_THAT(refusal({{patch(7, {{0, 1, 2}})}}),
              HasSubstr("0 and 7 do not have exactly one patch"));
  EXPECT_THAT(refusal({{patch(1, {{0, 1, 2}}), patch(1, {{0, 1, 3}})}}),
              HasSubstr("do not have exactly one patch"));
  EXPECT_THAT(refusal({{patch(1, {{0, 1, 2}})}, {patch(0, {{0, 2, 1}, {0, 1, 3}})}}),
              HasSubstr("have 1 and 2 faces"));
  ProcessorPatch quad{0, {}};
  quad.faces.emplace_back(std::array<std::int32_t, 4>{0, 1, 2, 3});
  EXPECT_EQ(refusal({{patch(1, {{0, 1, 2}})}, {quad}}),
            "case: processors 0 and 1 have a triangle and a quad in the same place between them");
}

TEST(ProcessorNumbers, refuses_nodes_of_one_processor_that_become_one) {
  EXPECT_THAT(refusal({{patch(1, {{0, 1, 2}, {3, 1, 2}})}, {patch(0, {{0, 2, 1}, {0, 2, 1}})}}),
              HasSubstr("two points of processor 0 coincide"));
  EXPECT_THAT(refusal({{patch(1, {{0, 1, 2}, {0, 1, 2}})}, {patch(0, {{0, 2, 1}, {3, 2, 1}})}}),
              HasSubstr("two points of processor 1 coincide"));
}

}  // namespace
}  // namespace tetfarm
