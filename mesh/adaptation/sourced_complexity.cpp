#include "mesh/adaptation/sourced_complexity.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

constexpr std::size_t most_pieces = 100'000;

struct PieceCorner {
  Vec2 point;
  Metric2 log;
};

using Piece = std::array<PieceCorner, 3>;

Metric2 mean_of_logs(const Metric2& a, const Metric2& b) {
  return {(a.xx + b.xx) / 2, (a.xy + b.xy) / 2, (a.yy + b.yy) / 2};
}

PieceCorner middle_of(const PieceCorner& a, const PieceCorner& b) {
  return {{(a.point.x + b.point.x) / 2, (a.point.y + b.point.y) / 2}, mean_of_logs(a.log, b.log)};
}

double square_of_side(const Piece& piece, std::size_t i) {
  const Vec2& a = piece[(i + 1) % 3].point;
  const Vec2& b = piece[(i + 2) % 3].point;
  return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

/// The corner opposite the longest side.
std::size_t apex_of(const Piece& piece) {
  std::size_t apex = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (square_of_side(piece, i) > square_of_side(piece, apex)) apex = i;
  }
  return apex;
}

double area_of(const Piece& piece) {
  const auto& [a, b, c] = piece;
  return ((b.point.x - a.point.x) * (c.point.y - a.point.y) -
          (b.point.y - a.point.y) * (c.point.x - a.point.x)) /
         2;
}

/// Adds what the piece has, by the middles of its sides.
void add_piece(SourcedComplexity& sum, const Piece& piece, const MetricSources& sources) {
  double density = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const PieceCorner middle = middle_of(piece[i], piece[(i + 1) % 3]);
    const Metric2 base = exp_of(middle.log);
    density += std::sqrt(determinant(sources.at(middle.point, base))) / 3;
    for (std::size_t k = 0; k < sources.size(); ++k) {
      if (sum.acts[k] == 0 && sources.acts(k, middle.point, base)) sum.acts[k] = 1;
    }
  }
  sum.complexity += area_of(piece) * density;
}

}  // namespace

SourcedComplexity sourced_complexity(const TriangleComplex& complex,
                                     std::span<const Metric2> metrics,
                                     const MetricSources& sources) {
  TF_CHECK(metrics.size() == complex.points.size());
  SourcedComplexity sum;
  sum.acts.assign(sources.size(), 0);
  std::vector<Piece> pieces;
  for (const TriangleComplex::Nodes& n : complex.triangles) {
    Piece piece;
    for (std::size_t i = 0; i < 3; ++i) {
      piece[i] = {complex.point(n[i]), log_of(metrics[at(n[i])])};
    }
    pieces.push_back(piece);
  }
  const std::size_t most = pieces.size() + most_pieces;
  // What is halved is replaced by two at the end, so that pieces of a size come one after another.
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Piece piece = pieces[k];
    const std::size_t apex = apex_of(piece);
    const auto& [top, from, to] = Piece{piece[apex], piece[(apex + 1) % 3], piece[(apex + 2) % 3]};
    const PieceCorner middle = middle_of(from, to);
    const double size = sources.piece_size(middle.point);
    if (pieces.size() >= most || square_of_side(piece, apex) <= size * size) {
      add_piece(sum, piece, sources);
      continue;
    }
    pieces.push_back({top, from, middle});
    pieces.push_back({top, middle, to});
  }
  // Of pieces that are too large nobody can tell.
  if (pieces.size() >= most) sum.acts.assign(sources.size(), 1);
  return sum;
}

}  // namespace tetfarm
