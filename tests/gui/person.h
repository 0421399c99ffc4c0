#pragma once
#include <xcb/xtest.h>

#include <QPoint>
#include <cstdint>
#include <cstdlib>

namespace underact::gui::test {

/// Somebody at the keyboard and the mouse.
class Person {
 public:
  static constexpr std::uint8_t kEscape = 9;  // the code of the key, of Xvfb

  Person() : xcb_(xcb_connect(nullptr, nullptr)) {}
  ~Person() { xcb_disconnect(xcb_); }
  Person(const Person&) = delete;
  Person& operator=(const Person&) = delete;
  void press(std::uint8_t key) { event(XCB_KEY_PRESS, key), event(XCB_KEY_RELEASE, key), done(); }
  void pressWithShift(std::uint8_t key) {
    event(XCB_KEY_PRESS, kShift);
    press(key);
    event(XCB_KEY_RELEASE, kShift), done();
  }
  void click(const QPoint& at) {
    const auto x = static_cast<std::int16_t>(at.x()), y = static_cast<std::int16_t>(at.y());
    xcb_test_fake_input(xcb_, XCB_MOTION_NOTIFY, 0, 0, root(), x, y, 0);
    event(XCB_BUTTON_PRESS, 1), event(XCB_BUTTON_RELEASE, 1), done();
  }
  /// A window of another program gets the keyboard.
  void takeKeyboard() {
    const xcb_window_t other = xcb_generate_id(xcb_);
    xcb_create_window(xcb_, 0, other, root(), 0, 0, 9, 9, 0, XCB_WINDOW_CLASS_INPUT_ONLY, 0, 0, nullptr);
    xcb_map_window(xcb_, other);
    xcb_set_input_focus(xcb_, XCB_INPUT_FOCUS_NONE, other, XCB_CURRENT_TIME);
    done();
  }

 private:
  xcb_window_t root() { return xcb_setup_roots_iterator(xcb_get_setup(xcb_)).data->root; }
  void event(std::uint8_t kind, std::uint8_t what) { xcb_test_fake_input(xcb_, kind, what, 0, XCB_NONE, 0, 0, 0); }
  void done() { std::free(xcb_get_input_focus_reply(xcb_, xcb_get_input_focus(xcb_), nullptr)); }  // the server has it

  static constexpr std::uint8_t kShift = 50;
  xcb_connection_t* xcb_;
};

}  // namespace underact::gui::test
