#include "tests/support/revolved.h"

#include <utility>

#include "tests/support/surface_parts.h"

namespace tetfarm::shapes {
namespace {

std::int32_t add_row(SurfaceMesh& mesh, const Loop& ring, const RevolvedRow& row) {
  const auto first = static_cast<std::int32_t>(mesh.vertices.size());
  const auto z = static_cast<double>(row.z);
  if (row.radius == 0) {
    mesh.vertices.push_back({0, 0, z});
    return first;
  }
  for (const GridPoint p : ring) {
    mesh.vertices.push_back(
        {static_cast<double>(row.radius * p.x), static_cast<double>(row.radius * p.y), z});
  }
  return first;
}

}  // namespace

EndCap any_cap(Chance& chance) {
  constexpr std::array<EndCap, 3> caps = {EndCap::rim_fan, EndCap::middle_fan, EndCap::strip};
  return caps[static_cast<std::size_t>(chance.pick(0, 2))];
}

void add_end_cap(SurfaceMesh& mesh, std::int32_t first, std::int32_t count, EndCap cap,
                 bool is_turned) {
  const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
    mesh.triangles.push_back(is_turned ? Triangle{a, c, b} : Triangle{a, b, c});
  };
  switch (cap) {
    case EndCap::rim_fan:
      for (std::int32_t k = 1; k + 1 < count; ++k) add(first, first + k, first + k + 1);
      break;
    case EndCap::middle_fan: {
      const auto middle = static_cast<std::int32_t>(mesh.vertices.size());
      mesh.vertices.push_back({0, 0, mesh.vertices[static_cast<std::size_t>(first)].z});
      for (std::int32_t k = 0; k < count; ++k) add(first + k, first + (k + 1) % count, middle);
      break;
    }
    case EndCap::strip: {
      // From both ends of the ring's numbers inwards.
      std::int32_t low = 0, high = count - 1;
      for (bool is_low = true; high - low > 1; is_low = !is_low) {
        const std::int32_t middle = is_low ? low + 1 : high - 1;
        add(first + low, first + middle, first + high);
        (is_low ? low : high) = middle;
      }
      break;
    }
  }
}

SurfaceMesh revolved(const Loop& ring, std::span<const RevolvedRow> rows, EndCap cap,
                     Chance& chance) {
  SurfaceMesh mesh;
  const auto n = static_cast<std::int32_t>(ring.size());
  std::vector<std::int32_t> firsts;
  for (const RevolvedRow& row : rows) firsts.push_back(add_row(mesh, ring, row));
  for (std::size_t j = 0; j + 1 < rows.size(); ++j) {
    const std::int32_t low = firsts[j], high = firsts[j + 1];
    for (std::int32_t k = 0; k < n; ++k) {
      const std::int32_t next = (k + 1) % n;
      if (rows[j].radius == 0) {
        mesh.triangles.push_back({low, high + next, high + k});
      } else if (rows[j + 1].radius == 0) {
        mesh.triangles.push_back({low + k, low + next, high});
      } else {
        add_quad(mesh, {low + k, low + next, high + next, high + k}, chance.coin());
      }
    }
  }
  if (rows.front().radius > 0) add_end_cap(mesh, firsts.front(), n, cap, true);
  if (rows.back().radius > 0) add_end_cap(mesh, firsts.back(), n, cap, false);
  return with_one_patch(std::move(mesh));
}

}  // namespace tetfarm::shapes
