// SPDX-License-Identifier: Apache-2.0
// A dialog of the studio: title, what it is about, content, and at the bottom Cancel and one primary button.
// It is as high as its texts and lists ask for at its width, and never larger than its room (window_place.h).
#pragma once

#include <QDialog>

class QBoxLayout;

namespace noctule::ui {

class Button;
class Label;

class DialogFrame : public QDialog {
    Q_OBJECT
public:
    DialogFrame(const QString& title, const QString& about, const QString& action, QWidget* parent);

    /// In the pixels of the style guide; narrower where the room is. Without it contents say how wide.
    void setWide(int width);
    QBoxLayout* content() { return content_; }
    /// Enter; accept() unless it is connected elsewhere first.
    Button* actionButton() { return action_; }
    /// In place, above the buttons; empty: none.
    void setProblem(const QString& problem);

protected:
    void showEvent(QShowEvent* event) override;
    bool event(QEvent* event) override;
    /// After what it shows became another thing.
    virtual void fitHeight();

private:
    void fitWidth();
    void keepLeastHeight();

    QBoxLayout* content_;
    Label* problem_;
    Button* action_;
    int wide_ = 0;
};

}  // namespace noctule::ui
