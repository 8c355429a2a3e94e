#include "cli/machine_probes.h"

#include <gmock/gmock.h>

#include <limits>

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

constexpr std::uint64_t gb = 1'000'000'000;
constexpr std::uint64_t any_files = std::numeric_limits<std::uint64_t>::max();

TEST(MachineProbes, hold_the_memory_of_a_worker_against_that_of_the_machine) {
  const MemoryOfMachine machine{8 * gb, 5 * gb};
  EXPECT_EQ(finding_of_memory(machine, 0).verdict, Verdict::ok);
  EXPECT_EQ(finding_of_memory(machine, 5 * gb).verdict, Verdict::ok);
  const Finding tight = finding_of_memory(machine, 6 * gb);
  EXPECT_EQ(tight.verdict, Verdict::warning);
  EXPECT_THAT(tight.found, HasSubstr("a worker is to take 6.00 GB"));
  const Finding impossible = finding_of_memory(machine, 9 * gb);
  EXPECT_EQ(impossible.verdict, Verdict::problem);
  EXPECT_THAT(impossible.remedy, HasSubstr("--memory 8.00 GB"));
  EXPECT_EQ(finding_of_memory({8 * gb, gb / 2}, 0).verdict, Verdict::warning);
}

TEST(MachineProbes, say_how_many_connections_the_open_files_suffice_for) {
  EXPECT_EQ(finding_of_open_files(32'768).verdict, Verdict::ok);
  const Finding few = finding_of_open_files(1'024);
  EXPECT_EQ(few.verdict, Verdict::warning);
  EXPECT_THAT(few.found, HasSubstr("room for 512 connections, not for 16384"));
  EXPECT_EQ(finding_of_open_files(64).verdict, Verdict::problem);
  EXPECT_EQ(look_at_open_files().check, "open files");
}

TEST(MachineProbes, find_disks_that_are_full_or_nearly_so) {
  EXPECT_EQ(finding_of_room("/farm", {50 * gb, 100 * gb}, any_files).verdict, Verdict::ok);
  EXPECT_EQ(finding_of_room("/farm", {50 * gb, 100 * gb}, any_files).remedy, "");
  EXPECT_EQ(finding_of_room("/farm", {gb / 2, 100 * gb}, any_files).verdict, Verdict::warning);
  const Finding full = finding_of_room("/farm", {1'000'000, 100 * gb}, any_files);
  EXPECT_EQ(full.verdict, Verdict::problem);
  EXPECT_THAT(full.found, HasSubstr("/farm: 1.0 MB free of 100.00 GB"));
  EXPECT_EQ(finding_of_room("/farm", {0, 0}, any_files).verdict, Verdict::ok) << "it does not say";
  EXPECT_EQ(finding_of_room("/farm", {50 * gb, 100 * gb}, 0).verdict, Verdict::problem);
  EXPECT_THAT(finding_of_room("/farm", {50 * gb, 100 * gb}, 500).found,
              HasSubstr("room for 500 more files"));
  EXPECT_EQ(look_at_room("/tmp").check, "disk");
}

}  // namespace
}  // namespace tetfarm
