#include "render/gl/context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>

#include "files/error.h"

namespace prairie {
namespace {

constexpr EGLint kRendererString = 0x335F;  // EGL_RENDERER_EXT of EGL_EXT_device_query_name
constexpr const char* kExpected = "a device that makes an OpenGL 4.5 core context";

struct Device {
  EGLDeviceEXT handle = EGL_NO_DEVICE_EXT;
  std::string name;
  bool is_software = false;
};

bool has_extension(const char* extensions, const char* name) {
  return extensions != nullptr && std::strstr(extensions, name) != nullptr;
}

std::vector<Device> find_devices() {
  std::vector<Device> devices;
  if (!has_extension(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_EXT_device_enumeration") &&
      !has_extension(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_EXT_device_base")) {
    return devices;
  }
  EGLDeviceEXT handles[32];
  EGLint count = 0;
  if (!eglQueryDevicesEXT(32, handles, &count)) return devices;
  for (EGLint n = 0; n < count; ++n) {
    const char* extensions = eglQueryDeviceStringEXT(handles[n], EGL_EXTENSIONS);
    Device device{handles[n], "", has_extension(extensions, "EGL_MESA_device_software")};
    const auto query = [&](const char* extension, EGLint what) -> const char* {
      return has_extension(extensions, extension) ? eglQueryDeviceStringEXT(handles[n], what) : nullptr;
    };
    const char* file = query("EGL_EXT_device_drm", EGL_DRM_DEVICE_FILE_EXT);
    const char* renderer = query("EGL_EXT_device_query_name", kRendererString);
    device.name = device.is_software ? "software" : renderer ? renderer : file ? file : "hardware";
    if (renderer && file) device.name += fmt::format(" ({})", file);
    devices.push_back(device);
  }
  return devices;
}

// Both names are looked up: some libraries have the function of EGL 1.5, some only that of the extension.
EGLDisplay platform_display(EGLenum platform, void* native) {
  const auto get_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYPROC>(eglGetProcAddress("eglGetPlatformDisplay"));
  if (get_display) return get_display(platform, native, nullptr);
  const auto get_display_ext =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get_display_ext) return get_display_ext(platform, native, nullptr);
  return EGL_NO_DISPLAY;
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_meant(const std::string& wanted, std::size_t index, const Device& device) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
  if (error == std::errc() && end == wanted.data() + wanted.size()) return number == index;
  return lower_case(device.name).find(lower_case(wanted)) != std::string::npos;
}

}  // namespace

struct HeadlessContext::Egl {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  ~Egl() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
  }

  /// An empty string if the context is made and current, else why not.
  std::string open(EGLDisplay candidate, const ContextOptions& options) {
    display = candidate;
    if (display == EGL_NO_DISPLAY) return "no display";
    EGLint major = 0, minor = 0;
    if (!eglInitialize(display, &major, &minor)) {
      display = EGL_NO_DISPLAY;
      return fmt::format("cannot be initialised (EGL error 0x{:x})", eglGetError());
    }
    const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
    if (!has_extension(extensions, "EGL_KHR_no_config_context") ||
        !has_extension(extensions, "EGL_KHR_surfaceless_context")) {
      return "no contexts without configuration and surface";
    }
    if (!eglBindAPI(EGL_OPENGL_API)) return "no desktop OpenGL";
    // Not every driver tells of resets (render/gl/graphics_reset.h), and some refuse to be asked to.
    context = make_context(options.debug, EGL_LOSE_CONTEXT_ON_RESET);
    if (context == EGL_NO_CONTEXT) context = make_context(options.debug, EGL_NO_RESET_NOTIFICATION);
    if (context == EGL_NO_CONTEXT)
      return fmt::format("no OpenGL 4.5 core context (EGL error 0x{:x})", eglGetError());
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
      return "the context cannot be made current";
    if (epoxy_gl_version() < 45)
      return fmt::format("OpenGL {}.{}", epoxy_gl_version() / 10, epoxy_gl_version() % 10);
    return "";
  }

  EGLContext make_context(bool debug, EGLint on_reset) {
    std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION,       4,
                                   EGL_CONTEXT_MINOR_VERSION,       5,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT};
    if (debug) attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
    if (on_reset != EGL_NO_RESET_NOTIFICATION)
      attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, on_reset});
    attributes.push_back(EGL_NONE);
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
  }
};

HeadlessContext::HeadlessContext(const std::optional<std::string>& device, const ContextOptions& options) {
  std::vector<std::string> attempts;
  const auto attempt = [&](const std::string& name, EGLDisplay display) {
    auto egl = std::make_unique<Egl>();
    const std::string fault = egl->open(display, options);
    if (fault.empty()) {
      egl_ = std::move(egl);
      return true;
    }
    attempts.push_back(name + ": " + fault);
    return false;
  };
  if (eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS) == nullptr) {
    throw NoSuitableOpenGl("", "OpenGL", "no EGL driver", kExpected);
  }
  const std::vector<Device> devices = find_devices();
  if (device) {
    for (std::size_t n = 0; n < devices.size(); ++n) {
      if (!is_meant(*device, n, devices[n])) continue;
      if (attempt(devices[n].name, platform_display(EGL_PLATFORM_DEVICE_EXT, devices[n].handle))) return;
    }
    if (attempts.empty()) attempts.push_back(fmt::format("no device is called \"{}\"", *device));
  } else {
    for (const Device& candidate : devices) {
      if (candidate.is_software) continue;
      if (attempt(candidate.name, platform_display(EGL_PLATFORM_DEVICE_EXT, candidate.handle))) return;
    }
    if (attempt("surfaceless", platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY))) return;
    for (const Device& candidate : devices) {
      if (!candidate.is_software) continue;
      if (attempt(candidate.name, platform_display(EGL_PLATFORM_DEVICE_EXT, candidate.handle))) return;
    }
  }
  throw NoSuitableOpenGl("", device ? "--device" : "OpenGL", fmt::format("{}", fmt::join(attempts, "; ")),
                         kExpected);
}

HeadlessContext::~HeadlessContext() = default;
HeadlessContext::HeadlessContext(HeadlessContext&&) noexcept = default;
HeadlessContext& HeadlessContext::operator=(HeadlessContext&&) noexcept = default;

std::vector<std::string> list_devices() {
  std::vector<std::string> lines;
  const std::vector<Device> devices = find_devices();
  for (std::size_t n = 0; n < devices.size(); ++n) lines.push_back(fmt::format("{}: {}", n, devices[n].name));
  return lines;
}

std::string renderer_name() {
  const auto text = [](GLenum name) { return reinterpret_cast<const char*>(glGetString(name)); };
  return fmt::format("{}, {}", text(GL_RENDERER), text(GL_VERSION));
}

}  // namespace prairie
