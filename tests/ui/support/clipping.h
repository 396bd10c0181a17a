// SPDX-License-Identifier: Apache-2.0
// Finds what a window cuts: texts that need more than they have, widgets smaller than they can be, outside of
// their parents or lying on each other. What a scroll area holds may be larger than its view; what is elided
// on purpose shows its whole text as a tooltip. Texts that a widget paints by itself count like labels:
// cells, headers, legends, marks.
#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QListView>
#include <QMainWindow>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitterHandle>
#include <QStringList>
#include <QStyle>
#include <QStyleOptionComboBox>

#include "tests/ui/support/painted_text.h"
#include "ui/widgets/elided_label.h"

namespace noctule::ui::test {

class Clipping {
public:
    /// One sentence each; empty: nothing is cut.
    static QStringList in(const QWidget& root) {
        Clipping found;
        for (const QWidget* widget : root.findChildren<QWidget*>())
            if (widget->isVisibleTo(&root) && widget->window() == root.window()) {
                found.lookAtPaintedTexts(*widget);
                if (!isInside(*widget))
                    found.look(*widget, root);
            }
        return found.sentences_;
    }

private:
    /// Parts that Qt makes inside of its own widgets.
    static bool isInside(const QWidget& widget) {
        for (const QWidget* up = widget.parentWidget(); up; up = up->parentWidget())
            if (qobject_cast<const QAbstractItemView*>(up) || qobject_cast<const QComboBox*>(up) ||
                qobject_cast<const QAbstractSpinBox*>(up) || qobject_cast<const QLineEdit*>(up) ||
                up->inherits("QwtPlot"))
                return true;
        return qobject_cast<const QSplitterHandle*>(&widget) != nullptr || widget.inherits("QRubberBand") ||
               widget.inherits("QScrollBar") || widget.inherits("QTabBar") || widget.inherits("QSizeGrip");
    }

    void look(const QWidget& widget, const QWidget& root) {
        lookAtText(widget);
        lookAtSize(widget);
        lookAtPlace(widget, root);
        lookAtNeighbours(widget);
    }

