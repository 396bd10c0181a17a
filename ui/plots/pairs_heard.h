// SPDX-License-Identifier: Apache-2.0
// How each source was heard over the last ten seconds, one row per source, in the colours of confidence; what
// no board heard stays in the colour of the surface.
#pragma once

#include <QImage>
#include <QWidget>

#include "core/live/heard_window.h"

namespace noctule::ui {

class PairsHeard : public QWidget {
    Q_OBJECT
public:
    explicit PairsHeard(QWidget* parent = nullptr);

    /// `names` per source: "Source 8 (hat)".
    void setHeard(const HeardWindow& heard, const QStringList& names);
    void clear();
    /// "Source 8 (hat): heard with confidence 0.91 now"
    QString words(int source) const;
    int rowCount() const { return rows_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    QRectF area() const;
    QRectF rowRect(int source) const;

    int rows_ = 0;
    std::vector<std::vector<std::optional<float>>> steps_;  ///< per source, oldest first
    QStringList names_;
};

}  // namespace noctule::ui
