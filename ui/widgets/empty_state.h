// SPDX-License-Identifier: Apache-2.0
// What stands where nothing is yet: one sentence what will be here, one button that makes it.
#pragma once

#include <QWidget>

namespace noctule::ui {

class Button;
class Label;

class EmptyState : public QWidget {
    Q_OBJECT
public:
    /// Without `action` there is only the sentence.
    explicit EmptyState(const QString& sentence, const QString& action = {}, const QString& icon_name = {},
                        QWidget* parent = nullptr);

    void setSentence(const QString& sentence);
    /// Null without an action.
    Button* button() const { return button_; }

signals:
    void activated();

private:
    Label* sentence_;
    Button* button_ = nullptr;
};

}  // namespace noctule::ui
