// SPDX-License-Identifier: Apache-2.0
// What must hold on every page: names for screen readers on everything that takes the keyboard, an order of
// focus without dead ends, and no text that does not fit, also at 150 percent.
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAccessible>
#include <QLabel>
#include <QScrollBar>
#include <set>

#include "tests/ui/main_window/studio_fixture.h"
#include "ui/main_window/side_docks.h"
#include "ui/style/theme.h"
#include "ui/views/page.h"

namespace noctule::ui {
namespace {

constexpr Step kAllSteps[] = {Step::kStart,  Step::kConnect, Step::kCalibrate, Step::kRecord,
                              Step::kReview, Step::kExport,  Step::kPerformer};

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
                if (button->text().isEmpty())
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
    for (const Step step : kAllSteps)
        expectNames(step);
}

TEST_F(Everywhere, WhatTakesTheKeyboardHasANameWithATakeOpen) {
    openSampleTake();
    for (const Step step : {Step::kReview, Step::kExport, Step::kPerformer})
        expectNames(step);
}

TEST_F(Everywhere, TabGoesAroundWithoutADeadEnd) {
    for (const Step step : kAllSteps) {
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
    for (const Step step : kAllSteps)
        expectRoom(step);
}

TEST_F(Everywhere, TextsHaveRoomAt150Percent) {
    window_->resize(1440, 900);
    Theme::get().setScale(1.5);
    for (const Step step : kAllSteps)
        expectRoom(step);
    Theme::get().setScale(1);
}

TEST_F(Everywhere, PagesFollowTheTheme) {
    for (const Step step : kAllSteps) {
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
