// SPDX-License-Identifier: Apache-2.0
// A body length in centimetres or inches that may be left empty: then it follows the height, and the length
// that makes is shown in grey. Up and Down change it by half a centimetre or a quarter of an inch; the button
// beside it empties it again.
#pragma once

#include <QLineEdit>
#include <QWidget>

namespace noctule::ui {

class ToolButton;

class LengthField : public QWidget {
    Q_OBJECT
public:
    /// Between the two lengths.
    LengthField(double shortest_m, double longest_m, QWidget* parent = nullptr);

    /// 0: empty.
    void setLength(double length_m, double proportional_m);
    /// What the screen reader calls it, and how it is measured.
    void describe(const QString& name, const QString& how);
    QLineEdit* edit() { return edit_; }

signals:
    void lengthEdited(double length_m);  ///< by the operator; 0: empty

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void accept();
    void step(double by_m);

    double shortest_m_, longest_m_, length_m_ = 0, proportional_m_ = 0;
    QLineEdit* edit_;
    ToolButton* reset_;
};

}  // namespace noctule::ui
