/// An array of a tree: its own, which grows, or one that lies elsewhere, in a mapped file.
///
/// Elements are read alike wherever they are; only an array of its own is changed. A copy has its
/// own elements.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include "base/check.h"

namespace tetfarm {

template <class T>
class TreeArray {
 public:
  using value_type = T;
  using const_iterator = const T*;

  TreeArray() = default;
  /// A vector is one.
  TreeArray(std::vector<T> own) : own_(std::move(own)) { look_at_own(); }
  TreeArray(std::initializer_list<T> items) : own_(items) { look_at_own(); }
  TreeArray(const TreeArray& other) : own_(other.begin(), other.end()) { look_at_own(); }
  TreeArray(TreeArray&& other) noexcept
      : own_(std::move(other.own_)), items_(std::exchange(other.items_, std::span<const T>())) {}
  TreeArray& operator=(TreeArray other) noexcept {
    own_.swap(other.own_);
    std::swap(items_, other.items_);
    return *this;
  }
  ~TreeArray() = default;

  /// @pre `items` stay where they are for as long as this or what it is moved to.
  static TreeArray elsewhere(std::span<const T> items) {
    TreeArray array;
    array.items_ = items;
    return array;
  }

  const T* data() const { return items_.data(); }
  std::size_t size() const { return items_.size(); }
  bool empty() const { return items_.empty(); }
  const T* begin() const { return items_.data(); }
  const T* end() const { return items_.data() + items_.size(); }
  const T& operator[](std::size_t i) const { return items_[i]; }

  // Of an array of its own:
  T& operator[](std::size_t i) { return own()[i]; }
  void reserve(std::size_t count) {
    own().reserve(count);
    look_at_own();
  }
  void resize(std::size_t count, const T& item = T()) {
    own().resize(count, item);
    look_at_own();
  }
  void push_back(const T& item) {
    own().push_back(item);
    look_at_own();
  }

 private:
  std::vector<T>& own() {
    TF_CHECK(items_.data() == own_.data());
    return own_;
  }
  void look_at_own() { items_ = own_; }

  std::vector<T> own_;
  std::span<const T> items_;
};

}  // namespace tetfarm
