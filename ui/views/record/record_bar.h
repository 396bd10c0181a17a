// SPDX-License-Identifier: Apache-2.0
// The row of the record button: the name of the take and how it begins at the left, what can be noted while
// it runs at the right.
#pragma once

#include <QWidget>

#include "ui/views/record/record_run.h"

class QCheckBox;
class QLineEdit;
class QMenu;
class QStackedWidget;

namespace noctule::ui {

class Button;
class ElidedLabel;
class Label;
class RecordButton;

class RecordBar : public QWidget {
    Q_OBJECT
public:
    explicit RecordBar(RecordRun& run, QWidget* parent = nullptr);

    RecordButton& button() { return *button_; }
    QLineEdit& name() { return *name_; }
    QLineEdit& note() { return *note_; }
    /// Beside the button: "Record both".
    QString verb() const;
    Button& markerButton() { return *marker_; }
    /// "None" or "3 seconds", as countdowns are offered.
    static QString secondsChoice(int seconds);
    Button& countdownButton() { return *countdown_; }

    void editName();
    /// Opens the field; Enter keeps the note, Esc closes.
    void writeNote();

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// A field was left by Enter or Esc.
    void fieldLeft();

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    QWidget* makeLeft();
    QWidget* makeMiddle();
    QWidget* makeRight();
    void fillMenu(QMenu& menu);
    void refresh();
    void showChoices();
    void closeNote();

    RecordRun& run_;
    bool is_laid_out_ = false;  ///< before that its width says nothing
    QLineEdit* name_ = nullptr;
    Label* next_ = nullptr;
    Button* countdown_ = nullptr;
    Button* tones_ = nullptr;
    RecordButton* button_ = nullptr;
    Label* verb_ = nullptr;
    Button* marker_ = nullptr;
    Button* note_button_ = nullptr;
    QStackedWidget* below_ = nullptr;
    QLineEdit* note_ = nullptr;
    QCheckBox* review_ = nullptr;
};

}  // namespace noctule::ui
