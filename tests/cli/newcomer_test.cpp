// What newcomers type, wrongly and rightly, and what they must see: a table of command lines with
// the exit code and the words of each.
#include <gmock/gmock.h>

#include <algorithm>
#include <memory>

#include "tests/support/program.h"

namespace tetfarm {
namespace {

using test::contents;
using test::Ended;
using test::run_program;
using test::TemporaryFolder;
using test::write_contents;
using ::testing::HasSubstr;
using ::testing::Not;

/// A command line, how it must end, and what must be read on the terminal.
struct Typed {
  std::vector<std::string> words;
  int code = 0;
  std::vector<std::string> sees;
};

std::string line_of(const Typed& typed) {
  std::string line = "tetfarm";
  for (const std::string& word : typed.words) line += " " + word;
  return line;
}

/// Words longer than these are nothing that a person would read.
constexpr std::size_t longest_word = 120;

std::size_t longest_word_of(const std::string& text) {
  std::size_t longest = 0;
  std::size_t length = 0;
  for (const char c : text) {
    length = c == ' ' || c == '\n' ? 0 : length + 1;
    longest = std::max(longest, length);
  }
  return longest;
}

constexpr const char* nowhere = "ipc:///tmp/no-coordinator-of-a-newcomer";

/// A folder as a newcomer has it: a duct, the mesh of it, and files that are wrong in some way.
class Newcomer : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    const std::filesystem::path& here = folder_->path();
    ASSERT_EQ(run_program({"shape", "duct", "-o", "duct.stl", "--spacing", "0.5"}, here).code, 0);
    const Ended meshed = run_program({"run", "duct.stl", "-o", "out", "-j", "1"}, here);
    ASSERT_EQ(meshed.code, 0) << meshed.err;
    std::filesystem::create_directory(here / "em");
    for (const char* file : {"body.stp", "part.iges", "em/coil.STEP", "points.xyz"}) {
      write_contents(here / file, "ISO-10303-21;\n");
    }
    write_contents(here / "em/bad.off", "OFF\n3 1 0\n0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n");
    write_contents(here / "em/open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    write_contents(here / "em/coil.toml", "[geometry]\nsurface = \"nowhere.stl\"\n");
    write_contents(here / "em/formats.toml",
                   "[geometry]\nsurface = \"../duct.stl\"\n[output]\nformats = [\"su3\"]\n");
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static void expect(const std::vector<Typed>& table) {
    for (const Typed& typed : table) {
      SCOPED_TRACE(line_of(typed));
      const Ended ended = run_program(typed.words, folder_->path());
      const std::string seen = ended.out + ended.err;
      EXPECT_EQ(ended.code, typed.code) << seen;
      for (const std::string& words : typed.sees) EXPECT_THAT(seen, HasSubstr(words));
      expect_plain_words(seen, typed);
    }
  }

  /// No word of C++, no file that was not typed, no number of 309 digits.
  static void expect_plain_words(const std::string& seen, const Typed& typed) {
    for (const char* word : {"std::", "filesystem error", "basic_string", "terminate", "what():"}) {
      EXPECT_THAT(seen, Not(HasSubstr(word)));
    }
    EXPECT_LE(longest_word_of(seen), longest_word) << seen;
    if (typed.code == 0) return;
    EXPECT_THAT(seen, Not(HasSubstr(folder_->path().string())));
    EXPECT_THAT(seen, Not(HasSubstr("job.toml")));
  }

