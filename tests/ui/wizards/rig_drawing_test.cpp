// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/rig_drawing.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QEvent>
#include <QPainter>
#include <QTest>
#include <algorithm>
#include <array>

#include "core/math/rotation.h"
#include "core/mesh/import/glb_reader.h"
#include "core/suit/default_suit.h"
#include "tests/ui/support/painted_text.h"
#include "ui/style/theme.h"
#include "ui/wizards/rig_geometry.h"
#include "ui/wizards/wizard_task.h"

namespace noctule::ui {
namespace {

using Kind = RigPicture::Kind;

RigPicture examplePicture(Kind kind, int side, int wrong_board = -1, size_t boards = 18) {
    RigPicture picture;
    picture.kind = kind;
    picture.side = side;
    picture.boards.assign(boards, BoardMark::kRight);
    picture.boards[0] = picture.boards[1] = BoardMark::kDone;
    picture.boards[3] = picture.boards[4] = BoardMark::kWaiting;
    picture.boards[9] = BoardMark::kSkipped;
    picture.boards[16] = BoardMark::kAbsent;
    if (wrong_board >= 0) {
        picture.boards[static_cast<size_t>(wrong_board)] = BoardMark::kWrong;
        picture.wrong_board = wrong_board;
        picture.call_out_title = QStringLiteral("Board %1").arg(wrong_board + 1);
        picture.call_out_text = QStringLiteral("left forearm, 4.2° askew");
    }
    return picture;
}

struct RigDrawingTest : testing::Test {
    void SetUp() override { Theme::install(*qApp); }
    void TearDown() override {
        Theme::get().setScheme(Scheme::kDark);
        Theme::get().setScale(1);
    }
};

class PaintCounter : public QObject {
public:
    int count = 0;
    bool eventFilter(QObject*, QEvent* event) override {
        count += event->type() == QEvent::Paint;
        return false;
    }
};

TEST(RigGeometry, TheAxisThatIsAskedForPointsUp) {
    for (int side = 0; side < 6; ++side) {
        const Vector3d axis = (side % 2 == 0 ? 1 : -1) * Vector3d::Unit(side / 2);
        const Matrix3d turn = plateTurn(side);
        EXPECT_TRUE((turn * axis).isApprox(Vector3d::UnitY())) << side;
        EXPECT_DOUBLE_EQ(turn.determinant(), 1) << side;  // a plate can be turned, never mirrored
    }
}

TEST(RigGeometry, TheEdgeOppositeOfTheSideIsDown) {
    EXPECT_EQ(edgeDown(0), 'C');
    EXPECT_EQ(edgeDown(1), 'D');
    EXPECT_EQ(edgeDown(2), 'B');
    EXPECT_EQ(edgeDown(3), 'A');
    EXPECT_EQ(edgeDown(4), 0);
    EXPECT_EQ(edgeDown(5), 0);
    EXPECT_EQ(edgeDown(-1), 0);
}

TEST(RigGeometry, AStandingPlateShowsItsFaceAndALyingOneItsUpperSide) {
    const RigCamera camera(30, 20);
    for (int side = 0; side < 6; ++side)
        EXPECT_EQ(camera.nearness(plateTurn(side).col(2)) > 0, side != 5) << side;
    EXPECT_GT(camera.nearness(-Vector3d::UnitX()), 0);
    EXPECT_LT(camera.along(Vector3d::UnitY()).y(), 0);
    EXPECT_GT(camera.along(Vector3d::UnitX()).x(), 0);
}

TEST_F(RigDrawingTest, RepaintsWhenThePictureChangesAndOnlyThen) {
    RigDrawing drawing;
    PaintCounter paints;
    drawing.installEventFilter(&paints);
    drawing.resize(800, 430);
    drawing.setPicture(examplePicture(Kind::kPlate, 2));
    drawing.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&drawing));
    QTest::qWait(50);
    const int before = paints.count;
    EXPECT_GT(before, 0);
    drawing.setPicture(examplePicture(Kind::kPlate, 2));
    QTest::qWait(50);
    EXPECT_EQ(paints.count, before);
    drawing.setPicture(examplePicture(Kind::kPlate, 2, 6));
    QTest::qWait(50);
    EXPECT_EQ(paints.count, before + 1);
}

TEST_F(RigDrawingTest, HasItsDescriptionAsName) {
    RigDrawing drawing;
    drawing.setDescription("The plate stands on edge B.");
    EXPECT_EQ(drawing.accessibleName(), "The plate stands on edge B.");
}

