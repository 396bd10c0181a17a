// SPDX-License-Identifier: Apache-2.0
// A problem in place: stripe, title = what, text = which and why and what to do, one outlined action and text
// actions after it. Announces itself once to screen readers.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/style/ink.h"

class QBoxLayout;

namespace noctule::ui {

class Button;
class IconLabel;
class Label;
class ToolButton;

class ProblemCard : public QWidget {
    Q_OBJECT
public:
    /// `tone` is kWarn or kError; kOk for what went well, kNeutral for what asks or informs.
    ProblemCard(Tone tone, const QString& title, const QString& text, QWidget* parent = nullptr);

    void setTexts(const QString& title, const QString& text);
    /// The first is outlined, all others are text. Connect to clicked().
    Button* addAction(const QString& text, const QString& icon_name = {});
    /// A cross at top right; closed() is the owner's to act on.
    void setClosable(bool closable);
    QString title() const;
    /// As wide as its widest action: those that find no room beside one another stand below.
    QSize minimumSizeHint() const override;

signals:
    void closed();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void restyle();
    void arrangeActions();
    std::vector<int> actionWidths() const;
    int contentsRoom() const;
    void placeClose();

    Tone tone_;
    QBoxLayout* content_;
    QBoxLayout* actions_ = nullptr;
    IconLabel* icon_;
    Label* title_;
    Label* text_;
    ToolButton* close_;
    bool closable_ = false;
    bool announced_ = false;
};

}  // namespace noctule::ui
