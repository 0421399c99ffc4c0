#pragma once
#include <xcb/xcb.h>

#include <QStringList>
#include <cstdlib>
#include <memory>

namespace underact::gui::test {

/// The titles of all windows on the X server's screen, of other programs, too.
class TitlesOnScreen {
 public:
  static QStringList read() {
    TitlesOnScreen screen;
    screen.add(xcb_setup_roots_iterator(xcb_get_setup(screen.xcb_.get())).data->root);
    return screen.titles_;
  }

 private:
  template <class Reply>
  using Kept = std::unique_ptr<Reply, decltype(&std::free)>;
  template <class Reply>
  static Kept<Reply> kept(Reply* reply) {
    return {reply, &std::free};
  }
  void add(xcb_window_t window) {
    xcb_connection_t* const xcb = xcb_.get();
    const auto title =
        kept(xcb_get_property_reply(xcb, xcb_get_property(xcb, 0, window, name_->atom, XCB_ATOM_ANY, 0, 99), nullptr));
    if (title && xcb_get_property_value_length(title.get()) > 0)
      titles_ << QString::fromUtf8(static_cast<const char*>(xcb_get_property_value(title.get())),
                                   xcb_get_property_value_length(title.get()));
    const auto tree = kept(xcb_query_tree_reply(xcb, xcb_query_tree(xcb, window), nullptr));
    for (int child = 0; tree && child < xcb_query_tree_children_length(tree.get()); ++child)
      add(xcb_query_tree_children(tree.get())[child]);
  }

  std::unique_ptr<xcb_connection_t, decltype(&xcb_disconnect)> xcb_{xcb_connect(nullptr, nullptr), &xcb_disconnect};
  Kept<xcb_intern_atom_reply_t> name_ =
      kept(xcb_intern_atom_reply(xcb_.get(), xcb_intern_atom(xcb_.get(), 0, 12, "_NET_WM_NAME"), nullptr));
  QStringList titles_;
};

}  // namespace underact::gui::test
