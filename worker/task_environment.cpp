#include "worker/task_environment.h"

namespace tetfarm {

std::vector<std::string> task_environment(char* const* environment) {
  const std::string variable = "GLIBC_TUNABLES=";
  const std::string choice = "glibc.malloc.hugetlb";
  std::string tunables = variable;
  std::vector<std::string> result;
  for (; *environment != nullptr; ++environment) {
    const std::string word = *environment;
    if (word.starts_with(variable)) {
      tunables = word;
    } else {
      result.push_back(word);
    }
  }
  if (tunables.find(choice) == std::string::npos) {
    tunables += (tunables == variable ? "" : ":") + choice + "=1";
  }
  result.push_back(tunables);
  return result;
}

}  // namespace tetfarm
