#pragma once
#include "app/cli/command.h"

namespace underact::cli {

/// lesson try: a scripted hand in a student's place.
void addLessonTry(Command command, const Streams& streams, Exit& exit);

}  // namespace underact::cli
