#pragma once
#include <QHash>
#include <QIcon>
#include <QKeySequence>
#include <QObject>
#include <QSet>
#include <QVariantList>
#include <functional>
#include <optional>

class QAction;
class QWidget;

namespace underact::gui {

/// What an action is called and looks like, everywhere it appears.
struct ActionInfo {
  QString name;  // "session.start": what stories and shortcuts know it by
  QString text;  // in menus, with its mnemonic
  QKeySequence shortcut;
  QString tip;          // one sentence
  QString icon = {};    // of icons.h; empty: none
  QString button = {};  // a shorter text for the tool bar
  bool checkable = false;
};

/// Everything the window can be asked to do, under one name each: the menus, the tool bar, the shortcuts and the
/// stories all go through here, so that none of them can do what the others cannot.
class Actions : public QObject {
  Q_OBJECT
 public:
  /// arguments: none where a menu, button or shortcut asked; a checkable action gets its new state. false: not done.
  using Run = std::function<bool(const QVariantList& arguments)>;

  explicit Actions(QWidget* window);

  QAction* add(const ActionInfo& info, Run run);
  /// Something that takes an argument, and so stands in no menu ("gains.set").
  void addCommand(const QString& name, Run run);

  /// The action of that name, or null.
  QAction* find(const QString& name) const;
  /// In the order in which they were added.
  QStringList names() const { return names_; }

  /// Does it. false: no such name, not possible now, or it was refused.
  bool perform(const QString& name, const QVariantList& arguments);
  template <class... Argument>
  bool perform(const QString& name, const Argument&... arguments) {
    return perform(name, QVariantList{QVariant(arguments)...});
  }

  /// Only these do anything from now on, by whatever way they are asked for: menu, shortcut, button or name.
  void allowOnly(const QSet<QString>& names);
  void allowAll();
  bool isLocked() const { return allowed_.has_value(); }
  bool allows(const QString& name) const { return !allowed_ || allowed_->contains(name); }

  void setIcons(const std::function<QIcon(const QString& icon)>& painted);

 signals:
  void locked();  // only some are allowed from now on

 private:
  void enableGroups(bool on);

  QWidget* window_;
  QStringList names_;
  QHash<QString, QAction*> actions_;
  QHash<QString, QString> icons_;
  QHash<QString, Run> runs_;
  std::optional<QSet<QString>> allowed_;  // none: all
};

}  // namespace underact::gui
