// SPDX-License-Identifier: Apache-2.0
#include "ui/views/dialog_frame.h"

#include <QEvent>
#include <QScrollBar>
#include <algorithm>

#include "ui/style/theme.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/window_place.h"
#include "ui/widgets/button.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"

namespace noctule::ui {

DialogFrame::DialogFrame(const QString& title, const QString& about, const QString& action, QWidget* parent)
    : QDialog(parent),
      problem_(new Label({}, TextRole::kSecondary, Ink::kError)),
      action_(makeButton(ButtonKind::kPrimary, action)) {
    setWindowTitle(title);
    setModal(true);
    setWindowFlag(Qt::WindowContextHelpButtonHint, false);
    auto* column = makeColumn(this);
    auto* body = new QWidget;
    content_ = makeColumn(body, {24, 20, 24, 20}, 12);
    content_->addWidget(new Label(title, TextRole::kPage, Ink::kValue, true));
    if (!about.isEmpty())
        content_->addWidget((new Label(about, TextRole::kBody, Ink::kLabel))->wrapped());
    column->addWidget(body, 1);
    column->addWidget(new Divider);
    auto* foot = new QWidget;
    auto* foot_column = makeColumn(foot, {24, 12, 24, 16}, 8);
    foot_column->addWidget(problem_->wrapped());
    problem_->hide();
    auto* buttons = addRow(foot_column, 8);
    auto* cancel = makeButton(ButtonKind::kOutlined, tr("Cancel"), {}, QKeySequence(Qt::Key_Escape));
    cancel->setTall(true);
    buttons->addStretch();
    buttons->addWidget(cancel);
    buttons->addWidget(action_);
    column->addWidget(foot);
    action_->setDefault(true);
    cancel->setAutoDefault(false);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(action_, &QPushButton::clicked, this, &QDialog::accept);
    connect(&Theme::get(), &Theme::changed, this, &DialogFrame::fitWidth);
}

void DialogFrame::setWide(int width) {
    wide_ = width;
    fitWidth();
}

void DialogFrame::fitWidth() {
    if (wide_ > 0)
        setFixedWidth(std::min(Theme::get().px(wide_), roomOf(*this).width()));
}

void DialogFrame::setProblem(const QString& problem) {
    problem_->setText(problem);
    problem_->setVisible(!problem.isEmpty());
}

void DialogFrame::showEvent(QShowEvent* event) {
    fitHeight();
    QDialog::showEvent(event);
}

bool DialogFrame::event(QEvent* event) {
    const bool handled = QDialog::event(event);
    if (event->type() == QEvent::LayoutRequest && isVisible())
        keepLeastHeight();
    return handled;
}

/// Qt's own least height is what wrapped texts would need at another width. Lists that scroll may be lower.
void DialogFrame::keepLeastHeight() {
    const int whole = layout()->totalHeightForWidth(width());
    int scrolled = 0;  // lists stand beside each other
    for (const ScrollArea* list : findChildren<ScrollArea*>())
        if (list->isVisibleTo(this))
            scrolled = std::max(scrolled, list->sizeHint().height() - list->minimumSizeHint().height());
    setMinimumHeight(std::clamp(whole - scrolled, 0, roomOf(*this).height()));
}

void DialogFrame::fitHeight() {
    fitWidth();
    layout()->activate();
    keepLeastHeight();
    const int wide = std::min(width(), roomOf(*this).width());
    placeDialog(*this, {wide, layout()->totalHeightForWidth(wide)});
    layout()->activate();
    int hidden = 0;  // wrapped texts in a list say their height only at the width that it has got
    for (const ScrollArea* list : findChildren<ScrollArea*>())
        if (list->isVisibleTo(this))
            hidden = std::max(hidden, list->verticalScrollBar()->maximum());
    if (hidden > 0)
        placeDialog(*this, {wide, height() + hidden});
}

}  // namespace noctule::ui
