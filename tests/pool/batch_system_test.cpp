// What is submitted to each batch system, against the documented forms of its options, and how its
// answers are read.
#include "pool/batch_system.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>

#include "base/error.h"
#include "pool/run_command.h"
#include "pool/worker_job.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAreArray;

constexpr std::uint64_t gib = std::uint64_t{1} << 30U;

PoolSettings settings() {
  PoolSettings settings;
  settings.name = "farm";
  settings.user = "anna";
  settings.program = "/opt/tetfarm";
  settings.coordinator = "tcp://head:5555";
  settings.store = "/shared/the farm";
  settings.key = "/home/anna/node.key";
  settings.logs = "/shared/logs";
  settings.walltime_s = 5400;
  settings.most_bytes = 16 * gib;
  return settings;
}

std::string script_of(const std::string& system, const PoolSettings& with = settings()) {
  const auto commands = make_batch_system(system, with)->submit({5, 4 * gib}, {});
  EXPECT_EQ(commands.size(), 1U);
  return commands.front().input;
}

/// The options after a prefix, one for each line.
std::vector<std::string> directives(const std::string& script, const std::string& prefix) {
  std::vector<std::string> found;
  for (const std::string& line : lines_of(script)) {
    if (line.starts_with(prefix)) found.push_back(line.substr(prefix.size()));
  }
  return found;
}

/// Each directive has the form of one of the options, and each option is there once.
void expect_documented(const std::vector<std::string>& directives,
                       const std::vector<std::string>& forms) {
  for (const std::string& directive : directives) {
    const bool known = std::any_of(forms.begin(), forms.end(), [&](const std::string& form) {
      return std::regex_match(directive, std::regex(form));
    });
    EXPECT_TRUE(known) << directive;
  }
  for (const std::string& form : forms) {
    const auto count = std::count_if(
        directives.begin(), directives.end(),
        [&](const std::string& text) { return std::regex_match(text, std::regex(form)); });
    EXPECT_EQ(count, 1) << form;
  }
}

std::vector<std::string> ids_of(const std::optional<std::vector<PoolJob>>& jobs) {
  std::vector<std::string> ids;
  if (jobs) {
    for (const PoolJob& job : *jobs) ids.push_back(job.id);
  }
  return ids;
}

TEST(Slurm, the_script_has_the_documented_options_and_becomes_the_worker) {
  const std::string script = script_of("slurm");
  EXPECT_TRUE(script.starts_with("#!/bin/sh\n"));
  expect_documented(
      directives(script, "#SBATCH "),
      {"--job-name=tetfarm-farm-4096M", "--array=1-5", "--nodes=1", "--ntasks=1",
       "--cpus-per-task=1", "--mem=4096M", "--time=01:30:00", "--signal=B:TERM@90", "--no-requeue",
       "--open-mode=append", "--output=/shared/logs/tetfarm-farm-4096M-%A_%a\\.log"});
  EXPECT_THAT(script, HasSubstr("\nexec /opt/tetfarm worker --connect tcp://head:5555 --store "
                                "'/shared/the farm' --key /home/anna/node.key --memory 3584MB "
                                "--pool-memory 14336MB --walltime 5400 --grace 60 --tag "
                                "\"farm/${SLURM_ARRAY_JOB_ID}_${SLURM_ARRAY_TASK_ID}\"\n"));
}

TEST(Slurm, workers_without_a_shared_folder_get_their_files_over_the_connection) {
  PoolSettings apart = settings();
  apart.store = "";
  apart.cache = "/local/scratch";
  for (const char* system : {"slurm", "condor", "lsf", "ge"}) {
    const std::string script = script_of(system, apart);
    EXPECT_THAT(script, HasSubstr("--no-shared-store")) << system;
    EXPECT_THAT(script, HasSubstr("/local/scratch")) << system;
    EXPECT_THAT(script, Not(HasSubstr("--store"))) << system;
  }
}

