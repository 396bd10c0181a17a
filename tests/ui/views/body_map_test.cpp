// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/body_map.h"

#include <gtest/gtest.h>

#include "core/suit/default_suit.h"
#include "tests/ui/support/wait.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

/// Share of the map that has the figure's colour.
double figureShare(BodyMap& map) {
    const QImage picture = map.grab().toImage().convertToFormat(QImage::Format_RGB32);
    const QRgb body = Theme::get().tokens().ctlh.rgb();
    int64_t count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            count += picture.pixel(x, y) == body;
    return static_cast<double>(count) / (picture.width() * picture.height());
}

TEST(BodyMap, ShowsTheBodyAtEverySize) {
    Theme::install(*qApp);
    BodyMap map(defaultActor(), defaultSuit(), nullptr);
    for (const QSize size : {QSize(760, 640), QSize(1000, 800)}) {
        map.resize(size);
        EXPECT_TRUE(waitFor([&] { return figureShare(map) > 0.03; })) << size.width();
    }
}

}  // namespace
}  // namespace noctule::ui
