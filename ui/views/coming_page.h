// SPDX-License-Identifier: Apache-2.0
// A step whose devices the studio does not use yet: what the step will show, and what can be done instead
// now. The drawing stands in the centre, the words and buttons in the right dock.
#pragma once

#include "ui/models/studio.h"
#include "ui/views/page.h"

class QVBoxLayout;

namespace noctule::ui {

class Button;

class ComingPage : public Page {
    Q_OBJECT
public:
    QString title() const override { return title_; }
    QWidget* rightDock() override { return dock_; }

    /// The buttons under "Until then", the way on first.
    const QList<Button*>& ways() const { return ways_; }

signals:
    void putSuitOnRequested();

protected:
    struct Words {
        QString title;           ///< of the step
        QString verdict, why;    ///< "No suit is connected", and one sentence
        QStringList what_comes;  ///< one line each
        QString until_then;      ///< one sentence
    };
    ComingPage(Studio& studio, const Words& words, QWidget* parent);

    /// Takes the space left of the dock.
    void setDrawing(QWidget* drawing, const QMargins& margins = {16, 12, 16, 12});
    Button* addWay(const QString& text, const QString& icon, std::function<void()> act);
    void addVirtualSuitWay();
    void addImportWay();

    Studio& studio_;

private:
    QString title_;
    QWidget* dock_;
    QVBoxLayout* way_column_;
    QList<Button*> ways_;
};

}  // namespace noctule::ui