TEST(Slurm, reads_what_sbatch_and_squeue_say) {
  const auto slurm = make_batch_system("slurm", settings());
  EXPECT_THAT(slurm->submitted({2, gib}, {0, "12\n", ""}), ElementsAre("12_1", "12_2"));
  EXPECT_THAT(slurm->submitted({1, gib}, {0, "12;mesh\n", ""}), ElementsAre("12_1"));
  EXPECT_THAT(slurm->submitted({1, gib}, {1, "", "sbatch: error: Invalid partition"}), IsEmpty());
  const auto jobs = slurm->listed({0,
                                   "12_1|RUNNING|None|tetfarm-farm-4096M\n"
                                   "12_2|PENDING|Resources|tetfarm-farm-4096M\n"
                                   "12_3|PENDING|JobHeldAdmin|tetfarm-farm-8192M\n"
                                   "12_4|COMPLETING|None|tetfarm-farm-4096M\n"
                                   "13|RUNNING|None|wing\n"
                                   "14_1|RUNNING|None|tetfarm-farm-2-4096M\n",
                                   ""});
  ASSERT_TRUE(jobs.has_value());
  EXPECT_THAT(ids_of(jobs), ElementsAre("12_1", "12_2", "12_3", "12_4"));
  EXPECT_EQ((*jobs)[0].state, PoolJobState::running);
  EXPECT_EQ((*jobs)[0].bytes, 4 * gib);
  EXPECT_EQ((*jobs)[1].state, PoolJobState::pending);
  EXPECT_EQ((*jobs)[2].state, PoolJobState::broken);
  EXPECT_EQ((*jobs)[2].bytes, 8 * gib);
  EXPECT_EQ((*jobs)[3].state, PoolJobState::ending);
  EXPECT_FALSE(slurm->listed({1, "", "slurm_load_jobs error"}).has_value());
  EXPECT_THAT(slurm->cancel({"12_1", "12_2"}),
              ElementsAre(ShellCommand{{"scancel", "12_1", "12_2"}, ""}));
}

TEST(HTCondor, the_description_has_the_documented_commands) {
  const std::string text = script_of("condor");
  for (const char* line :
       {"universe = vanilla", "executable = /opt/tetfarm", "request_memory = 4096MB",
        "request_cpus = 1", "kill_sig = SIGTERM", "want_graceful_removal = true",
        "job_max_vacate_time = 90", "batch_name = tetfarm-farm-4096M", "MY.TetfarmPool = \"farm\"",
        "should_transfer_files = NO", "queue 5"}) {
    EXPECT_THAT(lines_of(text), Contains(line));
  }
  EXPECT_THAT(text, HasSubstr("arguments = \"'worker' '--connect' 'tcp://head:5555' '--store' "
                              "'/shared/the farm' "));
  EXPECT_THAT(text, HasSubstr("'--tag' 'farm/$(Cluster).$(Process)'\""));
}

TEST(HTCondor, quotes_double_in_arguments) {
  PoolSettings odd = settings();
  odd.store = "/anna's \"store\"";
  EXPECT_THAT(script_of("condor", odd), HasSubstr("'/anna''s \"\"store\"\"'"));
}

TEST(HTCondor, reads_what_condor_submit_and_condor_q_say) {
  const auto condor = make_batch_system("condor", settings());
  EXPECT_THAT(condor->submitted({2, gib}, {0, "12.0 - 12.1\n", ""}), ElementsAre("12.0", "12.1"));
  EXPECT_THAT(condor->submitted({1, gib}, {1, "", "ERROR: Can't find address"}), IsEmpty());
  const auto jobs = condor->listed({0,
                                    "12 0 1 tetfarm-farm-4096M\n12 1 2 tetfarm-farm-4096M\n"
                                    "12 2 5 tetfarm-farm-4096M\n12 3 3 tetfarm-farm-4096M\n",
                                    ""});
  ASSERT_THAT(ids_of(jobs), ElementsAre("12.0", "12.1", "12.2", "12.3"));
  EXPECT_EQ((*jobs)[0].state, PoolJobState::pending);
  EXPECT_EQ((*jobs)[1].state, PoolJobState::running);
  EXPECT_EQ((*jobs)[2].state, PoolJobState::broken);
  EXPECT_EQ((*jobs)[3].state, PoolJobState::ending);
}

