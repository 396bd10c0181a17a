// SPDX-License-Identifier: Apache-2.0
#include "ui/views/performer/length_field.h"

#include <QKeyEvent>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/label.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

constexpr double kStep_m = 0.005;
constexpr int kDecimals = 1, kFieldWidth = 64;

QString inCentimetres(double length_m) {
    return numberText(100 * length_m, kDecimals);
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
    row->addWidget(new Label(tr("cm", "centimetres"), TextRole::kBody, Ink::kHint));
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
    const QString text = length_m > 0 ? inCentimetres(length_m) : QString();
    if (edit_->text() != text)
        edit_->setText(text);
    edit_->setPlaceholderText(inCentimetres(proportional_m));
    reset_->setVisible(length_m > 0);
}

void LengthField::accept() {
    const QString text = edit_->text().trimmed();
    if (text.isEmpty()) {
        if (length_m_ > 0)
            emit lengthEdited(0);
        return;
    }
    bool is_number = false;
    double typed_cm = QLocale().toDouble(text, &is_number);
    if (!is_number)
        typed_cm = QLocale::c().toDouble(text, &is_number);
    // What is no length leaves the field as it was.
    if (!is_number || typed_cm <= 0 || text == inCentimetres(length_m_)) {
        setLength(length_m_, proportional_m_);
        return;
    }
    edit_->setText(text);  // the field forgets the typing: from here on the session takes it back
    emit lengthEdited(std::clamp(typed_cm / 100, shortest_m_, longest_m_));
}

void LengthField::step(double by_m) {
    const double from_m = length_m_ > 0 ? length_m_ : proportional_m_;
    const double stepped_m = std::round((from_m + by_m) / kStep_m) * kStep_m;
    emit lengthEdited(std::clamp(stepped_m, shortest_m_, longest_m_));
}

bool LengthField::eventFilter(QObject* watched, QEvent* event) {
    if (watched == edit_ && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down) {
            step(key == Qt::Key_Up ? kStep_m : -kStep_m);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace noctule::ui
