// SPDX-License-Identifier: Apache-2.0
// Everything that a window says: what it paints, its tooltips, menus and cells, and what it tells screen
// readers. Of a German window the texts that are not German: English words, decimal points, keys of an
// English keyboard.
#pragma once

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QRegularExpression>
#include <QStringList>
#include <QTextEdit>

#include "tests/ui/support/painted_text.h"

namespace noctule::ui::test {

class ScreenWords {
public:
    /// Of the window and all that is in it, also of what is hidden now. Not of documents, which are English.
    static QStringList of(const QWidget& root) {
        ScreenWords found;
        found.look(root);
        for (const QWidget* widget : root.findChildren<QWidget*>())
            if (!isDocument(*widget))
                found.look(*widget);
        for (const QAction* action : root.findChildren<QAction*>())
            found.add({action->text(), action->toolTip(), action->statusTip()});
        found.words_.removeDuplicates();
        return found.words_;
    }

    static QStringList notGerman(const QStringList& texts) {
        // Words of which German has none, as the studio's English is full of them.
        static const QRegularExpression english(
            "\\b(the|of|and|with|without|to|from|by|is|are|has|have|no|yet|this|that|there|only|over|"
            "takes?|"
            "boards?|sources?|left|right|elbow|shoulder|wrist|knee|ankle|hip|shin|thigh|head|chest|mean|"
            "worst|time|"
            "frames?|open|close|save|cancel|undo|redo|copy|paste|cut|delete|select|yes|record|recording|"
            "writing|"
            "reading|loading|of them|seconds?|Ctrl|Shift|Del|Ins|PgUp|PgDown)\\b",
            QRegularExpression::CaseInsensitiveOption);
        static const QRegularExpression point("(?<![\\w.])\\d+\\.\\d+(?![\\w.])");
        QStringList found;
        for (const QString& text : texts)
            if (const QString own = withoutNames(text); own.contains(english) || own.contains(point))
                found += text;
        return found;
    }

private:
    static bool isDocument(const QWidget& widget) {
        return qobject_cast<const QTextEdit*>(&widget) ||
               qobject_cast<const QTextEdit*>(widget.parentWidget());
    }

    /// Paths, addresses and names of files, of licences and of other programs are what they are.
    static QString withoutNames(QString text) {
        static const QRegularExpression names(
            "<[^>]*>|\\{\\w+\\}|\\S*[/\\\\]\\S*|\\b[\\w-]+\\.(noctule|bvh|csv|json|txt|fbx|glb)\\b|OpenGL "
            "\\d\\.\\d|(placement, )?(source|kind), (board|id),?( [\\w, ]*_m\\b)?");
        return text.remove(names);
    }

    void add(const QStringList& texts) {
        for (const QString& text : texts)
            if (!text.trimmed().isEmpty())
                words_ += text;
    }

    void look(const QWidget& widget) {
        add({widget.windowTitle(), widget.toolTip(), widget.statusTip(), widget.accessibleName(),
             widget.accessibleDescription(), widget.property("text").toString(),
             widget.property("placeholderText").toString(), widget.property("suffix").toString()});
        if (widget.isVisible())
            for (const PaintedText& painted : TextRecorder::textsOf(widget))
                add({painted.text});
        if (const auto* box = qobject_cast<const QComboBox*>(&widget))
            lookAtCells(*box->model());
        if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget); view && view->model())
            lookAtCells(*view->model());
    }

    void lookAtCells(const QAbstractItemModel& model) {
        constexpr int kRoles[] = {Qt::DisplayRole, Qt::ToolTipRole, Qt::AccessibleTextRole,
                                  Qt::AccessibleDescriptionRole};
        constexpr int kMostRows = 200;
        for (const int role : kRoles)
            for (int column = 0; column < model.columnCount(); ++column) {
                add({model.headerData(column, Qt::Horizontal, role).toString()});
                for (int row = 0; row < std::min(model.rowCount(), kMostRows); ++row)
                    add({model.index(row, column).data(role).toString()});
            }
    }

    QStringList words_;
};

}  // namespace noctule::ui::test
