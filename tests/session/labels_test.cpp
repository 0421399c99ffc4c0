// Labels of markers are all kept by whoever opens a session: a stranger's may not fill the memory.
#include <gtest/gtest.h>

#include "core/record/session.h"
#include "core/record/session_writer.h"
#include "tests/session/rig.h"

namespace underact::record {
namespace {

/// A session with these labels, one a tick; what was said of its damage.
std::vector<Marker> markersOf(const std::string& path, const std::vector<std::string>& labels, Problems& damage) {
  SessionLimits none;  // as a stranger's writer has them
  none.all_label_bytes = INT64_MAX;
  Result<SessionWriter> writer = SessionWriter::create(path, {}, system::Existing::Refuse, none);
  EXPECT_TRUE(writer);
  EXPECT_TRUE(writer.value().begin(0, 0, {}, test::sphereScene()).empty());
  std::int64_t tick = 0;
  for (const std::string& label : labels) EXPECT_TRUE(writer.value().mark(++tick, label).empty());
  EXPECT_TRUE(writer.value().end({}).empty());
  const Result<Session> session = Session::open(path);
  EXPECT_TRUE(session);
  damage = session.value().info().damage;
  return session.value().markers();
}

}  // namespace

TEST(Labels, LongerThanMayBeAreCutBetweenLettersWhenTheyAreWritten) {
  const test::ScratchFolder folder;
  const std::string longest(kSessionLimits.label_bytes, 'a'), o_umlaut = "\xC3\xB6";
  const std::string no_letters(longest.size() + 7, '\x80');
  const std::vector<std::string> cut{longest, longest, longest.substr(1), longest.substr(2) + o_umlaut, ""};
  Problems damage;
  const std::vector<Marker> markers = markersOf(
      folder.file("s.h5"),
      {longest, longest + "b", longest.substr(1) + o_umlaut, longest.substr(2) + o_umlaut, no_letters}, damage);
  ASSERT_EQ(markers.size(), cut.size());
  EXPECT_TRUE(damage.empty());
  for (std::size_t index = 0; index < cut.size(); ++index) EXPECT_EQ(markers[index].label, cut[index]) << index;
}

TEST(Labels, OfWhichThereAreTooManyAreDamageAndNotKept) {
  const test::ScratchFolder folder;
  const auto max = static_cast<std::size_t>(kSessionLimits.all_label_bytes / kSessionLimits.label_bytes);
  Problems damage;
  const std::vector<Marker> markers = markersOf(
      folder.file("s.h5"), std::vector<std::string>(max + 3, std::string(kSessionLimits.label_bytes, 'x')), damage);
  ASSERT_EQ(markers.size(), max + 3);
  EXPECT_EQ(damage.size(), 3U);
  EXPECT_EQ(markers[max - 1].label.size(), static_cast<std::size_t>(kSessionLimits.label_bytes));
  EXPECT_EQ(markers[max].label, "?");
}

}  // namespace underact::record
