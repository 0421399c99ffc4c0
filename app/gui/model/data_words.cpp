#include "app/gui/model/data_words.h"

#include <QCoreApplication>

namespace underact::gui {
namespace {

/// A multi-line text ends with an empty line, which translations do not have.
void translate(const char* context, std::string& text) {
  while (text.ends_with('\n')) text.pop_back();
  if (!text.empty()) text = QCoreApplication::translate(context, text.c_str()).toStdString();
}

void translate(lesson::Check& check) {
  constexpr const char* kContext = "lesson text";
  translate(kContext, check.say);
  for (lesson::Misconception& one : check.misconceptions) translate(kContext, one.name);
  if (auto* ask = std::get_if<lesson::AskNumber>(&check.task)) translate(kContext, ask->question);
  if (auto* ask = std::get_if<lesson::AskChoice>(&check.task)) {
    translate(kContext, ask->question);
    for (std::string& choice : ask->choices) translate(kContext, choice);
  }
}

}  // namespace

QString sceneText(const std::string& text) {
  return text.empty() ? QString() : QCoreApplication::translate("scene text", text.c_str());
}

scene::Teaching translated(scene::Teaching teaching) {
  for (std::string* text : {&teaching.feel, &teaching.try_this, &teaching.equation}) translate("scene text", *text);
  return teaching;
}

lesson::Lesson translated(lesson::Lesson lesson) {
  for (std::string* text : {&lesson.title, &lesson.group, &lesson.about}) translate("lesson text", *text);
  for (lesson::Step& step : lesson.steps) {
    for (std::string* text : {&step.title, &step.text, &step.hint}) translate("lesson text", *text);
    for (lesson::Check& check : step.checks) translate(check);
  }
  return lesson;
}

}  // namespace underact::gui
