#pragma once
#include "app/gui/sessions/session_index.h"

namespace underact::gui {

/// Two lines for a list: the title; date, duration, size, subject, and whether the session was closed.
QString linesOf(const SessionEntry& entry);

/// All details, losses and errors first.
QString detailsOf(const SessionEntry& entry);

}  // namespace underact::gui
