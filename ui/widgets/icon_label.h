// SPDX-License-Identifier: Apache-2.0
// An icon in front of words that say the same; follows the theme.
#pragma once

#include <QWidget>
#include <functional>

namespace noctule::ui {

class IconLabel : public QWidget {
    Q_OBJECT
public:
    /// `color` is asked at each repaint, so that it can follow the theme.
    IconLabel(const QString& icon_name, std::function<QColor()> color, int size = 16,
              QWidget* parent = nullptr);

    void setIcon(const QString& icon_name, std::function<QColor()> color);
    void setIconSize(int size_at_100_percent);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString icon_name_;
    std::function<QColor()> color_;
    int size_;
};

}  // namespace noctule::ui
