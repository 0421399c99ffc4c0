#include "app/gui/files/add_dialog.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/view/workspace_picture.h"

namespace underact::gui {

AddDialog::AddDialog(const QString& name, const QString& title, const QString& path, const QString& counts,
                     QWidget* parent)
    : QDialog(parent),
      path_(QFileInfo(path).absoluteFilePath()),
      column_(new QVBoxLayout(this)),
      counts_(messageLabel(qPrintable(name + ".counts"), counts, "", this)),
      refusal_(messageLabel(qPrintable(name + ".refusal"), tr("Why it was not added"), "alarm", this)),
      foot_(new QHBoxLayout) {
  setObjectName(name);
  setAttribute(Qt::WA_DeleteOnClose);
  setModal(false);  // the arm stays usable
  setWindowTitle(title.arg(QFileInfo(path).fileName()));
  column_->setContentsMargins(16, 16, 16, 16);
  column_->setSpacing(12);
  column_->addWidget(counts_);
  refusal_->hide();
  foot_->setSpacing(8);
}

QPushButton* AddDialog::footButton(const char* name, const QString& text, const QString& tip) {
  QPushButton* made = pushButton(objectName() + '.' + name, text, tip, this);
  made->setAutoDefault(true);
  foot_->addWidget(made);
  return made;
}

void AddDialog::layFoot(bool can_add, const QString& add, const QString& fresh) {
  column_->addWidget(refusal_);
  column_->addStretch();
  foot_->addStretch(1);
  if (!add.isEmpty()) {
    QPushButton* adds = footButton("add", tr("&Add to the scene"), add);
    QPushButton* opens = footButton("new", tr("&Open as a new scene"), fresh);
    adds->setEnabled(can_add);
    (can_add ? adds : opens)->setDefault(true);
    connect(adds, &QPushButton::clicked, this, &AddDialog::addAsked);
    connect(opens, &QPushButton::clicked, this, &AddDialog::newSceneAsked);
  }
  QPushButton* close = footButton("close", add.isEmpty() ? tr("&Close") : tr("&Cancel"),
                                  tr("Closes this dialog. The scene is not changed."));
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  column_->addLayout(foot_);
}

void AddDialog::setRefusal(const QString& sentences) {
  showMessage(refusal_, sentences);
}

Eigen::Matrix4d AddDialog::placeWithin(const Vec3& middle_mm) {
  Eigen::Matrix4d X_WM = Eigen::Matrix4d::Identity();
  const bool is_within = (middle_mm.cwiseAbs() - workspaceHalf_mm()).maxCoeff() <= 0.0;
  if (!is_within) X_WM.topRightCorner<3, 1>() = -middle_mm;
  return X_WM;
}

std::string AddDialog::nameOfFile() const {
  return QFileInfo(path_).completeBaseName().toStdString();
}

}  // namespace underact::gui
