// Keys are made, authorised, listed and revoked as main does it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "base/file_system.h"
#include "cli/commands.h"
#include "proto/authorized_keys.h"
#include "proto/key_file.h"
#include "store/artifact_store.h"
#include "tests/base/temp_folder.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using Action = KeysCommand::Action;
using nlohmann::json;

/// The folder of a coordinator's keys, and keys of others beside it.
class Keys : public ::testing::Test {
 protected:
  Keys() {
    write_new_key(farm_, "coordinator");
    write_new_key(folder_.path(), "anna");
    write_new_key(folder_.path(), "bert");
  }
  Said keys(const KeysCommand& command) const {
    return said_by([&] { return keys_command(command); });
  }
  Said authorize(const std::string& subject, const std::string& name = "",
                 const std::string& role = "submitter") const {
    return keys({Action::authorize, subject, name, role, farm_.string(), false});
  }
  Said list(bool as_json = false) const { return keys({Action::list, "", "", "", farm_, as_json}); }
  std::string hex_of_key(const std::string& name) const {
    return hex_of(read_public_key(public_key_path(folder_.path(), name)));
  }
  std::string pub(const std::string& name) const {
    return public_key_path(folder_.path(), name).string();
  }

  const TempFolder folder_;
  const std::filesystem::path farm_ = folder_.path() / "keys";
};

TEST_F(Keys, are_made_in_the_folder_that_is_named_and_told_by_their_paths) {
  const std::string folder = (folder_.path() / "new").string();
  const Said made = keys({Action::make, "carl", "", "", folder, false});
  EXPECT_EQ(made.out, folder + "/carl.key\n" + folder + "/carl.pub\n");
  EXPECT_EQ(made.err, "");
  EXPECT_EQ(hex_of(read_secret_key(folder + "/carl.key").public_key),
            hex_of(read_public_key(folder + "/carl.pub")));
}

TEST_F(Keys, are_made_in_a_store_only_with_a_warning) {
  const ArtifactStore store(folder_.path() / "farm");
  const Said made = keys({Action::make, "carl", "", "", store.folder() / "keys", false});
  EXPECT_EQ(made.code, ExitCode::ok);
  EXPECT_EQ(made.err, "warning: " + store.folder().string() +
                          " is a store, which others can access: keep keys elsewhere\n");
}

TEST_F(Keys, are_authorised_by_file_or_by_digits) {
  EXPECT_EQ(authorize(pub("anna")).out, "anna is authorised as submitter\n");
  EXPECT_EQ(authorize(pub("bert"), "robert", "worker").out, "robert is authorised as worker\n");
  write_new_key(folder_.path(), "carl");
  EXPECT_EQ(authorize(hex_of_key("carl"), "carl", "viewer").out, "carl is authorised as viewer\n");
  EXPECT_EQ(list().out, hex_of_key("anna") + " submitter anna\n" + hex_of_key("carl") +
                            " viewer    carl\n" + hex_of_key("bert") + " worker    robert\n");
}

TEST_F(Keys, are_not_authorised_without_a_file_a_name_or_a_farm) {
  const Said missing = authorize("nobody.pub");
  EXPECT_EQ(missing.code, ExitCode::not_found);
  EXPECT_EQ(missing.error, "nobody.pub: no such file");
  EXPECT_EQ(missing.help, "give a .pub file, or the key's 64 hexadecimal digits");
  EXPECT_EQ(authorize(hex_of_key("anna").substr(1)).code, ExitCode::not_found);
  const Said nameless = authorize(hex_of_key("anna"));
  EXPECT_EQ(nameless.code, ExitCode::usage);
  EXPECT_EQ(nameless.error, "--name: is missing; a key given by its digits needs a name");
  const Said no_farm = keys({Action::authorize, pub("anna"), "", "worker", folder_.path(), false});
  EXPECT_EQ(no_farm.code, ExitCode::usage);
  EXPECT_EQ(no_farm.error,
            folder_.path().string() +
                ": has no coordinator.pub; give the coordinator's key folder with --keys, or make "
                "a key: `tetfarm keys new coordinator`");
  EXPECT_EQ(list().out, "");
}

TEST_F(Keys, are_listed_for_programs) {
  authorize(pub("anna"));
  EXPECT_EQ(
      json::parse(list(true).out),
      json(
          {{"type", "key"}, {"key", hex_of_key("anna")}, {"role", "submitter"}, {"name", "anna"}}));
}

TEST_F(Keys, in_lines_that_mean_nothing_are_told_of) {
  write_file_atomically(authorized_keys_path(farm_), "nonsense\n");
  std::filesystem::permissions(authorized_keys_path(farm_), std::filesystem::perms::owner_all);
  EXPECT_THAT(list().err, HasSubstr("warning: "));
}

TEST_F(Keys, that_are_revoked_are_in_the_list_no_more) {
  authorize(pub("anna"));
  authorize(pub("bert"));
  const Said revoked = keys({Action::revoke, "anna", "", "", farm_, false});
  EXPECT_EQ(revoked.out, "anna is revoked\n");
  EXPECT_EQ(list().out, hex_of_key("bert") + " submitter bert\n");
  EXPECT_EQ(keys({Action::revoke, "anna", "", "", farm_, false}).code, ExitCode::not_found);
}

}  // namespace
}  // namespace tetfarm
