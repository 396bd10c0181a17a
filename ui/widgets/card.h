// SPDX-License-Identifier: Apache-2.0
// Raised surface with rounded corners; put a layout into it.
#pragma once

#include <QWidget>

namespace noctule::ui {

class Card : public QWidget {
    Q_OBJECT
public:
    explicit Card(QWidget* parent = nullptr);

    /// The surface of what is chosen.
    void setSelected(bool selected);
    bool isSelected() const { return selected_; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    bool selected_ = false;
};

}  // namespace noctule::ui
