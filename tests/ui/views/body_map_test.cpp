// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/body_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

TEST(BodyMap, NoLeaderRunsThroughTheMarkOfAnotherBoard) {
    Theme::install(*qApp);
    Theme::get().setScale(1);
    const Suit suit = defaultSuit();
    BodyMap map(defaultActor(), suit, nullptr);
    map.resize(798, 702);  // Connect at 1280 by 800
    map.show();
    const auto at = [&](const std::string& segment) {
        return static_cast<int>(std::ranges::find(suit.boards, segment, &Board::segment) -
                                suit.boards.begin());
    };
    const QLineF pelvis = map.leaderOf(at("Hips"));
    ASSERT_GT(pelvis.dx(), 0) << "its label is in the right column";
    const QRect hand = map.boardButton(at("LeftHand"))->geometry();
    const double way = (hand.center().x() - pelvis.x1()) / pelvis.dx();
    const double y = pelvis.pointAt(way).y();
    EXPECT_TRUE(y < hand.center().y() - 9 || y > hand.center().y() + 9) << y << " at " << hand.center().y();
}

/// A transceiver in each corner of a ceiling.
Suit fourAnchors() {
    Suit room{"ceiling", {}, {}};
    for (const auto& [x, z] : {std::pair{2.3, 2.3}, {-2.3, 2.3}, {-2.3, -2.3}, {2.3, -2.3}}) {
        Board board;
        board.id = "ceiling_" + std::to_string(room.boards.size() + 1);
        board.p_segment_board_m = {x, 2.7, z};
        room.sources.push_back({board.id, "", "", {x, 2.7, z}, {0, -1, 0}});
        room.boards.push_back(board);
    }
    return room;
}

TEST(BodyMap, AnchorsHangInTheirRoomWithoutABody) {
    Theme::install(*qApp);
    BodyMap map(defaultActor(), fourAnchors(), nullptr);
    map.resize(760, 640);
    map.show();
    QTest::qWait(50);  // a figure would come the moment after
    EXPECT_TRUE(map.showsRoom());
    EXPECT_EQ(figureShare(map), 0);
    EXPECT_EQ(map.boardButton(0)->accessibleName(), "ceiling 1 (board 1)");
    const auto at = [&map](int board) { return map.boardButton(board)->geometry().center(); };
    EXPECT_GT(at(0).x(), at(1).x()) << "x to the right";
    EXPECT_GT(at(0).y(), at(3).y()) << "z down";
    for (int board = 0; board < 4; ++board) {
        EXPECT_TRUE(map.rect().contains(map.boardButton(board)->geometry()));
        const QPoint way = at(board) - map.sourceButton(board)->geometry().center();
        EXPECT_GT(std::hypot(way.x(), way.y()), 15) << "a source at the same place does not hide it";
    }
}

}  // namespace
}  // namespace noctule::ui
