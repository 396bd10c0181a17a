// SPDX-License-Identifier: Apache-2.0
// Any mesh as the body of the view: chosen, mapped by hand, kept with the session, undone.
#include "ui/views/performer/body_dialog.h"

#include <QComboBox>
#include <QScrollBar>
#include <fstream>

#include "core/job/atomic_file.h"
#include "tests/ui/support/mouse.h"
#include "tests/ui/views/reviewed_session.h"
#include "ui/views/performer/landmark_editor.h"
#include "ui/views/performer/landmark_picture.h"
#include "ui/widgets/button.h"
#include "ui/widgets/scroll_area.h"

namespace noctule::ui {
namespace {

class BodyDialogTest : public test::ReviewedSession {
protected:
    void SetUp() override {
        ReviewedSession::SetUp();
        if (HasFatalFailure())
            return;
        openTake("swing_001");
        mesh_ = writtenFigure();
    }
    static void chooseNone(BodyDialog& dialog, const char* joint) {
        dialog.boneOf(joint)->setCurrentIndex(0);
    }

    QString mesh_;
};

TEST_F(BodyDialogTest, AMeshIsChosenMappedKeptAndUndone) {
    BodyDialog dialog(*studio_);
    dialog.show();
    EXPECT_TRUE(dialog.actionButton()->isEnabled()) << "Noctule's own";
    dialog.setMesh(mesh_);
    EXPECT_FALSE(dialog.actionButton()->isEnabled()) << "not read yet";
    ASSERT_TRUE(waitFor([&] { return dialog.boneOf("Hips") && jobsAreDone(); }));
    EXPECT_TRUE(dialog.actionButton()->isEnabled());
    EXPECT_EQ(dialog.boneOf("LeftForeArm")->currentText(), "LeftForeArm");
    EXPECT_FALSE(dialog.draft().choices.bones) << "found, not set by hand";
    chooseNone(dialog, "Head");
    EXPECT_FALSE(dialog.actionButton()->isEnabled()) << "a body needs its head";
    dialog.boneOf("Head")->setCurrentText("Head");
    EXPECT_FALSE(dialog.draft().choices.bones);
    chooseNone(dialog, "Neck");
    ASSERT_TRUE(dialog.draft().choices.bones);
    EXPECT_FALSE(dialog.draft().choices.bones->node_of_joint.contains("Neck"));
    dialog.blending->setCurrentIndex(1);
    dialog.accept();
    ShownBody& shown = studio_->shownBody();
    ASSERT_TRUE(waitFor([&] { return shown.worn() != nullptr; }));
    EXPECT_FALSE(shown.worn()->bones.node_of_joint.contains("Neck"));
    EXPECT_EQ(studio_->look().blending, Blending::kDualQuaternion);

    studio_->session().saveNow();
    const auto kept = openSession(studio_->session().session().folder, {});
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->body, studio_->session().session().body);
    EXPECT_EQ(kept->body.mesh, mesh_.toStdString());

