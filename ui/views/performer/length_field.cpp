// SPDX-License-Identifier: Apache-2.0
#include "ui/views/performer/length_field.h"

#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include "ui/style/lengths.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/label.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

constexpr int kDecimals = 1, kFieldWidth = 64;

bool inInches() {
    return chosenUnits() == Units::kImperial;
}

double unit_m() {
    return inInches() ? kMetresPerInch : 0.01;
}

double step_m() {
    return inInches() ? kMetresPerInch / 4 : 0.005;
}

QString inUnits(double length_m) {
    return numberText(length_m / unit_m(), kDecimals);
}

}  // namespace

LengthField::LengthField(double shortest_m, double longest_m, QWidget* parent)
    : QWidget(parent),
      shortest_m_(shortest_m),
      longest_m_(longest_m),
      edit_(new QLineEdit),
      reset_(new ToolButton("undo", tr("In proportion to the height again"))) {
    auto* row = makeRow(this, {}, 8);
    row->addWidget(edit_);
    row->addWidget(
        new Label(inInches() ? tr("in", "inches") : tr("cm", "centimetres"), TextRole::kBody, Ink::kHint));
    row->addWidget(reset_);
    row->addStretch();
    keepSize(*edit_, kFieldWidth, 0);
    edit_->setAlignment(Qt::AlignRight);
    edit_->installEventFilter(this);
    setFocusProxy(edit_);
    QSizePolicy policy = reset_->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    reset_->setSizePolicy(policy);
    connect(edit_, &QLineEdit::editingFinished, this, &LengthField::accept);
    connect(reset_, &QToolButton::clicked, this, [this] { emit lengthEdited(0); });
}

void LengthField::describe(const QString& name, const QString& how) {
    edit_->setAccessibleName(name);
    edit_->setAccessibleDescription(how);
    edit_->setToolTip(how);
}

void LengthField::setLength(double length_m, double proportional_m) {
    length_m_ = length_m;
    proportional_m_ = proportional_m;
    const QString text = length_m > 0 ? inUnits(length_m) : QString();
    if (edit_->text() != text)
        edit_->setText(text);
    edit_->setPlaceholderText(inUnits(proportional_m));
    reset_->setVisible(length_m > 0);
}

void LengthField::accept() {
    const QString text = edit_->text().trimmed();
    if (text.isEmpty()) {
        if (length_m_ > 0)
            emit lengthEdited(0);
        return;
    }
    const auto typed_m = lengthFrom(text, unit_m());
    // What is no length leaves the field as it was.
    if (!typed_m || *typed_m <= 0 || text == inUnits(length_m_)) {
        setLength(length_m_, proportional_m_);
        return;
    }
    edit_->setText(text);  // the field forgets the typing: from here on the session takes it back
    emit lengthEdited(std::clamp(*typed_m, shortest_m_, longest_m_));
}

void LengthField::step(double by_m) {
    const double from_m = length_m_ > 0 ? length_m_ : proportional_m_;
    const double stepped_m = std::round((from_m + by_m) / step_m()) * step_m();
    emit lengthEdited(std::clamp(stepped_m, shortest_m_, longest_m_));
}

bool LengthField::eventFilter(QObject* watched, QEvent* event) {
    if (watched == edit_ && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down) {
            step(key == Qt::Key_Up ? step_m() : -step_m());
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace noctule::ui