TEST_F(RigDrawingTest, EveryMarkLooksDifferent) {
    RigDrawing drawing;
    drawing.resize(800, 430);
    drawing.setBody(BodyFigure::of(defaultActor(), nullptr), defaultSuit());
    for (const Kind kind : {Kind::kPlate, Kind::kTurntable, Kind::kJig, Kind::kStand}) {
        std::vector<QImage> seen;
        for (const BoardMark mark : {BoardMark::kWaiting, BoardMark::kRight, BoardMark::kDone,
                                     BoardMark::kWrong, BoardMark::kSkipped, BoardMark::kAbsent}) {
            RigPicture picture;
            picture.kind = kind;
            picture.boards.assign(18, BoardMark::kWaiting);
            picture.boards[7] = mark;
            drawing.setPicture(picture);
            seen.push_back(drawing.grab().toImage());
            for (size_t other = 0; other + 1 < seen.size(); ++other)
                EXPECT_NE(seen[other], seen.back()) << static_cast<int>(kind) << " " << other;
        }
    }
}

TEST_F(RigDrawingTest, TheFigureStandsAsTheSolverTakesForGranted) {
    const Actor actor = defaultActor();
    const GlobalPose rest = globalPose(actor.skeleton, actor.restPose());
    const auto drawn = BodyFigure::of(actor, nullptr, BodyFigure::Stance::kRest);
    const auto placeOf = [&](const char* segment) {
        Board board;
        board.segment = segment;
        return drawn->board(board);
    };
    for (const char* segment : {"LeftHand", "RightForeArm", "LeftFoot"}) {
        const Vector3d expected_m = rest.p_world_joint[static_cast<size_t>(actor.skeleton.find(segment))] -
                                    rest.p_world_joint[static_cast<size_t>(actor.skeleton.find("Head"))];
        EXPECT_NEAR(placeOf(segment).x() - placeOf("Head").x(), expected_m.x(), 1e-9) << segment;
        EXPECT_NEAR(placeOf(segment).y() - placeOf("Head").y(), expected_m.y(), 1e-9) << segment;
    }
    const Quaterniond& elbow =
        actor.rest_q_parent_joint[static_cast<size_t>(actor.skeleton.find("LeftForeArm"))];
    EXPECT_GT(angleBetween(elbow, Quaterniond::Identity()), radians(10));
    for (const WizardTask task : {WizardTask::kRestPose, WizardTask::kMovement, WizardTask::kCheck}) {
        EXPECT_TRUE(wordsOf(task).set_up.contains("elbows slightly bent")) << "the words say what it shows";
        EXPECT_TRUE(wordsOf(task).set_up.contains("a little away from the body"));
    }
    EXPECT_NE(BodyFigure::of(actor, nullptr), drawn) << "maps of boards keep the open stance";
}

/// Right and left of circles, with one digit or two: board 9 stands where board 16 does on the other side.
TEST_F(RigDrawingTest, NumbersOfTheStandAreAsFarFromTheirCirclesWithTwoDigits) {
    RigDrawing drawing;
    drawing.setBody(BodyFigure::of(defaultActor(), nullptr), defaultSuit());
    drawing.setPicture(examplePicture(Kind::kStand, -1));
    for (const double scale : {1.0, 1.5})
        for (const QSize& size : {QSize(560, 330), QSize(800, 430), QSize(1300, 700)}) {
            Theme::get().setScale(scale);
            drawing.resize(size * scale);
            const auto edge = [texts = test::TextRecorder::textsOf(drawing)](const char* number, bool right) {
                const auto found = std::ranges::find(texts, QString(number), &test::PaintedText::text);
                EXPECT_NE(found, texts.end()) << number;
                return found == texts.end() ? 0 : right ? found->place.right() : found->place.left();
            };
            const double middle = drawing.width() / 2.0;
            EXPECT_NEAR(middle - edge("16", true), edge("9", false) - middle, 2) << size.width();
        }
}

/// The drawing in the middle of a larger picture: painter and widget do not clip.
QImage onLargerPaper(RigDrawing& drawing, int margin) {
    QImage paper(drawing.size() + QSize(2 * margin, 2 * margin), QImage::Format_ARGB32_Premultiplied);
    paper.fill(Qt::transparent);
    QPainter painter(&paper);
    drawing.render(&painter, QPoint(margin, margin), QRegion(), QWidget::RenderFlags());
    return paper;
}

