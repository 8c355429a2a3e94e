#include "mesh/formats/plane/number_fields.h"

#include <utility>

#include "base/check.h"

namespace tetfarm {

std::vector<NumberField> number_fields(const NodeFields& fields) {
  std::vector<NumberField> result;
  std::size_t scalar = 0;
  std::size_t vector = 0;
  for (std::size_t k = 0; k < fields.order.size(); ++k) {
    const std::string number = std::to_string(k + 1);
    if (fields.order[k] == NodeFieldKind::scalar) {
      result.push_back({number, false, fields.scalars[scalar++]});
    } else if (fields.order[k] == NodeFieldKind::vector) {
      NumberField x{number + ".x", true, {}};
      NumberField y{number + ".y", true, {}};
      for (const Vec2& v : fields.vectors[vector++]) {
        x.values.push_back(v.x);
        y.values.push_back(v.y);
      }
      result.push_back(std::move(x));
      result.push_back(std::move(y));
    }
  }
  return result;
}

NodeFields assembled_fields(const NodeFields& like, std::vector<std::vector<double>> numbers,
                            std::vector<std::vector<Metric2>> metrics) {
  TF_CHECK(numbers.size() == like.scalars.size() + 2 * like.vectors.size());
  TF_CHECK(metrics.size() == like.metrics.size());
  NodeFields fields;
  fields.order = like.order;
  fields.metrics = std::move(metrics);
  auto next = numbers.begin();
  for (const NodeFieldKind kind : like.order) {
    if (kind == NodeFieldKind::scalar) fields.scalars.push_back(std::move(*next++));
    if (kind != NodeFieldKind::vector) continue;
    const std::vector<double> x = std::move(*next++);
    const std::vector<double> y = std::move(*next++);
    TF_CHECK(x.size() == y.size());
    std::vector<Vec2>& vectors = fields.vectors.emplace_back();
    for (std::size_t v = 0; v < x.size(); ++v) vectors.push_back({x[v], y[v]});
  }
  return fields;
}

}  // namespace tetfarm
