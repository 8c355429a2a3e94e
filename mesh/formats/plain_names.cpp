#include "mesh/formats/plain_names.h"

#include <set>

namespace tetfarm {
namespace {

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || c == '.';
}

}  // namespace

std::vector<std::string> plain_names(const std::vector<std::string>& names, std::size_t most,
                                     const std::vector<std::string>& taken) {
  std::set<std::string> known(taken.begin(), taken.end());
  std::vector<std::string> plain;
  for (const std::string& name : names) {
    std::string wanted;
    for (const char c : name.substr(0, most)) wanted += is_plain(c) ? c : '_';
    if (wanted.empty()) wanted = "_";
    std::string here = wanted;
    for (int n = 2; !known.insert(here).second; ++n) {
      const std::string suffix = "_" + std::to_string(n);
      here = wanted.substr(0, most - suffix.size()) + suffix;
    }
    plain.push_back(here);
  }
  return plain;
}

}  // namespace tetfarm
