/// Runs the built `tetfarm` program as a process of its own and looks at what it says.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace tetfarm::test {

/// A new folder that is removed with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct Ended {
  int code = -1;  ///< the exit code; 128 + signal when it was killed
  std::string out;
  std::string err;
};

/// A running program; killed with the object.
class Program {
 public:
  /// `words` go to the program `tetfarm`; it runs in `folder`, and its output is kept there.
  /// `launcher`, where given, stands in for the program, and is what starts it.
  Program(const std::vector<std::string>& words, const std::filesystem::path& folder,
          const std::vector<std::string>& launcher = {});
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  pid_t process() const { return process_; }
  bool is_running();
  void signal(int number) const;
  /// Waits for its end; killed after timeout_s, with code -1.
  Ended wait(double timeout_s = 120);
  /// What it has said so far on standard output.
  std::string out_so_far() const;

 private:
  pid_t process_ = -1;
  int status_ = 0;
  std::filesystem::path out_;
  std::filesystem::path err_;
};

Ended run_program(const std::vector<std::string>& words, const std::filesystem::path& folder,
                  double timeout_s = 120);
/// Where the built program lies.
std::filesystem::path built_program();

/// The living processes below `process`: children, their children, …
std::vector<pid_t> descendants(pid_t process);

std::string contents(const std::filesystem::path& file);
void write_contents(const std::filesystem::path& file, const std::string& bytes);

}  // namespace tetfarm::test
