// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/views/reviewed_session.h"

#include <QDir>
#include <QFile>
#include <cmath>

#include "core/math/rotation.h"
#include "core/processing/export_take.h"
#include "core/processing/process_take.h"
#include "tests/support/simulated_take.h"
#include "ui/style/theme.h"

namespace noctule::ui::test {
namespace {

constexpr const char* kCreated = "2026-01-01T00:00:00Z";

MotionClip swingingArms() {
    const Actor actor = defaultActor();
    MotionClip clip;
    clip.name = "swing";
    clip.skeleton = actor.skeleton;
    clip.frame_time_s = 1.0 / 120;
    for (int frame = 0; frame < 480; ++frame) {
        const double t_s = frame / 120.0;
        Pose pose = actor.restPose();
        const auto turn = [&](const char* joint, double angle_rad) {
            auto& q = pose.q_parent_joint[static_cast<size_t>(actor.skeleton.find(joint))];
            q = q * axisAngle(Vector3d::UnitX(), angle_rad);
        };
        turn("LeftArm", 0.8 * std::sin(3 * t_s));
        turn("RightArm", -0.8 * std::sin(3 * t_s));
        turn("LeftLeg", 0.3 * (1 - std::cos(4 * t_s)));
        clip.frames.push_back(pose);
    }
    return clip;
}

Status makeTake(const std::string& path, const JobContext& job) {
    return noctule::test::writeSimulatedTake(path, {.clip = swingingArms(), .rest_seconds = 0.5}, job);
}

/// Made once for all tests.
Result<std::string> processedTake() {
    static const QTemporaryDir folder;
    static const Result<std::string> path = []() -> Result<std::string> {
        const std::string made = folder.filePath("swing_001.noctule").toStdString();
        if (Status written = makeTake(made, {}); !written)
            return written.error();
        ProcessRequest request;
        request.take_path = made;
        request.tracker.root_given = true;
        request.software = "test";
        request.created_utc = kCreated;
        const auto summary = processTake(request, {});
        return summary ? Result<std::string>(made) : Result<std::string>(summary.error());
    }();
    return path;
}

}  // namespace

void ReviewedSession::SetUp() {
    const auto made = processedTake();
    ASSERT_TRUE(made) << made.error().text();
    Theme::install(*qApp);
    Theme::get().setScheme(Scheme::kDark);
    QSettings().clear();
    StudioParts parts;
    parts.software = "test";
    parts.utc_now = [] { return std::string(kCreated); };
    parts.make_sample_take = makeTake;
    studio_ = std::make_unique<Studio>(parts);
    ASSERT_TRUE(studio_->session().create(folder_.filePath("session"), "Stage tests"));
    ASSERT_TRUE(waitFor([this] { return studio_->session().isOpen(); }));
    studio_->session().importTakes({QString::fromStdString(*made)});
    ASSERT_TRUE(waitFor([this] { return studio_->session().session().takes.size() == 1 && jobsAreDone(); }));
}

void ReviewedSession::TearDown() {
    waitFor([this] { return !studio_ || jobsAreDone(); });
    studio_.reset();
}

void ReviewedSession::addTake(const QString& name) {
    const size_t before = studio_->session().session().takes.size();
    const QString copy = outsideFile(name + ".noctule");
    ASSERT_TRUE(QFile::copy(takePath("swing_001"), copy));
    studio_->session().importTakes({copy});
    ASSERT_TRUE(
        waitFor([&] { return studio_->session().session().takes.size() == before + 1 && jobsAreDone(); }));
}

QString ReviewedSession::writtenFigure(JointNames names) {
    ExportRequest figure;
    figure.take_path = takePath("swing_001").toStdString();
    figure.from_s = figure.to_s = 0.5;
    figure.names = names;
    figure.overwrite = true;
    figure.glb_path = outsideFile("figure.glb").toStdString();
    EXPECT_TRUE(exportTake(figure, {}));
    return outsideFile("figure.glb");
}

void ReviewedSession::openTake(const QString& name) {
    const int index = studio_->session().session().findTake(name.toStdString());
    ASSERT_GE(index, 0);
    studio_->session().setCurrentTake(index);
    ASSERT_TRUE(waitFor([this] { return studio_->take().isOpen() && studio_->take().verdict(); }))
        << studio_->take().problem().toStdString();
}

}  // namespace noctule::ui::test
