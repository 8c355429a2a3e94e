#include "mesh/formats/plane/number_fields.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;

NodeFields mixed_fields() {
  NodeFields fields;
  fields.order = {NodeFieldKind::vector, NodeFieldKind::scalar, NodeFieldKind::metric,
                  NodeFieldKind::scalar};
  fields.scalars = {{1, 2}, {3, 4}};
  fields.vectors = {{{5, 6}, {7, 8}}};
  fields.metrics = {{{1, 0, 1}, {2, 0, 2}}};
  return fields;
}

TEST(NumberFields, come_in_the_order_of_the_file_and_vectors_component_by_component) {
  const std::vector<NumberField> numbers = number_fields(mixed_fields());
  ASSERT_EQ(numbers.size(), 4U);
  EXPECT_EQ(numbers[0].name, "1.x");
  EXPECT_THAT(numbers[0].values, ElementsAre(5, 7));
  EXPECT_EQ(numbers[1].name, "1.y");
  EXPECT_TRUE(numbers[1].is_component);
  EXPECT_EQ(numbers[2].name, "2");
  EXPECT_FALSE(numbers[2].is_component);
  EXPECT_THAT(numbers[2].values, ElementsAre(1, 2));
  EXPECT_EQ(numbers[3].name, "4") << "metrics have a number, too";
}

TEST(NumberFields, assembled_again_are_the_fields_that_there_were) {
  const NodeFields before = mixed_fields();
  std::vector<std::vector<double>> numbers;
  for (const NumberField& field : number_fields(before)) numbers.push_back(field.values);
  const NodeFields after = assembled_fields(before, numbers, before.metrics);
  EXPECT_EQ(after.order, before.order);
  EXPECT_EQ(after.scalars, before.scalars);
  EXPECT_EQ(after.vectors, before.vectors);
  EXPECT_EQ(after.metrics.size(), 1U);
}

}  // namespace
}  // namespace tetfarm
