#pragma once

// Marks a text for translators, whose tool looks for this name in the sources; here, where no Qt is, it stands as it
// is.
#define QT_TRANSLATE_NOOP(context, text) text
