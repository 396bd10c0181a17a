// SPDX-License-Identifier: Apache-2.0
#include "ui/views/record/record_page.h"

#include <QKeyEvent>
#include <QScrollArea>
#include <QStackedWidget>

#include "ui/scene/scene_view.h"
#include "ui/views/record/no_suit.h"
#include "ui/views/record/record_actions.h"
#include "ui/views/record/record_bar.h"
#include "ui/views/record/record_center.h"
#include "ui/views/record/record_readiness.h"
#include "ui/views/record/record_sidebar.h"
#include "ui/views/scaled_layout.h"

namespace noctule::ui {

RecordPage::RecordPage(Studio& studio, QWidget* parent)
    : Page(parent),
      studio_(studio),
      run_(studio),
      center_(new RecordCenter(studio, run_)),
      no_suit_(new NoSuit(studio)),
      stack_(new QStackedWidget),
      sidebar_(new RecordSidebar(studio, run_, this)),
      readiness_(new RecordReadiness(studio, this)),
      actions_(nullptr) {
    makeColumn(this)->addWidget(stack_);
    stack_->addWidget(center_);
    stack_->addWidget(no_suit_);
    setFocusPolicy(Qt::ClickFocus);
    for (QWidget* dock : {static_cast<QWidget*>(sidebar_), static_cast<QWidget*>(readiness_)}) {
        dock->hide();
        dock->installEventFilter(this);
        for (QScrollArea* area : dock->findChildren<QScrollArea*>())
            area->installEventFilter(this);
    }
    actions_ = new RecordActions(*this, studio.placeReset());
    connect(&run_, &RecordRun::changed, this, &RecordPage::refresh);
    connect(&center_->bar(), &RecordBar::fieldLeft, this, [this] { setFocus(); });
    connect(&center_->scene(), &SceneView::frameDrawn, this, [this] {
        if (readiness_)
            readiness_->setScreenDelay(center_->scene().frameDelays().quantile_s(0.5));
    });
    connect(&studio.session(), &SessionModel::opened, this, &RecordPage::tellTitles);
    connect(&studio.session(), &SessionModel::changed, this, &RecordPage::tellTitles);
    refresh();
    tellTitles();
}

RecordPage::~RecordPage() = default;

QWidget* RecordPage::leftDock() {
    return sidebar_;
}

QWidget* RecordPage::rightDock() {
    return readiness_;
}

RecordSidebar& RecordPage::sidebar() {
    return *sidebar_;
}

RecordReadiness& RecordPage::readiness() {
    return *readiness_;
}

QList<QAction*> RecordPage::menuActions() const {
    return actions_->all();
}

bool RecordPage::showsSuit() const {
    return stack_->currentWidget() == center_;
}

void RecordPage::enter() {
    setFocus();
}

void RecordPage::leave() {
    run_.endCountdown();
}

void RecordPage::refresh() {
    stack_->setCurrentWidget(run_.state() == RecordRun::State::kNoSuit ? static_cast<QWidget*>(no_suit_)
                                                                       : center_);
}

void RecordPage::tellTitles() {
    const SessionModel& session = studio_.session();
    const QString left = session.isOpen() ? QString::fromStdString(session.session().name) : tr("No session");
    if (left != leftDockTitle())
        setDockTitles(left, tr("Readiness"));
}

void RecordPage::keyPressEvent(QKeyEvent* event) {
    if (!actions_->handleKey(*event))
        Page::keyPressEvent(event);
}

/// Keys that nothing in a dock wanted come to its scroll areas and to itself last.
bool RecordPage::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::KeyPress && actions_->handleKey(*static_cast<QKeyEvent*>(event)))
        return true;
    return Page::eventFilter(object, event);
}

}  // namespace noctule::ui
