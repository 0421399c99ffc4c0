#include "app/gui/kit/icons.h"

#include <QHash>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <functional>

#include "app/gui/kit/panel_icons.h"

namespace underact::gui {
namespace {

using Draw = DrawIcon;

QPen ink(const Theme& theme, double width = 1.6) {
  return QPen(theme.ink, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
}
QPen quiet(const Theme& theme) {
  return QPen(theme.quiet, 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
}
QBrush constraintFill(const Theme& theme) {
  QColor colour = theme.constraint;
  colour.setAlphaF(theme.dark ? 0.55F : 0.35F);
  return colour;
}
QPen edge(const Theme& theme) {
  return QPen(theme.dark ? theme.constraint.lighter(150) : theme.constraint, 1.6, Qt::SolidLine, Qt::RoundCap,
              Qt::RoundJoin);
}

const QPolygonF kFront{{{4, 9}, {15, 9}, {15, 20}, {4, 20}}};
const QPolygonF kTop{{{4, 9}, {9, 4}, {20, 4}, {15, 9}}};
const QPolygonF kSide{{{15, 9}, {20, 4}, {20, 15}, {15, 20}}};

// A cube with one face marked: the one that the view will face.
void cube(QPainter& painter, const Theme& theme, const QPolygonF* marked) {
  painter.setPen(ink(theme));
  for (const QPolygonF* face : {&kFront, &kTop, &kSide}) {
    painter.setBrush(face == marked ? constraintFill(theme) : QBrush(Qt::NoBrush));
    painter.drawPolygon(*face);
  }
}

void drawStart(QPainter& painter, const Theme& theme) {
  painter.setPen(QPen(theme.target, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(theme.target);
  painter.drawPolygon(QPolygonF{{{7, 4.5}, {19, 12}, {7, 19.5}}});
}
void drawStop(QPainter& painter, const Theme& theme) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(alarm(theme));
  painter.drawRoundedRect(QRectF(5, 5, 14, 14), 2, 2);
}
// A ring and a red dot: differs from Stop in shape.
void drawRecord(QPainter& painter, const Theme& theme) {
  painter.setPen(ink(theme));
  painter.drawEllipse(QPointF(12, 12), 8.5, 8.5);
  painter.setPen(Qt::NoPen);
  painter.setBrush(alarm(theme));
  painter.drawEllipse(QPointF(12, 12), 5, 5);
}
// A stylus between two fingers.
void drawHold(QPainter& painter, const Theme& theme) {
  painter.setPen(ink(theme, 2.6));
  painter.drawLine(QPointF(12, 3.5), QPointF(12, 20.5));
  painter.setPen(ink(theme));
  painter.setBrush(constraintFill(theme));
  painter.drawRoundedRect(QRectF(3, 8, 6, 8), 2.5, 2.5);
  painter.drawRoundedRect(QRectF(15, 8, 6, 8), 2.5, 2.5);
}
// Of a recording: in the ink colour, so that it is not mistaken for the servo's Start.
void drawPlay(QPainter& painter, const Theme& theme) {
  painter.setPen(ink(theme));
  painter.setBrush(theme.ink);
  painter.drawPolygon(QPolygonF{{{8, 5.5}, {18, 12}, {8, 18.5}}});
}
void drawPause(QPainter& painter, const Theme& theme) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.ink);
  painter.drawRect(QRectF(7, 5, 3.5, 14));
  painter.drawRect(QRectF(13.5, 5, 3.5, 14));
}
void drawForward(QPainter& painter, const Theme& theme) {
  painter.setPen(ink(theme));
  painter.setBrush(theme.ink);
  painter.drawLine(QPointF(6, 6), QPointF(6, 18));
  painter.drawPolygon(QPolygonF{{{10, 6.5}, {18, 12}, {10, 17.5}}});
}
void drawBack(QPainter& painter, const Theme& theme) {
  painter.translate(24, 0);
  painter.scale(-1, 1);
  drawForward(painter, theme);
}
void drawFit(QPainter& painter, const Theme& theme) {
  painter.setPen(ink(theme));
  for (const int turn : {0, 90, 180, 270}) {
    painter.save();
    painter.translate(12, 12);
    painter.rotate(turn);
    painter.drawPolyline(QPolygonF{{{-8, -3}, {-8, -8}, {-3, -8}}});
    painter.restore();
  }
  painter.setPen(edge(theme));
  painter.setBrush(constraintFill(theme));
  painter.drawEllipse(QPointF(12, 12), 3.5, 3.5);
}
void drawFront(QPainter& painter, const Theme& theme) {
  cube(painter, theme, &kFront);
}
void drawTop(QPainter& painter, const Theme& theme) {
  cube(painter, theme, &kTop);
}
void drawSide(QPainter& painter, const Theme& theme) {
  cube(painter, theme, &kSide);
}
void drawIsometric(QPainter& painter, const Theme& theme) {
  painter.setPen(ink(theme));
  painter.drawPolygon(QPolygonF{{{12, 3}, {20, 7.5}, {20, 16.5}, {12, 21}, {4, 16.5}, {4, 7.5}}});
  painter.drawPolyline(QPolygonF{{{4, 7.5}, {12, 12}, {20, 7.5}}});
  painter.drawLine(12, 12, 12, 21);
}
void drawLayers(QPainter& painter, const Theme& theme) {
  painter.setPen(ink(theme));
  painter.drawPolyline(QPolygonF{{{4, 16}, {12, 20}, {20, 16}}});
  painter.drawPolyline(QPolygonF{{{4, 12}, {12, 16}, {20, 12}}});
  painter.setBrush(constraintFill(theme));
  painter.drawPolygon(QPolygonF{{{12, 4}, {20, 8}, {12, 12}, {4, 8}}});
}
void questionMark(QPainter& painter) {
  QPainterPath path(QPointF(9.3, 9.8));
  path.cubicTo(9.3, 6.2, 14.9, 6.4, 14.7, 9.8);
  path.cubicTo(14.6, 11.8, 12, 11.8, 12, 14);
  painter.drawPath(path);
  painter.drawPoint(QPointF(12, 16.8));
}
void drawHelp(QPainter& painter, const Theme& theme) {
  painter.setPen(ink(theme));
  painter.drawEllipse(QPointF(12, 12), 8.5, 8.5);
  questionMark(painter);
}
// What message boxes say: a form and a colour for each.
void sign(QPainter& painter, const QColor& colour, const QPolygonF& form) {
  painter.setPen(QPen(colour, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(faint(colour, 0.18));
  form.isEmpty() ? painter.drawEllipse(QPointF(12, 12), 8.5, 8.5) : painter.drawPolygon(form);
  painter.setPen(QPen(colour, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
}
void drawQuestion(QPainter& painter, const Theme& theme) {
  sign(painter, edge(theme).color(), {});
  questionMark(painter);
}
void drawInformation(QPainter& painter, const Theme& theme) {
  sign(painter, edge(theme).color(), {});
  painter.drawLine(QPointF(12, 11.5), QPointF(12, 16));
  painter.drawPoint(QPointF(12, 8));
}
void drawWarning(QPainter& painter, const Theme& theme) {
  sign(painter, amber(theme), QPolygonF{{{12, 4}, {21, 19.5}, {3, 19.5}}});
  painter.drawLine(QPointF(12, 10), QPointF(12, 13.5));
  painter.drawPoint(QPointF(12, 16.7));
}
void drawCritical(QPainter& painter, const Theme& theme) {
  sign(painter, alarm(theme),
       QPolygonF{
           {{8.5, 3.5}, {15.5, 3.5}, {20.5, 8.5}, {20.5, 15.5}, {15.5, 20.5}, {8.5, 20.5}, {3.5, 15.5}, {3.5, 8.5}}});
  painter.drawLine(QPointF(9, 9), QPointF(15, 15));
  painter.drawLine(QPointF(15, 9), QPointF(9, 15));
}
void drawOpen(QPainter& painter, const Theme& theme) {
  painter.setPen(ink(theme));
  painter.drawPolyline(QPolygonF{{{19, 10}, {19, 7}, {11, 7}, {9, 5}, {4, 5}, {4, 19}}});
  painter.drawPolygon(QPolygonF{{{4, 19}, {7, 10}, {21, 10}, {18, 19}}});
}
void drawSave(QPainter& painter, const Theme& theme) {
  painter.setPen(ink(theme));
  painter.drawPolygon(QPolygonF{{{4.5, 4.5}, {16, 4.5}, {19.5, 8}, {19.5, 19.5}, {4.5, 19.5}}});
  painter.drawRect(QRectF(8, 13, 8, 6.5));
  painter.drawLine(QPointF(8, 4.5), QPointF(8, 8.5));
  painter.drawLine(QPointF(8, 8.5), QPointF(14, 8.5));
}
void drawUndo(QPainter& painter, const Theme& theme) {
  painter.setPen(ink(theme));
  painter.drawPolyline(QPolygonF{{{8, 5}, {4, 9}, {8, 13}}});
  QPainterPath path(QPointF(4, 9));
  path.lineTo(14, 9);
  path.cubicTo(21.5, 9, 21.5, 19, 14, 19);
  path.lineTo(9, 19);
  painter.drawPath(path);
}
void drawRedo(QPainter& painter, const Theme& theme) {
  painter.translate(24, 0);
  painter.scale(-1, 1);
  drawUndo(painter, theme);
}
void drawReset(QPainter& painter, const Theme& theme) {
  painter.setPen(ink(theme));
  painter.drawArc(QRectF(5, 5, 14, 14), -40 * 16, 290 * 16);
  painter.drawPolyline(QPolygonF{{{19.8, 11.2}, {17.3, 16.6}, {12.6, 14.6}}});
}
void drawFile(QPainter& painter, const Theme& theme) {
  painter.setPen(ink(theme));
  painter.drawPolygon(QPolygonF{{{6, 3.5}, {14, 3.5}, {18, 7.5}, {18, 20.5}, {6, 20.5}}});
  painter.drawLine(QPointF(9, 12), QPointF(15, 12));
  painter.drawLine(QPointF(9, 16), QPointF(15, 16));
}
void drawPoint(QPainter& painter, const Theme& theme) {
  painter.setPen(quiet(theme));
  painter.drawLine(12, 3, 12, 21);
  painter.drawLine(3, 12, 21, 12);
  painter.setPen(Qt::NoPen);
  painter.setBrush(edge(theme).color());
  painter.drawEllipse(QPointF(12, 12), 3.6, 3.6);
}
void drawSphere(QPainter& painter, const Theme& theme) {
  painter.setPen(edge(theme));
  painter.setBrush(constraintFill(theme));
  painter.drawEllipse(QPointF(12, 12), 8.5, 8.5);
  painter.setBrush(Qt::NoBrush);
  painter.drawArc(QRectF(3.5, 8.5, 17, 7), 180 * 16, 180 * 16);
}
void drawLine(QPainter& painter, const Theme& theme) {
  painter.setPen(QPen(edge(theme).color(), 2.2, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(4, 19, 20, 5);
}
void drawPlane(QPainter& painter, const Theme& theme) {
  painter.setPen(edge(theme));
  painter.setBrush(constraintFill(theme));
  painter.drawPolygon(QPolygonF{{{2.5, 17}, {8, 9}, {21.5, 9}, {16, 17}}});
  painter.setPen(ink(theme));
  painter.drawLine(QPointF(12, 13), QPointF(12, 4));
}
void drawCircle(QPainter& painter, const Theme& theme) {
  painter.setPen(QPen(edge(theme).color(), 2.2));
  painter.translate(12, 12);
  painter.rotate(-25);
  painter.drawEllipse(QPointF(0, 0), 9, 5);
}
void drawCylinder(QPainter& painter, const Theme& theme) {
  painter.setPen(edge(theme));
  painter.setBrush(constraintFill(theme));
  QPainterPath side(QPointF(6, 6));
  side.lineTo(6, 18);
  side.arcTo(QRectF(6, 15.5, 12, 5), 180, 180);
  side.lineTo(18, 6);
  side.arcTo(QRectF(6, 3.5, 12, 5), 0, -180);
  painter.drawPath(side);
  painter.drawEllipse(QRectF(6, 3.5, 12, 5));
}
void drawBox(QPainter& painter, const Theme& theme) {
  painter.setPen(edge(theme));
  painter.setBrush(constraintFill(theme));
  for (const QPolygonF* face : {&kFront, &kTop, &kSide}) painter.drawPolygon(*face);
}
// Two links and two hollow joints, in the colour of virtual robots.
void drawRobot(QPainter& painter, const Theme& theme) {
  painter.setPen(QPen(theme.virtual_robot, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawLine(QPointF(3, 20.5), QPointF(11, 20.5));
  painter.drawLine(QPointF(7.8, 14.7), QPointF(10.4, 9.4));
  painter.drawLine(QPointF(13.8, 8.0), QPointF(20.5, 11.5));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(QPointF(6.7, 17), 2.5, 2.5);
  painter.drawEllipse(QPointF(11.5, 7), 2.5, 2.5);
}
void drawMesh(QPainter& painter, const Theme& theme) {
  painter.setPen(edge(theme));
  painter.setBrush(constraintFill(theme));
  const QPointF middle(11, 11), around[] = {{12, 3}, {20, 8.5}, {18, 18}, {8, 20.5}, {3, 12}};
  for (int corner = 0; corner < 5; ++corner)
    painter.drawPolygon(QPolygonF{{middle, around[corner], around[(corner + 1) % 5]}});
}
void drawCurve(QPainter& painter, const Theme& theme) {
  painter.setPen(QPen(edge(theme).color(), 2.2, Qt::SolidLine, Qt::RoundCap));
  QPainterPath path(QPointF(3, 17));
  path.cubicTo(QPointF(9, -4), QPointF(12, 26), QPointF(21, 6));
  painter.drawPath(path);
}
void drawVisitor(QPainter& painter, const Theme& theme) {
  painter.setPen(ink(theme, 1.8));
  painter.drawEllipse(QPointF(12, 8), 4, 4);
  painter.drawArc(QRectF(4, 14.5, 16, 14), 0, 180 * 16);
}
void drawUnderact(QPainter& painter, const Theme& theme) {
  drawSphere(painter, theme);
  painter.setPen(QPen(theme.force, 2.4, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(17, 7), QPointF(21.5, 2.5));
  painter.setPen(ink(theme, 2.4));
  painter.drawLine(QPointF(17, 7), QPointF(11, 13));
}

const QHash<QString, Draw>& drawings() {
  static const QHash<QString, Draw> kAll{{"start", drawStart},       {"stop", drawStop},
                                         {"record", drawRecord},     {"play", drawPlay},
                                         {"pause", drawPause},       {"back", drawBack},
                                         {"forward", drawForward},   {"fit", drawFit},
                                         {"front", drawFront},       {"top", drawTop},
                                         {"side", drawSide},         {"isometric", drawIsometric},
                                         {"layers", drawLayers},     {"help", drawHelp},
                                         {"open", drawOpen},         {"save", drawSave},
                                         {"undo", drawUndo},         {"redo", drawRedo},
                                         {"reset", drawReset},       {"file", drawFile},
                                         {"point", drawPoint},       {"sphere", drawSphere},
                                         {"line", drawLine},         {"plane", drawPlane},
                                         {"circle", drawCircle},     {"cylinder", drawCylinder},
                                         {"box", drawBox},           {"virtual_manipulator", drawRobot},
                                         {"mesh", drawMesh},         {"curve", drawCurve},
                                         {"underact", drawUnderact}, {"hold", drawHold},
                                         {"visitor", drawVisitor},   {"question", drawQuestion},
                                         {"warning", drawWarning},   {"information", drawInformation},
                                         {"critical", drawCritical}};
  return kAll;
}

// Drawn on demand at the requested size and density, so that no bitmap is scaled on a 4K screen.
class Engine : public QIconEngine {
 public:
  Engine(Draw draw, const Theme& theme) : draw_(draw), theme_(theme) {}
  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (mode == QIcon::Disabled) painter->setOpacity(0.35);
    const int side = qMin(rect.width(), rect.height());
    painter->translate(rect.x() + (rect.width() - side) / 2, rect.y() + (rect.height() - side) / 2);
    painter->scale(side / 24.0, side / 24.0);
    draw_(*painter, theme_);
    painter->restore();
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return pixmap;
  }
  QIconEngine* clone() const override { return new Engine(*this); }

 private:
  Draw draw_;
  Theme theme_;
};

class FileEngine : public QIconEngine {
 public:
  explicit FileEngine(const QString& path) : path_(path) {}
  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    file().paint(painter, rect, Qt::AlignCenter, mode, state);
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    return file().pixmap(size, mode, state);
  }
  QIconEngine* clone() const override { return new FileEngine(*this); }

 private:
  const QIcon& file() {
    if (read_.isNull()) read_ = QIcon(path_);
    return read_;
  }

  QString path_;
  QIcon read_;
};

}  // namespace

QIcon icon(const QString& name, const Theme& theme) {
  const Draw draw = drawings().value(name, panelDrawings().value(name, nullptr));
  return draw == nullptr ? QIcon() : QIcon(new Engine(draw, theme));
}

QIcon fileIcon(const QString& path) {
  return QIcon(new FileEngine(path));
}

QColor alarm(const Theme& theme) {
  return theme.dark ? QColor(0xFF, 0x6B, 0x5E) : QColor(0xB3, 0x1B, 0x1B);
}

QColor amber(const Theme& theme) {
  return theme.dark ? QColor(0xF2, 0xB1, 0x34) : QColor(0xB3, 0x6B, 0x00);
}

}  // namespace underact::gui
