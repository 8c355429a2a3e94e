#include <algorithm>
#include <array>

#include "tests/support/cad_families.h"
#include "tests/support/relief.h"

namespace tetfarm::shapes {
namespace {

/// An outline on 8 x 12 squares, and what is open in it.
struct Glyph {
  Loop outline;
  std::vector<Loop> counters;
};

constexpr std::int64_t unit = 64;  // the side of a square

Loop ellipse(GridPoint middle, std::int64_t half_width, std::int64_t half_height, int n) {
  Loop loop = circle(n, unit * std::max(half_width, half_height));
  for (GridPoint& p : loop) {
    if (half_width < half_height) p.x = p.x * half_width / half_height;
    p = p + unit * middle;
  }
  return loop;
}

Loop scaled(Loop loop) {
  for (GridPoint& p : loop) p = unit * p;
  return loop;
}

Glyph letter_of_lines(int number) {
  switch (number) {
    case 0:  // I
      return {{{3, 0}, {5, 0}, {5, 12}, {3, 12}}, {}};
    case 1:  // L
      return {{{0, 0}, {8, 0}, {8, 2}, {2, 2}, {2, 12}, {0, 12}}, {}};
    case 2:  // T
      return {{{3, 0}, {5, 0}, {5, 10}, {8, 10}, {8, 12}, {0, 12}, {0, 10}, {3, 10}}, {}};
    case 3:  // E
      return {{{0, 0},
               {8, 0},
               {8, 2},
               {2, 2},
               {2, 5},
               {6, 5},
               {6, 7},
               {2, 7},
               {2, 10},
               {8, 10},
               {8, 12},
               {0, 12}},
              {}};
    case 4:  // H
      return {{{0, 0},
               {2, 0},
               {2, 5},
               {6, 5},
               {6, 0},
               {8, 0},
               {8, 12},
               {6, 12},
               {6, 7},
               {2, 7},
               {2, 12},
               {0, 12}},
              {}};
    case 5:  // A
      return {{{0, 0}, {2, 0}, {3, 3}, {5, 3}, {6, 0}, {8, 0}, {5, 12}, {3, 12}},
              {{{3, 5}, {5, 5}, {4, 10}}}};
    case 6:  // Z
      return {{{0, 0}, {8, 0}, {8, 2}, {3, 2}, {8, 10}, {8, 12}, {0, 12}, {0, 10}, {5, 10}, {0, 2}},
              {}};
    case 7:  // N
      return {{{0, 0}, {2, 0}, {2, 7}, {6, 0}, {8, 0}, {8, 12}, {6, 12}, {6, 5}, {2, 12}, {0, 12}},
              {}};
    case 8:  // B
      return {{{0, 0}, {6, 0}, {8, 2}, {8, 5}, {7, 6}, {8, 7}, {8, 10}, {6, 12}, {0, 12}},
              {{{2, 2}, {6, 2}, {6, 5}, {2, 5}}, {{2, 7}, {6, 7}, {6, 10}, {2, 10}}}};
    default:  // X
      return {{{0, 0},
               {2, 0},
               {4, 4},
               {6, 0},
               {8, 0},
               {5, 6},
               {8, 12},
               {6, 12},
               {4, 8},
               {2, 12},
               {0, 12},
               {3, 6}},
              {}};
  }
}

Glyph any_letter(Chance& chance, int round_corners) {
  const int number = chance.pick(0, 13);
  if (number <= 9) {
    Glyph glyph = letter_of_lines(number);
    glyph.outline = scaled(glyph.outline);
    for (Loop& counter : glyph.counters) counter = scaled(counter);
    return glyph;
  }
  const int n = chance.pick(6, round_corners), m = chance.pick(5, round_corners);
  if (number == 10) {  // a dot
    return {ellipse({4, 2}, 2, 2, m), {}};
  }
  if (number == 11) {  // P with a round counter
    return {scaled({{0, 0}, {2, 0}, {2, 5}, {7, 5}, {8, 6}, {8, 11}, {7, 12}, {0, 12}}),
            {ellipse({5, 8}, 2, 2, m)}};
  }
  return {ellipse({4, 6}, 4, 6, n), {ellipse({4, 6}, 1, 2, m)}};  // O
}

}  // namespace

SurfaceMesh lettering(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int letters = chance.pick_of({{{1, 1}, {1, 3}, {3, 12}, {12, 80}}}, size);
  const int columns = chance.pick(1, letters);
  const int rows = (letters + columns - 1) / columns;
  const int round_corners = 8 + 12 * size;
  Terrace plate;
  plate.height = 4 + static_cast<std::int64_t>(chance.small(-1, 1) * unit * 8);
  plate.outline = rectangle({0, 0}, {columns * 10 * unit, rows * 14 * unit});
  const auto step = std::min<std::int64_t>(
      plate.height - 1, 1 + static_cast<std::int64_t>(chance.small(-2, 0) * unit * 4));
  const int kind = chance.pick(0, 2);  // raised, engraved, cut through
  for (int k = 0; k < letters; ++k) {
    const GridPoint corner = {((k % columns) * 10 + 1) * unit, ((k / columns) * 14 + 1) * unit};
    const Glyph glyph = any_letter(chance, round_corners);
    Terrace letter;
    letter.outline = moved(glyph.outline, corner);
    letter.height = kind == 0 ? plate.height + step : kind == 1 ? plate.height - step : 0;
    if (kind < 2) {
      for (const Loop& counter : glyph.counters) {
        letter.inside.push_back({moved(counter, corner), plate.height, {}});
      }
    }
    plate.inside.push_back(std::move(letter));
  }
  ReliefOptions options;
  options.order = chance.coin() ? EarOrder::lowest : EarOrder::next;
  options.most_splits = chance.pick(0, 3) == 0 ? chance.pick(1, std::max(1, size)) : 0;
  return relief(plate, options, chance);
}

}  // namespace tetfarm::shapes
