#pragma once
#include <QHash>
#include <QIcon>
#include <QKeySequence>
#include <QObject>
#include <QSet>
#include <QVariantList>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

class QAction;
class QWidget;

namespace underact::gui {

/// Name and appearance of an action, wherever it appears.
struct ActionInfo {
  QString name;  // "session.start": its key for stories and shortcuts
  QString text;  // in menus, with its mnemonic
  QKeySequence shortcut;
  QString tip;          // one sentence
  QString icon = {};    // of icons.h; empty: none
  QString button = {};  // a shorter text for the tool bar
  bool checkable = false;
};

/// Something to open by its name, besides the actions themselves: a scene, a lesson, a page of the guide.
struct Choice {
  QString text;
  QString kind;    // "Scene"
  QString action;  // performed with that argument
  QString argument;
};

/// Everything the window can be asked to do, by name. Menus, tool bar, shortcuts and stories all go through here, so
/// that all of them can do the same.
class Actions : public QObject {
  Q_OBJECT
 public:
  /// arguments: none from a menu, button or shortcut; a checkable action gets its new state. false: not done.
  using Run = std::function<bool(const QVariantList& arguments)>;

  explicit Actions(QWidget* window);

  QAction* add(const ActionInfo& info, Run run);
  /// An action that needs an argument and is therefore in no menu ("gains.set").
  void addCommand(const QString& name, Run run);

  /// The action of that name, or null.
  QAction* find(const QString& name) const;
  /// All names, in the order in which they were added.
  QStringList names() const { return names_; }

  /// Performs the action. false: no such name, not possible now, or refused.
  bool perform(const QString& name, const QVariantList& arguments);
  template <class... Argument>
  bool perform(const QString& name, const Argument&... arguments) {
    return perform(name, QVariantList{QVariant(arguments)...});
  }

  /// make is asked anew each time.
  void addChoices(std::function<std::vector<Choice>()> make) { choices_.push_back(std::move(make)); }
  std::vector<Choice> choices() const;

  /// From now on only these have an effect, whether asked for by menu, shortcut, button or name.
  void allowOnly(const QSet<QString>& names);
  void allowAll();
  bool isLocked() const { return allowed_.has_value(); }
  bool allows(const QString& name) const { return !allowed_ || allowed_->contains(name); }

  void setIcons(const std::function<QIcon(const QString& icon)>& painted);

 signals:
  void locked();  // from now on only some are allowed

 private:
  void enableGroups(bool on);

  QWidget* window_;
  QStringList names_;
  QHash<QString, QAction*> actions_;
  QHash<QString, QString> icons_;
  QHash<QString, Run> runs_;
  std::vector<std::function<std::vector<Choice>()>> choices_;
  std::optional<QSet<QString>> allowed_;  // none: all
};

}  // namespace underact::gui
