// SPDX-License-Identifier: Apache-2.0
// All widgets in both themes at 75, 100 and 150 percent: nothing clips, every target is large enough,
// everything has a name and can be reached by keyboard. NOCTULE_TEST_PICTURES=folder keeps pictures to look
// at.
#include "tests/ui/widgets/gallery.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QLayout>
#include <QLineEdit>
#include <QSet>
#include <QTest>
#include <cmath>

#include "ui/widgets/widgets.h"

namespace noctule::ui {
namespace {

struct Look {
    Scheme scheme;
    int percent;
};

std::string nameOf(const Look& look) {
    return std::string(look.scheme == Scheme::kDark ? "dark_" : "light_") + std::to_string(look.percent);
}

std::string describe(const QWidget& widget) {
    return std::string(widget.metaObject()->className()) + " \"" + widget.accessibleName().toStdString() +
           "\"";
}

class GalleryTest : public testing::TestWithParam<Look> {
protected:
    void SetUp() override {
        Theme::install(*qApp);
        Theme::get().setScheme(GetParam().scheme);
        Theme::get().setScale(GetParam().percent / 100.0);
        gallery = makeGallery();
        gallery->resize(gallery->sizeHint());
        gallery->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(gallery.get()));
    }
    void TearDown() override {
        gallery.reset();
        Theme::get().setScheme(Scheme::kDark);
        Theme::get().setScale(1);
    }
    std::unique_ptr<QWidget> gallery;
};

TEST_P(GalleryTest, picture) {
    const QString folder = qEnvironmentVariable("NOCTULE_TEST_PICTURES");
    const QPixmap picture = gallery->grab();
    const QColor corner = picture.toImage().pixelColor(2, picture.height() - 3);
    EXPECT_EQ(corner.name().toStdString(), Theme::get().tokens().panel.name().toStdString());
    if (!folder.isEmpty()) {
        EXPECT_TRUE(picture.save(QDir(folder).filePath(QString::fromStdString(nameOf(GetParam()) + ".png"))));
    }
}

/// Editors inside spin boxes, buttons inside fields, headers inside tables: Qt's own business.
bool isPartOfAControl(const QWidget& widget) {
    const QWidget* parent = widget.parentWidget();
    return parent && (parent->inherits("QAbstractSpinBox") || parent->inherits("QLineEdit") ||
                      parent->inherits("QAbstractScrollArea") || parent->inherits("QTabBar"));
}

TEST_P(GalleryTest, nothingClips) {
    for (const auto* widget : gallery->findChildren<QWidget*>()) {
        if (!widget->isVisible() || qobject_cast<const ElidedLabel*>(widget) || isPartOfAControl(*widget))
            continue;
        const QSize least = widget->minimumSizeHint();
        EXPECT_GE(widget->width(), least.width()) << describe(*widget);
        const int least_height =
            widget->hasHeightForWidth() || (widget->layout() && widget->layout()->hasHeightForWidth())
                ? widget->heightForWidth(widget->width())
                : least.height();
        EXPECT_GE(widget->height(), least_height) << describe(*widget);
        if (const auto* label = qobject_cast<const QLabel*>(widget)) {
            EXPECT_GE(label->height(), label->heightForWidth(label->width())) << label->text().toStdString();
            if (!label->wordWrap()) {
                EXPECT_GE(label->width(), label->sizeHint().width()) << label->text().toStdString();
            }
        }
        if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
            EXPECT_GE(button->width(), button->sizeHint().width()) << button->text().toStdString();
        }
    }
}

TEST_P(GalleryTest, targetsAreLargeEnough) {
    const int least = Theme::get().px(28);
    for (const auto* widget : gallery->findChildren<QWidget*>()) {
        const bool target =
            qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QLineEdit*>(widget) ||
            qobject_cast<const QComboBox*>(widget) || qobject_cast<const RatingStars*>(widget);
        if (target && widget->isVisible() && !isPartOfAControl(*widget)) {
            EXPECT_GE(widget->height(), least) << describe(*widget);
        }
    }
}

TEST_P(GalleryTest, everythingInteractiveIsNamed) {
    for (auto* widget : gallery->findChildren<QWidget*>()) {
        if (!widget->isVisible() || !(widget->focusPolicy() & Qt::TabFocus) || isPartOfAControl(*widget))
            continue;
        QAccessibleInterface* reader = QAccessible::queryAccessibleInterface(widget);
        ASSERT_TRUE(reader) << describe(*widget);
        const bool plain = widget->inherits("QTableWidget") || widget->inherits("QPlainTextEdit") ||
                           widget->inherits("QSlider") || widget->inherits("QTabBar");
        if (!plain) {
            EXPECT_FALSE(reader->text(QAccessible::Name).isEmpty()) << describe(*widget);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Looks, GalleryTest,
                         testing::Values(Look{Scheme::kDark, 100}, Look{Scheme::kLight, 100},
                                         Look{Scheme::kDark, 150}, Look{Scheme::kLight, 150},
                                         Look{Scheme::kDark, 75}),
                         [](const auto& look) { return nameOf(look.param); });

TEST(Gallery, followsTheThemeWhileItIsShown) {
    Theme::install(*qApp);
    Theme::get().setScheme(Scheme::kDark);
    const auto live = makeGallery();
    live->resize(live->sizeHint());
    live->show();
    Theme::get().setScheme(Scheme::kLight);
    Theme::get().setScale(1.25);
    const auto fresh = makeGallery();
    QApplication::processEvents();
    const QSize live_size = live->sizeHint();
    const QSize fresh_size = fresh->sizeHint();
    EXPECT_NEAR(live_size.height(), fresh_size.height(), 40) << "a widget kept a size of the old scale";
    const QColor corner = live->grab().toImage().pixelColor(2, live->height() - 3);
    EXPECT_EQ(corner.name().toStdString(), Theme::get().tokens().panel.name().toStdString());
    Theme::get().setScheme(Scheme::kDark);
    Theme::get().setScale(1);
}

}  // namespace
}  // namespace noctule::ui
