// Job files made to end whoever parses them, to read what is not theirs, or never to end.
#include <sys/resource.h>

#include "tests/security/farm_under_attack.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::RawPeer;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr int exit_usage = 2;
constexpr double soon_s = 60;

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

const std::string surface_of_ball = "\n[geometry]\nsurface = \"surfaces/ball.off\"\n";

struct WickedJob {
  const char* case_name;
  std::string text;
};

void PrintTo(const WickedJob& job, std::ostream* stream) { *stream << job.case_name; }

std::vector<WickedJob> wicked_jobs() {
  constexpr int many = 120'000;
  const std::string spacing = surface_of_ball + "[spacing]\ndefault = ";
  return {
      {"a_dotted_key_of_120000_segments", repeated("a.", many) + "a = 1\n"},
      {"a_dotted_key_among_good_ones", surface_of_ball + repeated("b.", many) + "b = 1\n"},
      {"a_table_name_of_120000_segments", "[" + repeated("a.", many) + "a]\n"},
      {"an_array_of_tables_of_120000_segments", "[[" + repeated("a.", many) + "a]]\n"},
      {"quoted_segments", repeated("\"a\".", many) + "a = 1\n"},
      {"segments_with_spaces", repeated("a . ", many) + "a = 1\n"},
      {"arrays_in_arrays", "a = " + repeated("[", many) + repeated("]", many) + "\n"},
      {"arrays_without_an_end", "a = " + repeated("[", many)},
      {"tables_in_tables", "a = " + repeated("{a=", many) + "1" + repeated("}", many) + "\n"},
      {"segments_in_a_table", "a = {" + repeated("b.", many) + "b = 1}\n"},
      {"fifteen_megabytes_of_comments", repeated("# nothing\n", 1'500'000) + surface_of_ball},
      {"one_line_of_fifteen_megabytes", "name = \"" + std::string(15'000'000, 'n') + "\"\n"},
      {"a_nul", std::string("name = \"a\0b\"\n", 13) + surface_of_ball},
      {"no_utf8", "name = \"\xff\xfe\"\n" + surface_of_ball},
      {"an_unfinished_text", "name = \"\"\"" + std::string(100'000, 'x')},
      {"the_same_key_twice", "name = \"a\"\nname = \"b\"\n" + surface_of_ball},
      {"no_surface", "name = \"a\"\n"},
      {"a_size_that_is_no_number", spacing + "nan\n"},
      {"an_endless_size", spacing + "inf\n"},
      {"a_negative_size", spacing + "-1\n"},
      {"a_size_with_a_huge_exponent", spacing + "1e999999999\n"},
      {"a_whole_number_beyond_64_bits", spacing + std::string(400, '9') + "\n"},
      {"a_date_for_a_size", spacing + "1979-05-27T07:32:00Z\n"},
      {"a_negative_growth", surface_of_ball + "[spacing]\ngrowth = -1\n"},
      {"an_endless_growth", surface_of_ball + "[spacing]\ngrowth = inf\n"},
      {"a_negative_number_of_subdomains", surface_of_ball + "[decompose]\nsubdomains = -1\n"},
      {"an_endless_factor", surface_of_ball + "[domain]\nouter = \"box\"\nfactor = inf\n"},
      {"a_source_nowhere", surface_of_ball +
                               "[[source]]\nkind = \"point\"\nat = [nan, 0, 0]\nspacing = 1\n"
                               "inner = 1\nouter = 2\n"},
      {"a_name_that_leads_out", "name = \"../../x\"\n" + surface_of_ball},
      {"a_name_with_an_escape", "name = \"\\u001b[2J\"\n" + surface_of_ball},
      {"an_unknown_key", surface_of_ball + "[spacing]\nexecute = \"/bin/sh\"\n"},
  };
}

class WickedJobFile : public ::testing::TestWithParam<WickedJob> {
 protected:
  static void SetUpTestSuite() { farm_ = std::make_unique<test::Farm>(); }
  static void TearDownTestSuite() { farm_.reset(); }
  static std::unique_ptr<test::Farm> farm_;
};

std::unique_ptr<test::Farm> WickedJobFile::farm_;

TEST_P(WickedJobFile, is_refused_by_the_coordinator_and_by_the_program) {
  const int jobs = farm_->status().jobs_size();
  wire::Envelope submission = test::submission(*farm_, GetParam().case_name);
  submission.mutable_submit()->set_name("");
  submission.mutable_submit()->set_job_toml(GetParam().text);
  RawPeer anna(farm_->endpoint(), farm_->keys_of("anna"));
  EXPECT_TRUE(anna.ask(submission).has_refused());
  EXPECT_EQ(farm_->status().jobs_size(), jobs);
  test::write_contents(farm_->folder() / "wicked.toml", GetParam().text);
  const Ended checked = test::run_program({"check", "wicked.toml"}, farm_->folder(), soon_s);
  EXPECT_EQ(checked.code, exit_usage) << checked.err.substr(0, 1000);
  EXPECT_LT(checked.err.size(), 10'000U);
  EXPECT_TRUE(farm_->coordinator().is_running());
  EXPECT_EQ(farm_->ask({"status"}, "vera").code, 0);
}

INSTANTIATE_TEST_SUITE_P(Security, WickedJobFile, ::testing::ValuesIn(wicked_jobs()),
                         [](const auto& wicked) { return std::string(wicked.param.case_name); });

class JobFiles : public test::FarmUnderAttack {};

TEST_F(JobFiles, that_name_files_of_the_worker_are_not_given_to_it) {
  test::write_contents(farm().folder() / "private.txt", "for nobody else\n");
  RawPeer anna = peer("anna");
  wire::Envelope reading = test::submission(farm(), "reading");
  reading.mutable_submit()->set_job_toml(test::good_job() + "[spacing]\nsources = \"" +
                                         (farm().folder() / "private.txt").string() + "\"\n");
  const wire::Envelope answer = anna.ask(reading);
  EXPECT_TRUE(answer.has_refused());
  EXPECT_THAT(answer.refused().reason(), Not(HasSubstr("for nobody else")));
}

TEST_F(JobFiles, of_more_elements_than_any_farm_can_hold_fail_soon_and_blame_no_host) {
  RawPeer anna = peer("anna");
  wire::Envelope endless = test::submission(farm(), "endless");
  endless.mutable_submit()->set_job_toml(test::good_job() + "[spacing]\ndefault = 1e-7\n");
  const std::string job = anna.ask(endless).submitted().job();
  const test::Program worker({"worker", "--connect", farm().endpoint(), "--store", "store", "--key",
                              "node.key", "--coordinator-key", "keys/coordinator.pub"},
                             farm().folder());
  const Ended waited = farm().ask({"wait", job, "--progress", "none"}, "anna");
  EXPECT_GT(waited.code, 0) << "it was waited for in vain";
  EXPECT_NE(waited.err, "");
  EXPECT_EQ(farm().status().hosts_size(), 0);
  EXPECT_EQ(farm().status().jobs(0).attempts_lost(), 0U);
}

TEST_F(JobFiles, without_a_surface_make_no_job) {
  const int jobs = farm().status().jobs_size();
  RawPeer anna = peer("anna");
  wire::Envelope bare = test::submission(farm(), "bare");
  bare.mutable_submit()->clear_surface_path();
  EXPECT_TRUE(anna.ask(bare).has_refused());
  wire::Envelope other = test::submission(farm(), "other");
  other.mutable_submit()->clear_surface_path();
  wire::Artifact& input = *other.mutable_submit()->add_inputs();
  input.set_name("input_surface");
  input.set_hash("../../keys/coordinator.key");
  input.set_size(84);
  EXPECT_TRUE(anna.ask(other).has_refused());
  input.set_hash("0123456789abcdef0123456789abcdef");
  EXPECT_TRUE(anna.ask(other).has_refused());
  EXPECT_EQ(farm().status().jobs_size(), jobs);
}

}  // namespace
}  // namespace tetfarm
