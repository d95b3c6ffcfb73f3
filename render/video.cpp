#include "render/video.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <stdexcept>

extern char** environ;

namespace halsted::render {
namespace {

std::string rate(double framesPerSecond) {   // [Hz] in thousandths, so that no locale's comma gets in
  return std::to_string(static_cast<long>(framesPerSecond * 1000.0 + 0.5)) + "/1000";
}

/// Holds SIGPIPE off this thread for one write; a signal that the write raised is taken back.
class PipeGuard {
 public:
  PipeGuard() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    sigpending(&pending);
    wasPending_ = sigismember(&pending, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~PipeGuard() {
    const int kept = errno;
    const timespec now{0, 0};
    if (!wasPending_)
      while (sigtimedwait(&pipe_, nullptr, &now) < 0 && errno == EINTR) {}
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    errno = kept;
  }
  PipeGuard(const PipeGuard&) = delete;
  PipeGuard& operator=(const PipeGuard&) = delete;

 private:
  sigset_t pipe_, before_;
  bool wasPending_ = false;
};

bool writeAll(int file, const std::uint8_t* data, std::size_t left) {
  while (left > 0) {
    const ssize_t n = write(file, data, left);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    data += n;
    left -= static_cast<std::size_t>(n);
  }
  return true;
}

std::string lastLine(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  const auto at = text.find_last_of("\r\n");
  return at == std::string::npos ? text : text.substr(at + 1);
}

void closeOnce(int& file) {
  if (file >= 0) close(file);
  file = -1;
}

pid_t spawn(const std::vector<std::string>& words, int input, int complaints, int& error) {
  std::vector<char*> arguments;
  for (const std::string& w : words) arguments.push_back(const_cast<char*>(w.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, complaints, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;                             // the child must not inherit what this program blocks
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t child = -1;
  error = posix_spawnp(&child, words.front().c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return error == 0 ? child : -1;
}

}  // namespace

VideoWriter::VideoWriter(const std::string& path, const VideoFormat& format, const std::string& program)
    : path_(path), format_(format) {
  if (format.width < 16 || format.height < 16 || format.width % 2 || format.height % 2)
    throw std::runtime_error(path + ": a video's width and height must be even and at least 16");
  if (!(format.framesPerSecond >= 1.0 && format.framesPerSecond <= 240.0))
    throw std::runtime_error(path + ": a video has 1 to 240 frames a second");
  int toChild[2], fromChild[2];
  if (pipe2(toChild, O_CLOEXEC) != 0) throw std::runtime_error(path + ": no pipe for ffmpeg: " + std::strerror(errno));
  if (pipe2(fromChild, O_CLOEXEC) != 0) {
    const int why = errno;
    close(toChild[0]);
    close(toChild[1]);
    throw std::runtime_error(path + ": no pipe for ffmpeg: " + std::strerror(why));
  }
  // A path that starts with a dash would be read as an option; "file:" also keeps ffmpeg from seeing a protocol in it.
  const std::vector<std::string> words{program, "-nostdin", "-hide_banner", "-loglevel", "error", "-y", "-f", "rawvideo",
      "-pixel_format", "rgba", "-video_size", std::to_string(format.width) + "x" + std::to_string(format.height), "-framerate",
      rate(format.framesPerSecond), "-i", "pipe:0", "-an", "-c:v", "libx264", "-preset", "veryfast", "-crf", "18", "-pix_fmt",
      "yuv420p", "-threads", "1", "-movflags", "+faststart", "-f", "mp4", "file:" + path};
  int error = 0;
  child_ = spawn(words, toChild[0], fromChild[1], error);
  close(toChild[0]);
  close(fromChild[1]);
  input_ = toChild[1];
  complaints_ = fromChild[0];
  fcntl(complaints_, F_SETFL, O_NONBLOCK);
  if (child_ < 0) {
    closeOnce(input_);
    closeOnce(complaints_);
    throw std::runtime_error(path + ": cannot start " + program + ": " +
                             (error == ENOENT ? "not found (install the package ffmpeg)" : std::strerror(error)));
  }
}

VideoWriter::~VideoWriter() { reap(); }

int VideoWriter::reap() {
  closeOnce(input_);                         // end of the film: the child finishes its file and exits
  if (child_ < 0) return 0;
  if (complaints_ >= 0) fcntl(complaints_, F_SETFL, 0);
  char some[512];
  for (ssize_t n; complaints_ >= 0 && ((n = read(complaints_, some, sizeof some)) > 0 || (n < 0 && errno == EINTR));)
    if (n > 0 && words_.size() < 16384) words_.append(some, static_cast<std::size_t>(n));
  closeOnce(complaints_);
  int status = 0;
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {}
  child_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void VideoWriter::fail(const std::string& reason) {
  const int status = reap();
  const std::string said = lastLine(words_);
  throw std::runtime_error(path_ + ": " + reason + (said.empty() ? " (exit status " + std::to_string(status) + ")" : ": " + said));
}

void VideoWriter::add(const Frame& frame) {
  if (child_ < 0) throw std::runtime_error(path_ + ": the video is already closed");
  if (frame.width != format_.width || frame.height != format_.height || frame.rgba.size() != 4u * frame.width * frame.height)
    throw std::runtime_error(path_ + ": a frame of another size than the video's");
  bool written = false;
  {
    const PipeGuard guard;
    written = writeAll(input_, frame.rgba.data(), frame.rgba.size());
  }
  if (!written) fail("ffmpeg stopped early");
}

void VideoWriter::finish() {
  if (child_ < 0) return;
  const int status = reap();
  if (status != 0) {
    const std::string said = lastLine(words_);
    throw std::runtime_error(path_ + ": ffmpeg failed with status " + std::to_string(status) + (said.empty() ? "" : ": " + said));
  }
}

}  // namespace halsted::render