    studio_->session().undoStack().undo();
    EXPECT_EQ(shown.worn(), nullptr);
    EXPECT_EQ(studio_->look().blending, Blending::kLinear);
    studio_->session().undoStack().redo();
    EXPECT_TRUE(waitFor([&] { return shown.worn() != nullptr; }));
}

/// The surface of a body of ours as a file without bones.
QString writtenSurface(const SkinnedMesh& mesh, const QString& path) {
    std::ofstream file(path.toStdString());
    for (const SkinnedVertex& vertex : mesh.vertices)
        file << "v " << vertex.p_m.x() << ' ' << vertex.p_m.y() << ' ' << vertex.p_m.z() << '\n';
    for (const auto& corners : mesh.triangles)
        file << "f " << corners[0] + 1 << ' ' << corners[1] + 1 << ' ' << corners[2] + 1 << '\n';
    return path;
}

void drag(LandmarkPicture& picture, const std::string& landmark, const QPoint& by) {
    const QPoint from = picture.pointOf(LandmarkPicture::kFront, landmark).toPoint();
    test::dragMouse(picture, from, from + by);
}

/// The smallest screen, and one on which all rows have room; the list never ends within a row.
TEST_F(BodyDialogTest, ListsTakeTheRoomThatThereIsInWholeRows) {
    constexpr int kScreen = 800, kTitleBar = 40;
    for (const bool bare : {false, true}) {
        ASSERT_TRUE(waitFor([&] { return studio_->look().ours != nullptr; }));
        BodyDialog dialog(*studio_);
        dialog.setMaximumHeight(kScreen - kTitleBar);
        dialog.show();
        dialog.setMesh(bare ? writtenSurface(*studio_->look().ours, outsideFile("rows.obj")) : mesh_);
        ASSERT_TRUE(waitFor([&] { return (bare && dialog.landmarks()) || dialog.boneOf("Hips"); }));
        ASSERT_TRUE(waitFor([this] { return jobsAreDone(); }));
        QTest::qWait(50);
        EXPECT_LE(dialog.height(), kScreen - kTitleBar);
        EXPECT_GT(dialog.height(), kScreen - kTitleBar - 40) << "the list takes what room there is";
        const auto* list =
            bare ? dialog.landmarks()->findChild<ScrollArea*>() : dialog.findChild<ScrollArea*>();
        ASSERT_TRUE(list);
        EXPECT_GT(list->verticalScrollBar()->maximum(), 0);
        EXPECT_EQ(list->cutRow_px(), 0);
        const int seen = list->viewport()->height();
        for (const QWidget* part :
             list->widget()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
            const QRect place = part->geometry();
            EXPECT_FALSE(part->isVisible() && place.top() < seen && place.bottom() >= seen)
                << part->accessibleName().toStdString() << " is cut";
        }
    }
}

TEST_F(BodyDialogTest, LandmarksOfAMeshWithoutBonesAreDraggedAndKept) {
    ASSERT_TRUE(waitFor([&] { return studio_->look().ours != nullptr; }));
    BodyDialog dialog(*studio_);
    dialog.show();
    dialog.setMesh(writtenSurface(*studio_->look().ours, outsideFile("bare.obj")));
    ASSERT_TRUE(waitFor([&] { return dialog.landmarks() && jobsAreDone(); }));
    ASSERT_TRUE(dialog.actionButton()->isEnabled());
    const Landmarks found = dialog.landmarks()->places();
    EXPECT_FALSE(dialog.find_again->isVisible()) << "all are as found";
    drag(*dialog.landmarks()->picture, "LeftForeArm", {0, 6});
    ASSERT_TRUE(dialog.draft().choices.landmarks);
    EXPECT_LT(dialog.draft().choices.landmarks->at("LeftForeArm").y(), found.at("LeftForeArm").y());
    EXPECT_TRUE(dialog.find_again->isVisible());
    dialog.find_again->click();
    EXPECT_FALSE(dialog.draft().choices.landmarks) << "as found";
    dialog.landmarks()->undo();
    const Landmarks set = dialog.draft().choices.landmarks.value();
    dialog.accept();
    const ShownBody& shown = studio_->shownBody();
    ASSERT_TRUE(waitFor([&] { return shown.worn() != nullptr; }));
    EXPECT_EQ(shown.worn()->landmarks, set);

    BodyDialog again(*studio_);
    again.show();
    ASSERT_TRUE(waitFor([&] { return again.landmarks() && jobsAreDone(); }));
    EXPECT_EQ(again.landmarks()->places(), set);
    again.landmarks()->findAgain();
    EXPECT_EQ(again.landmarks()->places(), found) << "also after it was kept";
}

TEST_F(BodyDialogTest, WhereNoJointsAreFoundTheyAreSetByHand) {
    const QString box = outsideFile("box.obj");
    std::ofstream(box.toStdString())
        << "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    BodyDialog dialog(*studio_);
    dialog.show();
    dialog.setMesh(box);
    ASSERT_TRUE(waitFor([&] { return dialog.landmarks() && jobsAreDone(); }));
    EXPECT_FALSE(dialog.actionButton()->isEnabled()) << "nothing was found in it";
    EXPECT_NEAR(dialog.landmarks()->places().at("HeadEnd").y(), 2, 0.1)
        << "a typical body as tall as the box";
    drag(*dialog.landmarks()->picture, "LeftForeArm", {0, 6});
    EXPECT_TRUE(dialog.actionButton()->isEnabled());
    dialog.landmarks()->undo();
    EXPECT_FALSE(dialog.actionButton()->isEnabled());
}

TEST_F(BodyDialogTest, WhatCannotBeWornIsSaid) {
    const QString text = outsideFile("text.glb");
    ASSERT_TRUE(writeFileAtomically(text.toStdString(), "no mesh", true));
    BodyDialog dialog(*studio_);
    dialog.show();
    dialog.setMesh(text);
    ASSERT_TRUE(waitFor([&] { return jobsAreDone(); }));
    EXPECT_FALSE(dialog.actionButton()->isEnabled());
    EXPECT_EQ(dialog.boneOf("Hips"), nullptr);
    dialog.setMesh({});
    EXPECT_TRUE(dialog.actionButton()->isEnabled());
}

TEST_F(BodyDialogTest, AMeshThatHasGoneLeavesOurs) {
    SessionBody body;
    body.mesh = outsideFile("gone.glb").toStdString();
    QString problem;
    QObject::connect(studio_.get(), &Studio::failed, [&](const QString& what) { problem = what; });
    studio_->session().setBody(body);
    ASSERT_TRUE(waitFor([&] { return !problem.isEmpty(); }));
    EXPECT_TRUE(problem.contains("gone.glb")) << problem.toStdString();
    EXPECT_EQ(studio_->shownBody().worn(), nullptr);
    EXPECT_TRUE(studio_->shownBody().problem());
}

}  // namespace
}  // namespace noctule::ui
