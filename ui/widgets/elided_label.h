// SPDX-License-Identifier: Apache-2.0
// One line of text that may be cut ("optical_tu…_003.bvh"); the whole text is then its tooltip.
#pragma once

#include "ui/widgets/label.h"

namespace noctule::ui {

class ElidedLabel : public Label {
    Q_OBJECT
public:
    explicit ElidedLabel(const QString& text = {}, TextRole role = TextRole::kBody, Ink ink = Ink::kValue,
                         bool medium = false, QWidget* parent = nullptr);

    /// Paths lose their middle, sentences their end (the default).
    void setElideMode(Qt::TextElideMode mode);

    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    Qt::TextElideMode mode_ = Qt::ElideRight;
};

}  // namespace noctule::ui
