// SPDX-License-Identifier: Apache-2.0
// A heading that opens and closes what is below it; Space, Enter, Left and Right work on the heading.
#pragma once

#include <QAbstractButton>
#include <QWidget>

namespace noctule::ui {

class CollapsibleSection : public QWidget {
    Q_OBJECT
public:
    /// Owns `content`.
    CollapsibleSection(const QString& title, QWidget* content, bool open = true, QWidget* parent = nullptr);

    void setOpen(bool open);
    bool isOpen() const;

signals:
    void toggled(bool open);

private:
    QAbstractButton* heading_;
    QWidget* content_;
};

}  // namespace noctule::ui
