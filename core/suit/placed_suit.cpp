// SPDX-License-Identifier: Apache-2.0
#include "core/suit/placed_suit.h"

namespace noctule {

Suit placedSuit(Suit suit, const Calibration& calibration) {
    for (Source& source : suit.sources)
        if (const int b = source.segment.empty() ? suit.findBoard(source.board) : -1; b >= 0) {
            const Board& housing = suit.boards[static_cast<size_t>(b)];
            const BoardCalibration* known = calibration.findBoard(housing.id);
            if (known && known->q_segment_board)
                source.normal_segment =
                    *known->q_segment_board * housing.q_segment_board.conjugate() * source.normal_segment;
        }
    for (Board& board : suit.boards)
        if (const BoardCalibration* known = calibration.findBoard(board.id)) {
            board.p_segment_board_m = known->p_segment_board_m.value_or(board.p_segment_board_m);
            board.q_segment_board = known->q_segment_board.value_or(board.q_segment_board);
        }
    for (Source& source : suit.sources)
        if (const SourceCalibration* known = calibration.findSource(source.id))
            source.p_segment_source_m = known->p_segment_source_m.value_or(source.p_segment_source_m);
    return suit;
}

}  // namespace noctule
