// SPDX-License-Identifier: Apache-2.0
#include "ui/style/theme.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QComboBox>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFontDatabase>
#include <QFontInfo>
#include <QFontMetrics>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <cmath>
#include <map>
#include <set>

#include "ui/style/icons.h"
#include "ui/style/paint.h"
#include "ui/style/resources.h"

namespace noctule::ui {
namespace {

class ThemeTest : public testing::Test {
protected:
    void SetUp() override {
        Theme::install(*qApp);
        reset();
    }
    void TearDown() override { reset(); }
    static void reset() {
        Theme::get().setScheme(Scheme::kDark);
        Theme::get().setScale(1);
        Theme::get().setReduceMotion(false);
    }
};

/// How much ink is in `pixmap`: the sum of its opacities.
double inkOfPixels(const QPixmap& pixmap) {
    const QImage image = pixmap.toImage().convertToFormat(QImage::Format_ARGB32);
    double sum = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            sum += qAlpha(image.pixel(x, y)) / 255.0;
    return sum;
}

TEST_F(ThemeTest, schemesDifferAndTellIt) {
    Theme& theme = Theme::get();
    EXPECT_TRUE(theme.isDark());
    const QColor dark = theme.tokens().panel;
    QSignalSpy changed(&theme, &Theme::changed);
    theme.setScheme(Scheme::kLight);
    EXPECT_EQ(changed.count(), 1);
    EXPECT_FALSE(theme.isDark());
    EXPECT_NE(theme.tokens().panel, dark);
    EXPECT_EQ(qApp->palette().color(QPalette::Window), theme.tokens().panel);
    theme.setScheme(Scheme::kLight);
    EXPECT_EQ(changed.count(), 1);
}

TEST_F(ThemeTest, lengthsAndTypeFollowTheScale) {
    Theme& theme = Theme::get();
    EXPECT_EQ(theme.px(30), 30);
    EXPECT_EQ(theme.font(TextRole::kBody).pixelSize(), 13);
    theme.setScale(1.5);
    EXPECT_EQ(theme.px(30), 45);
    EXPECT_EQ(theme.font(TextRole::kVerdict).pixelSize(), 39);
    EXPECT_EQ(qApp->font().pixelSize(), 20);
    theme.setScale(9);
    EXPECT_DOUBLE_EQ(theme.scale(), 1.5);
    theme.setScale(0.75);
    EXPECT_GE(theme.px(1), 1) << "a hairline stays visible";
}

TEST_F(ThemeTest, fontsAreRobotoAndDigitsHaveOneWidth) {
    const Theme& theme = Theme::get();
    for (const bool medium : {false, true}) {
        const QFont font = theme.font(TextRole::kBody, medium);
        EXPECT_EQ(QFontInfo(font).family(), "Roboto");
        EXPECT_EQ(QFontInfo(font).weight(), medium ? QFont::Medium : QFont::Normal);
        std::set<int> widths;
        for (char digit = '0'; digit <= '9'; ++digit)
            widths.insert(QFontMetrics(font).horizontalAdvance(QChar(digit)));
        EXPECT_EQ(widths.size(), 1u);
    }
    EXPECT_EQ(QFontInfo(theme.font(TextRole::kClock)).weight(), QFont::Light);
}

TEST_F(ThemeTest, confidenceEndsWhereTheTokensEnd) {
    const Theme& theme = Theme::get();
    EXPECT_EQ(theme.confidence(0), theme.tokens().confidence.front());
    EXPECT_EQ(theme.confidence(1), theme.tokens().confidence.back());
    EXPECT_EQ(theme.confidence(7), theme.tokens().confidence.back());
    EXPECT_EQ(theme.confidence(std::nan("")), theme.tokens().confidence.front());
}

TEST_F(ThemeTest, reducedMotionTakesNoTime) {
    EXPECT_EQ(Theme::get().motion_ms(120), 120);
    Theme::get().setReduceMotion(true);
    EXPECT_EQ(Theme::get().motion_ms(120), 0);
}

TEST_F(ThemeTest, everyIconDrawsInTheAskedColour) {
    const QStringList files = QDir(resourcePath("icons")).entryList({"*.svg"});
    ASSERT_GE(files.size(), 60);
    for (const QString& file : files) {
        SCOPED_TRACE(file.toStdString());
        const QPixmap pixmap = drawIcon(file.chopped(4), 32, QColor("#123456"), 1);
        EXPECT_GT(inkOfPixels(pixmap), 12);
        EXPECT_LT(inkOfPixels(pixmap), 700);
        const QImage image = pixmap.toImage().convertToFormat(QImage::Format_ARGB32);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x)
                if (qAlpha(image.pixel(x, y)) == 255) {
                    EXPECT_EQ(QColor(image.pixel(x, y)).name().toStdString(), "#123456");
                }
    }
}

/// As literals in the calls that draw an icon, or make a button with one.
std::map<QString, QString> iconsThatTheSourcesName() {
    const QRegularExpression calls[] = {
        QRegularExpression(
            R"re(\b(?:ToolButton|IconLabel|BigButton|drawIcon|icon)\(\s*(?:QStringLiteral\()?"([a-z0-9_]+)")re"),
        QRegularExpression(
            R"re(\bmakeButton\(\s*ButtonKind::\w+,\s*(?:tr\("[^"]*"[^()]*\)|\{\}|\w+),\s*"([a-z0-9_]+)")re")};
    std::map<QString, QString> named;  // icon, one of the files
    QDirIterator files(NOCTULE_SOURCE_DIR "/ui", {"*.cpp"}, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        if (!file.open(QFile::ReadOnly))
            continue;
        const QString text = QString::fromUtf8(file.readAll());
        for (const QRegularExpression& call : calls)
            for (auto match = call.globalMatch(text); match.hasNext();)
                named.emplace(match.next().captured(1), file.fileName());
    }
    return named;
}

TEST_F(ThemeTest, everyIconThatTheSourcesNameIsThere) {
    const auto named = iconsThatTheSourcesName();
    EXPECT_GT(named.size(), 40u) << "the calls are no longer found";
    for (const auto& [name, file] : named)
        EXPECT_TRUE(QFile::exists(resourcePath("icons/" + name + ".svg")))
            << name.toStdString() << " in " << file.toStdString();
}

TEST_F(ThemeTest, pictureOfAllIcons) {
    const QString folder = qEnvironmentVariable("NOCTULE_TEST_PICTURES");
    if (folder.isEmpty())
        GTEST_SKIP() << "NOCTULE_TEST_PICTURES names no folder";
    const QStringList files = QDir(resourcePath("icons")).entryList({"*.svg"});
    constexpr int kColumns = 12;
    constexpr int kCell = 76;
    QPixmap sheet(kColumns * kCell, (files.size() / kColumns + 1) * kCell);
    sheet.fill(Theme::get().tokens().panel);
    QPainter painter(&sheet);
    painter.setFont(Theme::get().font(TextRole::kCaption));
    for (int i = 0; i < files.size(); ++i) {
        const QRect cell(i % kColumns * kCell, i / kColumns * kCell, kCell, kCell);
        const QString name = files[i].chopped(4);
        paintIcon(painter, cell.adjusted(0, 4, -kCell / 2, -24), name, 16, Theme::get().tokens().t1);
        paintIcon(painter, cell.adjusted(kCell / 2 - 8, 4, 0, -24), name, 32, Theme::get().tokens().t1);
        painter.setPen(Theme::get().tokens().t2);
        painter.drawText(cell.adjusted(0, 0, 0, -4), Qt::AlignHCenter | Qt::AlignBottom, name);
    }
    painter.end();
    EXPECT_TRUE(sheet.save(QDir(folder).filePath("icons.png")));
}

TEST_F(ThemeTest, popupsAreDense) {
    QMenu menu;
    QAction* open = menu.addAction(
        Theme::get().icon("open"), "&Open session…", [] {}, QKeySequence("Ctrl+O"));
    QAction* rays = menu.addAction("&Rays");
    rays->setCheckable(true);
    rays->setChecked(true);
    menu.addSeparator();
    menu.addAction("Reset this layout")->setEnabled(false);
    menu.addMenu("Recent")->addAction("Stage tests");
    menu.setActiveAction(open);
    menu.popup({20, 20});
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&menu));
    EXPECT_EQ(menu.actionGeometry(open).height(), 28);
    EXPECT_LT(menu.actionGeometry(open).width(), 260);
    const QString folder = qEnvironmentVariable("NOCTULE_TEST_PICTURES");
    if (!folder.isEmpty()) {
        EXPECT_TRUE(menu.grab().save(QDir(folder).filePath("menu.png")));
    }
    menu.close();
    QComboBox box;
    for (int i = 0; i < 40; ++i)
        box.addItem(QString("%1 per second").arg(10 * i));
    box.show();
    box.showPopup();
    QWidget* list = box.view()->window();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(list));
    EXPECT_EQ(box.view()->visualRect(box.model()->index(0, 0)).height(), 28);
    if (!folder.isEmpty()) {
        EXPECT_TRUE(list->grab().save(QDir(folder).filePath("list.png")));
    }
}

