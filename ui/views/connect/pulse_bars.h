// SPDX-License-Identifier: Apache-2.0
// How well one board hears each source now: a bar per source, as high and in the colour of its confidence.
#pragma once

#include <QWidget>
#include <vector>

namespace noctule::ui {

class PulseBars : public QWidget {
    Q_OBJECT
public:
    explicit PulseBars(QWidget* parent = nullptr);

    /// Per source, 0..1; below 0: not heard.
    void setConfidences(const std::vector<double>& confidences);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::vector<double> confidences_;
};

}  // namespace noctule::ui
