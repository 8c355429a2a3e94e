#include "tests/support/result_digest.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>

namespace tetfarm::test {
namespace {

using Digests = std::map<std::string, std::string>;

std::string list_of(const std::string& room) {
  return std::string(TETFARM_GOLDEN_FOLDER) + "/" + room + ".txt";
}

Digests known_digests(const std::string& room) {
  std::ifstream file(list_of(room));
  Digests digests;
  std::string name;
  std::string digest;
  while (file >> name >> digest) digests[name] = digest;
  return digests;
}

void write_digests(const std::string& room, const Digests& digests) {
  std::ofstream file(list_of(room));
  for (const auto& [name, digest] : digests) file << name << " " << digest << "\n";
  ASSERT_TRUE(file.flush().good()) << list_of(room);
}

}  // namespace

void expect_known(const std::string& room, const std::string& name, const ResultDigest& result) {
  Digests digests = known_digests(room);
  if (std::getenv("UPDATE_GOLDEN") != nullptr) {
    digests[name] = result.hex();
    write_digests(room, digests);
    return;
  }
  const auto found = digests.find(name);
  ASSERT_NE(found, digests.end()) << list_of(room) << " does not know " << name;
  EXPECT_EQ(result.hex(), found->second)
      << "the result of " << name << " is another than it was; see tests/support/result_digest.h";
}

}  // namespace tetfarm::test
