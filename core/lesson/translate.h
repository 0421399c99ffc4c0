#pragma once

// Inside the room: marks a text for translators, whose tool looks for this name in the sources; here it stands as it
// is.
#define QT_TRANSLATE_NOOP(context, text) text
