// SPDX-License-Identifier: Apache-2.0
// Icon button, 28 px, with a tooltip that tells its name and shortcut; the name is also what screen readers
// say. Checkable ones show their state by surface and colour. The shortcut is told only, a QAction acts on
// it.
#pragma once

#include <QKeySequence>
#include <QToolButton>

namespace noctule::ui {

class ToolButton : public QToolButton {
    Q_OBJECT
public:
    ToolButton(const QString& icon_name, const QString& name, const QKeySequence& shortcut = {},
               QWidget* parent = nullptr);

    /// For buttons that change their meaning, as play and pause.
    void setMeaning(const QString& icon_name, const QString& name, const QKeySequence& shortcut = {});
    /// Filled with the accent, as Play is.
    void setPrimary(bool primary);
    /// Width and height at 100 percent; the icon is drawn at 16, 20 or 24 px, whatever fits.
    void setTargetSize(int width, int height);
    /// Disabled with the reason as tooltip; an empty reason enables it.
    void setDisabledBecause(const QString& reason);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void restyle();

    QString icon_name_;
    QString tooltip_;
    bool primary_ = false;
    QSize target_{28, 28};
};

}  // namespace noctule::ui
