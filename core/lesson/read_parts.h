#pragma once
#include <string>
#include <vector>

#include "core/json/object_reader.h"
#include "core/lesson/lesson.h"

namespace underact::lesson {

// Inside the room: what the readers of a lesson's parts share.
using json::Findings;
using json::ObjectReader;

/// One of known; else a problem, with the nearest of them suggested. what: "layer".
std::string readName(const json::Value& value, const std::string& path, const std::vector<std::string>& known,
                     const Sentence& what, Findings& findings);

/// A text of one line.
std::string readLine(ObjectReader& object, const char* key, bool required);

/// A text, or a list of its lines.
std::string readProse(ObjectReader& object, const char* key, bool required);

/// A check of a step.
Check readCheck(const json::Value& value, const std::string& path, Findings& findings);

}  // namespace underact::lesson
