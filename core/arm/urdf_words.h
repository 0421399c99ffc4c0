#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"

namespace tinyxml2 {
class XMLElement;
}

namespace underact::arm {

/// What tinyxml2 reads an element as.
using tinyxml2::XMLElement;

/// Inside the room: reads words and numbers of the elements of one file, and collects its problems.
class UrdfWords {
 public:
  /// file: its name, for problems.
  explicit UrdfWords(const std::string& file) : file_(file) {}
  /// Not copied: into_ points into it.
  UrdfWords(const UrdfWords&) = delete;
  UrdfWords& operator=(const UrdfWords&) = delete;
  /// All problems.
  Problems take() { return std::move(problems_); }

 protected:
  /// A problem at an element.
  void say(const XMLElement& at, const std::string& key, Sentence sentence);
  /// A word that is nearly a known one is a typing error; another one belongs to another program.
  void checkWord(const XMLElement& element, const std::vector<std::string>& known);
  /// Checks attributes in the same way.
  void checkAttributes(const XMLElement& element, const std::vector<std::string>& known);
  /// Of an element that moves a link no word is skipped: it would move it otherwise, and nobody would know.
  void checkAll(const XMLElement& element, const std::vector<std::string>& known);
  /// The child of that name; a second one is an error, as it would be skipped.
  const XMLElement* only(const XMLElement& parent, const char* name);
  /// An attribute that the element needs; empty, with a problem, where it is missing.
  std::string attribute(const XMLElement& element, const char* key, const char* what);
  /// Numbers separated by white space, as many as there have to be.
  bool numbers(const XMLElement& element, const char* key, const char* text, std::span<double> into);
  /// Three numbers, or nothing where the attribute is missing.
  bool three(const XMLElement& element, const char* key, Vec3& into);
  /// A number, otherwise that of the caller.
  double one(const XMLElement& element, const char* key, double otherwise);

  std::string file_;
  Problems problems_;
  Problems* into_ = &problems_;  // where problems go
};

/// A problem at a line of a file.
Problem problemAt(const std::string& file, int line, const std::string& key, Sentence sentence);

}  // namespace underact::arm
