// The icons of the panels, by their keys.
#include "app/gui/kit/panel_icons.h"

#include <QPainterPath>

namespace underact::gui {
namespace {

QPen pen(const Theme& theme, double width = 1.6) {
  return QPen(theme.ink, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
}

QPen blue(const Theme& theme, double width = 1.8) {
  return QPen(theme.dark ? theme.constraint.lighter(150) : theme.constraint, width, Qt::SolidLine, Qt::RoundCap,
              Qt::RoundJoin);
}

void lines(QPainter& painter, const QPen& with, std::initializer_list<QLineF> all) {
  painter.setPen(with);
  painter.setBrush(Qt::NoBrush);
  for (const QLineF& line : all) painter.drawLine(line);
}

void rings(QPainter& painter, const QPen& with, std::initializer_list<QPointF> centres, double radius) {
  painter.setPen(with);
  painter.setBrush(Qt::NoBrush);
  for (const QPointF& centre : centres) painter.drawEllipse(centre, radius, radius);
}

// Four pictures.
void scenes(QPainter& painter, const Theme& theme) {
  painter.setPen(pen(theme));
  for (const QPointF& corner : {QPointF(4, 4), QPointF(13, 4), QPointF(4, 13), QPointF(13, 13)})
    painter.drawRoundedRect(QRectF(corner, QSizeF(7, 7)), 1, 1);
}
// A board with a tick.
void lessons(QPainter& painter, const Theme& theme) {
  painter.setPen(pen(theme));
  painter.drawRoundedRect(QRectF(3, 4, 18, 12), 1, 1);
  lines(painter, pen(theme), {{12, 16, 8, 21}, {12, 16, 16, 21}});
  lines(painter, QPen(theme.target, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin),
        {{8, 10, 11, 13}, {11, 13, 16, 7}});
}
// Three sliders.
void feel(QPainter& painter, const Theme& theme) {
  lines(painter, pen(theme), {{4, 6, 20, 6}, {4, 12, 20, 12}, {4, 18, 20, 18}});
  painter.setPen(blue(theme));
  painter.setBrush(theme.background);
  for (const QPointF& knob : {QPointF(9, 6), QPointF(16, 12), QPointF(7, 18)}) painter.drawEllipse(knob, 2.4, 2.4);
}
void shape(QPainter& painter, const Theme& theme) {
  painter.setPen(blue(theme));
  painter.drawEllipse(QPointF(12, 12), 8, 8);
  lines(painter, pen(theme, 1.2), {{12, 12, 17.5, 6.5}});
  painter.setBrush(theme.ink);
  painter.drawEllipse(QPointF(12, 12), 1, 1);
}
void arm(QPainter& painter, const Theme& theme) {
  lines(painter, pen(theme, 2.2), {{6, 20, 9, 10}, {9, 10, 18, 5}});
  rings(painter, pen(theme), {{9, 10}}, 2.0);
  lines(painter, pen(theme), {{3, 20, 12, 20}});
}
void plots(QPainter& painter, const Theme& theme) {
  lines(painter, pen(theme), {{4, 4, 4, 20}, {4, 20, 21, 20}});
  painter.setPen(blue(theme));
  painter.drawPolyline(QPolygonF{{{6, 16}, {10, 9}, {14, 13}, {20, 5}}});
}
void kinematics(QPainter& painter, const Theme& theme) {
  lines(painter, pen(theme, 2.0), {{5, 19, 11, 8}, {11, 8, 20, 12}});
  rings(painter, blue(theme), {{5, 19}, {11, 8}, {20, 12}}, 2.2);
}
void dh(QPainter& painter, const Theme& theme) {
  painter.setPen(pen(theme));
  painter.drawRect(QRectF(4, 5, 16, 14));
  lines(painter, pen(theme, 1.2), {{4, 10, 20, 10}, {4, 14.5, 20, 14.5}, {9.3, 5, 9.3, 19}, {14.6, 5, 14.6, 19}});
}
void transform(QPainter& painter, const Theme& theme) {
  lines(painter, QPen(theme.x_axis, 1.8), {{6, 18, 14, 18}});
  lines(painter, QPen(theme.y_axis, 1.8), {{6, 18, 6, 10}});
  lines(painter, QPen(theme.x_axis, 1.8), {{15, 11, 20, 6}});
  lines(painter, QPen(theme.y_axis, 1.8), {{15, 11, 10, 6}});
}
void robot(QPainter& painter, const Theme& theme) {
  const QPen purple(theme.virtual_robot, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  lines(painter, purple, {{6, 20, 6, 12}, {6, 12, 15, 7}, {15, 7, 19, 13}});
  rings(painter, purple, {{6, 12}, {15, 7}}, 2.2);
}
void servo(QPainter& painter, const Theme& theme) {
  painter.setPen(pen(theme));
  painter.drawEllipse(QPointF(12, 12), 8.5, 8.5);
  lines(painter, pen(theme), {{12, 12, 12, 6.5}, {12, 12, 16, 14}});
}
void second(QPainter& painter, const Theme& theme) {
  lines(painter, pen(theme, 2.0), {{4, 20, 6, 11}, {6, 11, 11, 7}});
  lines(painter, blue(theme, 2.0), {{20, 20, 18, 11}, {18, 11, 13, 7}});
}
void hands(QPainter& painter, const Theme& theme) {
  painter.setPen(pen(theme));
  painter.drawRoundedRect(QRectF(3, 8, 18, 10), 5, 5);
  rings(painter, blue(theme), {{16.5, 13}}, 1.8);
  lines(painter, pen(theme), {{7.5, 11, 7.5, 15}, {5.5, 13, 9.5, 13}});
}
void step(QPainter& painter, const Theme& theme) {
  lines(painter, pen(theme, 1.2), {{4, 20, 21, 20}, {4, 4, 4, 20}});
  QPainterPath rise(QPointF(5, 19));
  rise.cubicTo(8, 19, 8, 5, 11, 5);
  rise.cubicTo(13, 5, 13, 11, 15, 11);
  rise.cubicTo(17, 11, 17, 9, 21, 9);
  painter.setPen(blue(theme));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(rise);
}
void lab(QPainter& painter, const Theme& theme) {
  painter.setPen(pen(theme));
  painter.drawPolyline(
      QPolygonF{{{9.5, 4}, {9.5, 10}, {4.5, 19}, {6, 20.5}, {18, 20.5}, {19.5, 19}, {14.5, 10}, {14.5, 4}}});
  lines(painter, pen(theme), {{8, 4, 16, 4}});
  lines(painter, blue(theme), {{7, 16, 17, 16}});
}
void devices(QPainter& painter, const Theme& theme) {
  painter.setPen(pen(theme));
  painter.drawRoundedRect(QRectF(7, 9, 10, 7), 1, 1);
  lines(painter, pen(theme), {{9.5, 9, 9.5, 4.5}, {14.5, 9, 14.5, 4.5}, {12, 16, 12, 21}});
}
void calibration(QPainter& painter, const Theme& theme) {
  painter.setPen(pen(theme));
  painter.drawEllipse(QPointF(12, 12), 6, 6);
  lines(painter, pen(theme), {{12, 3, 12, 8}, {12, 16, 12, 21}, {3, 12, 8, 12}, {16, 12, 21, 12}});
}
// A stack of recordings.
void sessions(QPainter& painter, const Theme& theme) {
  painter.setPen(pen(theme));
  for (const double top : {4.0, 10.0, 16.0}) painter.drawRoundedRect(QRectF(4, top, 16, 4.5), 1, 1);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.force_limited);
  for (const double middle : {6.2, 12.2, 18.2}) painter.drawEllipse(QPointF(7, middle), 1.2, 1.2);
}
// A plot with the line of a cursor.
void session(QPainter& painter, const Theme& theme) {
  plots(painter, theme);
  lines(painter, QPen(theme.force_limited, 1.6), {{13, 3, 13, 20}});
}
void more(QPainter& painter, const Theme& theme) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.ink);
  for (const double x : {6.0, 12.0, 18.0}) painter.drawEllipse(QPointF(x, 12), 1.8, 1.8);
}

}  // namespace

const QHash<QString, DrawIcon>& panelDrawings() {
  static const QHash<QString, DrawIcon> kAll{{"scenes", scenes},
                                             {"lessons", lessons},
                                             {"feel", feel},
                                             {"shape", shape},
                                             {"arm", arm},
                                             {"plots", plots},
                                             {"kinematics", kinematics},
                                             {"dh", dh},
                                             {"transform", transform},
                                             {"robot", robot},
                                             {"servo", servo},
                                             {"second", second},
                                             {"hands", hands},
                                             {"step", step},
                                             {"lab", lab},
                                             {"devices", devices},
                                             {"calibration", calibration},
                                             {"sessions", sessions},
                                             {"session", session},
                                             {"more", more}};
  return kAll;
}

}  // namespace underact::gui
