// What people are told when a coordinator cannot start, cannot go on or does not take something:
// whole sentences, with what is meant and what to do.
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

#include "base/error.h"
#include "base/file_system.h"
#include "coordinator/authenticator.h"
#include "coordinator/client_files.h"
#include "coordinator/file_thread.h"
#include "coordinator/guarded_database.h"
#include "coordinator/start_rules.h"
#include "coordinator/submitted_job.h"
#include "coordinator/surface_roots.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

template <class Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return std::to_string(static_cast<int>(error.code())) + " " + error.what();
  }
  return "";
}

class RefusalWords : public testing::Test {
 protected:
  fs::path at(const std::string& name) const { return fs::canonical(folder_.path()) / name; }
  void write(const std::string& name, const std::string& bytes) const {
    fs::create_directories(at(name).parent_path());
    std::ofstream(at(name)) << bytes;
  }
  const TempFolder folder_;
};

TEST_F(RefusalWords, of_surfaces_outside_of_the_allowed_folders) {
  const ArtifactStore store(at("store"));
  write("one/a.stl", "solid");
  write("two/b.stl", "solid");
  write("secret/c.stl", "solid");
  fs::create_symlink(at("secret/c.stl"), at("one/link.stl"));
  const SurfaceRoots roots({at("one"), at("two")}, {at("store"), {}, {}, {at("two/b.stl")}});
  const auto refusal = [&](const fs::path& path) {
    return error_of([&] { roots.take(path, store); });
  };
  const std::string where =
      ": is not in a folder where jobs may name surfaces; submit it without --coordinator-reads, "
      "or put it in one of these folders: " +
      at("one").string() + ", " + at("two").string();
  EXPECT_EQ(refusal(at("secret/c.stl")), "2 " + at("secret/c.stl").string() + where);
  EXPECT_EQ(refusal(at("one/link.stl")),
            "2 " + at("one/link.stl").string() + " (" + at("secret/c.stl").string() + ")" + where);
  EXPECT_EQ(refusal(at("two/b.stl")),
            "2 " + at("two/b.stl").string() +
                ": is a key, a database or another of the farm's own files, which no job may name");
  EXPECT_EQ(refusal("a.stl"), "2 a.stl: is not an absolute path");
  EXPECT_EQ(refusal(at("one")), "2 " + at("one").string() + ": is not a file");
  EXPECT_EQ(refusal(at("one/none")),
            "5 " + at("one/none").string() + ": cannot open: No such file or directory");
  const SurfaceRoots none({}, {});
  EXPECT_THAT(
      error_of([&] { none.take(at("one/a.stl"), store); }),
      testing::EndsWith("one of these folders: none (see --allow-root of the coordinator)"));
  fs::resize_file(at("one/a.stl"), max_taken_bytes + 1);
  EXPECT_EQ(refusal(at("one/a.stl")),
            "2 " + at("one/a.stl").string() +
                ": is larger than the 2147483648 bytes that the coordinator copies; submit it "
                "with --store");
  EXPECT_EQ(error_of([&] { SurfaceRoots({at("nowhere")}, {}); }),
            "2 --allow-root " + at("nowhere").string() + ": is not a folder");
  EXPECT_EQ(error_of([&] {
              SurfaceRoots({at("store")}, {at("store"), {}, {}, {}});
            }),
            "2 --allow-root " + at("store").string() +
                ": jobs must not name files in the store or among the keys; give surfaces a "
                "folder of their own");
}

TEST_F(RefusalWords, of_files_that_clients_ask_for_or_bring) {
  ClientFiles clients({.surfaces = 2, .surfaces_of_client = 1});
  const ClientSender anna{"line", client_name("anna")};
  const ClientSender bob{"other", client_name("bob")};
  const ClientSender eve{"third", client_name("eve")};
  const std::string hash(32, 'a');
  const auto fetch = [&](std::uint64_t job, const std::string& of, std::uint64_t offset) {
    return error_of([&] {
      wire::FetchFile message;
      message.set_task(job);
      message.set_hash(of);
      message.set_offset(offset);
      clients.fetch(anna, message,
                    [&](JobId number) {
                      return number == JobId{1}
                                 ? std::optional(std::vector<StoredArtifact>{{hash, 9}})
                                 : std::nullopt;
                    },
                    {});
    });
  };
  EXPECT_EQ(fetch(1, hash, 0), "");
  EXPECT_EQ(fetch(1, hash, 7), "2 job-1: no chunk begins at byte 7");
  EXPECT_EQ(fetch(2, hash, 0), "5 no job job-2");
  EXPECT_EQ(fetch(1, std::string(32, 'b'), 0), "5 job-1 has no such file");
  const auto offer = [&](const ClientSender& sender, const std::string& of, std::uint64_t size) {
    return error_of([&] {
      wire::OfferFile message;
      message.set_hash(of);
      message.set_size(size);
      clients.offer(sender, message, {});
    });
  };
  EXPECT_EQ(offer(anna, "x", 1), "2 the surface: has no valid checksum");
  EXPECT_EQ(offer(anna, hash, max_brought_bytes + 1),
            "2 the surface: has 2147483649 bytes; at most 2147483648 can be sent over a "
            "connection: submit it with --store");
  EXPECT_EQ(offer(anna, hash, max_brought_bytes), "");
  EXPECT_EQ(offer(anna, hash, 5), "") << "the same one again";
  const std::string full =
      "6 too many surfaces are being sent to this coordinator; try again later";
  EXPECT_EQ(offer(anna, std::string(32, 'b'), 5), full) << "one of a client";
  EXPECT_EQ(offer(bob, hash, 5), "");
  EXPECT_EQ(offer(eve, hash, 5), full) << "two of all";
}

