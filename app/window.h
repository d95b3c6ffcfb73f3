#pragma once
/// The training window: shows the frame that was rendered off screen and turns keys and mouse into the target of one hand.
/// Main thread only. It uses the window's own OpenGL through function pointers; the program never links libGL (render/context.h).
#include <memory>
#include <string>

#include "render/frame.h"
#include "sim/exchange.h"

namespace halsted::app {

class Window {
 public:
  /// Throws SystemFault when there is no screen. `hand` is where the moved hand starts; `view` says what is right and up on screen.
  Window(const std::string& title, int width, int height, const Pose& hand, const CameraView& view);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  void show(const render::Frame&);             // draws it and swaps
  void poll();                                 // reads keys and mouse; waits a few milliseconds at most
  bool closed() const;                         // the user pressed Esc or closed it
  bool helpVisible() const;
  bool otherView() const;                      // a layered body cut open, or whole where the scene opens it
  bool takeThreadAsked();                      // N was pressed since the last call: the assistant is asked for a new needled thread
  bool takeInstrumentsAsked();                 // T was pressed since the last call: both hands change their instruments
  bool takeClampAsked();                       // H was pressed since the last call: the assistant takes the clamp over
  const HandTarget& target() const;            // world

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace halsted::app
