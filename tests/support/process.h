#pragma once
/// Runs the shipped program as a user would. POSIX; one thread.
#include <sys/types.h>

#include <string>
#include <vector>

namespace halsted::testing {

struct ProcessResult {
  int exitCode = -1;                           // 128 + signal when a signal ended it
  std::string output, errors;                  // standard output and standard error
};

/// Runs to the end; `arguments[0]` is the program.
ProcessResult run(const std::vector<std::string>& arguments);

/// A process that goes on while the test does something else. Killed when the object goes.
class RunningProcess {
 public:
  explicit RunningProcess(const std::vector<std::string>& arguments);
  ~RunningProcess();
  RunningProcess(const RunningProcess&) = delete;
  RunningProcess& operator=(const RunningProcess&) = delete;

  void send(int signal);
  int wait();                                  // exit code, 128 + signal when a signal ended it
  bool ended();                                // without waiting

 private:
  pid_t pid_ = -1;
  int code_ = -1;
};

/// A folder of the test's own, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string file(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::string readText(const std::string& path);
void writeText(const std::string& path, const std::string& text);

}  // namespace halsted::testing
