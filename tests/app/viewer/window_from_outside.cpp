#include "tests/app/viewer/window_from_outside.h"

#include <X11/Xlib.h>

#include <chrono>
#include <string>
#include <thread>

namespace prairie::testing {

WindowFromOutside::WindowFromOutside() : display_(XOpenDisplay(nullptr)) {
  for (int attempt = 0; display_ != nullptr && attempt < 1000 && window_ == 0; ++attempt) {
    find();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

WindowFromOutside::~WindowFromOutside() {
  if (display_ != nullptr) XCloseDisplay(display_);
}

void WindowFromOutside::hide() {
  XUnmapWindow(display_, window_);
  XSync(display_, False);
}

void WindowFromOutside::show() {
  XMapWindow(display_, window_);
  XSync(display_, False);
}

void WindowFromOutside::resize(unsigned width_px, unsigned height_px) {
  XResizeWindow(display_, window_, width_px, height_px);
  XSync(display_, False);
}

void WindowFromOutside::press(unsigned long symbol) {
  send_key(KeyPress, symbol);
  send_key(KeyRelease, symbol);
}

void WindowFromOutside::hold(unsigned long symbol) {
  send_key(KeyPress, symbol);
}

void WindowFromOutside::turn_wheel() {
  XEvent event{};
  event.xbutton.type = ButtonPress;
  event.xbutton.display = display_;
  event.xbutton.window = window_;
  event.xbutton.root = DefaultRootWindow(display_);
  event.xbutton.same_screen = True;
  event.xbutton.button = Button4;
  XSendEvent(display_, window_, False, ButtonPressMask, &event);
  XSync(display_, False);
}

void WindowFromOutside::close() {
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = window_;
  event.xclient.message_type = XInternAtom(display_, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(display_, "WM_DELETE_WINDOW", False));
  XSendEvent(display_, window_, False, NoEventMask, &event);
  XSync(display_, False);
}

void WindowFromOutside::send_key(int type, unsigned long symbol) {
  XEvent event{};
  event.xkey.type = type;
  event.xkey.display = display_;
  event.xkey.window = window_;
  event.xkey.root = DefaultRootWindow(display_);
  event.xkey.same_screen = True;
  event.xkey.keycode = XKeysymToKeycode(display_, symbol);
  event.xkey.time = time_ms_ += 100;
  XSendEvent(display_, window_, False, type == KeyPress ? KeyPressMask : KeyReleaseMask, &event);
  XSync(display_, False);
}

void WindowFromOutside::find() {
  Window root = 0;
  Window parent = 0;
  Window* children = nullptr;
  unsigned count = 0;
  XQueryTree(display_, DefaultRootWindow(display_), &root, &parent, &children, &count);
  for (unsigned n = 0; n < count; ++n) {
    char* name = nullptr;
    XWindowAttributes attributes{};
    if (XFetchName(display_, children[n], &name) != 0 && std::string(name) == "prairie" &&
        XGetWindowAttributes(display_, children[n], &attributes) != 0 && attributes.map_state == IsViewable) {
      window_ = children[n];
    }
    if (name != nullptr) XFree(name);
  }
  if (children != nullptr) XFree(children);
}

}  // namespace prairie::testing
