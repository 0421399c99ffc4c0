#pragma once
#include <string_view>

#include "core/base/sentence.h"

namespace underact {

/// What a file is and the way out, where its first bytes say that nothing here reads it: a pointer of Git LFS, a web
/// page, an archive, a text in UTF-16, a CAD model, a document, a picture, a film or a program. Empty: they do not. A
/// binary STL is to be recognised before, by its size: it may begin with anything.
Sentence foreignKind(std::string_view head);

/// "This is a text file. Underact opens scenes, ...": what: "a text file".
Sentence notOpened(Sentence what);

/// The name of the first element of a text of XML; empty: it is none.
std::string_view xmlRoot(std::string_view head);

}  // namespace underact
