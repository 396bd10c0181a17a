// SPDX-License-Identifier: Apache-2.0
// The boards on the plate and in the jig's frame.
#include <algorithm>
#include <cmath>

#include "ui/style/paint.h"
#include "ui/wizards/rig_canvas.h"

namespace noctule::ui {
namespace {

constexpr double kBoardThick = 0.16;

/// As it lies in its slot; the wrong one askew and not pressed in.
RigPlace placeOfBoard(const RigPlace& face, const QPointF& slot, bool askew) {
    RigPlace place{face.turn, face * Vector3d(slot.x(), slot.y(), 0)};
    if (askew) {
        place.turn = face.turn * Eigen::AngleAxisd(radians(8), Vector3d::UnitZ()) *
                     Eigen::AngleAxisd(radians(-9), Vector3d::UnitY());
        place.p += face.turn * Vector3d(0, 0, 0.1);
    }
    return place;
}

void paintBoard(RigCanvas& canvas, const RigPlace& place, double size, int number, BoardMark mark,
                bool seen_from_behind) {
    const RigBoardLook look = boardLook(mark);
    const double half = size / 2, front = seen_from_behind ? 0 : kBoardThick;
    Vector3d right = place.turn.col(0) * (seen_from_behind ? -1 : 1), up = place.turn.col(1);
    canvas.makeUpright(right, up);
    if (seen_from_behind || mark == BoardMark::kAbsent) {
        RigLook outline{QColor(), look.box.outline, look.box.width, true};
        if (mark == BoardMark::kWrong)
            outline.fill = look.box.fill;
        canvas.polygon({place * Vector3d(-half, -half, 0), place * Vector3d(half, -half, 0),
                        place * Vector3d(half, half, 0), place * Vector3d(-half, half, 0)},
                       outline);
    } else {
        canvas.box(place, {-half, -half, 0}, {half, half, kBoardThick}, look.box);
    }
    canvas.text(QString::number(number), place * Vector3d(0, 0, mark == BoardMark::kAbsent ? 0 : front),
                right * size * 0.5, up * size * 0.5, look.number);
    const Vector3d corner = place * Vector3d(0, 0, front) + (right + up) * half * 0.66;
    if (mark == BoardMark::kDone)
        canvas.check(corner, right * size * 0.11, up * size * 0.11, canvas.tokens().ok);
    if (mark == BoardMark::kSkipped)
        canvas.polygon({corner - right * size * 0.09, corner + right * size * 0.09},
                       {QColor(), look.number, 2}, false);
}

}  // namespace

RigBoardLook boardLook(BoardMark mark) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const QColor fill = tokens.raised;
    switch (mark) {
        case BoardMark::kRight:
            return {{fill, tokens.acc, 2}, tokens.t1};
        case BoardMark::kDone:
            return {{fill, tokens.ok, 1.5}, tokens.t1};
        case BoardMark::kWrong:
            return {{mixed(tokens.warnbg, tokens.warn, theme.isDark() ? 0.25 : 0.08), tokens.warn, 2},
                    tokens.warn};
        case BoardMark::kSkipped:
            return {{mixed(fill, tokens.figure, 0.5), tokens.edge, 1.5, true}, tokens.t3};
        case BoardMark::kAbsent:
            return {{QColor(), tokens.edge, 1.5, true}, tokens.t3};
        case BoardMark::kWaiting:
            break;
    }
    return {{fill, tokens.edge, 1}, tokens.t1};
}

RigGrid::RigGrid(size_t boards, double across, double up) : wide(across), high(up) {
    if (boards > 18) {
        columns = 8;
        rows = std::max(3, (static_cast<int>(boards) + columns - 1) / columns);
    }
}

QPointF RigGrid::slot(int index) const {
    return {wide * ((index % columns + 0.5) / columns - 0.5), high * (0.5 - (index / columns + 0.5) / rows)};
}

double RigGrid::board() const {
    return 0.84 * std::min(wide / columns, high / rows);
}

QVector<QPointF> paintBoards(RigCanvas& canvas, const RigPlace& face, const RigGrid& grid,
                             const RigPicture& picture, bool seen_from_behind) {
    struct Item {
        int index;
        double nearness;
    };
    const int boards = static_cast<int>(picture.boards.size());
    std::vector<Item> items;
    for (int i = 0; i < std::max(boards, grid.columns * grid.rows); ++i) {
        const QPointF slot = grid.slot(i);
        items.push_back({i, canvas.camera().nearness(face * Vector3d(slot.x(), slot.y(), 0))});
    }
    std::ranges::sort(items, {}, &Item::nearness);
    QVector<QPointF> called_out;
    const auto paint = [&](int index, bool wrong) {
        const RigPlace place = placeOfBoard(face, grid.slot(index), wrong);
        paintBoard(canvas, place, grid.board(), index + 1, picture.boards[static_cast<size_t>(index)],
                   seen_from_behind);
        if (index == picture.wrong_board)
            for (const auto& [x, y] : {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)})
                called_out << canvas.at(place * (grid.board() / 2 * Vector3d(x, y, 0)));
    };
    const auto isWrong = [&](int index) {
        return index == picture.wrong_board ||
               (index < boards && picture.boards[static_cast<size_t>(index)] == BoardMark::kWrong);
    };
    for (const Item& item : items)
        if (item.index >= boards) {
            const QPointF slot = grid.slot(item.index);
            const double half = grid.board() / 2;
            const auto corner = [&](double x, double y) {
                return face * Vector3d(slot.x() + x, slot.y() + y, 0);
            };
            canvas.polygon(
                {corner(-half, -half), corner(half, -half), corner(half, half), corner(-half, half)},
                {QColor(), canvas.tokens().line, 1});
        } else if (!isWrong(item.index)) {
            paint(item.index, false);
        }
    for (const Item& item : items)  // what stands out is in front
        if (item.index < boards && isWrong(item.index))
            paint(item.index, true);
    return called_out;
}

}  // namespace noctule::ui
