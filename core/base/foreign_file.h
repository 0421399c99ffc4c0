#pragma once
#include <string_view>

#include "core/base/sentence.h"

namespace underact {

/// What a file is and the way out, where its first bytes say that nothing here reads it: a pointer of Git LFS, a web
/// page, a file that is compressed, in UTF-16, a CAD model, a document or a picture. Empty: they do not. A binary STL
/// is to be recognised before, by its size: it may begin with anything.
Sentence foreignKind(std::string_view head);

}  // namespace underact
