#pragma once

// Marks a text for translators, whose tool looks for this name in the sources (packaging/languages); the text stands as
// it is. context: "problem" for what sentence.h puts together.
#define TRANSLATE_NOOP(context, text) text
