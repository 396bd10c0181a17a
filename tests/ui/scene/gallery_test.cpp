// SPDX-License-Identifier: Apache-2.0
// The 3D view in both themes: the picture has the theme's background and is not empty.
// NOCTULE_TEST_PICTURES=folder keeps pictures to look at, NOCTULE_TEST_TAKE=file shows another take,
// NOCTULE_TEST_TIMES=1.5,3 at other times.
#include <QDir>

#include "core/suit/default_suit.h"
#include "tests/ui/scene/scene_fixture.h"

namespace noctule::ui {
namespace {

class SceneGallery : public test::SceneFixture, public testing::WithParamInterface<Scheme> {
protected:
    void TearDown() override {
        Theme::get().setScheme(Scheme::kDark);
        Theme::get().setScale(1);
        SceneFixture::TearDown();
    }
    void keep(const QString& name) {
        const QString folder = qEnvironmentVariable("NOCTULE_TEST_PICTURES");
        if (folder.isEmpty())
            return;
        QDir().mkpath(folder);
        settle();
        view_->grab().save(QDir(folder).filePath(
            QString("%1_%2.png").arg(name, GetParam() == Scheme::kDark ? "dark" : "light")));
    }
    void openChosen() {
        const QString take = qEnvironmentVariable("NOCTULE_TEST_TAKE", QString::fromStdString(path()));
        studio_->take().open(take);
        ASSERT_TRUE(waitFor([this] { return studio_->take().isOpen() && studio_->take().shownMotion(); }));
        studio_->take().setComparedRun(TakeDocument::kReference);
        ASSERT_TRUE(waitFor([this] {
            return studio_->take().comparedMotion() && studio_->take().ranges() && studio_->take().contacts();
        }));
    }
};

TEST_P(SceneGallery, TakeAndFigure) {
    Theme::get().setScheme(GetParam());
    view_->resize(860, 460);
    openChosen();
    view_->setShown(SceneLayer::kTrails, true);
    for (const QString& time : qEnvironmentVariable("NOCTULE_TEST_TIMES", "0.5").split(',')) {
        studio_->time().setTime(time.toDouble());
        view_->frameBody();
        settle();
        keep("take_" + time);
    }
    const QImage picture = view_->picture();
    const QColor corner = picture.pixelColor(picture.width() - 3, 3);
    EXPECT_NEAR(corner.lightness(), Theme::get().tokens().view.lightness(), 8);
    studio_->selection().setPair(0, 1);
    settle();
    keep("chosen");
    view_->setShown(SceneLayer::kMesh, false);
    keep("skeleton");
    view_->setShown(SceneLayer::kMesh, true);
    view_->resize(455, 334);
    keep("small");
    Theme::get().setScale(1.5);
    view_->resize(860, 620);
    keep("large_type");
    Theme::get().setScale(1);
    studio_->take().close();
    keep("empty");
    view_->setFigure(actor_, defaultSuit());
    view_->setChosenPart({SuitPart::Kind::kBoard, 5});
    keep("figure");
}

INSTANTIATE_TEST_SUITE_P(Schemes, SceneGallery, testing::Values(Scheme::kDark, Scheme::kLight));

TEST(Thumbnail, ShowsTheBodySmall) {
    Theme::install(*qApp);
    Studio studio{StudioParts{}};
    ASSERT_TRUE(waitFor([&] { return studio.body() != nullptr; }));
    const QImage picture = thumbnail(studio.body(), defaultActor(), QSize(160, 200));
    if (picture.isNull())
        GTEST_SKIP() << "no OpenGL without a window here";
    EXPECT_EQ(picture.size(), QSize(160, 200));
    EXPECT_NE(picture.pixel(80, 100), picture.pixel(5, 100));
    if (const QString folder = qEnvironmentVariable("NOCTULE_TEST_PICTURES");
        !folder.isEmpty() && QDir().mkpath(folder))
        picture.save(QDir(folder).filePath("thumbnail.png"));
}

}  // namespace
}  // namespace noctule::ui
