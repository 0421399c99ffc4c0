#include "app/gui/sessions/session_lines.h"

#include <gtest/gtest.h>

#include <QPushButton>
#include <QSignalSpy>
#include <memory>

#include "app/gui/sessions/delete_question.h"
#include "app/gui/sessions/record_section.h"
#include "app/gui/sessions/session_index.h"
#include "core/record/recorder.h"

namespace underact::gui::test {
namespace {

SessionEntry recordedEntry() {
  SessionEntry entry;
  entry.path = "/home/2026-11-21.underact.h5";
  entry.size_bytes = 4'200'000;
  entry.info.header.scene_title = "Circle in a tilted plane";
  entry.info.header.rate_hz = 1000;
  entry.info.header.words.subject = "P7";
  entry.info.header.words.notes = "the chair was low";
  entry.info.duration_s = 83.0;
  entry.info.ticks = 83'000;
  entry.info.end.emplace();
  return entry;
}

}  // namespace

TEST(SessionLines, ASessionIsCalledByItsNameElseItsSceneElseItsFile) {
  SessionEntry entry = recordedEntry();
  EXPECT_EQ(titleOf(entry), QString("Circle in a tilted plane"));
  entry.info.header.words.name = "Pilot";
  EXPECT_EQ(titleOf(entry), QString("Pilot"));
  entry.info.header.words.name.clear();
  entry.info.header.scene_title.clear();
  EXPECT_TRUE(entry.path.contains(titleOf(entry)) && !titleOf(entry).isEmpty());
}

TEST(SessionLines, WhatIsAmissStandsFirst) {
  SessionEntry entry = recordedEntry();
  EXPECT_TRUE(linesOf(entry).contains("01:23") && linesOf(entry).contains("4.2 MB"));
  EXPECT_FALSE(linesOf(entry).contains("Recover"));
  entry.info.end.reset();
  EXPECT_TRUE(linesOf(entry).section('\n', 1).startsWith("not closed: Recover"));
  entry.info.dropped = 12;
  EXPECT_TRUE(detailsOf(entry).startsWith("Not closed:"));
  EXPECT_TRUE(detailsOf(entry).section('\n', 0, 0).contains("12 ticks are missing."));
  entry.wrong = "It is no session.";
  EXPECT_TRUE(detailsOf(entry).startsWith("It is no session."));
  EXPECT_TRUE(linesOf(entry).endsWith("cannot be read"));
}

TEST(SessionLines, MarkersCountFromTheFirstTickAndManyAreShortened) {
  SessionEntry entry = recordedEntry();
  entry.first_tick = 5000;
  for (int marker = 0; marker < 7; ++marker) entry.markers.push_back({.tick = 5000 + 61'000, .label = "here"});
  EXPECT_TRUE(detailsOf(entry).contains("01:01 here"));
  EXPECT_TRUE(detailsOf(entry).contains("and 2 more"));
}

TEST(SessionSearch, EveryWordHasToBeSomewhereInWhateverCase) {
  const SessionEntry entry = recordedEntry();
  EXPECT_TRUE(fitsSearch(entry, "CIRCLE chair"));
  EXPECT_TRUE(fitsSearch(entry, " "));
  EXPECT_FALSE(fitsSearch(entry, "circle table"));
}

TEST(DeleteQuestion, EscAndEnterLeaveTheSessionWhereItIs) {
  QWidget window;
  const std::unique_ptr<DeleteQuestion> question(askToDelete("Pilot", "/home/pilot.h5", &window));
  QSignalSpy bin(question.get(), &DeleteQuestion::binWanted), gone(question.get(), &DeleteQuestion::removalWanted);
  ASSERT_NE(question->defaultButton(), nullptr);
  EXPECT_EQ(question->buttonRole(question->defaultButton()), QMessageBox::RejectRole);
  EXPECT_EQ(question->escapeButton(), static_cast<QAbstractButton*>(question->defaultButton()));
  EXPECT_TRUE((question->text() + question->informativeText()).contains("Pilot"));
}

TEST(RecordSection, SaysInWhichFileItGoesOnAndHowManyTicksAreMissing) {
  record::RecorderStatus status;
  EXPECT_EQ(warningOf(status, false), "");
  status.files = {"/home/a.h5", "/home/a_2.h5"};
  status.dropped = 7;
  EXPECT_EQ(warningOf(status, false),
            "The recording was split into 2 files, because a session's length is limited. The last one is a_2.h5.\n"
            "7 ticks are missing: the computer was too busy to write them. The servo kept running.");
}

}  // namespace underact::gui::test
