// SPDX-License-Identifier: Apache-2.0
// The performer page: measures drive the body, boards are moved, mirrored and put back, and all of it is
// undone.
#include "ui/views/performer/performer_page.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScopeGuard>
#include <QTableView>
#include <QTest>
#include <QUndoStack>

#include "core/math/rotation.h"
#include "core/session/session_json.h"
#include "core/suit/default_suit.h"
#include "tests/support/files.h"
#include "ui/scene/scene_view.h"
#include "ui/style/lengths.h"
#include "ui/style/theme.h"
#include "ui/views/length_box.h"
#include "ui/views/performer/length_field.h"
#include "ui/views/performer/performer_editor.h"
#include "ui/views/performer/performer_measures_panel.h"
#include "ui/views/performer/performer_placement_panel.h"
#include "ui/widgets/button.h"

namespace noctule::ui {
namespace {

class PerformerPageTest : public testing::Test {
protected:
    void SetUp() override {
        Theme::install(*qApp);
        studio_ = std::make_unique<Studio>(StudioParts{"test", [] { return std::string(); }, {}});
        ASSERT_TRUE(studio_->session().create(QString::fromStdString(home_.file("s")), "Test"));
        makePage();
    }
    void makePage() {
        removePage();
        page_ = std::make_unique<PerformerPage>(*studio_);
        page_->leftDock()->resize(248, 800);
        page_->rightDock()->resize(295, 800);
        page_->leftDock()->show();
        page_->rightDock()->show();
    }
    void removePage() {
        if (!page_)
            return;
        delete page_->leftDock();
        delete page_->rightDock();
        page_.reset();
    }
    void TearDown() override {
        removePage();
        studio_.reset();
    }

    PerformerEditor& editor() { return page_->editor(); }
    const Performer& performer() { return studio_->session().session().performers.at(0); }
    UndoHistory& undo() { return studio_->session().undoStack(); }
    void chooseBoard(const char* id) {
        editor().choosePart({SuitPart::Kind::kBoard, performer().suit.findBoard(id)});
    }
    const Board& board(const char* id) {
        return performer().suit.boards[static_cast<size_t>(performer().suit.findBoard(id))];
    }