TEST_F(RefusalWords, of_keys_that_are_not_where_they_should_be) {
  const auto places = [this](const char* wanted) {
    return KeyPlaces{*wanted == '\0' ? fs::path() : at(wanted), at("standard"), at("old")};
  };
  EXPECT_EQ(find_keys(places("")).remark,
            "no coordinator.key in " + at("standard").string() + " or " + at("old").string());
  EXPECT_EQ(error_of([&] { find_keys(places("wanted")); }),
            "2 " + at("wanted").string() +
                ": has no coordinator's key; make one with `tetfarm keys new coordinator --keys " +
                at("wanted").string() + "`");
  write("old/coordinator.key", "key");
  const KeysInUse old = find_keys(places(""));
  EXPECT_EQ(old.folder, at("old"));
  EXPECT_EQ(old.remark, "keys of " + at("old").string());
  EXPECT_EQ(old.warning, "the keys are in " + at("old").string() +
                             ", where earlier versions kept them: move that folder to " +
                             at("standard").string() + ", or give it with --keys");
  write("standard/coordinator.key", "key");
  EXPECT_EQ(error_of([&] { find_keys(places("")); }),
            "2 " + at("standard").string() + ": there are keys here and in " + at("old").string() +
                ", where earlier versions kept them: say with --keys which to use");
  EXPECT_EQ(find_keys(places("old")).warning, "");
  const ArtifactStore store(at("store"));
  write("store/keys/coordinator.key", "key");
  EXPECT_EQ(find_keys(places("store/keys")).warning,
            "the keys are in the store " + at("store").string() +
                ", which others can access: move that folder out of it");
}

TEST_F(RefusalWords, of_the_database_of_another_store) {
  EXPECT_EQ(database_folder("/store", ""), "/store");
  EXPECT_EQ(database_folder("/store", "/state"), "/state");
  EXPECT_EQ(prepared_database(at("store"), "", "probe"), at("store/tetfarm.db"));
  EXPECT_EQ(prepared_database(at("store"), at("state"), "probe"), at("state/tetfarm.db"));
  EXPECT_EQ(read_file(at("state/store_id")), "probe");
  EXPECT_EQ(prepared_database(at("store"), at("state"), "probe"), at("state/tetfarm.db"));
  EXPECT_EQ(error_of([&] { prepared_database(at("store"), at("state"), "another"); }),
            "2 " + at("state").string() + ": this folder holds the database of another store");
}

TEST_F(RefusalWords, of_a_database_that_is_not_in_its_place) {
  const std::string path = at("tetfarm.db").string();
  GuardedDatabase database(path);
  fs::rename(path, at("elsewhere"));
  EXPECT_EQ(database.look(1000), GuardedDatabase::Look::has_closed);
  EXPECT_EQ(database.trouble(),
            path +
                ": the database was removed while the coordinator was using it; nothing is "
                "accepted until the same file is back. Move it back, or stop the coordinator, "
                "which then saves what it holds in a file beside it for `tetfarm restore`");
  EXPECT_EQ(database.trouble_code(), ExitCode::failed);
  EXPECT_EQ(database.save_when_removed(77), path + ".saved-77");
  fs::remove(path + ".saved-77");
  write("tetfarm.db", "another");
  EXPECT_EQ(database.look(1499), GuardedDatabase::Look::as_before) << "twice a second";
  EXPECT_EQ(database.look(1500), GuardedDatabase::Look::as_before) << "it is still closed";
  EXPECT_EQ(database.trouble(),
            path +
                ": another file has taken the place of the database while the coordinator was "
                "using it; nothing is accepted. Move the old file back, or restart the "
                "coordinator to continue with the new one");
  EXPECT_EQ(database.save_when_removed(78), "");
  fs::rename(at("elsewhere"), path);
  EXPECT_EQ(database.look(2000), GuardedDatabase::Look::has_opened);
  EXPECT_EQ(database.trouble(), "");
  fs::rename(path + "-wal", at("log"));
  EXPECT_EQ(database.look(2500), GuardedDatabase::Look::has_closed);
  EXPECT_EQ(database.trouble(),
            path +
                "-wal: the log of the database was removed or replaced while the coordinator was "
                "using it; nothing is accepted. Restart the coordinator: as it stops, it writes "
                "what the log held to the database");
}