TEST_F(ThemeTest, iconsAreSharpAtEveryRatio) {
    for (const double ratio : {1.0, 1.5, 2.0}) {
        const QPixmap pixmap = drawIcon("board", 16, Qt::white, ratio);
        EXPECT_EQ(pixmap.width(), qRound(16 * ratio));
        EXPECT_DOUBLE_EQ(pixmap.devicePixelRatio(), ratio);
    }
    const double once = inkOfPixels(drawIcon("board", 16, Qt::white, 1));
    const double twice = inkOfPixels(drawIcon("board", 16, Qt::white, 2));
    EXPECT_NEAR(twice / once, 4, 0.4) << "drawn anew, in the same shape";
}

TEST_F(ThemeTest, unknownIconIsACrossedBoxAndFailsATest) {
    QPixmap pixmap;
    EXPECT_NONFATAL_FAILURE(pixmap = drawIcon("no_such_icon", 16, Qt::white, 1), "no_such_icon");
    EXPECT_GT(inkOfPixels(pixmap), 10);
}

TEST_F(ThemeTest, iconFollowsState) {
    const QIcon icon = Theme::get().icon("check");
    const auto strongest = [&icon](QIcon::Mode mode, QIcon::State state) {
        const QImage image = icon.pixmap(QSize(32, 32), mode, state).toImage();
        QColor found;
        int alpha = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (const QColor color = image.pixelColor(x, y); color.alpha() > alpha) {
                    alpha = color.alpha();
                    found = color;
                }
        return found.name().toStdString();
    };
    const Tokens& tokens = Theme::get().tokens();
    EXPECT_EQ(strongest(QIcon::Normal, QIcon::Off), tokens.t2.name().toStdString());
    EXPECT_EQ(strongest(QIcon::Normal, QIcon::On), tokens.acc.name().toStdString());
    EXPECT_EQ(strongest(QIcon::Disabled, QIcon::Off), tokens.t3.name().toStdString());
}

