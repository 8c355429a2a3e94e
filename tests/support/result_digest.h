/// Results of single steps known by their digests: the same bytes on every machine, build and day.
///
/// The lists are tests/golden/ROOM.txt. A change that is meant to change results runs the tests
/// once with UPDATE_GOLDEN=1 and commits them; of several that differ, the earliest step tells
/// where to look. Surfaces and points that go in must come by + - * / and sqrt only.
#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/hash.h"
#include "base/work_progress.h"
#include "mesh/core/vec3.h"

namespace tetfarm::test {

/// The bytes of a result, one number after the other.
class ResultDigest {
 public:
  template <typename Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
  void add(const Number& number) { hasher_.add(&number, sizeof(number)); }
  void add(const Vec3& p) {
    for (int axis = 0; axis < 3; ++axis) add(p[axis]);
  }
  void add(const std::string& text) {
    add(text.size());
    hasher_.add(text.data(), text.size());
  }
  template <typename Thing, std::size_t count>
  void add(const std::array<Thing, count>& things) {
    for (const Thing& thing : things) add(thing);
  }
  template <typename Thing>
  void add(const std::vector<Thing>& things) {
    add(things.size());
    for (const Thing& thing : things) add(thing);
  }
  void add(const std::vector<bool>& things) {
    add(things.size());
    for (const bool thing : things) add(thing);
  }
  template <typename Thing>
  void add(const std::optional<Thing>& thing) {
    add(thing.has_value());
    if (thing) add(*thing);
  }
  template <typename First, typename Second>
  void add(const std::pair<First, Second>& both) {
    add(both.first);
    add(both.second);
  }
  template <typename... Things>
  requires(sizeof...(Things) > 1) void add(const Things&... things) { (add(things), ...); }
  /// Adds what a calculation tells of its progress. @pre this outlives the calculation.
  WorkProgress listener() {
    return WorkProgress(
        [this](const WorkCount& count) { add(count.stage, count.pass, count.done, count.total); });
  }

  std::string hex() const { return hasher_.finish().hex(); }

 private:
  Hasher hasher_;
};

/// Expects the digest that tests/golden/ROOM.txt has under the name.
void expect_known(const std::string& room, const std::string& name, const ResultDigest& result);

}  // namespace tetfarm::test
