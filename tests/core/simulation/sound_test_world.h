// SPDX-License-Identifier: Apache-2.0
// A world for the sound's tests: boards and sources in uniform motion, and capsules that stand still.
#pragma once

#include <vector>

#include "core/simulation/world.h"

namespace noctule::simulation {

struct TestWorld : World {
    struct Mover {
        Vector3d p_m = Vector3d::Zero(), v_m_per_s = Vector3d::Zero();
        Vector3d normal = Vector3d::UnitZ();
        int segment = -1;
        Vector3d at(double t_s) const { return p_m + v_m_per_s * t_s; }
    };
    std::vector<Mover> boards, sources;
    std::vector<WorldCapsule> body;

    double duration_s() const override { return 1000; }
    int boardCount() const override { return static_cast<int>(boards.size()); }
    int sourceCount() const override { return static_cast<int>(sources.size()); }
    Vector3d microphone(int board, double t_s) const override { return boards.at(board).at(t_s); }
    Vector3d source(int source, double t_s) const override { return sources.at(source).at(t_s); }
    Vector3d sourceNormal(int source, double) const override { return sources.at(source).normal; }
    int boardSegment(int board) const override { return boards.at(board).segment; }
    int sourceSegment(int source) const override { return sources.at(source).segment; }
    void capsules(double, std::vector<WorldCapsule>& capsules) const override { capsules = body; }
};

}  // namespace noctule::simulation
