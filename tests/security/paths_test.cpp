// Submissions that name what no job may have as its surface: secrets, whatever way leads to them,
// and what is no file.
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "tests/security/farm_under_attack.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

using test::RawPeer;

/// The whole of the farm's folder is allowed, with everything that is secret in it.
class Paths : public test::FarmUnderAttack {
 protected:
  static void SetUpTestSuite() {
    farm_ = std::make_unique<test::Farm>(std::vector<std::string>{"--allow-root", "."});
  }

  static wire::Envelope naming(const fs::path& path) {
    wire::Envelope envelope = test::submission(farm(), "");
    envelope.mutable_submit()->set_surface_path(path.string());
    return envelope;
  }
  /// Each is refused, and no job and no artifact comes of it.
  static void expect_refused(const std::vector<fs::path>& paths) {
    RawPeer anna = peer("anna");
    const std::size_t artifacts = artifact_count();
    const int jobs = farm().status().jobs_size();
    for (const fs::path& path : paths) {
      const wire::Envelope answer = anna.ask(naming(path));
      EXPECT_TRUE(answer.has_refused()) << path.string().substr(0, 200);
    }
    EXPECT_EQ(artifact_count(), artifacts);
    EXPECT_EQ(farm().status().jobs_size(), jobs);
  }
  static std::size_t artifact_count() {
    std::size_t count = 0;
    for (const auto& file : fs::recursive_directory_iterator(farm().store() / "artifacts")) {
      if (file.is_regular_file()) ++count;
    }
    return count;
  }
  static fs::path in_folder(const std::string& name) { return farm().folder() / name; }
  static fs::path in_surfaces(const std::string& name) {
    return farm().folder() / "surfaces" / name;
  }
};

TEST_F(Paths, a_surface_in_a_folder_that_is_allowed_is_taken) {
  RawPeer anna = peer("anna");
  EXPECT_TRUE(anna.ask(naming(in_surfaces("ball.off"))).has_submitted());
}

TEST_F(Paths, secret_keys_and_the_list_of_the_authorised) {
  expect_refused({in_folder("keys/coordinator.key"), in_folder("keys/coordinator.pub"),
                  authorized_keys_path(farm().keys_folder()), in_folder("anna.key"),
                  in_folder("node.key")});
}

TEST_F(Paths, the_database_and_its_log) {
  expect_refused({in_folder("state/tetfarm.db"), in_folder("state/tetfarm.db-wal"),
                  in_folder("state/tetfarm.db-shm")});
}

TEST_F(Paths, whatever_lies_in_the_store) {
  std::vector<fs::path> paths = {farm().store(), farm().store() / "artifacts",
                                 farm().store() / "scratch"};
  for (const auto& entry : fs::recursive_directory_iterator(farm().store())) {
    paths.push_back(entry.path());
  }
  EXPECT_GT(paths.size(), 5U);
  expect_refused(paths);
}

TEST_F(Paths, the_token_of_http) { expect_refused({in_folder("token")}); }

TEST_F(Paths, the_coordinators_own_descriptors) {
  std::vector<fs::path> paths;
  for (int i = 0; i < 64; ++i) {
    paths.push_back("/proc/self/fd/" + std::to_string(i));
    paths.push_back("/dev/fd/" + std::to_string(i));
    paths.push_back("/proc/" + std::to_string(farm().coordinator().process()) + "/fd/" +
                    std::to_string(i));
  }
  expect_refused(paths);
}

TEST_F(Paths, what_the_kernel_tells_of_processes) {
  const std::string pid = std::to_string(farm().coordinator().process());
  std::vector<fs::path> paths;
  for (const std::string& process : {std::string("self"), pid, std::string("1")}) {
    for (const char* name : {"environ", "mem", "maps", "cmdline", "auxv", "exe",
                             "cwd/keys/coordinator.key", "cwd/token", "task/"}) {
      paths.push_back("/proc/" + process + "/" + name);
    }
    paths.push_back("/proc/" + process + "/root" + in_folder("token").string());
    paths.push_back("/proc/" + process + "/root/etc/shadow");
  }
  paths.insert(paths.end(), {"/proc/kmsg", "/proc/kcore", "/sys/kernel/notes"});
  expect_refused(paths);
}

TEST_F(Paths, files_of_the_system) {
  expect_refused({"/etc/shadow", "/etc/passwd", "/etc/hostname", "/root/.ssh/id_ed25519",
                  "/var/log/syslog", "/", "/nowhere/at/all"});
}