/// Whether a line of pixels along the widget's border is empty.
bool borderIsEmpty(const QImage& paper, int margin) {
    const QRect inside = paper.rect().adjusted(margin, margin, -margin, -margin);
    for (int x = inside.left(); x <= inside.right(); ++x)
        if (qAlpha(paper.pixel(x, inside.top())) || qAlpha(paper.pixel(x, inside.bottom())))
            return false;
    for (int y = inside.top(); y <= inside.bottom(); ++y)
        if (qAlpha(paper.pixel(inside.left(), y)) || qAlpha(paper.pixel(inside.right(), y)))
            return false;
    return true;
}

TEST_F(RigDrawingTest, PaintsNothingOutside) {
    RigDrawing drawing;
    drawing.setBody(BodyFigure::of(defaultActor(), nullptr), defaultSuit());
    for (const double scale : {1.0, 1.5}) {
        Theme::get().setScale(scale);
        for (const QSize& size : {QSize(560, 330), QSize(800, 430), QSize(1300, 700)})
            for (const Kind kind : {Kind::kPlate, Kind::kTurntable, Kind::kJig, Kind::kStand})
                for (int side = -1; side < 6; ++side) {
                    drawing.resize(size * scale);
                    drawing.setPicture(examplePicture(kind, side, 6));
                    EXPECT_TRUE(borderIsEmpty(onLargerPaper(drawing, 10), 10))
                        << static_cast<int>(kind) << " side " << side << " width " << size.width();
                }
    }
}

TEST_F(RigDrawingTest, NarrowAndEmptyPicturesAreHarmless) {
    RigDrawing drawing;
    for (const QSize& size : {QSize(1, 1), QSize(80, 400), QSize(400, 40)})
        for (const Kind kind : {Kind::kPlate, Kind::kTurntable, Kind::kJig, Kind::kStand}) {
            drawing.resize(size);
            RigPicture picture;
            picture.kind = kind;
            drawing.setPicture(picture);
            drawing.grab();
        }
}

std::vector<std::pair<QString, RigPicture>> galleryPictures() {
    std::vector<std::pair<QString, RigPicture>> pictures{
        {"plate-setup", examplePicture(Kind::kPlate, -1)},
        {"plate-32", examplePicture(Kind::kPlate, 2, 22, 32)},
        {"turntable-setup", examplePicture(Kind::kTurntable, -1)},
        {"jig", examplePicture(Kind::kJig, -1)},
        {"jig-wrong", examplePicture(Kind::kJig, -1, 6)},
        {"stand", examplePicture(Kind::kStand, -1)},
        {"stand-wrong", examplePicture(Kind::kStand, -1, 6)}};
    for (int side = 0; side < 6; ++side)
        for (const Kind kind : {Kind::kPlate, Kind::kTurntable}) {
            const QString name = kind == Kind::kPlate ? "plate" : "turntable";
            RigPicture picture = examplePicture(kind, side, std::array{12, 5, 6, 11, 14, 0}[side]);
            picture.turns = side % 2 == 0;
            pictures.emplace_back(name + QStringLiteral("-side%1").arg(side), picture);
        }
    return pictures;
}

/// Pictures to look at, into the folder NOCTULE_SCREENSHOTS.
TEST_F(RigDrawingTest, Gallery) {
    const QString folder = qEnvironmentVariable("NOCTULE_SCREENSHOTS");
    if (folder.isEmpty())
        GTEST_SKIP() << "NOCTULE_SCREENSHOTS names no folder";
    QDir().mkpath(folder);
    const auto body = std::make_shared<const SkinnedMesh>(
        *readSkinnedMesh(NOCTULE_SOURCE_DIR "/resources/bodies/mannequin.glb"));
    RigDrawing drawing;
    drawing.setBody(BodyFigure::of(defaultActor(), body), defaultSuit());
    drawing.setAutoFillBackground(true);
    for (const Scheme scheme : {Scheme::kDark, Scheme::kLight})
        for (const auto& [size, scale] :
             {std::pair(QSize(800, 430), 1.0), std::pair(QSize(560, 330), 1.0),
              std::pair(QSize(1300, 700), 1.0), std::pair(QSize(800, 430), 1.5)}) {
            Theme::get().setScheme(scheme);
            Theme::get().setScale(scale);
            drawing.resize(size * scale);
            for (const auto& [name, picture] : galleryPictures()) {
                drawing.setPicture(picture);
                const QString file = QStringLiteral("rig-%1-%2-%3-%4.png")
                                         .arg(name, scheme == Scheme::kDark ? "dark" : "light")
                                         .arg(size.width())
                                         .arg(qRound(scale * 100));
                EXPECT_TRUE(drawing.grab().save(QDir(folder).filePath(file))) << file.toStdString();
            }
        }
}

}  // namespace
}  // namespace noctule::ui
