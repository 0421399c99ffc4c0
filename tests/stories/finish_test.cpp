#include <gtest/gtest.h>
#include <xcb/xcb.h>

#include <QProcess>
#include <QScreen>

#include "tests/stories/story.h"

// What makes the window look finished, on the screen.
namespace underact::gui::test {
namespace {

/// Of the rows in which a mesh's blue begins, those with a tone between the ground's and its own.
double smoothShare(const QImage& picture) {
  int begins = 0, smooth = 0;
  const auto blueness = [&](int x, int y) { return qBlue(picture.pixel(x, y)) - qRed(picture.pixel(x, y)); };
  for (int y = picture.height() / 4; y < picture.height(); ++y) {
    for (int x = 2; x + 2 < picture.width(); ++x) {
      const int inside = blueness(x + 2, y), here = blueness(x + 1, y);
      if (blueness(x, y) > 4 || inside < 60 || std::abs(here - inside) > 0.9 * inside) continue;
      const bool between = here > 0.12 * inside && here < 0.88 * inside;
      ++begins;
      smooth += between ? 1 : 0;
      break;
    }
  }
  return begins < 30 ? 0.0 : static_cast<double>(smooth) / begins;
}

/// The titles of all windows on the screen.
QStringList titlesOnScreen() {
  QStringList titles;
  xcb_connection_t* const xcb = xcb_connect(nullptr, nullptr);
  const auto kept = [](auto* reply) {
    return std::unique_ptr<std::remove_pointer_t<decltype(reply)>, decltype(&free)>(reply, &free);
  };
  const auto name = kept(xcb_intern_atom_reply(xcb, xcb_intern_atom(xcb, 0, 12, "_NET_WM_NAME"), nullptr));
  const auto tree = kept(
      xcb_query_tree_reply(xcb, xcb_query_tree(xcb, xcb_setup_roots_iterator(xcb_get_setup(xcb)).data->root), nullptr));
  for (int child = 0; child < xcb_query_tree_children_length(tree.get()); ++child) {
    const auto value = kept(xcb_get_property_reply(
        xcb, xcb_get_property(xcb, 0, xcb_query_tree_children(tree.get())[child], name->atom, XCB_ATOM_ANY, 0, 99),
        nullptr));
    if (value == nullptr || xcb_get_property_value_length(value.get()) == 0) continue;
    titles << QString::fromUtf8(static_cast<const char*>(xcb_get_property_value(value.get())),
                                xcb_get_property_value_length(value.get()));
  }
  xcb_disconnect(xcb);
  return titles;
}

}  // namespace

TEST(FinishStory, TheSilhouetteOfAMeshIsSmoothOnTheScreenAtRest) {
  Story story("26_bumpy_sphere");
  story.perform("view.theme.light");
  story.perform("layer.arm", false);
  story.settle(900);
  const QImage screen = story.view().screen()->grabWindow(story.view().window()->winId()).toImage();
  const QPoint corner = story.view().mapTo(story.view().window(), QPoint());
  EXPECT_GT(smoothShare(screen.copy(QRect(corner, story.view().size()))), 0.6);
}

TEST(FinishStory, TitlesHaveOneDashAndItIsNotAddedByQt) {
  for (const char* const language : {"en", "de"}) {
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("LANGUAGE", language);
    environment.insert("LC_ALL", QString(language) == "de" ? "de_DE.UTF-8" : "C.UTF-8");
    environment.insert("XDG_CONFIG_HOME", temporaryFile(QString("titles_") + language));
    program.setProcessEnvironment(environment);
    program.start(UNDERACT_WINDOW, {temporaryFile("titles.json", R"({"underact_scene": 1, "arm": "omny"})")});
    QStringList titles;
    const bool is_told = QTest::qWaitFor(
        [&] {
          return (titles = titlesOnScreen()).join(' ').contains("cene not") || titles.join(' ').contains("nicht");
        },
        20000);
    EXPECT_TRUE(is_told) << titles.join("; ").toStdString();
    for (const QString& title : titles)
      EXPECT_FALSE(title.contains(QChar(0x2014)) || title.contains(" - ")) << title.toStdString();
    program.kill();
    program.waitForFinished();
  }
}

}  // namespace underact::gui::test
