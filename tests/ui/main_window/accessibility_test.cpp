// SPDX-License-Identifier: Apache-2.0
// What must hold on every page: names for screen readers on everything that takes the keyboard, an order of
// focus without dead ends, and no text that does not fit, also at 150 percent.
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAccessible>
#include <QFile>
#include <QLabel>
#include <QScrollBar>
#include <set>

#include "tests/ui/main_window/studio_fixture.h"
#include "ui/main_window/side_docks.h"
#include "ui/style/theme.h"
#include "ui/views/export/export_form.h"
#include "ui/views/export/export_page.h"
#include "ui/views/page.h"
#include "ui/widgets/button.h"
#include "ui/widgets/scroll_area.h"

namespace noctule::ui {
namespace {

QString nameOf(QWidget& widget) {
    QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(&widget);
    return interface ? interface->text(QAccessible::Name) : QString();
}

/// "ToolButton 'close' in DockTitle", to find it by.
std::string describe(const QWidget& widget) {
    QString text = widget.metaObject()->className();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        text += " '" + button->text() + "'";
    if (const auto* label = qobject_cast<const QLabel*>(&widget))
        text += " '" + label->text() + "'";
    for (const QWidget* parent = widget.parentWidget(); parent; parent = parent->parentWidget())
        text += QString(" < ") + parent->metaObject()->className();
    return text.toStdString();
}

class Everywhere : public test::StudioWindow {
protected:
    template <class Check>
    void forEachVisible(Check&& check) {
        for (QWidget* widget : window_->findChildren<QWidget*>())
            if (widget->isVisible())
                check(*widget);
    }
    void expectNames(Step step) {
        window_->goTo(step);
        QCoreApplication::processEvents();
        forEachVisible([&](QWidget& widget) {
            const bool takes_keyboard = widget.focusPolicy() & Qt::TabFocus;
            if (!takes_keyboard || widget.focusProxy() || qobject_cast<QScrollBar*>(&widget))
                return;
            EXPECT_FALSE(nameOf(widget).isEmpty())
                << "step " << static_cast<int>(step) << ": " << describe(widget);
        });
    }
    /// The take of the virtual suit and three more like it.
    void openSeveralTakes() {
        openSampleTake();
        QStringList more;
        for (const char* name : {"fight_001", "fight_002", "turn_003"}) {
            more << folder_.filePath(QString(name) + ".noctule");
            ASSERT_TRUE(QFile::copy(studio_->take().path(), more.back()));
        }
        studio_->session().importTakes(more);
        ASSERT_TRUE(waitFor([this] { return studio_->session().session().takes.size() == 4; }));
    }
    /// Scrolls only where the content is higher than the area at its width.
    void expectNoNeedlessScrolling(Step step) {
        window_->goTo(step);
        waitFor([this] { return studio_->jobs().idle(); });
        QTest::qWait(50);
        for (const ScrollArea* area : window_->findChildren<ScrollArea*>()) {
            if (!area->isVisible() || !area->widget())
                continue;
            const int room = area->maximumViewportSize().height();
            const int needed = area->widget()->hasHeightForWidth()
                                   ? area->widget()->heightForWidth(area->maximumViewportSize().width())
                                   : area->widget()->minimumSizeHint().height();
            if (needed <= room) {
                EXPECT_EQ(area->verticalScrollBar()->maximum(), 0)
                    << "step " << static_cast<int>(step) << ": " << describe(*area);
            }
        }
    }
    /// Texts on labels and buttons have the room that they ask for.
    void expectRoom(Step step) {
        window_->goTo(step);
        waitFor([this] { return studio_->jobs().idle(); });  // what they find changes texts
        QTest::qWait(50);
        forEachVisible([&](QWidget& widget) {
            if (const auto* label = qobject_cast<QLabel*>(&widget)) {
                const bool elides = QString(label->metaObject()->className()).contains("Elided");
                if (label->text().isEmpty() || elides)
                    return;
                const int needed =
                    label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
                EXPECT_GE(label->height() + 1, needed) << "too low: " << describe(widget);
                if (!label->wordWrap()) {
                    EXPECT_GE(label->width() + 1, label->sizeHint().width())
                        << "too narrow: " << describe(widget);
                }
            } else if (const auto* button = qobject_cast<QAbstractButton*>(&widget)) {
                if (button->text().isEmpty() || button->inherits("QLineEditIconButton"))
                    return;
                EXPECT_GE(button->width() + 1, button->minimumSizeHint().width())
                    << "too narrow: " << describe(widget);
                EXPECT_GE(button->height() + 1, button->minimumSizeHint().height())
                    << "too low: " << describe(widget);
            }
        });
    }
};

TEST_F(Everywhere, WhatTakesTheKeyboardHasAName) {
    for (const Step step : test::kEveryStep)
        expectNames(step);
}

TEST_F(Everywhere, WhatTakesTheKeyboardHasANameWithATakeOpen) {
    openSampleTake();
    for (const Step step : {Step::kReview, Step::kExport, Step::kPerformer})
        expectNames(step);
}

TEST_F(Everywhere, TabGoesAroundWithoutADeadEnd) {
    for (const Step step : test::kEveryStep) {
        window_->goTo(step);
        QCoreApplication::processEvents();
        QWidget* const first = QApplication::focusWidget();
        std::set<QWidget*> visited;
        for (int i = 0; i < 400; ++i) {
            QTest::keyClick(window_.get(), Qt::Key_Tab);
            QWidget* now = QApplication::focusWidget();
            ASSERT_TRUE(now) << "step " << static_cast<int>(step);
            if (!visited.insert(now).second)
                break;
        }
        EXPECT_GE(visited.size(), 4U) << "step " << static_cast<int>(step);
        EXPECT_LT(visited.size(), 400U) << "step " << static_cast<int>(step);
        if (first && (first->focusPolicy() & Qt::TabFocus)) {
            EXPECT_TRUE(visited.count(first))
                << "step " << static_cast<int>(step) << ": Tab does not come back to " << describe(*first);
        }
    }
}

TEST_F(Everywhere, TextsHaveRoom) {
    window_->resize(1280, 800);
    for (const Step step : test::kEveryStep)
        expectRoom(step);
}

TEST_F(Everywhere, TextsHaveRoomAt150Percent) {
    window_->resize(1440, 900);
    Theme::get().setScale(1.5);
    for (const Step step : test::kEveryStep)
        expectRoom(step);
    Theme::get().setScale(1);
}

TEST_F(Everywhere, TextsHaveRoomWithTakes) {
    openSeveralTakes();
    window_->resize(1280, 800);
    for (const Step step : test::kEveryStep)
        expectRoom(step);
}

TEST_F(Everywhere, NothingScrollsWhereThereIsRoom) {
    openSeveralTakes();
    for (const QSize size : {QSize(1280, 800), QSize(1440, 900), QSize(1920, 1080)})
        for (const Scheme scheme : {Scheme::kLight, Scheme::kDark}) {  // all is laid out again
            Theme::get().setScheme(scheme);
            window_->resize(size);
            for (const Step step : test::kEveryStep)
                expectNoNeedlessScrolling(step);
        }
}

/// All of it is seen at once, whatever is exported: who looks for "Try first" does not have to scroll.
TEST_F(Everywhere, TheExportFormFitsTheSmallestScreen) {
    openSeveralTakes();
    window_->resize(1280, 800);
    window_->goTo(Step::kExport);
    auto& page = dynamic_cast<ExportPage&>(window_->page(Step::kExport));
    page.form().setTakes({"fight_001", "fight_002", "sample_001", "turn_003"});
    ASSERT_EQ(page.form().takes().size(), 4);
    for (const char* preset : {"motionbuilder", "bvh", "web", "angles", "film", "picture"}) {
        page.choosePreset(preset);
        page.form().range->setCurrentIndex(2);  // seconds of its own: a row more
        QTest::qWait(50);
        const QPoint below =
            page.form().try_one_frame->mapTo(&page, QPoint(0, page.form().try_one_frame->height()));
        EXPECT_LE(below.y(), page.form().parentWidget()->mapTo(&page, QPoint()).y() +
                                 page.form().parentWidget()->height())
            << preset;
        EXPECT_LE(page.form().height(), page.form().parentWidget()->height()) << preset << ": it scrolls";
    }
}

TEST_F(Everywhere, TheKeyboardStaysInExportWhenFilesAreWritten) {
    openSampleTake();
    window_->goTo(Step::kExport);
    auto& page = dynamic_cast<ExportPage&>(window_->page(Step::kExport));
    page.choosePreset("bvh");
    page.writeButton()->setFocus();
    QTest::keyClick(page.writeButton(), Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return page.results() && studio_->jobs().idle(); }));
    EXPECT_TRUE(QApplication::focusWidget() == &page || page.isAncestorOf(QApplication::focusWidget()))
        << describe(*QApplication::focusWidget());
}

TEST_F(Everywhere, PagesFollowTheTheme) {
    for (const Step step : test::kEveryStep) {
        window_->goTo(step);
        Theme::get().setScheme(Scheme::kDark);
        QTest::qWait(30);
        const QImage dark = window_->grab().toImage();
        Theme::get().setScheme(Scheme::kLight);
        QTest::qWait(30);
        const QImage light = window_->grab().toImage();
        const QPoint corner(4, 4), bottom(dark.width() / 2, dark.height() - 4);
        EXPECT_LT(dark.pixelColor(corner).lightness() + 60, light.pixelColor(corner).lightness());
        EXPECT_LT(dark.pixelColor(bottom).lightness() + 60, light.pixelColor(bottom).lightness());
    }
}

}  // namespace
}  // namespace noctule::ui
