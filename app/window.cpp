#include "app/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/errors.h"

namespace halsted::app {
namespace {

// The few names of OpenGL 1.1 that a picture needs; fetched at run time because OSMesa exports the same symbols.
constexpr unsigned kColorBufferBit = 0x4000, kRgba = 0x1908, kUnsignedByte = 0x1401, kUnpackAlignment = 0x0CF5;

struct OpenGl {
  void (*clear)(unsigned) = nullptr;
  void (*viewport)(int, int, int, int) = nullptr;
  void (*rasterPos2f)(float, float) = nullptr; // [1]
  void (*pixelZoom)(float, float) = nullptr;   // [1]
  void (*pixelStorei)(unsigned, int) = nullptr;
  void (*drawPixels)(int, int, unsigned, unsigned, const void*) = nullptr;

  void load() {
    const auto fetch = [](auto& function, const char* name) {
      function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(glfwGetProcAddress(name));
      if (!function) throw SystemFault(std::string("window: the OpenGL driver has no ") + name);
    };
    fetch(clear, "glClear");
    fetch(viewport, "glViewport");
    fetch(rasterPos2f, "glRasterPos2f");
    fetch(pixelZoom, "glPixelZoom");
    fetch(pixelStorei, "glPixelStorei");
    fetch(drawPixels, "glDrawPixels");
  }
};

constexpr double kWheelStep = 2e-3;            // [m] a notch
constexpr double kTurnPerPixel = 0.006;        // [rad]
constexpr double kReach = 0.12;                // [m] from the middle of the field: farther is out of the device's workspace
constexpr double kPi = 3.14159265358979323846;

std::string glfwReason() {
  const char* reason = nullptr;
  glfwGetError(&reason);
  return reason ? reason : "unknown reason";
}

}  // namespace

/// Axes of the screen in the world, and how far the hand moves for a pixel at the distance of the target.
struct ScreenFrame {
  Vec3 right, up, toEye;                       // [1]
  double metresPerPixel;                       // [m]

  ScreenFrame(const CameraView& view, int height) {
    toEye = (view.eye - view.target).normalized();
    right = view.up.cross(toEye).normalized();
    up = toEye.cross(right);
    metresPerPixel = 2.0 * (view.eye - view.target).norm() * std::tan(view.fovDegrees * kPi / 360.0) / height;
  }
};

struct Window::Parts {
  GLFWwindow* window = nullptr;
  OpenGl gl;
  ScreenFrame screen;
  HandTarget hand;
  double lastX = 0.0, lastY = 0.0;             // [px]
  bool hasLast = false, help = false, otherView = false, threadAsked = false, instrumentsAsked = false, clampAsked = false;

  Parts(const CameraView& view, int height) : screen(view, height) {}

  static Parts& of(GLFWwindow* window) { return *static_cast<Parts*>(glfwGetWindowUserPointer(window)); }

  void moveHand(const Vec3& by) {              // [m]
    Vec3 moved = hand.pose.position + by;
    for (int axis = 0; axis < 3; ++axis) moved[axis] = std::clamp(moved[axis], -kReach, kReach);
    hand.pose.position = moved;
  }

  void mouseMoved(double x, double y) {        // [px]
    const double dx = hasLast ? x - lastX : 0.0, dy = hasLast ? y - lastY : 0.0;   // [px]
    lastX = x;
    lastY = y;
    hasLast = true;
    if (glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS) {
      const Quat turn(Eigen::AngleAxisd(dx * kTurnPerPixel, screen.up) * Eigen::AngleAxisd(dy * kTurnPerPixel, screen.right));
      hand.pose.orientation = (turn * hand.pose.orientation).normalized();
    } else {
      moveHand(screen.metresPerPixel * (dx * screen.right - dy * screen.up));
    }
  }

  void keyPressed(int key) {
    if (key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(window, GLFW_TRUE);
    if (key == GLFW_KEY_F1) help = !help;
    if (key == GLFW_KEY_C) otherView = !otherView;
    if (key == GLFW_KEY_N) threadAsked = true;
    if (key == GLFW_KEY_T) instrumentsAsked = true;
    if (key == GLFW_KEY_H) clampAsked = true;
    const Vec3 axes[] = {-screen.right, screen.right, screen.up, -screen.up, screen.toEye, -screen.toEye};
    const int keys[] = {GLFW_KEY_LEFT, GLFW_KEY_RIGHT, GLFW_KEY_UP, GLFW_KEY_DOWN, GLFW_KEY_PAGE_UP, GLFW_KEY_PAGE_DOWN};
    for (int i = 0; i < 6; ++i)
      if (key == keys[i]) moveHand(kWheelStep * axes[i]);
  }

  void listen() {
    glfwSetWindowUserPointer(window, this);
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) { of(w).mouseMoved(x, y); });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double notches) {
      of(w).moveHand(-notches * kWheelStep * of(w).screen.toEye);
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
      if (action == GLFW_REPEAT && (key == GLFW_KEY_N || key == GLFW_KEY_T || key == GLFW_KEY_H)) return;
      if (action != GLFW_RELEASE) of(w).keyPressed(key);
    });
  }
};

Window::Window(const std::string& title, int width, int height, const Pose& hand, const CameraView& view)
    : parts_(std::make_unique<Parts>(view, height)) {
  if (!glfwInit()) throw SystemFault("window: " + glfwReason() + "; without a screen use --headless");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 2);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
  parts_->window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (!parts_->window) {
    const std::string reason = glfwReason();
    glfwTerminate();
    throw SystemFault("window: " + reason + "; without OpenGL on the screen use --headless");
  }
  glfwMakeContextCurrent(parts_->window);
  glfwSwapInterval(0);
  parts_->gl.load();
  parts_->hand = {hand, 1.0, true};
  parts_->listen();
}

Window::~Window() {
  glfwDestroyWindow(parts_->window);
  glfwTerminate();
}

void Window::show(const render::Frame& frame) {
  if (frame.rgba.empty()) return;
  int width = 0, height = 0;
  glfwGetFramebufferSize(parts_->window, &width, &height);
  const OpenGl& gl = parts_->gl;
  gl.viewport(0, 0, width, height);
  gl.clear(kColorBufferBit);
  gl.rasterPos2f(-1.0f, 1.0f);                 // top left: the frame's first row is its top one
  gl.pixelZoom(static_cast<float>(width) / static_cast<float>(frame.width), -static_cast<float>(height) / static_cast<float>(frame.height));
  gl.pixelStorei(kUnpackAlignment, 4);
  gl.drawPixels(frame.width, frame.height, kRgba, kUnsignedByte, frame.rgba.data());
  glfwSwapBuffers(parts_->window);
}

void Window::poll() {
  glfwWaitEventsTimeout(4e-3);
  GLFWwindow* window = parts_->window;
  const bool closes = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS || glfwGetKey(window, GLFW_KEY_SPACE) == GLFW_PRESS;
  parts_->hand.jaw = closes ? 0.0 : 1.0;
}

bool Window::closed() const { return glfwWindowShouldClose(parts_->window) != 0; }
bool Window::helpVisible() const { return parts_->help; }
bool Window::otherView() const { return parts_->otherView; }
bool Window::takeThreadAsked() { return std::exchange(parts_->threadAsked, false); }
bool Window::takeInstrumentsAsked() { return std::exchange(parts_->instrumentsAsked, false); }
bool Window::takeClampAsked() { return std::exchange(parts_->clampAsked, false); }
const HandTarget& Window::target() const { return parts_->hand; }

}  // namespace halsted::app