TEST_F(RefusalWords, of_the_list_of_keys) {
  fs::create_directories(at("keys"));
  write_new_key(at("keys"), "coordinator");
  zmq::context_t context;
  Refusals refusals;
  Authenticator authenticator(context, {.keys_folder = at("keys")}, refusals);
  EXPECT_EQ(authenticator.authorized(), 0U);
  EXPECT_FALSE(authenticator.has_new_list());
  const fs::path list = authorized_keys_path(at("keys"));
  write_file_atomically(list, std::string(64, 'a') + " worker one\nx\n");
  EXPECT_TRUE(authenticator.has_new_list());
  EXPECT_FALSE(authenticator.has_new_list()) << "since the last call";
  EXPECT_THAT(authenticator.take_complaints(),
              ElementsAre("authorised keys: 1",
                          "authorised keys: line 2: not KEY ROLE NAME; this line is ignored"));
  EXPECT_THAT(authenticator.take_complaints(), testing::IsEmpty());
  EXPECT_EQ(authenticator.authorized(), 1U);
  fs::permissions(list, fs::perms::others_write, fs::perm_options::add);
  EXPECT_TRUE(authenticator.has_new_list());
  EXPECT_THAT(authenticator.take_complaints(),
              ElementsAre("nobody is authorised: " + list.string() +
                          ": other users may write to the list of authorised keys: run chmod 644 "
                          "on it"));
  EXPECT_EQ(authenticator.authorized(), 0U);
  EXPECT_FALSE(authenticator.admits_worker(std::string(64, 'a')));
}

TEST_F(RefusalWords, of_submissions) {
  wire::Submit submit;
  const auto refusal = [&submit] { return error_of([&] { checked_job_name(submit); }); };
  submit.set_job_toml("name = \"wing\"\n[geometry]\nsurface = \"/a.stl\"\n");
  EXPECT_EQ(refusal(), "");
  EXPECT_EQ(checked_job_name(submit), "wing");
  submit.set_name("duct");
  EXPECT_EQ(checked_job_name(submit), "duct");
  submit.set_name("a/b");
  EXPECT_EQ(refusal(), "2 the job's name must be a plain name, without `/`");
  submit.set_name("");
  submit.set_job_toml("[geometry]\nsurface = \"/a.stl\"\n[spacing]\nsources = \"/b.sou\"\n");
  EXPECT_EQ(refusal(),
            "2 job.toml: `sources` names a file; a submitted job must contain its sources");
}

TEST(OpenFiles, are_allowed_as_far_as_they_may_be) {
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  rlimit few = before;
  few.rlim_cur = 64;
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &few), 0);
  rlimit now{};
  allow_open_files(32);
  ::getrlimit(RLIMIT_NOFILE, &now);
  EXPECT_EQ(now.rlim_cur, 64U) << "never fewer";
  allow_open_files(200);
  ::getrlimit(RLIMIT_NOFILE, &now);
  EXPECT_EQ(now.rlim_cur, std::min<rlim_t>(200, before.rlim_max));
  ::setrlimit(RLIMIT_NOFILE, &before);
}

TEST_F(RefusalWords, of_a_thread_that_carries_out_file_orders) {
  const ArtifactStore store(at("store"));
  const StoredArtifact sound = store.publish("sound");
  FileThread thread(store);
  FileOrder order;
  order.kind = FileOrder::Kind::check;
  order.attempt = AttemptId{7};
  order.connection = "line";
  for (const std::string& hash : {sound.hash, std::string(32, 'f')}) {
    order.file = {hash, sound.size};
    thread.give(order);
  }
  std::vector<FileAnswer> answers;
  for (int i = 0; i < 1000 && answers.size() < 2; ++i) {
    for (FileAnswer& answer : thread.take_answers()) answers.push_back(std::move(answer));
    ::usleep(1000);
  }
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].connection, "line");
  EXPECT_EQ(answers[0].checked->verdict, CheckedFile::Verdict::sound) << "in the order given";
  EXPECT_EQ(answers[0].checked->attempt, AttemptId{7});
  EXPECT_EQ(answers[1].checked->verdict, CheckedFile::Verdict::damaged) << "it is not there";
  EXPECT_EQ(answers[1].checked->hash, std::string(32, 'f'));
}

}  // namespace
}  // namespace tetfarm
