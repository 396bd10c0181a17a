// SPDX-License-Identifier: Apache-2.0
// Heading of a part of a dock: caption in t3, with a hint or a small control at its right end; over it, if
// wanted, a line from edge to edge of the dock.
#pragma once

#include <QWidget>

class QBoxLayout;

namespace noctule::ui {

class Label;

class SectionHeader : public QWidget {
    Q_OBJECT
public:
    explicit SectionHeader(const QString& title, const QString& hint = {}, QWidget* parent = nullptr);

    void setTitle(const QString& title);
    void setHint(const QString& hint);
    /// Beside the hint, at the right end.
    void addTrailing(QWidget* widget);

private:
    QBoxLayout* row_;
    Label* title_;
    Label* hint_;
};

}  // namespace noctule::ui
