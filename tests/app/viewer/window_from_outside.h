// The viewer's window as another client of the X server sees it, such as a window manager.
#pragma once

struct _XDisplay;  // Xlib's own name; its header defines macros such as None

namespace prairie::testing {

class WindowFromOutside {
 public:
  /// Waits until the window is there, at most ten seconds.
  WindowFromOutside();
  ~WindowFromOutside();
  WindowFromOutside(const WindowFromOutside&) = delete;
  WindowFromOutside& operator=(const WindowFromOutside&) = delete;

  bool is_there() const { return window_ != 0; }
  // Each returns when the X server has done it.
  void hide();
  void show();
  void resize(unsigned width_px, unsigned height_px);
  /// Presses a key and lets it go: X's code of its symbol, such as 'p' or XK_Escape.
  void press(unsigned long symbol);
  /// Presses a key and holds it.
  void hold(unsigned long symbol);
  /// Turns the mouse wheel by a notch away from the person.
  void turn_wheel();
  /// Asks the program to close it, as the cross in a window's frame does.
  void close();

 private:
  void find();
  void send_key(int type, unsigned long symbol);

  _XDisplay* display_;
  unsigned long window_ = 0;
  unsigned long time_ms_ = 0;  // of the last key: GLFW takes two at one time for one
};

}  // namespace prairie::testing
