#include "app/gui/model/session_words.h"

#include <gtest/gtest.h>

#include <QDateTime>

#include "app/gui/model/session_paths.h"

namespace underact::gui::test {

TEST(SessionMetadata, LittleRoomOnTheDiskIsAmberBeforeItIsNone) {
  record::RecorderStatus status;
  EXPECT_FALSE(isDiskLow(status));
  status.disk_left_bytes = 50'000'000'000;
  EXPECT_FALSE(isDiskLow(status));
  status.disk_left_s = 599.0;
  EXPECT_TRUE(isDiskLow(status));
  status.disk_left_s = 601.0;
  EXPECT_FALSE(isDiskLow(status));
  EXPECT_EQ(diskText(status), "50.0 GB, enough for 10 min");
  status.disk_left_bytes = 999'999'999;
  EXPECT_TRUE(isDiskLow(status));
}

TEST(SessionMetadata, TimesAndSizesReadAsOneSaysThem) {
  EXPECT_EQ(clockText(0.0), "00:00");
  EXPECT_EQ(clockText(83.9), "01:23");
  EXPECT_EQ(clockText(3723.0), "1:02:03");
  EXPECT_EQ(spanText(1.24), "1.2 s");
  EXPECT_EQ(spanText(83.0), "1 min 23 s");
  EXPECT_EQ(spanText(7800.0), "2 h 10 min");
  EXPECT_EQ(spanText(9.0 * 86400.0), "9 days");
  EXPECT_EQ(bytesText(1), "1 kB");
  EXPECT_EQ(bytesText(4'200'000), "4.2 MB");
  EXPECT_EQ(bytesText(13'000'000'000), "13.0 GB");
  const QDateTime when(QDate(2026, 11, 21), QTime(19, 56, 47));
  EXPECT_EQ(newSessionFile("/none", when, "Circle in a tilted plane"),
            "/none/2026-11-21_19-56-47_circle-in-a-tilted-plane.underact.h5");
  EXPECT_EQ(newSessionFile("/none", when, QString::fromUtf8("Ü")), "/none/2026-11-21_19-56-47_session.underact.h5");
}

}  // namespace underact::gui::test