TEST_F(Paths, symbolic_links_to_secrets) {
  const std::vector<std::pair<std::string, fs::path>> links = {
      {"to_key.off", in_folder("keys/coordinator.key")},
      {"to_database.off", in_folder("state/tetfarm.db")},
      {"to_shadow.off", "/etc/shadow"},
      {"to_environment.off", "/proc/self/environ"},
      {"to_token.off", "../token"},
      {"to_link.off", "to_key.off"},
      {"to_itself.off", "to_itself.off"},
      {"to_keys", in_folder("keys")},
      {"to_root", "/"},
  };
  std::vector<fs::path> paths;
  for (const auto& [name, target] : links) {
    fs::create_symlink(target, in_surfaces(name));
    paths.push_back(in_surfaces(name));
  }
  paths.push_back(in_surfaces("to_keys/coordinator.key"));
  paths.push_back(in_surfaces("to_root/etc/shadow"));
  expect_refused(paths);
}

TEST_F(Paths, hard_links_to_secrets) {
  fs::create_hard_link(in_folder("keys/coordinator.key"), in_surfaces("key.off"));
  fs::create_hard_link(in_folder("state/tetfarm.db"), in_surfaces("database.off"));
  fs::create_hard_link(in_folder("token"), in_surfaces("token.off"));
  fs::create_hard_link(farm().store() / "coordinator.log", in_surfaces("log.off"));
  std::vector<fs::path> paths;
  for (const char* name : {"key.off", "database.off", "token.off", "log.off"}) {
    paths.push_back(in_surfaces(name));
  }
  expect_refused(paths);
  for (const fs::path& path : paths) fs::remove(path);
}

TEST_F(Paths, copies_of_a_key_or_a_database_are_known_by_their_content) {
  fs::copy_file(in_folder("keys/coordinator.key"), in_surfaces("copy.off"));
  fs::copy_file(in_folder("state/tetfarm.db"), in_surfaces("copy.stl"));
  expect_refused({in_surfaces("copy.off"), in_surfaces("copy.stl")});
}

TEST_F(Paths, what_is_no_regular_file_is_refused_at_once) {
  ASSERT_EQ(::mkfifo(in_surfaces("pipe.off").c_str(), 0666), 0);
  fs::create_directory(in_surfaces("folder.off"));
  fs::create_symlink("/dev/zero", in_surfaces("zero.off"));
  fs::create_symlink("/dev/tty", in_surfaces("terminal.off"));
  const int listener = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  in_surfaces("socket.off").string().copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(::bind(listener, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  expect_refused({in_surfaces("pipe.off"), in_surfaces("folder.off"), in_surfaces("zero.off"),
                  in_surfaces("terminal.off"), in_surfaces("socket.off"), "/dev/zero",
                  "/dev/random", "/dev/stdin", in_surfaces("")});
  ::close(listener);
}

TEST_F(Paths, paths_that_are_no_paths) {
  const std::string good = in_surfaces("ball.off").string();
  expect_refused({good + std::string("\0.off", 5), std::string("\0", 1) + good,
                  in_folder("token").string() + std::string("\0.off", 5), "surfaces/ball.off",
                  "ball.off", ".", "..", "~/ball.off", "file://" + good, good + "/", good + "/..",
                  good + "\n", "\xff\xfe", std::string(1'000'000, 'x'),
                  "/" + std::string(5000, 'y'), in_surfaces(std::string(300, 'z'))});
}

TEST_F(Paths, dots_that_lead_out_of_the_folders) {
  const std::string surfaces = in_surfaces("").string();
  expect_refused({surfaces + "../keys/coordinator.key", surfaces + "./../token",
                  surfaces + "../../../../../../../../../../etc/shadow",
                  surfaces + "nowhere/../../state/tetfarm.db"});
}

TEST_F(Paths, a_file_beyond_two_gibibytes_is_refused_unread) {
  std::ofstream(in_surfaces("sparse.off")) << "OFF\n";
  fs::resize_file(in_surfaces("sparse.off"), (std::uintmax_t{2} << 30U) + 1);
  expect_refused({in_surfaces("sparse.off")});
}

TEST_F(Paths, a_link_that_changes_all_the_time_never_gives_a_secret) {
  const fs::path link = in_surfaces("changing.off");
  const fs::path next = in_surfaces("next");
  fs::create_symlink("ball.off", link);
  std::atomic<bool> is_over{false};
  std::thread changer([&] {
    for (int i = 0; !is_over; ++i) {
      std::error_code ignored;
      fs::create_symlink(i % 2 == 0 ? "../keys/coordinator.key" : "ball.off", next, ignored);
      fs::rename(next, link, ignored);
    }
  });
  RawPeer anna = peer("anna");
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    if (anna.ask(naming(link)).has_refused()) ++refused;
  }
  is_over = true;
  changer.join();
  EXPECT_LT(0, refused);
  EXPECT_LT(refused, 300) << "both were tried";
}

/// Without `--allow-root` a path is no way to submit.
TEST(PathsWithoutRoots, are_all_refused) {
  test::Farm farm({}, test::Farm::Roots::none);
  RawPeer anna(farm.endpoint(), farm.keys_of("anna"));
  EXPECT_TRUE(anna.ask(test::submission(farm, "")).has_refused());
  EXPECT_EQ(farm.refused("outside_roots"), 1U);
}

}  // namespace
}  // namespace tetfarm
