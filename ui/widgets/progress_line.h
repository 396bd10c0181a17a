// SPDX-License-Identifier: Apache-2.0
// Progress of one job: "turn_003: ranges, 6 s left", the bar, and Cancel beside it.
#pragma once

#include <QWidget>

class QProgressBar;

namespace noctule::ui {

class Button;
class Label;

class ProgressLine : public QWidget {
    Q_OBJECT
public:
    explicit ProgressLine(QWidget* parent = nullptr);

    void setText(const QString& text);
    /// 0..1; negative: it runs, but how far cannot be told.
    void setFraction(double fraction);
    void setCancellable(bool cancellable);

signals:
    void cancelled();

private:
    Label* text_;
    QProgressBar* bar_;
    Button* cancel_;
};

}  // namespace noctule::ui
