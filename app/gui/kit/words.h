#pragma once
#include <QString>
#include <vector>

#include "core/base/fault.h"
#include "core/base/result.h"
#include "core/base/sentence.h"
#include "core/base/types.h"

namespace underact::gui {

/// In the window's language, for functions that are no members.
QString tr(const char* text);

/// What the parts below the window say, in its language; English where that has no words for it.
QString sentenceText(const Sentence& sentence);

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

/// "memory locked, all cores"
QString phrasesOf(const std::vector<Sentence>& phrases);

}  // namespace underact::gui
