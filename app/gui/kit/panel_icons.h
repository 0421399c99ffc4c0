#pragma once
#include <QHash>
#include <QPainter>
#include <QString>

#include "app/gui/kit/theme.h"

namespace underact::gui {

using DrawIcon = void (*)(QPainter& painter, const Theme& theme);  // in a square of 24 x 24

/// The drawings of the panels' icons, by the panel's key ("feel"); and "more".
const QHash<QString, DrawIcon>& panelDrawings();

}  // namespace underact::gui
