#include "app/gui/kit/stop_ear.h"

#include <QGuiApplication>
#include <algorithm>
#include <cstdlib>
#include <thread>
#include <utility>
#include <vector>

#if __has_include(<xcb/xinput.h>)
#include <xcb/xinput.h>
#define UNDERACT_HAS_XCB
#endif

namespace underact::gui {

#ifdef UNDERACT_HAS_XCB
namespace {

constexpr xcb_keysym_t kEscape = 0xFF1B, kLeftShift = 0xFFE1, kRightShift = 0xFFE2;
constexpr int kDeepest = 32;  // windows within one another

template <class Reply>
using Answer = std::unique_ptr<Reply, decltype(&std::free)>;

template <class Reply>
Answer<Reply> held(Reply* reply) {
  return {reply, &std::free};
}

class XcbEar final : public StopEar {
 public:
  XcbEar(xcb_connection_t* xcb, xcb_window_t root, const xcb_setup_t& of_windows,
         std::function<void(const Press&)> heard)
      : xcb_(xcb),
        root_(root),
        ours_(of_windows.resource_id_base),
        ours_mask_(~of_windows.resource_id_mask),
        heard_(std::move(heard)) {
    xcb_create_window(xcb_, 0, end_ = xcb_generate_id(xcb_), root_, 0, 0, 1, 1, 0, XCB_WINDOW_CLASS_INPUT_ONLY, 0, 0,
                      nullptr);
    struct {
      xcb_input_event_mask_t head{XCB_INPUT_DEVICE_ALL_MASTER, 1};
      std::uint32_t mask = XCB_INPUT_XI_EVENT_MASK_RAW_KEY_PRESS | XCB_INPUT_XI_EVENT_MASK_RAW_KEY_RELEASE |
                           XCB_INPUT_XI_EVENT_MASK_RAW_BUTTON_PRESS;
    } wanted;
    xcb_input_xi_select_events(xcb_, root_, 1, &wanted.head);
    readKeys();
    thread_ = std::thread(&XcbEar::run, this);
  }
  ~XcbEar() override {
    xcb_client_message_event_t last{};
    last.response_type = XCB_CLIENT_MESSAGE;
    last.format = 32;
    last.window = end_;
    xcb_send_event(xcb_, 0, end_, 0, reinterpret_cast<const char*>(&last));  // ends the wait
    xcb_flush(xcb_);
    thread_.join();
    xcb_disconnect(xcb_);
  }

 private:
  void run() {
    while (const auto event = held(xcb_wait_for_event(xcb_))) {  // null: the server has gone
      const unsigned type = event->response_type & 0x7FU;
      if (type == XCB_CLIENT_MESSAGE) return;
      if (type == XCB_MAPPING_NOTIFY) readKeys();
      if (type != XCB_GE_GENERIC) continue;
      const auto& raw = *reinterpret_cast<const xcb_input_raw_key_press_event_t*>(event.get());
      const bool is_pressed = raw.event_type == XCB_INPUT_RAW_KEY_PRESS;
      if (is_pressed || raw.event_type == XCB_INPUT_RAW_KEY_RELEASE) {
        if (isAmong(shifts_, raw.detail)) is_shift_ = is_pressed;  // by the time one asks it may be up again
        if (is_pressed && isAmong(escapes_, raw.detail)) hear(true);
      } else if (raw.event_type == XCB_INPUT_RAW_BUTTON_PRESS && raw.detail == 1) {
        hear(false);
      }
    }
  }

  void hear(bool is_key) {
    const auto mouse = held(xcb_query_pointer_reply(xcb_, xcb_query_pointer(xcb_, root_), nullptr));
    if (!mouse) return;
    const auto focus = held(xcb_get_input_focus_reply(xcb_, xcb_get_input_focus(xcb_), nullptr));
    const bool follows_mouse = !focus || focus->focus == XCB_INPUT_FOCUS_POINTER_ROOT;
    const bool is_ours = is_key && !follows_mouse ? isOurs(focus->focus) : isUnderMouse(mouse->child);
    if (is_ours) heard_({is_key, is_shift_, {mouse->root_x, mouse->root_y}});
  }

  /// A window manager puts ours into its own.
  bool isUnderMouse(xcb_window_t window) const {
    for (int depth = 0; window != XCB_NONE && depth < kDeepest; ++depth) {
      if (isOurs(window)) return true;
      const auto within = held(xcb_query_pointer_reply(xcb_, xcb_query_pointer(xcb_, window), nullptr));
      window = within ? within->child : XCB_NONE;
    }
    return false;
  }

  static bool isAmong(const std::vector<std::uint32_t>& keys, std::uint32_t key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  }
  bool isOurs(xcb_window_t window) const { return (window & ours_mask_) == ours_; }

  void readKeys() {
    const xcb_setup_t& setup = *xcb_get_setup(xcb_);
    const int count = setup.max_keycode - setup.min_keycode + 1;
    const auto asked = xcb_get_keyboard_mapping(xcb_, setup.min_keycode, static_cast<std::uint8_t>(count));
    const auto keys = held(xcb_get_keyboard_mapping_reply(xcb_, asked, nullptr));
    if (!keys || keys->keysyms_per_keycode == 0) return;
    escapes_.clear();
    shifts_.clear();
    const xcb_keysym_t* const symbols = xcb_get_keyboard_mapping_keysyms(keys.get());
    for (int at = 0; at < xcb_get_keyboard_mapping_keysyms_length(keys.get()); ++at) {
      const auto key = static_cast<std::uint32_t>(setup.min_keycode + at / keys->keysyms_per_keycode);
      if (symbols[at] == kEscape) escapes_.push_back(key);
      if (symbols[at] == kLeftShift || symbols[at] == kRightShift) shifts_.push_back(key);
    }
  }

  xcb_connection_t* xcb_;
  xcb_window_t root_, end_ = XCB_NONE;
  std::uint32_t ours_, ours_mask_;
  std::vector<std::uint32_t> escapes_, shifts_;  // codes of the keys
  bool is_shift_ = false;
  std::function<void(const Press&)> heard_;
  std::thread thread_;
};

}  // namespace

std::unique_ptr<StopEar> StopEar::listen(std::function<void(const Press&)> heard) {
  const auto* const x11 = qGuiApp->nativeInterface<QNativeInterface::QX11Application>();
  if (x11 == nullptr) return nullptr;
  int screen = 0;
  xcb_connection_t* const xcb = xcb_connect(nullptr, &screen);
  if (xcb_connection_has_error(xcb) != 0) {  // such a one has no screens
    xcb_disconnect(xcb);
    return nullptr;
  }
  xcb_screen_iterator_t screens = xcb_setup_roots_iterator(xcb_get_setup(xcb));
  for (; screen > 0 && screens.rem > 1; --screen) xcb_screen_next(&screens);
  const auto version = held(xcb_input_xi_query_version_reply(xcb, xcb_input_xi_query_version(xcb, 2, 2), nullptr));
  const bool has_raw = version && 256 * version->major_version + version->minor_version >= 256 * 2 + 1;
  if (has_raw)
    return std::make_unique<XcbEar>(xcb, screens.data->root, *xcb_get_setup(x11->connection()), std::move(heard));
  xcb_disconnect(xcb);
  return nullptr;
}
#else
std::unique_ptr<StopEar> StopEar::listen(std::function<void(const Press&)>) {
  return nullptr;
}
#endif
#undef UNDERACT_HAS_XCB

}  // namespace underact::gui
