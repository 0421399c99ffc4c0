#pragma once

// Marks a text for translators; their tool looks for this name in the sources (packaging/languages). The text itself is
// unchanged. context: "problem" for sentences of sentence.h.
#define TRANSLATE_NOOP(context, text) text