    const noctule::test::Folder home_;
    std::unique_ptr<Studio> studio_;
    std::unique_ptr<PerformerPage> page_;
};

TEST_F(PerformerPageTest, HeightDrivesTheActorAndTheSuitLive) {
    const nlohmann::json before = toJson(studio_->session().session());
    LengthBox& height = page_->measures().height();
    EXPECT_EQ(height.value(), 1.75);
    for (int i = 0; i < 10; ++i)
        QTest::keyClick(&height, Qt::Key_Up);
    EXPECT_NEAR(performer().measures.height_m, 1.85, 1e-9);
    EXPECT_NEAR(editor().actor().height_m, 1.85, 1e-9);
    const Suit expected = suitOnActor(defaultSuit(), editor().actor());
    EXPECT_LT((board("l_leg").p_segment_board_m -
               expected.boards[static_cast<size_t>(expected.findBoard("l_leg"))].p_segment_board_m)
                  .norm(),
              1e-9);
    EXPECT_EQ(undo().count(), 1);
    undo().undo();
    EXPECT_EQ(toJson(studio_->session().session()), before);
    EXPECT_EQ(height.value(), 1.75);
}

TEST_F(PerformerPageTest, EmptyLengthFollowsTheHeight) {
    LengthField& forearm = page_->measures().field(&BodyMeasures::forearm_m);
    EXPECT_TRUE(forearm.edit()->text().isEmpty());
    EXPECT_EQ(forearm.edit()->placeholderText(), QLocale().toString(25.0, 'f', 1));
    forearm.edit()->setText("27");
    QTest::keyClick(forearm.edit(), Qt::Key_Return);
    EXPECT_NEAR(performer().measures.forearm_m, 0.27, 1e-9);
    EXPECT_NEAR(editor().actor().skeleton.joint(editor().actor().skeleton.find("LeftHand")).offset_m.norm(),
                0.27, 1e-9);
    QTest::keyClick(forearm.edit(), Qt::Key_Up);
    EXPECT_NEAR(performer().measures.forearm_m, 0.275, 1e-9);
    forearm.edit()->clear();
    QTest::keyClick(forearm.edit(), Qt::Key_Return);
    EXPECT_EQ(performer().measures.forearm_m, 0);
}

TEST_F(PerformerPageTest, LengthsAreShownAndTypedInFeetAndInchesWhenChosen) {
    chooseUnits(Units::kImperial);
    const auto back = qScopeGuard([] { chooseUnits(Units::kMetric); });
    makePage();
    LengthBox& height = page_->measures().height();
    EXPECT_EQ(height.text(), QString::fromUtf8("5′8.9″"));
    height.selectAll();
    QTest::keyClicks(&height, "5'11\"");
    QTest::keyClick(&height, Qt::Key_Return);
    EXPECT_EQ(height.text(), QString::fromUtf8("5′11″"));
    EXPECT_EQ(performer().measures.height_m, 1.8034);
    height.selectAll();
    QTest::keyClicks(&height, "180.12 cm");
    QTest::keyClick(&height, Qt::Key_Return);
    EXPECT_EQ(height.text(), QString::fromUtf8("5′10.9″"));
    EXPECT_EQ(performer().measures.height_m, 1.8012);
    LengthField& forearm = page_->measures().field(&BodyMeasures::forearm_m);
    forearm.edit()->setText("10.2");
    QTest::keyClick(forearm.edit(), Qt::Key_Return);
    EXPECT_NEAR(performer().measures.forearm_m, 0.25908, 1e-9);
    EXPECT_EQ(forearm.edit()->text(), "10.2");
    QTest::keyClick(forearm.edit(), Qt::Key_Up);
    EXPECT_NEAR(performer().measures.forearm_m, 10.5 * kMetresPerInch, 1e-9);
}

TEST_F(PerformerPageTest, AHeightThatNobodyTypedKeepsEveryBit) {
    constexpr double kMeasured_m = 1.7812345678901234;
    for (const Units units : {Units::kImperial, Units::kMetric}) {
        chooseUnits(units);
        const auto back = qScopeGuard([] { chooseUnits(Units::kMetric); });
        makePage();
        editor().setHeight(kMeasured_m);
        LengthBox& height = page_->measures().height();
        height.setFocus();
        QTest::keyClick(&height, Qt::Key_Return);
        EXPECT_EQ(performer().measures.height_m, kMeasured_m) << height.text().toStdString();
    }
}

TEST_F(PerformerPageTest, AHeightThatIsNoLengthGoesBackToTheOldOne) {
    LengthBox& height = page_->measures().height();
    for (const char* nonsense : {"71 i", "50 kg", "180 cm 2", "abc"}) {
        height.selectAll();
        QTest::keyClicks(&height, nonsense);
        EXPECT_EQ(performer().measures.height_m, 1.75) << nonsense << ": a beginning is no height";
        QTest::keyClick(&height, Qt::Key_Return);
        EXPECT_EQ(performer().measures.height_m, 1.75) << nonsense;
        EXPECT_EQ(height.text(), height.textFromValue(1.75)) << nonsense;
    }
    EXPECT_EQ(undo().count(), 0);
    height.selectAll();
    QTest::keyClicks(&height, "71 in");
    QTest::keyClick(&height, Qt::Key_Return);
    EXPECT_EQ(performer().measures.height_m, 1.8034);
    EXPECT_EQ(undo().count(), 1);
    height.selectAll();
    QTest::keyClicks(&height, "160");
    QTest::keyClick(&height, Qt::Key_Up);
    EXPECT_NEAR(performer().measures.height_m, 1.61, 1e-9) << "a step from what was typed";
}

TEST_F(PerformerPageTest, NonsenseInAFieldChangesNothing) {
    LengthField& forearm = page_->measures().field(&BodyMeasures::forearm_m);
    for (const char* nonsense : {"abc", "-5", "0", "1e999"}) {
        forearm.edit()->setText(nonsense);
        QTest::keyClick(forearm.edit(), Qt::Key_Return);
        EXPECT_EQ(performer().measures.forearm_m, 0) << nonsense;
    }
    EXPECT_EQ(undo().count(), 0);
}

TEST_F(PerformerPageTest, DoubtsAreSaidInWords) {
    BodyMeasures measures;
    EXPECT_TRUE(PerformerMeasuresPanel::doubtsInWords(measures).isEmpty());
    measures.forearm_m = 0.4;
    EXPECT_TRUE(PerformerMeasuresPanel::doubtsInWords(measures).startsWith("Forearm: 40"));
    measures.forearm_m = 0;
    measures.thigh_m = measures.shin_m = 0.51;
    EXPECT_TRUE(PerformerMeasuresPanel::doubtsInWords(measures).startsWith("Trunk and legs make"));
}

TEST_F(PerformerPageTest, RowBodyAndNumbersShowOneChoice) {
    QTableView& table = page_->placement().table();
    EXPECT_EQ(table.model()->rowCount(), 26);
    table.selectRow(9);
    EXPECT_EQ(editor().part(), (SuitPart{SuitPart::Kind::kBoard, 9}));
    EXPECT_EQ(page_->scene().chosenPart(), editor().part());
    EXPECT_EQ(page_->placement().segment().currentData().toString(), "LeftLeg");
    EXPECT_NEAR(page_->placement().position()[1]->value(), -200, 0.05);
    EXPECT_TRUE(page_->placement().position()[1]->text().startsWith(QChar(0x2212)));
    emit page_->scene().partChosen({SuitPart::Kind::kSource, 7});
    EXPECT_EQ(table.currentIndex().row(), 25);
    EXPECT_EQ(page_->placement().segment().currentData().toString(), "Head");
    EXPECT_FALSE(page_->placement().rotation()[2]->isVisible());
}

TEST_F(PerformerPageTest, TypedPositionMovesOnlyThatAxis) {
    chooseBoard("l_leg");
    const Vector3d before = board("l_leg").p_segment_board_m;
    page_->placement().position()[2]->setValue(65);
    EXPECT_EQ(board("l_leg").p_segment_board_m, Vector3d(before.x(), before.y(), 0.065));
    undo().undo();
    EXPECT_EQ(board("l_leg").p_segment_board_m, before);
}

TEST_F(PerformerPageTest, NegativeNumbersCanBeTypedWithTheKeyboard) {
    chooseBoard("l_leg");
    QDoubleSpinBox* box = page_->placement().position()[0];
    box->selectAll();
    QTest::keyClicks(box, "-12.5");
    QTest::keyClick(box, Qt::Key_Return);
    EXPECT_NEAR(board("l_leg").p_segment_board_m.x(), -0.0125, 1e-12);
}

TEST_F(PerformerPageTest, RotationsAreKeptAsTyped) {
    chooseBoard("l_arm");
    for (size_t axis = 0; axis < 3; ++axis)
        page_->placement().rotation()[axis]->setValue(10.0 * static_cast<double>(axis + 1));
    const Quaterniond expected = axisAngle(Vector3d::UnitX(), radians(10)) *
                                 axisAngle(Vector3d::UnitY(), radians(20)) *
                                 axisAngle(Vector3d::UnitZ(), radians(30));
    EXPECT_LT(angleBetween(board("l_arm").q_segment_board, expected), 1e-9);
    for (size_t axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(page_->placement().rotation()[axis]->value(), 10.0 * static_cast<double>(axis + 1), 0.05);
}

TEST_F(PerformerPageTest, DraggingIsOneStep) {
    const SuitPart part{SuitPart::Kind::kBoard, performer().suit.findBoard("chest")};
    const Vector3d before = board("chest").p_segment_board_m;
    for (int i = 1; i <= 30; ++i)
        emit page_->scene().placementDragged(part, before + Vector3d(0.001 * i, 0, 0),
                                             Quaterniond::Identity());
    emit page_->scene().dragEnded();
    emit page_->scene().placementDragged(part, before, Quaterniond::Identity());
    EXPECT_EQ(undo().count(), 2);
    undo().undo();
    EXPECT_NEAR(board("chest").p_segment_board_m.x(), before.x() + 0.03, 1e-12);
    undo().undo();
    EXPECT_EQ(board("chest").p_segment_board_m, before);
}

TEST_F(PerformerPageTest, MirrorGoesToTheOtherSideAndIsUndone) {
    chooseBoard("l_leg");
    const Board right_before = board("r_leg");
    editor().setPosition({0.03, -0.25, 0.05});
    QTest::mouseClick(&page_->placement().mirrorButton(), Qt::LeftButton);
    EXPECT_LT((board("r_leg").p_segment_board_m - Vector3d(-0.03, -0.25, 0.05)).norm(), 1e-12);
    EXPECT_EQ(board("r_leg").segment, "RightLeg");
    undo().undo();
    EXPECT_EQ(board("r_leg").p_segment_board_m, right_before.p_segment_board_m);
    EXPECT_NEAR(board("l_leg").p_segment_board_m.x(), 0.03, 1e-12);
    chooseBoard("chest");
    EXPECT_FALSE(page_->placement().mirrorButton().isEnabled());
}

TEST_F(PerformerPageTest, BackToTheSuitsPlace) {
    editor().setHeight(1.6);
    chooseBoard("r_foot");
    EXPECT_FALSE(page_->placement().backButton().isEnabled());
    const Board placed = board("r_foot");
    editor().setPosition({0, 0, 0.2});
    editor().setSegment("RightToeBase");
    EXPECT_TRUE(page_->placement().backButton().isEnabled());
    QTest::mouseClick(&page_->placement().backButton(), Qt::LeftButton);
    EXPECT_EQ(board("r_foot").segment, "RightFoot");
    EXPECT_LT((board("r_foot").p_segment_board_m - placed.p_segment_board_m).norm(), 1e-9);
}

TEST_F(PerformerPageTest, SourcesPointWhereTheirNumbersSay) {
    editor().choosePart({SuitPart::Kind::kSource, performer().suit.findSource("navel")});
    page_->placement().rotation()[0]->setValue(20);
    page_->placement().rotation()[1]->setValue(-10);
    const Vector3d normal = performer().suit.sources[4].normal_segment;
    EXPECT_NEAR(directionOf(normal).left_rad, radians(20), 1e-9);
    EXPECT_NEAR(directionOf(normal).up_rad, radians(-10), 1e-9);
}

TEST_F(PerformerPageTest, PerformersComeAndGo) {
    editor().setHeight(1.9);
    editor().duplicate();
    ASSERT_EQ(studio_->session().session().performers.size(), 2u);
    EXPECT_EQ(editor().index(), 1);
    EXPECT_EQ(editor().performer().name, "Performer 1 (2)");
    EXPECT_EQ(editor().performer().measures.height_m, 1.9);
    editor().rename("Performer 1");  // taken: it gets a number
    EXPECT_EQ(editor().performer().name, "Performer 1 (2)");
    editor().rename("Ada");
    EXPECT_EQ(editor().performer().name, "Ada");
    editor().wearSuit();
    EXPECT_EQ(studio_->session().session().current_performer, "Ada");
    editor().remove();
    EXPECT_EQ(editor().index(), 0);
    EXPECT_EQ(studio_->session().session().current_performer, "Performer 1");
    editor().add();
    EXPECT_EQ(editor().performer().measures.height_m, 1.75);
    while (undo().canUndo())
        undo().undo();
    EXPECT_EQ(studio_->session().session().performers.size(), 1u);
}

TEST_F(PerformerPageTest, ClosedSessionLeavesAnEmptyPage) {
    chooseBoard("chest");
    studio_->session().close();
    EXPECT_FALSE(editor().hasPerformer());
    EXPECT_FALSE(page_->rightDock()->isEnabled());
    editor().mirror();
    editor().duplicate();
    editor().setHeight(1.8);
}

/// NOCTULE_TEST_PICTURES=folder keeps pictures to look at.
TEST_F(PerformerPageTest, NothingIsCutOffInAnyThemeAndSize) {
    QWidget window;
    auto* row = new QHBoxLayout(&window);
    row->setContentsMargins({});
    row->setSpacing(1);
    row->addWidget(page_->leftDock());
    row->addWidget(page_.get(), 1);
    row->addWidget(page_->rightDock());
    chooseBoard("l_forearm");
    editor().setPosition({0.22, 0.03, 0.05});
    editor().setLength(&BodyMeasures::forearm_m, 0.35);
    editor().duplicate();
    chooseBoard("l_forearm");
    for (const Scheme scheme : {Scheme::kDark, Scheme::kLight})
        for (const double scale : {1.0, 1.5}) {
            Theme::get().setScheme(scheme);
            Theme::get().setScale(scale);
            page_->leftDock()->setFixedWidth(Theme::get().px(248));
            page_->rightDock()->setFixedWidth(Theme::get().px(295));
            window.resize(1440, 822);
            window.show();
            QTest::qWait(100);
            for (const QWidget* dock : {page_->leftDock(), page_->rightDock()})
                for (const QLabel* label : dock->findChildren<QLabel*>())
                    if (label->isVisible() && !label->wordWrap()) {
                        EXPECT_GE(label->width(), label->sizeHint().width()) << label->text().toStdString();
                    }
            const QString folder = qEnvironmentVariable("NOCTULE_TEST_PICTURES");
            if (!folder.isEmpty())
                window.grab().save(QString("%1/performer_%2_%3.png")
                                       .arg(folder, scheme == Scheme::kDark ? "dark" : "light")
                                       .arg(100 * scale));
        }
    Theme::get().setScheme(Scheme::kDark);
    Theme::get().setScale(1);
    page_->leftDock()->setParent(nullptr);
    page_->rightDock()->setParent(nullptr);
    page_->setParent(nullptr);
}

}  // namespace
}  // namespace noctule::ui
