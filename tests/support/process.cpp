#include "tests/support/process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace halsted::testing {
namespace {

int exitCodeOf(int status) { return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status); }

pid_t start(const std::vector<std::string>& arguments, const std::string& outputFile, const std::string& errorFile) {
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const pid_t pid = fork();
  if (pid < 0) throw std::runtime_error("fork failed");
  if (pid > 0) return pid;
  const int out = open(outputFile.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int err = open(errorFile.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  execv(argv[0], argv.data());
  _exit(127);
}

}  // namespace

ProcessResult run(const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  const pid_t pid = start(arguments, folder.file("out"), folder.file("err"));
  int status = 0;
  waitpid(pid, &status, 0);
  return {exitCodeOf(status), readText(folder.file("out")), readText(folder.file("err"))};
}

RunningProcess::RunningProcess(const std::vector<std::string>& arguments) : pid_(start(arguments, "/dev/null", "/dev/null")) {}

RunningProcess::~RunningProcess() {
  if (pid_ <= 0) return;
  kill(pid_, SIGKILL);
  wait();
}

void RunningProcess::send(int signal) {
  if (pid_ > 0) kill(pid_, signal);
}

int RunningProcess::wait() {
  if (pid_ <= 0) return code_;
  int status = 0;
  waitpid(pid_, &status, 0);
  pid_ = -1;
  return code_ = exitCodeOf(status);
}

bool RunningProcess::ended() {
  if (pid_ <= 0) return true;
  int status = 0;
  if (waitpid(pid_, &status, WNOHANG) != pid_) return false;
  pid_ = -1;
  code_ = exitCodeOf(status);
  return true;
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / ("halsted-test-" + std::string(6, 'X'))).string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("cannot make a temporary folder");
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string readText(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void writeText(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
}

}  // namespace halsted::testing