    void lookAtText(const QWidget& widget) {
        if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
            if (label->text().isEmpty() || qobject_cast<const ElidedLabel*>(label))
                return;
            const int needed =
                label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().width();
            const int has = label->wordWrap() ? label->height() : label->width();
            if (needed > has + 1)
                tell(widget, label->text(), needed, has);
        } else if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
            const bool shows_text = !button->text().isEmpty() && button->inherits("QPushButton");
            const bool is_box = button->inherits("QCheckBox") || button->inherits("QRadioButton");
            if ((shows_text || is_box) && button->sizeHint().width() > button->width() + 1)
                tell(widget, button->text(), button->sizeHint().width(), button->width());
        } else if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
            QStyleOptionComboBox option;
            option.initFrom(box);
            const int has =
                box->style()
                    ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box)
                    .width();
            const int needed = box->fontMetrics().horizontalAdvance(box->currentText());
            if (needed > has + 1 && box->toolTip().isEmpty())
                tell(widget, box->currentText(), needed, has);
        } else if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) {
            const int needed = line->fontMetrics().horizontalAdvance(line->placeholderText());
            if (line->text().isEmpty() && needed > line->width() - 4)
                tell(widget, line->placeholderText(), needed, line->width() - 4);
        } else if (const auto* list = qobject_cast<const QListView*>(&widget);
                   list && list->horizontalScrollBar()->maximum() > 0) {
            tell(widget, {}, list->sizeHintForColumn(0), list->viewport()->width());
        }
    }

    void lookAtPaintedTexts(const QWidget& widget) {
        const std::vector<PaintedText> texts = TextRecorder::textsOf(widget);
        const auto* area =
            scrolls(widget) ? static_cast<const QAbstractScrollArea*>(widget.parentWidget()) : nullptr;
        const bool scrolls_across = area && area->horizontalScrollBar()->maximum() > 0;
        for (size_t i = 0; i < texts.size(); ++i) {
            const auto& [text, place, room] = texts[i];
            if (text.trimmed().isEmpty())
                continue;
            const double across = std::max(room.left() - place.left(), place.right() - room.right());
            const double down = std::max(room.top() - place.top(), place.bottom() - room.bottom());
            if (text.contains(kEllipsis) && !isWholeElsewhere(widget, texts[i]))
                sentences_ += QStringLiteral("%1 cuts “%2”").arg(nameOf(widget), text);
            else if (place.intersects(room) && ((across > 2 && !scrolls_across) || (down > 4 && !area)))
                tell(widget, text, qRound(place.width()), qRound(place.width() - across));
            for (size_t j = 0; j < i; ++j)
                if (const QRectF both = texts[j].place.adjusted(1, 2, -1, -2) & place.adjusted(1, 2, -1, -2);
                    both.width() > 2 && both.height() > 2 && !texts[j].text.trimmed().isEmpty() &&
                    texts[j].text != text)
                    sentences_ +=
                        QStringLiteral("%1 paints “%2” on “%3”").arg(nameOf(widget), text, texts[j].text);
        }
    }

    /// A text with an ellipsis of its own, or one that a tooltip shows whole.
    static bool isWholeElsewhere(const QWidget& widget, const PaintedText& painted) {
        QStringList own{widget.property("text").toString(), widget.property("placeholderText").toString()};
        QStringList tooltips{widget.toolTip()};
        if (const auto* view = qobject_cast<const QAbstractItemView*>(widget.parentWidget())) {
            const QModelIndex index = view->indexAt(painted.place.center().toPoint());
            own += index.data().toString();
            tooltips += index.data(Qt::ToolTipRole).toString();
        }
        const QString begin = painted.text.section(kEllipsis, 0, 0);
        return qobject_cast<const ElidedLabel*>(&widget) || own.join('\n').contains(painted.text) ||
               tooltips.join('\n').contains(begin);
    }

    void lookAtSize(const QWidget& widget) {
        // A container that is too small shows in what it holds; a row of wrapped words says too large a least
        // height.
        if (qobject_cast<const QLabel*>(&widget) || widget.layout() || widget.inherits("QSplitter"))
            return;
        if (qobject_cast<const QAbstractSpinBox*>(&widget) || qobject_cast<const QComboBox*>(&widget)) {
            if (widget.height() < widget.fontMetrics().height() + 6)
                tell(widget, {}, widget.fontMetrics().height() + 6, widget.height());
            return;
        }
        const QSize least = widget.minimumSizeHint().boundedTo(widget.maximumSize());
        if (least.width() > widget.width() + 1 || least.height() > widget.height() + 1)
            sentences_ += QStringLiteral("%1 is %2x%3 and needs %4x%5")
                              .arg(nameOf(widget))
                              .arg(widget.width())
                              .arg(widget.height())
                              .arg(least.width())
                              .arg(least.height());
    }

    static bool scrolls(const QWidget& parent) {
        const auto* area =
            parent.parentWidget() ? qobject_cast<const QAbstractScrollArea*>(parent.parentWidget()) : nullptr;
        return area && area->viewport() == &parent;
    }

    void lookAtPlace(const QWidget& widget, const QWidget& root) {
        const QWidget* parent = widget.parentWidget();
        if (!parent || &widget == &root || widget.isWindow())
            return;
        const QRect place = widget.geometry(), room = parent->rect();
        if (scrolls(*parent)) {
            const auto* area = qobject_cast<const QScrollArea*>(parent->parentWidget());
            if (area && area->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff &&
                place.width() > room.width())
                sentences_ += QStringLiteral("%1 is %2 wide in a view of %3")
                                  .arg(nameOf(widget))
                                  .arg(place.width())
                                  .arg(room.width());
        } else if (!room.adjusted(-1, -1, 1, 1).contains(place)) {
            sentences_ += QStringLiteral("%1 stands outside of %2 by %3 px")
                              .arg(nameOf(widget), nameOf(*parent))
                              .arg(std::max({-place.left(), -place.top(), place.right() - room.right(),
                                             place.bottom() - room.bottom()}));
        }
    }

    /// Only of widgets that take the mouse: overlays for drawing lie on others on purpose.
    void lookAtNeighbours(const QWidget& widget) {
        const QWidget* parent = widget.parentWidget();
        if (!parent || widget.testAttribute(Qt::WA_TransparentForMouseEvents) || widget.isWindow() ||
            widget.geometry().isEmpty())
            return;
        const bool is_placed =
            parent->layout() && parent->layout()->indexOf(const_cast<QWidget*>(&widget)) >= 0;
        for (const QObject* child : parent->children()) {
            const auto* other = qobject_cast<const QWidget*>(child);
            if (!other || other <= &widget || !other->isVisibleTo(parent) || other->isWindow() ||
                other->geometry().isEmpty() || other->testAttribute(Qt::WA_TransparentForMouseEvents) ||
                isInside(*other))
                continue;
            const bool other_is_placed =
                parent->layout() && parent->layout()->indexOf(const_cast<QWidget*>(other)) >= 0;
            const QRect both =
                widget.geometry().adjusted(1, 1, -1, -1) & other->geometry().adjusted(1, 1, -1, -1);
            if (is_placed != other_is_placed)
                is_placed ? lookAtToolsOf(widget, *other) : lookAtToolsOf(*other, widget);
            // A free child may lie on the one that fills the parent: a tool on a view.
            const bool is_on = is_placed != other_is_placed || widget.geometry() == parent->rect() ||
                               other->geometry() == parent->rect();
            // Buttons on the drawing of a body keep a free middle.
            const bool is_drawn = widget.inherits("noctule::ui::MapMarker") &&
                                  3 * both.width() * both.height() < widget.width() * widget.height();
            if (!both.isEmpty() && !is_on && !is_drawn)
                sentences_ += QStringLiteral("%1 lies on %2 by %3x%4")
                                  .arg(nameOf(widget), nameOf(*other))
                                  .arg(both.width())
                                  .arg(both.height());
        }
    }

    /// A free child that lies on a view stays beside the tools that the view has placed by itself.
    void lookAtToolsOf(const QWidget& view, const QWidget& free) {
        if (view.layout() || view.inherits("QAbstractScrollArea") || view.inherits("QSplitter"))
            return;
        for (const QObject* child : view.children()) {
            const auto* tool = qobject_cast<const QWidget*>(child);
            if (!tool || !tool->isVisibleTo(&view) || tool->isWindow() || tool->geometry() == view.rect() ||
                tool->testAttribute(Qt::WA_TransparentForMouseEvents) || isInside(*tool))
                continue;
            const QRect place = tool->geometry().translated(view.pos());
            const QRect both = place.adjusted(1, 1, -1, -1) & free.geometry().adjusted(1, 1, -1, -1);
            if (!both.isEmpty())
                sentences_ += QStringLiteral("%1 lies on %2 by %3x%4")
                                  .arg(nameOf(free), nameOf(*tool))
                                  .arg(both.width())
                                  .arg(both.height());
        }
    }

    void tell(const QWidget& widget, const QString& text, int needed, int has) {
        sentences_ += QStringLiteral("%1 “%2” needs %3 px and has %4")
                          .arg(nameOf(widget), text.left(60))
                          .arg(needed)
                          .arg(has);
    }

    static QString nameOf(const QWidget& widget) {
        QString name = QString::fromLatin1(widget.metaObject()->className()).remove("noctule::ui::");
        if (const auto* button = qobject_cast<const QAbstractButton*>(&widget);
            button && !button->text().isEmpty())
            name += " “" + button->text() + "”";
        else if (!widget.accessibleName().isEmpty())
            name += " “" + widget.accessibleName() + "”";
        const QRect place = widget.geometry();
        name += QStringLiteral(" (%1x%2 at %3, %4)")
                    .arg(place.width())
                    .arg(place.height())
                    .arg(place.x())
                    .arg(place.y());
        const QWidget* parent = widget.parentWidget();
        while (parent && QByteArray(parent->metaObject()->className()) == "QWidget")
            parent = parent->parentWidget();
        return parent ? name + " of " +
                            QString::fromLatin1(parent->metaObject()->className()).remove("noctule::ui::")
                      : name;
    }

    static constexpr QChar kEllipsis{0x2026};

    QStringList sentences_;
};

}  // namespace noctule::ui::test
