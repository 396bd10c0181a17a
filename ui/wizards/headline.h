// SPDX-License-Identifier: Apache-2.0
// A few words that are read from three metres: as large as the width allows, up to 76 px. They never break,
// and larger text elsewhere does not enlarge them.
#pragma once

#include <QWidget>

namespace noctule::ui {

class Headline : public QWidget {
    Q_OBJECT
public:
    explicit Headline(QWidget* parent = nullptr);

    void setText(const QString& text);
    const QString& text() const { return text_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QFont fitting() const;

    QString text_;
};

}  // namespace noctule::ui
