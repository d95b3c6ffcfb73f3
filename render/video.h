#pragma once
/// An MP4 file (H.264, yuv420p), encoded by ffmpeg as a child process that reads raw frames from a pipe.
///
/// Errors are std::runtime_error with one line that names the file: ffmpeg missing, or what ffmpeg said last. A child that dies is
/// noticed at the next `add`; it cannot end this program (SIGPIPE is held off the writing thread), and it is always waited for.
#include <sys/types.h>

#include <string>
#include <vector>

#include "render/frame.h"

namespace halsted::render {

struct VideoFormat {
  int width = 0, height = 0;                 // pixels; even, as yuv420p needs
  double framesPerSecond = 30.0;             // [Hz]
};

class VideoWriter {
 public:
  /// Starts the child. `program` is looked up in PATH.
  VideoWriter(const std::string& path, const VideoFormat&, const std::string& program = "ffmpeg");
  ~VideoWriter();                            // a file that was not finished is left as it is
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  void add(const Frame&);
  void finish();                             // closes the file; throws when ffmpeg did not end well

 private:
  [[noreturn]] void fail(const std::string& reason);
  int reap();                                // ends the pipe, reads the child's words, waits; its exit status
  std::string path_, words_;
  VideoFormat format_;
  pid_t child_ = -1;
  int input_ = -1, complaints_ = -1;         // file descriptors
};

}  // namespace halsted::render