// IBM Spectrum LSF 10.1, bsub: -J "name[1-N]"; -n N; -R "res_req"; -M limit with a unit;
// -W [hour:]minute; -wt '[hour:]minute'; -wa '[signal | command | CHKPNT]'; -rn; -o file with %J,
// %I.
TEST(Lsf, the_script_has_the_documented_options_with_units) {
  const std::string script = script_of("lsf");
  expect_documented(
      directives(script, "#BSUB "),
      {"-J \"tetfarm-farm-4096M\\[1-5\\]\"", "-n 1",
       "-R \"span\\[hosts=1\\] rusage\\[mem=[0-9]+(KB|MB|GB)\\]\"", "-M [0-9]+(KB|MB|GB|TB)",
       "-W [0-9]+:[0-5][0-9]", "-wt '([0-9]+:)?[0-9]+'", "-wa '(TERM|USR2)'", "-rn",
       "-o \"/shared/logs/tetfarm-farm-4096M-%J_%I\\.log\""});
  EXPECT_THAT(script, HasSubstr("#BSUB -M 4096MB\n"));
  EXPECT_THAT(script, HasSubstr("#BSUB -W 1:30\n"));
  EXPECT_THAT(script, HasSubstr("--tag \"farm/${LSB_JOBID}[${LSB_JOBINDEX}]\"\n"));
  EXPECT_THAT(make_batch_system("lsf", settings())->submit({1, gib}, {}).front().words,
              ElementsAre("bsub"));
}

TEST(Lsf, reads_what_bsub_and_bjobs_say) {
  const auto lsf = make_batch_system("lsf", settings());
  EXPECT_THAT(
      lsf->submitted({2, gib}, {0, "Job <35> is submitted to default queue <normal>.\n", ""}),
      ElementsAre("35[1]", "35[2]"));
  const auto jobs = lsf->listed({0,
                                 "35|1|RUN|tetfarm-farm-4096M[1]\n35|2|PEND|tetfarm-farm-4096M[2]\n"
                                 "35|3|PSUSP|tetfarm-farm-4096M[3]\n36|0|RUN|wing\n",
                                 ""});
  ASSERT_THAT(ids_of(jobs), ElementsAre("35[1]", "35[2]", "35[3]"));
  EXPECT_EQ((*jobs)[1].state, PoolJobState::pending);
  EXPECT_EQ((*jobs)[2].state, PoolJobState::broken);
  EXPECT_THAT(lsf->cancel({"35[1]", "35[2]"}),
              ElementsAre(ShellCommand{{"bkill", "35[1]", "35[2]"}, ""}));
}

TEST(Lsf, an_empty_list_is_an_answer_though_bjobs_calls_it_an_error) {
  const auto lsf = make_batch_system("lsf", settings());
  const auto none = lsf->listed({255, "", "No unfinished job found\n"});
  ASSERT_TRUE(none.has_value());
  EXPECT_THAT(*none, IsEmpty());
  EXPECT_FALSE(lsf->listed({255, "", "Failed in an LSF library call"}).has_value());
}

// Son of Grid Engine 8.1.9, submit(1): -N name; -t n[-m[:s]]; -S path; -cwd; -l resource=value
// with hh:mm:ss, and memory with K, M, G; -notify; -r y[es]|n[o]; -j y[es]|n[o]; -o path with
// $JOB_NAME, $JOB_ID, $TASK_ID.
TEST(GridEngine, the_script_has_the_documented_options) {
  const std::string script = script_of("ge");
  expect_documented(directives(script, "#$ "),
                    {"-N tetfarm-farm-4096M", "-t 1-5", "-S /bin/sh", "-cwd",
                     "-l h_rt=[0-9]{2,}:[0-5][0-9]:[0-5][0-9]", "-l h_vmem=[0-9]+[KMG]", "-notify",
                     "-r n", "-j y", "-o /shared/logs/\\$JOB_NAME-\\$JOB_ID\\.\\$TASK_ID\\.log"});
  EXPECT_THAT(script, HasSubstr("--tag \"farm/${JOB_ID}.${SGE_TASK_ID}\"\n"));
}

