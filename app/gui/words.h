#pragma once
#include <QString>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/servo/scheduling.h"

namespace underact::gui {

/// The sentences alone, one a line: for a panel that the reader is already looking at.
QString sentencesOf(const Problems& problems);

/// A length on the screen, 0.1 mm.
QString millimetres(double length_mm);

/// "10.0, 20.0, 30.0 mm"
QString placeText(const Vec3& p_mm);

/// "-0.577, 0.577, -0.577": a direction, made unit length.
QString directionText(const Vec3& direction);

/// A number with a real minus sign, so that columns line up; -0.0 is 0.0.
QString numberText(double value, int decimals);

/// "real time: FIFO 80"
QString schedulingText(const servo::Scheduling& scheduling);

/// "memory locked, all cores"
QString phrasesOf(const std::vector<std::string>& phrases);

}  // namespace underact::gui
