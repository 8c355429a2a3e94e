// What the built program makes of files and names that were made to harm it or its terminal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::run_program;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class HostileNames : public testing::Test {
 protected:
  Ended run(const std::vector<std::string>& words) const {
    return run_program(words, folder_.path());
  }
  void write(const std::string& name, const std::string& text) const {
    test::write_contents(folder_.path() / name, text);
  }

  test::TemporaryFolder folder_;
};

TEST_F(HostileNames, a_long_dotted_key_is_refused_where_it_is_by_every_command_that_reads_it) {
  std::string key = "a";
  for (int i = 1; i < 120'000; ++i) key += ".a";
  write("job.toml", "# a job\n" + key + " = 1\n");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"check", "job.toml"},
        {"plan", "job.toml"},
        {"run", "job.toml"},
        {"submit", "job.toml", "--connect", "ipc://nobody", "--timeout", "1"}}) {
    const Ended ended = run(words);
    EXPECT_EQ(ended.code, 2) << words.front();
    EXPECT_THAT(ended.err, HasSubstr("job.toml:2:32: a key of more than 16 parts"))
        << words.front();
  }
}

TEST_F(HostileNames, a_job_file_without_end_is_not_read_to_its_end) {
  write("job.toml", std::string(2 << 20, '\n'));
  const Ended ended = run({"check", "job.toml"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("job.toml: more than 1048576 bytes"));
}

TEST_F(HostileNames, a_job_is_not_named_like_a_file_with_an_end_of_line) {
  write("a\nb.off", "OFF\n");
  const Ended ended = run({"submit", "a\nb.off", "--connect", "ipc://nobody", "--timeout", "1"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("must not contain control characters"));
}

TEST_F(HostileNames, a_job_file_cannot_name_its_job_so_that_a_terminal_obeys) {
  write("job.toml", "name = \"\\u001b[2J\"\n[geometry]\nsurface = \"a.off\"\n");
  const Ended ended = run({"check", "job.toml"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("job.toml:1:8: `name` must not contain control characters"));
}

TEST_F(HostileNames, paths_steer_no_terminal) {
  const Ended ended = run({"check", "\x1b]0;title\a\xff.off"});
  EXPECT_EQ(ended.code, 5);
  EXPECT_THAT(ended.err, AllOf(HasSubstr("\\u001b]0;title\\u0007\\xff.off"), Not(HasSubstr("\x1b")),
                               Not(HasSubstr("\xff"))));
}

TEST_F(HostileNames, errors_in_json_are_json_whatever_the_path) {
  const Ended ended = run({"check", "a\x1b\u009b\x7f\xff.off", "--json"});
  const nlohmann::json error = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(error.is_object()) << ended.out;
  EXPECT_THAT(error["message"].get<std::string>(), HasSubstr("a\x1b\u009b\x7f\ufffd.off"));
}

TEST_F(HostileNames, patches_steer_no_terminal_and_are_json) {
  write("a.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng \x1b[31;1mp\xff\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 "
        "4\n");
  const Ended said = run({"convert", "a.obj", "a.off", "--json"});
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_TRUE(nlohmann::json::parse(said.out, nullptr, false).is_object()) << said.out;
  EXPECT_THAT(said.out, Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace tetfarm
