#pragma once
#include "app/gui/sessions/session_index.h"

namespace underact::gui {

/// Two lines for a list: what the session is called; when, how long, how large, of whom, and whether it was closed.
QString linesOf(const SessionEntry& entry);

/// All that is worth knowing of it, what is amiss first.
QString detailsOf(const SessionEntry& entry);

}  // namespace underact::gui
