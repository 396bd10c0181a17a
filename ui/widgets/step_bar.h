// SPDX-License-Identifier: Apache-2.0
// The steps in the centre of the top bar. A step shows its number, a check mark when done or ! when
// something is wrong, and the present one is underlined; any step can be opened at any time. Arrow keys walk,
// Enter opens.
#pragma once

#include <QWidget>
#include <vector>

namespace noctule::ui {

class StepBar : public QWidget {
    Q_OBJECT
public:
    enum class State { kOpen, kDone, kAttention };

    /// `names` in order of work, translated.
    explicit StepBar(const QStringList& names, QWidget* parent = nullptr);

    int count() const { return static_cast<int>(steps_.size()); }
    void setState(int index, State state);
    State state(int index) const;
    QString name(int index) const;
    /// A step that is not shown takes no room and no number.
    void setShown(int index, bool shown);
    bool isShown(int index) const;
    /// -1: none (Start).
    void setCurrent(int index);
    int current() const { return current_; }
    /// In the widget; for tests and tours.
    QRect stepRect(int index) const;

signals:
    void stepClicked(int index);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    class StepButton;

    std::vector<StepButton*> steps_;
    int current_ = -1;
};

}  // namespace noctule::ui