// qstat -xml: job_info, queue_info and job_list elements; qdel job_id -t range (sge_types(1),
// wc_job_range).
TEST(GridEngine, reads_what_qsub_and_qstat_say) {
  const auto ge = make_batch_system("ge", settings());
  EXPECT_THAT(ge->submitted({2, gib}, {0, "12.1-2:1\n", ""}), ElementsAre("12.1", "12.2"));
  const std::string xml =
      "<?xml version='1.0'?>\n<job_info>\n  <queue_info>\n"
      "    <job_list state=\"running\">\n      <JB_job_number>12</JB_job_number>\n"
      "      <JB_name>tetfarm-farm-4096M</JB_name>\n      <state>r</state>\n"
      "      <tasks>1</tasks>\n    </job_list>\n  </queue_info>\n  <job_info>\n"
      "    <job_list state=\"pending\">\n      <JB_job_number>12</JB_job_number>\n"
      "      <JB_name>tetfarm-farm-4096M</JB_name>\n      <state>qw</state>\n"
      "      <tasks>2</tasks>\n    </job_list>\n"
      "    <job_list state=\"pending\">\n      <JB_job_number>12</JB_job_number>\n"
      "      <JB_name>tetfarm-farm-4096M</JB_name>\n      <state>Eqw</state>\n"
      "      <tasks>3</tasks>\n    </job_list>\n"
      "    <job_list state=\"pending\">\n      <JB_job_number>13</JB_job_number>\n"
      "      <JB_name>wing</JB_name>\n      <state>qw</state>\n    </job_list>\n"
      "  </job_info>\n</job_info>\n";
  const auto jobs = ge->listed({0, xml, ""});
  ASSERT_THAT(ids_of(jobs), ElementsAre("12.1", "12.2", "12.3"));
  EXPECT_EQ((*jobs)[0].state, PoolJobState::running);
  EXPECT_EQ((*jobs)[1].state, PoolJobState::pending);
  EXPECT_EQ((*jobs)[2].state, PoolJobState::broken);
  EXPECT_FALSE(ge->listed({0, "", "error: commlib error"}).has_value());
}

TEST(GridEngine, cancels_runs_of_tasks_with_one_command_each) {
  const auto ge = make_batch_system("ge", settings());
  EXPECT_THAT(ge->cancel({"12.3", "12.4", "12.5", "12.9", "13.1"}),
              ElementsAre(ShellCommand{{"qdel", "12", "-t", "3-5"}, ""},
                          ShellCommand{{"qdel", "12", "-t", "9"}, ""},
                          ShellCommand{{"qdel", "13", "-t", "1"}, ""}));
}

TEST(BatchSystem, options_of_the_site_go_into_the_script) {
  PoolSettings with = settings();
  with.options = {"--partition=mesh"};
  EXPECT_THAT(script_of("slurm", with), HasSubstr("#SBATCH --partition=mesh\n"));
  with.options = {"-q long"};
  EXPECT_THAT(script_of("lsf", with), HasSubstr("#BSUB -q long\n"));
  EXPECT_THAT(script_of("ge", with), HasSubstr("#$ -q long\n"));
  with.options = {"accounting_group = mesh"};
  EXPECT_THAT(script_of("condor", with), HasSubstr("\naccounting_group = mesh\nqueue 5\n"));
}

