/// The names that a surface file gives to its triangles, numbered in the order of their first use.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tetfarm {

/// Triangles without a name are in the patch "surface".
inline constexpr std::string_view unnamed_patch = "surface";

class PatchNames {
 public:
  std::int32_t number_of(std::string_view name) {
    if (name.empty()) name = unnamed_patch;
    if (const auto it = name2number_.find(name); it != name2number_.end()) return it->second;
    const auto number = static_cast<std::int32_t>(names_.size());
    names_.emplace_back(name);
    name2number_.emplace(name, number);
    return number;
  }
  std::size_t size() const { return names_.size(); }
  std::vector<std::string> take() { return std::move(names_); }

 private:
  std::vector<std::string> names_;
  std::map<std::string, std::int32_t, std::less<>> name2number_;
};

}  // namespace tetfarm
