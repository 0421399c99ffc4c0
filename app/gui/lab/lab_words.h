#pragma once
#include <QString>
#include <string>

#include "core/tradeoff/choices.h"

namespace underact::gui {

// Numbers as the Lab panel and its chart write them: three significant digits, in the unit that makes them short.
QString timeText(double us);                           // "812 ns", "1.24 µs", "3.1 ms"
QString lengthText(double mm);                         // "31 µm", "0.12 mm"
QString errorText(double error, const QString& unit);  // of a choice; a length as above
QString durationText(double seconds);                  // "20 s", "3 min": for "about"
QString optionText(const std::string& name);           // of a choice: "closed form", "trapezoidal, 200 µs"
QString choiceName(const tradeoff::Choice& choice);    // "Servo rate"

}  // namespace underact::gui
