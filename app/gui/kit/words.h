#pragma once
#include <QString>
#include <vector>

#include "core/base/fault.h"
#include "core/base/result.h"
#include "core/base/sentence.h"
#include "core/base/types.h"

namespace underact::gui {

/// Translates to the window's language, for functions that are not members.
QString tr(const char* text);

/// A message of the parts below the window in its language, or in English if it has no translation.
QString sentenceText(const Sentence& sentence);

/// A name for the text of a menu, a button or a tab, where an & would underline the letter behind it.
QString menuText(QString name);

/// Letters and digits of any script with single hyphens between: a part of a file's name; empty: there are none.
QString fileNameOf(const QString& words);

/// Only the sentences, one per line, for a panel that the user is already looking at.
QString sentencesOf(const Problems& problems);

/// A length on the screen, 0.1 mm.
QString millimetres(double length_mm);

/// "10.0, 20.0, 30.0 mm"
QString placeText(const Vec3& p_mm);

/// "-0.577, 0.577, -0.577": a direction, normalised.
QString directionText(const Vec3& direction);

/// A number with a true minus sign, so that columns line up; -0.0 becomes 0.0.
QString numberText(double value, int decimals);

/// "memory locked, all cores"
QString phrasesOf(const std::vector<Sentence>& phrases);

}  // namespace underact::gui
