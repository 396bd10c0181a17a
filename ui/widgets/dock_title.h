// SPDX-License-Identifier: Apache-2.0
// Head of a dock or panel, 36 px: title, a hint, and actions at its right end, with a hairline below.
#pragma once

#include <QWidget>

class QBoxLayout;

namespace noctule::ui {

class Label;
class ElidedLabel;

class DockTitle : public QWidget {
    Q_OBJECT
public:
    explicit DockTitle(const QString& title, QWidget* parent = nullptr);

    void setTitle(const QString& title);
    void setHint(const QString& hint);
    /// Buttons, left to right; owned by the title.
    void addAction(QWidget* widget);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QBoxLayout* row_;
    ElidedLabel* title_;
    Label* hint_;
};

}  // namespace noctule::ui
