// SPDX-License-Identifier: Apache-2.0
// Any mesh as the body of the view: chosen, mapped by hand, kept with the session, undone.
#include "ui/views/body_dialog.h"

#include <QComboBox>
#include <QDoubleSpinBox>

#include "core/job/atomic_file.h"
#include "tests/ui/views/reviewed_session.h"
#include "ui/widgets/button.h"

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
