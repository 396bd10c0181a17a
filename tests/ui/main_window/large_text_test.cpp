// SPDX-License-Identifier: Apache-2.0
// The smallest screen with text of 100, 125 and 150 percent: everything can be read and reached.
#include <QDir>
#include <QScrollArea>
#include <QScrollBar>

#include "tests/ui/main_window/clipping_fixture.h"
#include "ui/main_window/panel_tab.h"
#include "ui/main_window/side_docks.h"
#include "ui/views/export/export_form.h"
#include "ui/views/export/export_page.h"
#include "ui/views/export/export_settings.h"
#include "ui/views/report/report_view.h"
#include "ui/views/review/review_page.h"
#include "ui/widgets/button.h"

namespace noctule::ui {
namespace {

constexpr int kRounding_px = 2;
constexpr int kSettled_ms = 200;   ///< after it docks keep the widths that they are given
constexpr int kScrollBar_px = 12;  ///< it comes or goes with the height of what a dock holds

class LargeText : public test::ClippingFixture {
protected:
    void open(Step step) {
        openSampleTake();
        ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
        window_->resize(1280, 800);
        window_->goTo(step);
    }
    /// Colours cut nothing.
    template <class Look>
    void atEverySize(Look look) {
        for (const double scale : {1.0, 1.25, 1.5}) {
            Theme::get().setScale(scale);
            window_->resize(1280, 800);
            window_->sideDocks().reset();
            QTest::qWait(kSettled_ms);
            look(QStringLiteral("%1, %2 %").arg(GetParam()).arg(100 * scale));
        }
    }
    void expectWindowWhole(const QString& where) {
        expectWholeAndItsLanguage(*window_, where);
        EXPECT_EQ(window_->size(), QSize(1280, 800)) << where.toStdString();
        savePictures(where);
    }
    /// With NOCTULE_SCREENSHOTS, for whoever wants to look at them.
    void savePictures(QString where) {
        const QString folder = qEnvironmentVariable("NOCTULE_SCREENSHOTS");
        if (folder.isEmpty())
            return;
        where.remove(',').remove(" %").replace(' ', '-');
        for (const Scheme scheme : {Scheme::kLight, Scheme::kDark}) {
            Theme::get().setScheme(scheme);
            QTest::qWait(100);
            window_->grab().save(QDir(folder).filePath(
                QStringLiteral("large-%1-%2.png").arg(where, scheme == Scheme::kDark ? "dark" : "light")));
        }
    }
    /// Scrolled to, no scroll area around it hides a part.
    static bool canBeSeenWhole(QWidget& widget) {
        for (QWidget* up = widget.parentWidget(); up; up = up->parentWidget()) {
            auto* area = qobject_cast<QScrollArea*>(up);
            if (!area)
                continue;
            const QPoint middle = widget.mapTo(area->widget(), widget.rect().center());
            area->ensureVisible(middle.x(), middle.y(), 0, widget.height() / 2 + 1);
            const QRect place(widget.mapTo(area->viewport(), QPoint()), widget.size());
            if (!area->viewport()->rect().contains(place))
                return false;
        }
        return true;
    }
};

TEST_P(LargeText, ExportShowsTheSettingsOfEveryPreset) {
    open(Step::kExport);
    auto& page = dynamic_cast<ExportPage&>(window_->page(Step::kExport));
    ExportForm& form = page.form();
    const ExportPresets presets(studio_->settings());
    atEverySize([&](const QString& look) {
        for (const ExportPreset& preset : presets.all()) {
            const QString where = look + ", export " + preset.key;
            page.choosePreset(preset.key);
            form.range->setCurrentIndex(form.range->count() - 1);  // the one with fields of its own
            QTest::qWait(30);
            expectWindowWhole(where);
            const QWidget* view = form.parentWidget();
            while (!qobject_cast<const QScrollArea*>(view->parentWidget()))
                view = view->parentWidget();
            EXPECT_GE(view->height(), page.height() / 2) << where.toStdString() << ": the settings' room";
            for (QWidget* part : form.findChildren<QWidget*>())
                if (part->isVisible() && part->focusPolicy() != Qt::NoFocus)
                    EXPECT_TRUE(canBeSeenWhole(*part))
                        << where.toStdString() << ": " << part->accessibleName().toStdString();
            EXPECT_TRUE(canBeSeenWhole(*form.takesPart())) << where.toStdString();
        }
    });
}

TEST_P(LargeText, TheFullReportIsReadWithoutScrollingSideways) {
    open(Step::kReview);
    dynamic_cast<ReviewPage&>(window_->page(Step::kReview)).openFullReport();
    ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
    auto& report = *window_->findChild<ReportView*>();
    atEverySize([&](const QString& look) {
        expectWindowWhole(look + ", report");
        const QScrollBar& sideways = *report.page().horizontalScrollBar();
        EXPECT_TRUE(QTest::qWaitFor([&] { return sideways.maximum() <= kRounding_px; }))
            << look.toStdString() << " scrolls sideways by " << sideways.maximum();
        QDockWidget& right = window_->sideDocks().right();
        window_->resizeDocks({&right}, {right.maximumWidth()}, Qt::Horizontal);
        QTest::qWait(60);
        expectWindowWhole(look + ", report beside a wide panel");
    });
}

/// Of the docks of a step; 0: not seen.
std::pair<int, int> widthsOf(SideDocks& docks) {
    const auto width = [](const QDockWidget& dock) { return dock.isVisible() ? dock.width() : 0; };
    return {width(docks.left()), width(docks.right())};
}

TEST_P(LargeText, DocksHaveTheirUsualWidthsAgainAfterwards) {
    open(Step::kReview);
    SideDocks& docks = window_->sideDocks();
    for (const int width : {1280, 1440, 1900}) {
        window_->resize(width, 800);
        for (const Step step : test::kEveryStep) {
            window_->goTo(step);
            docks.reset();
            QTest::qWait(200);  // a page that is shown for the first time learns its sizes
            docks.reset();
            QTest::qWait(200);
            const auto usual = widthsOf(docks);
            const std::string where =
                window_->page(step).title().toStdString() + ", " + std::to_string(width);
            const auto expectUsual = [&](const char* when) {
                const auto isUsual = [&] {
                    const auto [left, right] = widthsOf(docks);
                    return std::abs(left - usual.first) <= kScrollBar_px &&
                           std::abs(right - usual.second) <= kScrollBar_px;
                };
                EXPECT_TRUE(QTest::qWaitFor(isUsual))
                    << where << ", " << when << ": " << widthsOf(docks).first << " and "
                    << widthsOf(docks).second << " instead of " << usual.first << " and " << usual.second;
            };
            for (const double scale : {1.25, 1.5, 1.0}) {
                Theme::get().setScale(scale);
                QTest::qWait(60);
            }
            expectUsual("100 % again");
            Theme::get().setScale(1.5);
            QTest::qWait(60);
            window_->goTo(step == Step::kConnect ? Step::kReview : Step::kConnect);
            Theme::get().setScale(1);
            QTest::qWait(60);
            window_->goTo(step);
            expectUsual("100 % again on another page");
            QTest::qWait(kSettled_ms);
            window_->resizeDocks({&docks.left(), &docks.right()}, {350, 390}, Qt::Horizontal);
            QTest::qWait(60);
            if (docks.left().isVisible() && docks.right().isVisible()) {
                EXPECT_NE(widthsOf(docks), usual) << where;
            }
            docks.reset();
            expectUsual("reset");
        }
    }
}

TEST_P(LargeText, AFoldedPanelLeavesATabThatShowsIt) {
    open(Step::kReview);
    SideDocks& docks = window_->sideDocks();
    for (const Step step : test::kEveryStep) {
        window_->goTo(step);
        atEverySize([&](const QString& look) {
            const Page& page = window_->page(step);
            const QString where = look + ", folded, page " + page.title();
            expectWindowWhole(where);
            const bool has_left = window_->page(step).leftDock() != nullptr;
            EXPECT_EQ(docks.leftTab().isVisible(), has_left && !docks.left().isVisible())
                << where.toStdString();
            EXPECT_FALSE(docks.rightTab().isVisible()) << where.toStdString();
            if (!docks.leftTab().isVisible())
                return;
            EXPECT_EQ(docks.leftTab().text(), page.leftDockTitle());
            docks.leftTab().click();
            QTest::qWait(60);
            EXPECT_TRUE(docks.left().isVisible() && !docks.leftTab().isVisible()) << where.toStdString();
            EXPECT_TRUE(!docks.right().isVisible() && docks.rightTab().isVisible()) << where.toStdString();
            expectWindowWhole(look + ", the other one folded, page " + page.title());
            docks.rightTab().click();
            QTest::qWait(60);
            EXPECT_TRUE(docks.right().isVisible() && docks.leftTab().isVisible()) << where.toStdString();
            docks.leftTab().setFocus(Qt::TabFocusReason);
            QTest::keyClick(&docks.leftTab(), Qt::Key_Space);
            EXPECT_TRUE(docks.left().isVisible()) << where.toStdString();
            EXPECT_TRUE(docks.left().isAncestorOf(window_->focusWidget())) << "and the next keys are for it";
        });
        Theme::get().setScale(1);
    }
}

TEST_P(LargeText, APanelThatTheOperatorClosedLeavesNoTab) {
    open(Step::kReview);
    SideDocks& docks = window_->sideDocks();
    docks.left().close();
    QTest::qWait(60);
    EXPECT_FALSE(docks.leftTab().isVisible());
}

INSTANTIATE_TEST_SUITE_P(Languages, LargeText, testing::Values("en", "de"));

}  // namespace
}  // namespace noctule::ui
