// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/main_window/studio_fixture.h"

#include <QDir>
#include <QStandardPaths>

#include "core/formats/bvh.h"
#include "tests/support/simulated_take.h"
#include "ui/language/language.h"
#include "ui/style/resources.h"
#include "ui/style/theme.h"
#include "ui/views/session/big_button.h"
#include "ui/views/session/start_page.h"

namespace noctule::ui::test {

Status makeQuickTake(const std::string& path, const JobContext& job) {
    const QByteArray motion = resourceBytes("motions/sample.bvh");
    const auto document = parseBvh(motion.toStdString(), "sample.bvh");
    if (!document)
        return document.error();
    auto clip = toClip(*document);
    if (!clip)
        return clip.error();
    return noctule::test::writeSimulatedTake(
        path, {.clip = std::move(*clip), .duration_s = 3, .rest_seconds = 0.5}, job);
}

void StudioWindow::SetUp() {
    Theme::install(*qApp);
    Theme::get().setScheme(Scheme::kDark);
    Theme::get().setScale(1);
    QSettings().clear();
    QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation)).removeRecursively();
    QSettings().setValue("folders/sessions", home());
    QSettings().setValue("folders/suits", folder_.filePath("suits"));
    applyLanguage(QSettings());
    start();
}

void StudioWindow::TearDown() {
    window_.reset();
    studio_.reset();
}

StudioParts StudioWindow::parts() const {
    StudioParts parts;
    parts.software = "noctule 0.1.0";
    parts.utc_now = [] { return std::string("2026-01-01T00:00:00Z"); };
    parts.make_sample_take = makeQuickTake;
    parts.make_motion_take = [](const figure::UnderstoodMotion& motion, const std::string& scenario,
                                const std::string& path, const JobContext& job) -> Status {
        const auto world = simulation::Scenario::named(scenario);
        if (!world)
            return world.error();
        return noctule::test::writeSimulatedTake(
            path, {.clip = motion.clip, .duration_s = 3, .rest_seconds = 0.5, .scenario = *world}, job);
    };
    parts.virtual_suit_program = NOCTULE_PROGRAM "-virtual-suit";
    return parts;
}

void StudioWindow::start() {
    studio_ = std::make_unique<Studio>(parts());
    window_ = std::make_unique<MainWindow>(*studio_);
    window_->show();
    QApplication::setActiveWindow(window_.get());
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    ASSERT_TRUE(waitFor([this] { return studio_->body() != nullptr; }));
}

void StudioWindow::restart() {
    window_->close();
    window_.reset();
    studio_.reset();
    start();
}

void StudioWindow::openSampleTake() {
    auto& start_page = dynamic_cast<StartPage&>(window_->page(Step::kStart));
    QTest::mouseClick(start_page.tryButton(), Qt::LeftButton);
    ASSERT_TRUE(waitFor([this] { return studio_->take().isOpen() && studio_->take().shownRun() >= 0; }))
        << "the take of the virtual suit did not open";
    ASSERT_EQ(window_->step(), Step::kReview);
}

}  // namespace noctule::ui::test
