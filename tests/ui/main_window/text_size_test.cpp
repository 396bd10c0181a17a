// SPDX-License-Identifier: Apache-2.0
// The size of text is changed in Preferences while pages, panels and dialogs are open: they follow at once.
#include <QBoxLayout>
#include <QComboBox>
#include <QScrollArea>
#include <algorithm>

#include "tests/ui/main_window/clipping_fixture.h"
#include "ui/main_window/jobs_panel.h"
#include "ui/main_window/preferences_dialog.h"
#include "ui/main_window/top_bar.h"
#include "ui/plots/plot_lane.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/transport_bar.h"
#include "ui/views/connect/board_card.h"
#include "ui/views/connect/connect_page.h"
#include "ui/views/connect/readiness_panel.h"
#include "ui/views/export/export_form.h"
#include "ui/views/export/export_take_list.h"
#include "ui/views/record/record_bar.h"
#include "ui/views/review/review_center.h"
#include "ui/views/review/review_page.h"
#include "ui/views/review/scene_area.h"
#include "ui/views/window_place.h"
#include "ui/widgets/button.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/step_bar.h"

namespace noctule::ui {
namespace {

class TextSizeTest : public test::ClippingFixture {
protected:
    /// As the operator chooses it.
    static void choose(PreferencesDialog& dialog, int percent) {
        QComboBox& sizes = dialog.textSize();
        sizes.setCurrentIndex(sizes.findData(percent));
        emit sizes.activated(sizes.currentIndex());
    }
    /// No scroll area around it hides a part.
    static bool isSeenWhole(const QWidget& widget) {
        for (const QWidget* up = widget.parentWidget(); up; up = up->parentWidget()) {
            const auto* area = qobject_cast<const QScrollArea*>(up);
            if (area && !area->viewport()->rect().contains(
                            QRect(widget.mapTo(area, QPoint()) - area->viewport()->pos(), widget.size())))
                return false;
        }
        return true;
    }
};

TEST_P(TextSizeTest, AnOpenPageIsWholeAtEverySize) {
    openSampleTake();
    ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
    window_->resize(1440, 900);
    for (const Step step : test::kEveryStep) {
        window_->goTo(step);
        QTest::qWait(60);
        for (const double scale : {1.5, 0.75, 1.0}) {
            Theme::get().setScale(scale);
            QTest::qWait(60);
            expectWhole(*window_, QStringLiteral("page %1, made %2 times as large")
                                      .arg(window_->page(step).title())
                                      .arg(scale));
        }
    }
}

TEST_P(TextSizeTest, ASmallScreenWithLargeTextKeepsWhatMustBeSeen) {
    openSampleTake();
    ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
    window_->resize(1280, 800);
    Theme::get().setScale(1.5);
    for (const Step step : {Step::kConnect, Step::kReview, Step::kExport}) {
        window_->goTo(step);
        QTest::qWait(60);
        TopBar& bar = window_->topBar();
        const Chip* suit = bar.findChildren<Chip*>().front();
        ASSERT_TRUE(suit->isVisible()) << "a broken link must be seen";
        const QRect chip(suit->mapTo(&bar, QPoint()), suit->size());
        const QRect steps(bar.steps().mapTo(&bar, QPoint()), bar.steps().size());
        EXPECT_TRUE(bar.rect().contains(chip));
        EXPECT_FALSE(chip.intersects(steps));
    }
    window_->goTo(Step::kReview);
    QTest::qWait(60);
    const auto* transport = window_->findChild<TransportBar*>();
    EXPECT_EQ(transport->visibleRegion().boundingRect(), transport->rect());
    auto& review = dynamic_cast<ReviewPage&>(window_->page(Step::kReview)).center();
    EXPECT_TRUE(QTest::qWaitFor([&] { return isSeenWhole(review.plots()) && isSeenWhole(review.scenes()); }))
        << "body and curves at once, without scrolling";
    EXPECT_TRUE(isSeenWhole(*review.plots().lanes().front())) << "one curve from its title to its foot";
    EXPECT_GE(review.plots().height(), 160);
    EXPECT_GE(review.scenes().height(), 160);
    window_->goTo(Step::kExport);
    QTest::qWait(60);
    const auto* form = window_->findChild<ExportForm*>();
    const auto* takes = window_->findChild<ExportTakeList*>();
    EXPECT_GT(form->parentWidget()->height(), 2 * takes->height()) << "the settings have the room";
}

TEST_P(TextSizeTest, PreferencesFollowTheirOwnChange) {
    PreferencesDialog dialog(*studio_, window_.get());
    dialog.show();
    choose(dialog, 100);
    const QSize before = dialog.size();
    choose(dialog, 75);
    EXPECT_LT(dialog.height(), before.height());
    QTest::qWait(60);
    expectWhole(dialog, "preferences at 75 %");
    choose(dialog, 100);
    EXPECT_TRUE(QTest::qWaitFor([&] { return dialog.size() == before; })) << "once it has been laid out";
}

TEST_P(TextSizeTest, PreferencesStayWithinASmallWindow) {
    window_->resize(1280, 800);
    PreferencesDialog dialog(*studio_, window_.get());
    dialog.show();
    choose(dialog, 150);
    QTest::qWait(60);
    EXPECT_EQ(dialog.size().boundedTo(window_->size()), dialog.size());
    EXPECT_TRUE(freeRoom(*window_).contains(dialog.geometry())) << "grown, it stays on the screen";
    const auto closes = [](const Button* button) { return button->text() == PreferencesDialog::tr("Close"); };
    const auto buttons = dialog.findChildren<Button*>();
    const auto close = std::ranges::find_if(buttons, closes);
    ASSERT_NE(close, buttons.end());
    EXPECT_TRUE(dialog.rect().contains(QRect((*close)->mapTo(&dialog, QPoint()), (*close)->size())));
}

TEST_P(TextSizeTest, TheOpenPanelOfJobsFollows) {
    JobsPanel& panel = window_->jobsPanel();
    panel.toggle();
    const int before = panel.width();
    Theme::get().setScale(0.75);
    EXPECT_TRUE(QTest::qWaitFor([&] { return panel.width() < before; }, 1000));
    Theme::get().setScale(1);
    EXPECT_TRUE(QTest::qWaitFor([&] { return panel.width() == before; }, 1000));
}

INSTANTIATE_TEST_SUITE_P(Languages, TextSizeTest, testing::Values("en", "de"));

/// Where nothing gets another size by itself, what has room changes all the same.
class TextSizeOfPage : public test::StudioWindow {
protected:
    void TearDown() override {
        Theme::get().setScale(1);
        StudioWindow::TearDown();
    }
};

TEST_F(TextSizeOfPage, TheCardOfABoardGoesWhereThereIsRoom) {
    ConnectPage page(*studio_);
    page.resize(800, 740);
    page.show();
    ASSERT_TRUE(page.readiness().isAncestorOf(&page.card()));
    Theme::get().setScale(0.75);
    EXPECT_TRUE(page.isAncestorOf(&page.card()) && !page.readiness().isAncestorOf(&page.card()));
}

TEST_F(TextSizeOfPage, TheRecordBarSaysMoreWhereThereIsRoomAndIsAsHighAsItMust) {
    RecordRun run(*studio_);
    RecordBar bar(run);
    bar.resize(700, 90);
    bar.show();
    QTest::qWait(30);
    const int high = bar.sizeHint().height();
    const QString brief = bar.countdownButton().text();
    Theme::get().setScale(0.75);
    EXPECT_NE(bar.countdownButton().text(), brief);
    EXPECT_TRUE(QTest::qWaitFor([&] { return bar.sizeHint().height() < high; }, 1000));
    Theme::get().setScale(1.5);
    EXPECT_TRUE(QTest::qWaitFor([&] { return bar.minimumSizeHint().height() > high; }, 1000));
}

}  // namespace
}  // namespace noctule::ui