  static std::unique_ptr<TemporaryFolder> folder_;
};

std::unique_ptr<TemporaryFolder> Newcomer::folder_;

TEST_F(Newcomer, who_mistypes_a_command_is_told_what_was_meant) {
  expect({
      {{}, 2, {"no command given", "tetfarm run wing.stl -o out"}},
      {{"runn", "duct.stl"}, 2, {"unknown command `runn`; did you mean `run`?"}},
      {{"rnu", "duct.stl"}, 2, {"unknown command `rnu`; did you mean `run`?"}},
      {{"qualitty", "out"}, 2, {"unknown command `qualitty`; did you mean `quality`?"}},
      {{"generate", "duct.stl"}, 2, {"unknown command `generate`", "lists the commands"}},
      {{"duct.stl"}, 2, {"did you mean `tetfarm run duct.stl`?"}},
      {{"keys", "authorise", "a.pub"}, 2, {"did you mean `authorize`?", "`tetfarm keys --help`"}},
      {{"keys"}, 2, {"no command given after `keys`"}},
      {{"--versoin"}, 2, {"--versoin", "help: see `tetfarm --help`"}},
      {{"run", "duct.stl", "--outter", "box"}, 2, {"unknown option `--outter`; did you mean"}},
      {{"run", "duct.stl", "duct.stl"}, 2, {"duct.stl", "help: see `tetfarm run --help`"}},
  });
}

TEST_F(Newcomer, of_cfd_with_cad_files_or_another_folder_in_mind) {
  expect({
      {{"run", "wing.stl"}, 5, {"wing.stl: cannot open", "No such file", "help: check the path"}},
      {{"run", "out"}, 2, {"out: is a folder"}},
      {{"run", "body.stp"},
       2,
       {"error: body.stp: unsupported file type `.stp`; mesh a CAD file first: `gmsh -2 body.stp "
        "-o body.msh`"}},
      {{"check", "part.iges"}, 2, {"mesh a CAD file first: `gmsh -2 part.iges -o part.msh`"}},
      {{"plan", "em/coil.STEP"}, 2, {"`gmsh -2 em/coil.STEP -o em/coil.msh`"}},
      {{"run", "points.xyz"}, 2, {"unsupported file type `.xyz`; Tetfarm reads .stl .obj"}},
      {{"check", "em/open.off", "-o", "d.vtp"}, 3, {"em/open.off: the surface cannot be meshed"}},
      {{"run", "em/open.off", "-o", "o1", "-j", "1", "--progress", "none"},
       3,
       {"error: em/open.off: the surface cannot be meshed", "open edge", "tetfarm check"}},
      {{"run", "em/bad.off", "-o", "o2"}, 3, {"error: em/bad.off:4"}},
  });
  EXPECT_FALSE(std::filesystem::exists(folder_->path() / "o2")) << "nothing is started";
}

TEST_F(Newcomer, of_cfd_is_told_that_cad_needs_another_program_and_nothing_else) {
  const Ended ended = run_program({"run", "body.stp"}, folder_->path());
  EXPECT_THAT(ended.err, Not(HasSubstr("help:")));
}

TEST_F(Newcomer, of_cfd_asks_for_formats_of_solvers) {
  expect({
      {{"run", "duct.stl", "-o", "o3", "--format", "fluent"},
       2,
       {"--format fluent: unknown format; known are vtkhdf, lb8.ugrid, "}},
      {{"run", "duct.stl", "-o", "o3", "--format", "vtkhdg"}, 2, {"did you mean `vtkhdf`?"}},
      {{"run", "duct.stl", "-o", "o3", "--format", "vtkhdf,vtkhdf"}, 2, {"is given twice"}},
      {{"export", "out", "-o", "m.su2", "--partitions", "64"}, 2, {"--partitions 64: ", "su2"}},
      {{"export", "out", "-o", "m.su2", "--partitions", "0"}, 2, {"as-meshed or a whole number"}},
      {{"export", "out", "-o", "m.su2"}, 0, {"m.su2: SU2;"}},
      {{"export", "out", "-o", "m.cgns", "--partitions", "2"}, 0, {"2 parts"}},
      {{"render", "out", "-o", "m.jpg"}, 2, {"m.jpg: render writes only PNG pictures"}},
      {{"render", "out", "-o", "m.png", "--size", "80x60"}, 0, {}},
  });
  EXPECT_FALSE(std::filesystem::exists(folder_->path() / "o3")) << "nothing is started";
  EXPECT_FALSE(std::filesystem::exists(folder_->path() / "m.jpg"));
}

TEST_F(Newcomer, of_cfd_asks_for_boundary_layers) {
  expect({
      {{"spacing", "--reynolds", "6e6", "--length", "1"}, 0, {"first height    4.457e-06, for y+"}},
      {{"check", "duct.stl", "--layers", "*:first=0.01"}, 0, {"layers          \"", "isotropic"}},
      {{"run", "duct.stl", "-o", "o5", "--layers", "flap:first=0.01"}, 2, {"\"flap\" matches n"}},
      {{"run", "duct.stl", "-o", "o5", "--layers", "*"}, 2, {"--layers '*': must be PATCH,..."}},
      {{"plan", "duct.stl", "--layers", "*:first=10"},
       2,
       {"would be 10 high, ", "median edge of these"}},
      {{"run", "duct.stl", "-o", "o5", "--layers", "*:thickness=1"}, 2, {"unknown key `thick"}},
  });
  EXPECT_FALSE(std::filesystem::exists(folder_->path() / "o5")) << "nothing is started";
}

TEST_F(Newcomer, of_electromagnetics_gives_numbers_that_cannot_be) {
  const std::string a_number = "must be a number above 0, not ";
  expect({
      {{"run", "duct.stl", "--size", "0"}, 2, {"--size: " + a_number + "0"}},
      {{"run", "duct.stl", "--size", "lambda/10"}, 2, {"--size: " + a_number + "lambda/10"}},
      {{"run", "duct.stl", "--size", "inf"}, 2, {"--size: " + a_number + "inf"}},
      {{"plan", "duct.stl", "--growth", "-1"}, 2, {"--growth: " + a_number + "-1"}},
      {{"run", "duct.stl", "-o", ""}, 2, {"--output: must not be empty"}},
      {{"run", "duct.stl", "-j", "0"}, 2, {"must be a whole number from 1 to 4096, not 0"}},
      {{"run", "duct.stl", "--subdomains", "8.5"}, 2, {"--subdomains: must be a whole number"}},
      {{"run", "duct.stl", "--outer", "cube"}, 2, {"--outer: \"cube\" is not box[:FACTOR]"}},
      {{"run", "duct.stl", "--outer", "box:inf"}, 2, {"--outer: the factor in \"box:inf\""}},
      {{"run", "duct.stl", "--outer", "sphere:1"}, 2, {"must be a number above 1"}},
      {{"run", "duct.stl", "--max-memory", "lots"}, 2, {"--max-memory: \"lots\" is not an amount"}},
      {{"run", "duct.stl", "--max-memory", "1MB", "-o", "o4", "-j", "1"},
       2,
       {"error: --max-memory 1MB: this surface needs at least"}},
  });
}

TEST_F(Newcomer, of_electromagnetics_writes_a_job_file) {
  expect({
      {{"check", "em/coil.toml"}, 5, {"error: em/nowhere.stl: cannot open"}},
      {{"run", "em/coil.toml"}, 5, {"error: em/nowhere.stl: cannot open"}},
      {{"run", "em/formats.toml"}, 2, {"em/formats.toml:4:12", "did you mean `su2`?"}},
      {{"check", "em/missing.toml"}, 5, {"em/missing.toml: cannot open"}},
  });
}

TEST_F(Newcomer, of_a_cluster_submits_what_cannot_be_meshed) {
  const auto submit = [](std::vector<std::string> more) {
    more.insert(more.begin(), "submit");
    more.insert(more.end(), {"--connect", nowhere, "--timeout", "0.1"});
    return more;
  };
  expect({
      {submit({"body.stp"}), 2, {"unsupported file type `.stp`; mesh a CAD file"}},
      {submit({"em/bad.off"}), 3, {"error: em/bad.off:4"}},
      {submit({"em/open.off"}), 3, {"em/open.off: the surface cannot be meshed", "open edge"}},
      {submit({"em/open.off", "--no-check"}), 5, {"no coordinator answers"}},
      {submit({"duct.stl"}), 5, {"no coordinator answers"}},
      {submit({"elsewhere.stl"}), 5, {"elsewhere.stl: no such file", "--coordinator-reads"}},
      {submit({"elsewhere.stl", "--coordinator-reads"}),
       5,
       {"elsewhere.stl cannot be seen from here", "no coordinator answers"}},
      {submit({"duct.stl", "--format", "su3"}), 2, {"--format su3:", "did you mean `su2`?"}},
      {{"cancel", "job-1"}, 2, {"--connect is required", "help: see `tetfarm cancel --help`"}},
      {{"jobs", "--store", "out"}, 0, {"job-1", "done"}},
      {{"tasks", "--store", "out", "--state", "running"}, 0, {"no matching tasks"}},
      {{"status", "job-7", "--store", "out"}, 5, {"no job job-7"}},
      {{"status", "job-7", "--store", "em"}, 5, {"em: not a store or the output folder of a run"}},
      {{"gc", "nowhere"}, 5, {"nowhere: no such folder"}},
      {{"quality", "nowhere.vtkhdf"}, 5, {"nowhere.vtkhdf: no such file"}},
  });
}

TEST_F(Newcomer, of_a_cluster_is_told_which_key_is_missing) {
  expect({
      {{"keys", "authorize", "anna.pub", "--role", "worker"},
       5,
       {"anna.pub: no such file", "64 hexadecimal digits"}},
      {{"pool", "slurm", "--coordinator", nowhere, "--max", "3", "--key", "me.key", "--dry-run"},
       2,
       {"--worker-key: is missing", "tetfarm keys authorize worker.pub --role worker"}},
  });
}

TEST_F(Newcomer, reads_of_no_option_that_a_command_has_not) {
  for (const char* command : {"cancel", "drain", "retry"}) {
    const Ended help = run_program({command, "--help"}, folder_->path());
    EXPECT_EQ(help.code, 0);
    EXPECT_THAT(help.out, Not(HasSubstr("store"))) << command;
  }
  EXPECT_THAT(run_program({"jobs", "--help"}, folder_->path()).out,
              HasSubstr("coordinator.pub in the store"));
}

}  // namespace
}  // namespace tetfarm
