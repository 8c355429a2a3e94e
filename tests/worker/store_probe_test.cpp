#include "worker/store_probe.h"

#include <gtest/gtest.h>

#include "base/file_system.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

TEST(StoreProbe, is_a_file_of_the_store_that_the_message_names_and_that_goes_with_its_owner) {
  const TempFolder folder;
  const ArtifactStore store(folder.path());
  std::filesystem::path file;
  {
    StoreProbe probe(folder.path());
    EXPECT_FALSE(probe.is_lost()) << "there was none yet";
    wire::Hello hello;
    EXPECT_TRUE(probe.put_into(hello, 0));
    EXPECT_EQ(hello.store_probe(), store.probe());
    EXPECT_EQ(hello.probe_file().size(), 32U);
    EXPECT_EQ(hello.probe_text().size(), 32U);
    EXPECT_NE(hello.probe_file(), hello.probe_text());
    file = probe_path(store, hello.probe_file());
    EXPECT_EQ(read_file(file), hello.probe_text());
    wire::Hello again;
    EXPECT_TRUE(probe.put_into(again, 1));
    EXPECT_EQ(again.probe_file(), hello.probe_file()) << "the coordinator may read either";
    EXPECT_EQ(again.probe_text(), hello.probe_text());
    EXPECT_FALSE(probe.is_lost());
  }
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(StoreProbe, that_was_swept_away_is_followed_by_another) {
  const TempFolder folder;
  const ArtifactStore store(folder.path());
  StoreProbe probe(folder.path());
  wire::Hello hello;
  probe.put_into(hello, 0);
  std::filesystem::remove(probe_path(store, hello.probe_file()));
  EXPECT_TRUE(probe.is_lost());
  wire::Hello again;
  EXPECT_TRUE(probe.put_into(again, 1));
  EXPECT_NE(again.probe_file(), hello.probe_file());
  EXPECT_EQ(read_file(probe_path(store, again.probe_file())), again.probe_text());
  EXPECT_FALSE(probe.is_lost());
}

TEST(StoreProbe, waits_for_a_store_that_is_not_there_but_not_for_ever) {
  const TempFolder folder;
  StoreProbe probe(folder.path() / "store");
  wire::Hello hello;
  EXPECT_FALSE(probe.put_into(hello, 500));
  EXPECT_FALSE(probe.put_into(hello, 10'499));
  EXPECT_TRUE(probe.put_into(hello, 10'500)) << "ten seconds after the first look";
  EXPECT_EQ(hello.store_probe() + hello.probe_file() + hello.probe_text(), "");
  { const ArtifactStore store(folder.path() / "store"); }
  EXPECT_TRUE(probe.put_into(hello, 10'600));
  EXPECT_NE(hello.probe_file(), "");
  std::filesystem::rename(folder.path() / "store", folder.path() / "away");
  EXPECT_FALSE(probe.put_into(hello, 50'000)) << "the patience begins anew";
  EXPECT_TRUE(probe.put_into(hello, 60'000));
}

TEST(StoreProbe, of_a_worker_without_a_store_is_none) {
  StoreProbe probe("");
  wire::Hello hello;
  EXPECT_TRUE(probe.put_into(hello, 0));
  EXPECT_EQ(hello.ByteSizeLong(), 0U);
  EXPECT_FALSE(probe.is_lost());
}

}  // namespace
}  // namespace tetfarm