TEST_F(ThemeTest, ringGoesAroundWhatTheKeyboardReached) {
    QWidget window;
    auto* column = new QVBoxLayout(&window);
    auto* first = new QPushButton("First");
    auto* second = new QPushButton("Second");
    column->addWidget(first);
    column->addWidget(second);
    window.show();
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    qApp->setActiveWindow(&window);
    first->setFocus(Qt::MouseFocusReason);
    EXPECT_FALSE(window.findChild<QWidget*>("focus_ring"));
    QTest::keyClick(first, Qt::Key_Tab);
    ASSERT_TRUE(second->hasFocus());
    auto* ring = window.findChild<QWidget*>("focus_ring");
    ASSERT_TRUE(ring && ring->isVisible());
    EXPECT_EQ(ring->geometry(), second->geometry().adjusted(-4, -4, 4, 4));
    QTest::mouseClick(first, Qt::LeftButton);
    EXPECT_FALSE(ring->isVisible());
}

TEST_F(ThemeTest, fieldsAreAsHighAsTheGuideSays) {
    QLineEdit edit;
    EXPECT_EQ(edit.sizeHint().height(), 30);
    QPushButton button("Browse");
    EXPECT_EQ(button.sizeHint().height(), 30);
    Theme::get().setScale(1.5);
    QLineEdit larger;
    EXPECT_EQ(larger.sizeHint().height(), 45);
}

}  // namespace
}  // namespace noctule::ui
