// SPDX-License-Identifier: Apache-2.0
// All of the room in both themes and at 100 and 150 percent: it draws without a warning and uses its colours.
// NOCTULE_TEST_PICTURES=folder keeps pictures to look at, NOCTULE_TEST_TAKE=file shows another take.
#include <QDir>
#include <QHBoxLayout>
#include <QSplitter>
#include <QVBoxLayout>

#include "tests/ui/plots/plots_fixture.h"
#include "ui/plots/heat_map.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/timeline.h"
#include "ui/plots/transport_bar.h"

namespace noctule::ui {
namespace {

struct Look {
    Scheme scheme;
    int percent;
};

class PlotsGallery : public test::PlotsFixture, public testing::WithParamInterface<Look> {
protected:
    void TearDown() override {
        Theme::get().setScheme(Scheme::kDark);
        Theme::get().setScale(1);
        PlotsFixture::TearDown();
    }
    bool isSettled() const {
        return studio_->jobs().idle() && !studio_->take().isLoading() && studio_->jobs().running() == 0;
    }
    void keep(QWidget& page, const QString& name) {
        const QString folder = qEnvironmentVariable("NOCTULE_TEST_PICTURES");
        if (folder.isEmpty())
            return;
        const QString look = GetParam().scheme == Scheme::kDark ? "dark" : "light";
        QDir().mkpath(folder);
        page.grab().save(
            QDir(folder).filePath(QString("%1_%2_%3.png").arg(name, look).arg(GetParam().percent)));
    }
};

TEST_P(PlotsGallery, draws) {
    Theme::get().setScheme(GetParam().scheme);
    Theme::get().setScale(GetParam().percent / 100.0);
    QWidget page;
    auto* column = new QVBoxLayout(&page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* map = new HeatMap(*studio_);
    map->setFixedSize(Theme::get().px(440), Theme::get().px(345));
    auto* plots = new PlotPanel(*studio_);
    auto* timeline = new Timeline(*studio_, plots->window());
    column->addWidget(map, 0, Qt::AlignRight);
    column->addWidget(plots, 1);
    column->addWidget(timeline);
    column->addWidget(new TransportBar(*studio_, *timeline));
    show(page, 896, 900);
    const QString take = qEnvironmentVariable("NOCTULE_TEST_TAKE", QString::fromStdString(path()));
    studio_->take().open(take);
    ASSERT_TRUE(waitFor([this] { return studio_->take().isOpen(); }));
    TimeCursor& time = studio_->time();
    time.setRange(time.duration() * 0.12, time.duration() * 0.88);
    time.setTime(time.duration() * 0.48);
    plots->channels().setPair({0, 0}, true);
    ASSERT_TRUE(waitFor([&] { return isSettled() && !plots->lanes().empty(); }));
    const auto shoot = [&](const QString& name, std::initializer_list<PlotTab> tabs) {
        for (int tab = 0; tab < kPlotTabs; ++tab)
            plots->setOn(static_cast<PlotTab>(tab),
                         std::find(tabs.begin(), tabs.end(), static_cast<PlotTab>(tab)) != tabs.end());
        QTest::qWait(120);
        waitFor([this] { return isSettled(); });
        QTest::qWait(120);
        keep(page, name);
    };
    shoot("review", {PlotTab::kConfidence, PlotTab::kJointAngles});
    plots->channels().removeAll();
    shoot("ranges", {PlotTab::kRanges});
    shoot("inertial", {PlotTab::kInertial, PlotTab::kRawSound});
    shoot("root", {PlotTab::kRoot});
    studio_->selection().setPair(0, 0);
    plots->window().show(time.time() - 0.05, time.time() + 0.05);
    shoot("sound", {PlotTab::kRawSound, PlotTab::kRanges});
    // The chosen curve's colour is on the screen.
    plots->window().showAll();
    shoot("confidence", {PlotTab::kConfidence});
    const QImage picture = plots->picture();
    const QColor accent = Theme::get().tokens().acc;
    int accents = 0;
    for (int x = 0; x < picture.width(); ++x)
        for (int y = 0; y < picture.height(); ++y)
            accents += picture.pixelColor(x, y) == accent;
    EXPECT_GT(accents, 50);
}

INSTANTIATE_TEST_SUITE_P(Looks, PlotsGallery,
                         testing::Values(Look{Scheme::kDark, 100}, Look{Scheme::kLight, 100},
                                         Look{Scheme::kDark, 150}),
                         [](const auto& look) {
                             return std::string(look.param.scheme == Scheme::kDark ? "dark" : "light") +
                                    std::to_string(look.param.percent);
                         });

}  // namespace
}  // namespace noctule::ui
