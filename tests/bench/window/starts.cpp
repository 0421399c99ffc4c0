#include "tests/bench/window/starts.h"

#include <QProcess>
#include <QRegularExpression>
#include <QThread>
#include <algorithm>
#include <cstdio>
#include <vector>

#include "tests/support/resident_memory.h"

namespace underact::gui {
namespace {

constexpr int kStarts = 11;
constexpr int kPlotsRun_ms = 5'000;

void printRange(const char* what, std::vector<double> values, const char* unit) {
  if (values.empty()) return;
  std::sort(values.begin(), values.end());
  std::printf("%-34s median %6.0f  least %6.0f  most %6.0f %s\n", what, values[values.size() / 2], values.front(),
              values.back(), unit);
}

}  // namespace

void measureStarts() {
  std::vector<double> first_ms, processor_ms, resident;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("UNDERACT_TIMING", "1");
  for (int start = 0; start < kStarts; ++start) {
    QProcess program;
    program.setProcessEnvironment(environment);
    program.start(UNDERACT_WINDOW, {QString(UNDERACT_SOURCE) + "/scenes/02_sphere.json"});
    QString given;
    QRegularExpressionMatch first;
    for (int waited = 0; waited < 300 && !first.hasMatch(); ++waited) {
      static const QRegularExpression kFirst("first picture after (\\d+) ms \\((\\d+) ms of CPU time\\)");
      program.waitForReadyRead(100);
      given += QString::fromLocal8Bit(program.readAllStandardError());  // Qt may have something to say before
      first = kFirst.match(given);
    }
    if (!first.hasMatch()) std::printf("no picture: %s\n", qUtf8Printable(given));
    if (first.hasMatch()) {
      first_ms.push_back(first.captured(1).toDouble());
      processor_ms.push_back(first.captured(2).toDouble());
      QThread::msleep(kPlotsRun_ms);
      resident.push_back(1e-6 * underact::test::residentBytes(static_cast<long>(program.processId())));
    }
    program.kill();
    program.waitForFinished();
  }
  printRange("first picture after main", first_ms, "ms");
  printRange("of CPU time", processor_ms, "ms");
  printRange("resident, one scene, after 5 s", resident, "MB");
}

}  // namespace underact::gui
