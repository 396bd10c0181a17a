// SPDX-License-Identifier: Apache-2.0
// Points that few hear for a while. The filter of Welch 2018 linearises about one place. A point that drifted
// off unheard is drawn to a wrong place by the next ranges, often to the mirror image across a plane of
// sources. It then gates out what contradicts that place. So a point whose place has become unsure leaves the
// filter. It goes along with the nearest known point of its wearer, and a window of ranges is fitted from
// many starting points. It comes back when one place explains them. Ours: the paper has nothing of the kind.
#pragma once

#include <deque>
#include <vector>

#include "core/cooperative/point_fit.h"

namespace noctule::cooperative {

class LostPoints {
public:
    /// `user_of_point`: who wears each; `reaches`: of each point to each.
    LostPoints(const std::vector<Vector3d>& rest_m, std::vector<int> user_of_point,
               std::vector<std::vector<Reach>> reaches, const LostPointSettings& settings = {});

    bool isLost(int point) const { return points_[static_cast<size_t>(point)].is_lost; }
    void judged(int point, bool gated);
    void note(int point, const LostRange& range) {
        points_[static_cast<size_t>(point)].ranges.push_back(range);
    }
    /// Once per interval_s of `time_s`: who is lost, where those are, who is known again.
    void look(FreePoints& points, double time_s);

    int64_t losses() const { return losses_; }

private:
    struct Watched {
        bool is_lost = false;
        double known_s = 0;  ///< last time it was well known
        double gated_share = 0;
        std::deque<LostRange> ranges{};
        std::vector<Vector3d> offsets_m{};  ///< to each other point, when both were well known
    };
    void remember(const FreePoints& points, double time_s);
    void loseUnsure(const FreePoints& points);
    void loseOutOfReach(const FreePoints& points);
    void lose(int point);
    /// The known point of the same wearer that bones bind most closely; none: -1.
    int neighbourOf(int point) const;
    void seek(FreePoints& points, int point, double time_s);

    LostPointSettings settings_;
    std::vector<int> user_of_point_;
    std::vector<std::vector<Reach>> reaches_;
    std::vector<Watched> points_;
    double lowest_m_ = 0, next_look_s_ = 0;
    int64_t losses_ = 0;
};

}  // namespace noctule::cooperative
