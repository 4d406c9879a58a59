#include "app/viewer/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "files/error.h"

namespace prairie {
namespace {

std::string last_error() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description != nullptr ? description : "no window";
}

double axis(GLFWwindow* window, int plus_key, int minus_key) {
  const auto held = [window](int key) { return glfwGetKey(window, key) == GLFW_PRESS ? 1.0 : 0.0; };
  return held(plus_key) - held(minus_key);
}

constexpr double kLongestWaitS = 0.5;  // not every window system says that a window is back

GLFWwindow* make_window(glm::ivec2 size_px, int on_reset) {
  glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, on_reset);
  return glfwCreateWindow(size_px.x, size_px.y, "prairie", nullptr, nullptr);
}

constexpr std::pair<int, NamedKey> kNamedKeys[] = {
    {GLFW_KEY_ESCAPE, NamedKey::kEscape},
    {GLFW_KEY_ENTER, NamedKey::kEnter},
    {GLFW_KEY_TAB, NamedKey::kTab},
    {GLFW_KEY_BACKSPACE, NamedKey::kBackspace},
    {GLFW_KEY_INSERT, NamedKey::kInsert},
    {GLFW_KEY_DELETE, NamedKey::kDelete},
    {GLFW_KEY_HOME, NamedKey::kHome},
    {GLFW_KEY_END, NamedKey::kEnd},
    {GLFW_KEY_PAGE_UP, NamedKey::kPageUp},
    {GLFW_KEY_PAGE_DOWN, NamedKey::kPageDown},
    {GLFW_KEY_F1, NamedKey::kF1},
    {GLFW_KEY_F2, NamedKey::kF2},
    {GLFW_KEY_F3, NamedKey::kF3},
    {GLFW_KEY_F4, NamedKey::kF4},
    {GLFW_KEY_F5, NamedKey::kF5},
    {GLFW_KEY_F6, NamedKey::kF6},
    {GLFW_KEY_F7, NamedKey::kF7},
    {GLFW_KEY_F8, NamedKey::kF8},
    {GLFW_KEY_F9, NamedKey::kF9},
    {GLFW_KEY_F10, NamedKey::kF10},
    {GLFW_KEY_F11, NamedKey::kF11},
    {GLFW_KEY_F12, NamedKey::kF12},
    {GLFW_KEY_KP_ADD, NamedKey::kKeypadAdd},
    {GLFW_KEY_KP_SUBTRACT, NamedKey::kKeypadSubtract},
    {GLFW_KEY_LEFT_SHIFT, NamedKey::kShift},
    {GLFW_KEY_RIGHT_SHIFT, NamedKey::kShift},
    {GLFW_KEY_UP, NamedKey::kArrows},
    {GLFW_KEY_DOWN, NamedKey::kArrows},
    {GLFW_KEY_LEFT, NamedKey::kArrows},
    {GLFW_KEY_RIGHT, NamedKey::kArrows},
};

Key key_of(int glfw_key) {
  // These codes are those of ASCII.
  if (glfw_key >= GLFW_KEY_SPACE && glfw_key <= GLFW_KEY_GRAVE_ACCENT) return static_cast<char>(glfw_key);
  const auto found = std::find_if(std::begin(kNamedKeys), std::end(kNamedKeys),
                                  [glfw_key](const auto& named) { return named.first == glfw_key; });
  return found != std::end(kNamedKeys) ? found->second : NamedKey::kOther;
}

void pass_key_on(GLFWwindow* handle, int glfw_key, int, int action, int) {
  const auto* window = static_cast<const Window*>(glfwGetWindowUserPointer(handle));
  if (action == GLFW_PRESS && window->on_key) window->on_key(key_of(glfw_key));
}

}  // namespace

Window::Library::Library() {
  if (glfwInit() != GLFW_TRUE) {
    throw NoSuitableOpenGl("", "window", last_error(), "a display in DISPLAY or WAYLAND_DISPLAY");
  }
}

Window::Library::~Library() {
  glfwTerminate();
}

Window::Window(glm::ivec2 size_px) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);  // the renderer has targets of its own
  handle_ = make_window(size_px, GLFW_LOSE_CONTEXT_ON_RESET);
  if (handle_ == nullptr) handle_ = make_window(size_px, GLFW_NO_ROBUSTNESS);
  if (handle_ == nullptr) throw NoSuitableOpenGl("", "window", last_error(), "OpenGL 4.5 core");
  glfwMakeContextCurrent(handle_);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(handle_, this);
  glfwSetKeyCallback(handle_, pass_key_on);
  glfwSetScrollCallback(handle_, count_wheel);
}

Window::~Window() {
  glfwDestroyWindow(handle_);
}

glm::ivec2 Window::size_px() const {
  glm::ivec2 size_px{0};
  glfwGetWindowSize(handle_, &size_px.x, &size_px.y);
  return size_px;
}

glm::ivec2 Window::framebuffer_size_px() const {
  glm::ivec2 size_px{0};
  glfwGetFramebufferSize(handle_, &size_px.x, &size_px.y);
  return size_px;
}

bool Window::can_be_seen() const {
  const glm::ivec2 size_px = framebuffer_size_px();
  return size_px.x > 0 && size_px.y > 0 && glfwGetWindowAttrib(handle_, GLFW_ICONIFIED) == 0 &&
         glfwGetWindowAttrib(handle_, GLFW_VISIBLE) != 0;
}

bool Window::poll() {
  if (can_be_seen()) {
    glfwPollEvents();
  } else {
    glfwWaitEventsTimeout(kLongestWaitS);
  }
  return glfwWindowShouldClose(handle_) == 0;
}

void Window::close() {
  glfwSetWindowShouldClose(handle_, GLFW_TRUE);
}

void Window::show_frame() {
  glfwSwapBuffers(handle_);
}

void Window::count_wheel(GLFWwindow* handle, double, double notches) {
  static_cast<Window*>(glfwGetWindowUserPointer(handle))->wheel_ += notches;
}

Steering Window::steering(bool mouse_is_taken) {
  Steering steering;
  steering.forward = axis(handle_, GLFW_KEY_W, GLFW_KEY_S);
  steering.right = axis(handle_, GLFW_KEY_D, GLFW_KEY_A);
  steering.up = axis(handle_, GLFW_KEY_E, GLFW_KEY_Q);
  steering.fast = axis(handle_, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT) != 0.0;

  const bool held = glfwGetMouseButton(handle_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS ||
                    glfwGetMouseButton(handle_, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS;
  const bool drags = held && (dragging_ || !mouse_is_taken);
  if (drags != dragging_) {
    glfwSetInputMode(handle_, GLFW_CURSOR, drags ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
  }
  glm::dvec2 cursor_px{0.0};
  glfwGetCursorPos(handle_, &cursor_px.x, &cursor_px.y);
  if (drags && dragging_) {
    steering.turn_right_px = cursor_px.x - cursor_px_.x;
    steering.turn_up_px = cursor_px_.y - cursor_px.y;
  }
  const double notches = std::exchange(wheel_, 0.0);
  if (!mouse_is_taken) steering.wheel = notches;
  dragging_ = drags;
  cursor_px_ = cursor_px;
  return steering;
}

CartControls Window::cart_controls() const {
  return {axis(handle_, GLFW_KEY_UP, GLFW_KEY_DOWN), axis(handle_, GLFW_KEY_LEFT, GLFW_KEY_RIGHT)};
}

}  // namespace prairie
