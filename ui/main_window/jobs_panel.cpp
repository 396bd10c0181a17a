// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/jobs_panel.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/main_window/job_row.h"
#include "ui/style/keys.h"
#include "ui/style/theme.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/dock_title.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

constexpr int kWidth = 400, kTallest = 420, kStatusLine = 26, kMargin = 12;

}  // namespace

JobsPanel::JobsPanel(Jobs& jobs, QWidget* window) : QFrame(window), jobs_(jobs) {
    setAccessibleName(tr("Jobs"));
    auto* outer = makeColumn(this, {1, 1, 1, 1});
    auto* title = new DockTitle(tr("Jobs"));
    clear_ = makeButton(ButtonKind::kText, tr("Clear finished"));
    auto* close = new ToolButton("close", tr("Close"));
    followKey(*close, "window/jobs", QKeySequence("Ctrl+J"),
              [close](const QKeySequence& key) { close->setMeaning("close", tr("Close"), key); });
    title->addAction(clear_);
    title->addAction(close);
    outer->addWidget(title);
    list_ = new QWidget;
    column_ = makeColumn(list_, {0, 4, 0, 4});
    none_ = new Label(
        tr("Processing, imports and exports are listed here while they run, and until they are seen."),
        TextRole::kBody, Ink::kLabel);
    none_->wrapped();
    column_->addWidget(none_);
    column_->addStretch();
    area_ = new ScrollArea(list_);
    outer->addWidget(area_, 1);
    connect(clear_, &QPushButton::clicked, &jobs_, &Jobs::clearEnded);
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    connect(&jobs_, &Jobs::changed, this, &JobsPanel::follow);
    // Once all that it holds has its new size.
    connect(
        &Theme::get(), &Theme::changed, this,
        [this] {
            if (isVisible())
                place();
        },
        Qt::QueuedConnection);
    window->installEventFilter(this);
    follow();
    hide();
}

void JobsPanel::follow() {
    const std::vector<Job*>& all = jobs_.all();
    for (auto row = rows_.begin(); row != rows_.end();)
        if (std::find(all.begin(), all.end(), row->first) == all.end()) {
            row->second->deleteLater();
            row = rows_.erase(row);
        } else {
            ++row;
        }
    bool any_ended = false;
    for (Job* job : all) {
        any_ended |= job->state() != Job::State::kRunning;
        if (rows_.count(job))
            continue;
        rows_[job] = new JobRow(*job);
        column_->insertWidget(0, rows_[job]);
    }
    none_->setVisible(all.empty());
    clear_->setVisible(any_ended);
    if (isVisible())
        place();
}

void JobsPanel::toggle() {
    if (isVisible())
        return hide();
    show();
}

void JobsPanel::place() {
    const Theme& theme = Theme::get();
    none_->setMargin(theme.px(12));
    const QWidget& window = *parentWidget();
    const int width = std::min(theme.px(kWidth), window.width() - theme.px(2 * kMargin));
    const int room = window.height() - theme.px(kStatusLine + 2 * kMargin + 52);
    const int wanted =
        list_->heightForWidth(width) > 0 ? list_->heightForWidth(width) : list_->sizeHint().height();
    const int height = std::min({room, theme.px(kTallest), wanted + theme.px(36 + 12)});
    setGeometry(window.width() - width - theme.px(kMargin),
                window.height() - height - theme.px(kStatusLine + kMargin), width, height);
    raise();
}

void JobsPanel::showEvent(QShowEvent*) {
    focus_before_ = QApplication::focusWidget();
    place();
    setFocusPolicy(Qt::TabFocus);
    if (QWidget* first = nextInFocusChain())
        first->setFocus(Qt::TabFocusReason);
}

void JobsPanel::hideEvent(QHideEvent*) {
    for (Job* job : jobs_.all())
        if (job->state() != Job::State::kRunning)
            job->setSeen();
    emit closed();
    if (focus_before_)
        focus_before_->setFocus();
    focus_before_ = nullptr;
}

void JobsPanel::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape)
        hide();
    else
        QFrame::keyPressEvent(event);
}

bool JobsPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && isVisible())
        place();
    return QFrame::eventFilter(watched, event);
}

void JobsPanel::paintEvent(QPaintEvent*) {
    const Tokens& tokens = Theme::get().tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(tokens.edge);
    painter.setBrush(tokens.panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
}

}  // namespace noctule::ui