TEST(BatchSystem, a_script_holds_nothing_that_would_break_out_of_it) {
  PoolSettings odd = settings();
  odd.store = "/a\nrm -rf /";
  EXPECT_THROW(make_batch_system("slurm", odd), UsageError);
  odd = settings();
  odd.name = "a b";
  EXPECT_THROW(make_batch_system("slurm", odd), UsageError);
  odd = settings();
  for (const char* host : {"-oProxyCommand=evil", "-v"}) {
    odd.hosts = {host};
    EXPECT_THROW(make_batch_system("ssh", odd), UsageError) << host;
  }
  odd = settings();
  odd.options = {"--partition=mesh\nrm -rf /"};
  EXPECT_THROW(make_batch_system("slurm", odd), UsageError);
  odd = settings();
  odd.store = "/a $(touch b) 'c'";
  const std::string script = script_of("slurm", odd);
  const std::size_t at = script.find("--store ") + 8;
  const CommandOutcome echoed = run_command(
      {{"sh", "-s"}, "printf %s " + script.substr(at, script.find(" --key") - at)}, 10'000);
  EXPECT_EQ(echoed.out, odd.store);
}

TEST(Hosts, are_filled_up_to_their_slots_and_a_silent_one_counts_as_full) {
  PoolSettings with = settings();
  with.hosts = {"one:2", "two:3"};
  const auto ssh = make_batch_system("ssh", with);
  const auto jobs = ssh->listed({0, "job one/ab 4294967296\nlisted one\nsilent two\n", ""});
  ASSERT_TRUE(jobs.has_value());
  EXPECT_EQ(jobs->size(), 4U) << "one there, three that may be there";
  const auto commands = ssh->submit({5, 4 * gib}, *jobs);
  ASSERT_EQ(commands.size(), 1U);
  EXPECT_THAT(commands[0].input, HasSubstr("ssh -o BatchMode=yes -o ConnectTimeout=10 one sh -s"));
  EXPECT_THAT(commands[0].input, HasSubstr("[ $i -lt 1 ]"));
  EXPECT_THAT(commands[0].input, Not(HasSubstr(" two sh -s")));
  EXPECT_FALSE(ssh->listed({0, "silent one\nsilent two\n", ""}).has_value());
}

TEST(Hosts, are_given_no_more_workers_together_than_are_ordered) {
  PoolSettings with = settings();
  with.hosts = {"one:2", "two:3", "three:1"};
  const std::string script = make_batch_system("ssh", with)->submit({4, 4 * gib}, {}).at(0).input;
  EXPECT_THAT(script, HasSubstr(" one sh -s"));
  EXPECT_THAT(script, HasSubstr(" two sh -s"));
  EXPECT_THAT(script, Not(HasSubstr(" three sh -s")));
  EXPECT_THAT(script, HasSubstr("[ $i -lt 2 ]"));
  EXPECT_THAT(script, Not(HasSubstr("[ $i -lt 3 ]")));
}

/// A program that takes the worker's arguments and waits.
std::string waiting_program(const std::string& folder) {
  const std::string path = folder + "/waits";
  std::ofstream(path) << "#!/bin/sh\nwhile :; do sleep 0.1; done\n";
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return path;
}

TEST(Hosts, a_worker_on_this_machine_is_started_found_again_and_ended) {
  const TempFolder folder;
  PoolSettings with = settings();
  with.name = "test" + std::to_string(::getpid());
  with.logs = folder.path().string();
  with.program = waiting_program(with.logs);
  const auto local = make_batch_system("local", with);
  const auto list = [&] {
    return ids_of(local->listed(run_command(local->list().front(), 10'000)));
  };
  EXPECT_THAT(list(), IsEmpty());
  const CommandOutcome outcome = run_command(local->submit({2, gib}, {}).front(), 10'000);
  const std::vector<std::string> ids = local->submitted({2, gib}, outcome);
  ASSERT_EQ(ids.size(), 2U) << outcome.err;
  EXPECT_THAT(list(), UnorderedElementsAreArray(ids))
      << "at once, as a process that is to become it";
  const std::string files = "/tmp/tetfarm-pool-" + std::to_string(::geteuid()) + "-" + with.name;
  std::ofstream(files + "/other") << ::getpid() << " 77 1\n";
  EXPECT_THAT(list(), UnorderedElementsAreArray(ids)) << "not who has a worker's number after it";
  EXPECT_FALSE(std::filesystem::exists(files + "/other"));
  run_command(local->cancel({ids[0]}).front(), 10'000);
  for (int i = 0; i < 100 && list().size() > 1; ++i) ::usleep(50'000);
  EXPECT_THAT(list(), ElementsAre(ids[1]));
  run_command(local->cancel({ids[1]}).front(), 10'000);
  for (int i = 0; i < 100 && !list().empty(); ++i) ::usleep(50'000);
  EXPECT_THAT(list(), IsEmpty());
  std::filesystem::remove_all(files);
}

TEST(RunCommand, keeps_output_feeds_input_and_ends_what_takes_too_long) {
  const CommandOutcome echoed = run_command({{"cat"}, std::string(1 << 20U, 'x')}, 10'000);
  EXPECT_EQ(echoed.code, 0);
  EXPECT_EQ(echoed.out.size(), std::size_t{1} << 20U);
  EXPECT_EQ(run_command({{"sh", "-c", "exit 3"}, ""}, 10'000).code, 3);
  const CommandOutcome missing = run_command({{"/no/such/program"}, ""}, 10'000);
  EXPECT_EQ(missing.code, 127);
  EXPECT_THAT(missing.err, HasSubstr("No such file"));
  const CommandOutcome late = run_command({{"sleep", "60"}, ""}, 100);
  EXPECT_EQ(late.code, -1);
  EXPECT_EQ(late.err, "was killed, or did not answer in time");
}

TEST(RunCommand, ends_with_a_command_what_the_command_has_started) {
  const CommandOutcome outcome = run_command({{"sh", "-c", "sleep 60 & echo $!; wait"}, ""}, 300);
  EXPECT_EQ(outcome.code, -1);
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 1U);
  // The kernel ends it when it comes to it. Of a process that has ended and was not yet waited for,
  // there is no command line.
  std::string first = "it";
  for (int i = 0; i < 1'000 && !first.empty(); ++i) {
    if (i > 0) ::usleep(2'000);
    first.clear();
    std::ifstream words("/proc/" + lines[0] + "/cmdline");
    std::getline(words, first, '\0');
  }
  EXPECT_EQ(first, "");
}

TEST(HoursMinutesSeconds, has_as_many_hours_as_there_are) {
  EXPECT_EQ(hours_minutes_seconds(59), "00:00:59");
  EXPECT_EQ(hours_minutes_seconds(3'600 + 23 * 60 + 4), "01:23:04");
  EXPECT_EQ(hours_minutes_seconds(3 * 24 * 3'600), "72:00:00");
  EXPECT_EQ(hours_minutes_seconds(200 * 3'600 + 59 * 60), "200:59:00");
}

/// What is wrong with settings; "": nothing.
std::string refusal_of(const PoolSettings& with, const std::string& system = "slurm") {
  try {
    make_batch_system(system, with);
    return "";
  } catch (const UsageError& error) {
    return error.what();
  }
}

TEST(BatchSystem, says_what_it_cannot_take) {
  const std::string name = ": a pool's name must be 1 to 40 letters, digits, _ and -";
  PoolSettings with = settings();
  for (const std::string& bad : {std::string("a b"), std::string("a/b"), std::string(41, 'a')}) {
    with.name = bad;
    EXPECT_EQ(refusal_of(with), bad + name);
  }
  with.name = "";
  EXPECT_EQ(refusal_of(with), name.substr(2));
  with.name = std::string(36, 'a') + "A9_-";
  EXPECT_EQ(refusal_of(with), "");
  with = settings();
  const std::string control = ": must not contain control characters";
  for (std::string PoolSettings::*path :
       {&PoolSettings::program, &PoolSettings::coordinator, &PoolSettings::store,
        &PoolSettings::cache, &PoolSettings::key, &PoolSettings::coordinator_key,
        &PoolSettings::logs}) {
    PoolSettings odd = settings();
    odd.*path = "a\x7f";
    EXPECT_EQ(refusal_of(odd), "pool" + control);
    odd.*path = "a\x1f";
    EXPECT_EQ(refusal_of(odd), "pool" + control);
  }
  with.options = {"a", "b\t"};
  EXPECT_EQ(refusal_of(with), "--option" + control);
  with = settings();
  for (const char* logs : {"/my logs", "/l\"", "/l'", "/l%", "/l$"}) {
    with.logs = logs;
    EXPECT_EQ(
        refusal_of(with),
        std::string(logs) + ": the path of the log folder must not contain spaces, quotes, % or $");
  }
  EXPECT_EQ(refusal_of(settings(), "pbs"), "pbs: not a batch system");
  EXPECT_EQ(refusal_of(settings(), "ssh"),
            "--hosts: is missing: name the hosts to start workers on");
  EXPECT_EQ(refusal_of(settings(), "local"), "");
}

TEST(Hosts, have_a_name_and_perhaps_slots) {
  PoolSettings with = settings();
  for (const char* host : {"", ":2", "a:x", "a:2:3", "a:123456", "a b", "-a", "a;b", "a/b"}) {
    with.hosts = {"good", host};
    EXPECT_EQ(refusal_of(with, "ssh"), (*host == 0 ? "" : std::string(host) + ": ") +
                                           "is not a host: give NAME or NAME:SLOTS")
        << host;
  }
  with.hosts = {"anna@node-1.site_2", "b:99999"};
  EXPECT_EQ(refusal_of(with, "ssh"), "");
}

TEST(Hosts, without_slots_take_one_worker) {
  PoolSettings with = settings();
  with.hosts = {"one"};
  const auto ssh = make_batch_system("ssh", with);
  const std::string script = ssh->submit({5, 4 * gib}, {}).at(0).input;
  EXPECT_THAT(script, HasSubstr("[ $i -lt 1 ]"));
  EXPECT_THAT(ssh->submit({5, 4 * gib}, {{"one/ab", PoolJobState::running, 0}}), IsEmpty());
}

TEST(Hosts, are_asked_for_their_own_workers_and_told_to_end_those) {
  PoolSettings with = settings();
  with.hosts = {"one:2", "two"};
  const auto ssh = make_batch_system("ssh", with);
  const auto commands = ssh->cancel({"two/ab", "two/c d"});
  ASSERT_EQ(commands.size(), 1U);
  EXPECT_THAT(commands[0].input, HasSubstr(" two sh -s"));
  EXPECT_THAT(commands[0].input, Not(HasSubstr(" one sh -s")));
  EXPECT_THAT(commands[0].input, HasSubstr("for name in ab 'c d'; do"));
  EXPECT_THAT(ssh->cancel({"three/ab"}), IsEmpty());
  const std::string list = ssh->list().at(0).input;
  EXPECT_THAT(list, HasSubstr("echo listed one\n"));
  EXPECT_THAT(list, HasSubstr("echo listed two\n"));
  const auto jobs = ssh->listed({0, "job one/ab 77\njob one/cd x\nlisted one\nlisted two\n", ""});
  ASSERT_THAT(ids_of(jobs), ElementsAre("one/ab"));
  EXPECT_EQ((*jobs)[0].state, PoolJobState::running);
  EXPECT_EQ((*jobs)[0].bytes, 77U);
  EXPECT_FALSE(ssh->listed({1, "listed one\n", ""}).has_value());
}

PoolJobState state_in(const std::string& system, const std::string& answer) {
  const auto jobs = make_batch_system(system, settings())->listed({0, answer, ""});
  EXPECT_TRUE(jobs && jobs->size() == 1) << answer;
  return jobs && !jobs->empty() ? jobs->front().state : PoolJobState::ending;
}

TEST(Slurm, knows_its_states_and_what_a_job_never_gets_over) {
  const auto of = [](const std::string& state, const std::string& reason = "None") {
    return state_in("slurm", "1_1|" + state + "|" + reason + "|tetfarm-farm-4096M\n");
  };
  for (const char* state :
       {"RUNNING", "SUSPENDED", "CONFIGURING", "STOPPED", "SIGNALING", "RESIZING"}) {
    EXPECT_EQ(of(state), PoolJobState::running) << state;
  }
  for (const char* state : {"PENDING", "REQUEUED", "REQUEUE_FED"}) {
    EXPECT_EQ(of(state), PoolJobState::pending) << state;
  }
  for (const char* state : {"REQUEUE_HOLD", "SPECIAL_EXIT"}) {
    EXPECT_EQ(of(state), PoolJobState::broken) << state;
  }
  for (const char* state : {"COMPLETING", "CANCELLED", "FAILED", "TIMEOUT"}) {
    EXPECT_EQ(of(state), PoolJobState::ending) << state;
  }
  for (const char* reason :
       {"JobHeldAdmin", "JobHeldUser", "BadConstraints", "launch_failed_requeued_held",
        "InvalidAccount", "InvalidQOS", "PartitionTimeLimit"}) {
    EXPECT_EQ(of("PENDING", reason), PoolJobState::broken) << reason;
    EXPECT_EQ(of("RUNNING", reason), PoolJobState::running) << reason;
  }
  EXPECT_EQ(of("PENDING", "Priority"), PoolJobState::pending);
}

TEST(HTCondor, knows_its_states) {
  const auto of = [](int status) {
    return state_in("condor", "1 0 " + std::to_string(status) + " tetfarm-farm-4096M\n");
  };
  EXPECT_EQ(of(1), PoolJobState::pending);
  for (const int status : {2, 6, 7}) EXPECT_EQ(of(status), PoolJobState::running) << status;
  EXPECT_EQ(of(5), PoolJobState::broken);
  for (const int status : {3, 4}) EXPECT_EQ(of(status), PoolJobState::ending) << status;
}

TEST(Lsf, knows_its_states) {
  const auto of = [](const std::string& state) {
    return state_in("lsf", "1|1|" + state + "|tetfarm-farm-4096M[1]\n");
  };
  for (const char* state : {"PEND", "WAIT", "PROV"}) {
    EXPECT_EQ(of(state), PoolJobState::pending) << state;
  }
  for (const char* state : {"RUN", "SSUSP", "USUSP", "UNKWN"}) {
    EXPECT_EQ(of(state), PoolJobState::running) << state;
  }
  EXPECT_EQ(of("PSUSP"), PoolJobState::broken);
  for (const char* state : {"DONE", "EXIT", "ZOMBI"}) {
    EXPECT_EQ(of(state), PoolJobState::ending) << state;
  }
}

TEST(GridEngine, knows_its_states) {
  const auto of = [](const std::string& state) {
    return state_in("ge",
                    "<job_info><job_list><JB_job_number>12</JB_job_number>"
                    "<JB_name>tetfarm-farm-4096M</JB_name><state>" +
                        state + "</state><tasks>1</tasks></job_list></job_info>");
  };
  EXPECT_EQ(of("qw"), PoolJobState::pending);
  for (const char* state : {"r", "t", "Rr", "s", "S", "T"}) {
    EXPECT_EQ(of(state), PoolJobState::running) << state;
  }
  for (const char* state : {"Eqw", "hqw"}) EXPECT_EQ(of(state), PoolJobState::broken) << state;
  for (const char* state : {"dr", "dEqw"}) EXPECT_EQ(of(state), PoolJobState::ending) << state;
}

TEST(BatchSystem, is_asked_by_the_documented_commands) {
  const auto submit = [](const char* system) {
    return make_batch_system(system, settings())->submit({5, 4 * gib}, {}).at(0).words;
  };
  const auto list = [](const char* system) {
    return make_batch_system(system, settings())->list().at(0).words;
  };
  EXPECT_THAT(submit("slurm"), ElementsAre("sbatch", "--parsable"));
  EXPECT_THAT(list("slurm"), ElementsAre("squeue", "--noheader", "--array", "--user=anna",
                                         "--format=%i|%T|%r|%j"));
  EXPECT_THAT(submit("condor"), ElementsAre("condor_submit", "-terse", "-"));
  EXPECT_THAT(list("condor"),
              ElementsAre("condor_q", "-constraint", "TetfarmPool == \"farm\"", "-autoformat",
                          "ClusterId", "ProcId", "JobStatus", "JobBatchName"));
  EXPECT_THAT(make_batch_system("condor", settings())->cancel({"12.0", "12.1"}),
              ElementsAre(ShellCommand{{"condor_rm", "12.0", "12.1"}, ""}));
  EXPECT_THAT(submit("lsf"), ElementsAre("bsub"));
  EXPECT_THAT(list("lsf"), ElementsAre("bjobs", "-u", "anna", "-noheader", "-o",
                                       "jobid jobindex stat job_name delimiter='|'"));
}

TEST(BatchSystem, has_submitted_nothing_when_its_answer_cannot_be_understood) {
  const auto submitted = [](const char* system, const CommandOutcome& outcome) {
    return make_batch_system(system, settings())->submitted({2, gib}, outcome);
  };
  for (const auto& [system, good] : {std::pair{"slurm", "12\n"},
                                     {"condor", "12.0 - 12.1\n"},
                                     {"lsf", "Job <35> is\n"},
                                     {"ge", "12.1-2:1\n"}}) {
    EXPECT_THAT(submitted(system, {0, good, ""}), testing::SizeIs(2)) << system;
    EXPECT_THAT(submitted(system, {1, good, ""}), IsEmpty()) << system;
    for (const char* odd : {"", "sorry\n", "Job <x> is\n"}) {
      EXPECT_THAT(submitted(system, {0, odd, ""}), IsEmpty()) << system << " said " << odd;
    }
  }
}

TEST(Lsf, writes_minutes_rounded_up) {
  PoolSettings with = settings();
  with.walltime_s = 3601;
  with.grace_s = 61;
  const std::string script = script_of("lsf", with);
  EXPECT_THAT(script, HasSubstr("#BSUB -W 1:01\n"));
  EXPECT_THAT(script, HasSubstr("#BSUB -wt '2'\n"));
  with.walltime_s = 60;
  EXPECT_THAT(script_of("lsf", with), HasSubstr("#BSUB -W 0:01\n"));
}

}  // namespace
}  // namespace tetfarm
