// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "core/simulation/rig_world.h"

namespace noctule::simulation {
namespace {

constexpr double kUsualStation_s = 4, kUsualTurning_s = 8, kUsualRolling_s = 120;

struct Shape {
    double stations = 0;
    double between_s = 0;  ///< from one station to the next
    double before_s = 0, after_s = 0;
};

Shape shapeOf(RigKind kind, const RigScenario& scenario) {
    switch (kind) {
        case RigKind::kJig:
            return {static_cast<double>(scenario.jig_placements), RigWorld::kMove_s};
        case RigKind::kLevelPlate:
            return {6, RigWorld::kTurn_s};
        case RigKind::kBag:
            return {1};
        case RigKind::kTurntable:
            break;
    }
    return {6, 2 * RigWorld::kSpeedUp_s + RigWorld::kTurn_s, RigWorld::kSpeedUp_s, RigWorld::kSpeedUp_s};
}

}  // namespace

double stationLength_s(RigKind kind, const RigScenario& scenario, double duration_s) {
    const Shape shape = shapeOf(kind, scenario);
    return (duration_s - shape.before_s - shape.after_s - (shape.stations - 1) * shape.between_s) /
           shape.stations;
}

double usualDuration_s(RigKind kind, const RigScenario& scenario) {
    const Shape shape = shapeOf(kind, scenario);
    const double station_s = kind == RigKind::kBag         ? kUsualRolling_s
                             : kind == RigKind::kTurntable ? kUsualTurning_s
                                                           : kUsualStation_s;
    return shape.before_s + shape.after_s + (shape.stations - 1) * shape.between_s +
           shape.stations * station_s;
}

std::vector<RigStation> runThrough(RigWorld& rig, const RigScenario& scenario, double station_s) {
    std::vector<RigStation> stations;
    double now_s = 0;
    const auto stay = [&](double since_s, const std::string& label) {
        now_s = since_s + station_s;
        stations.push_back({since_s, now_s, label});
    };
    switch (rig.kind()) {
        case RigKind::kJig:
            for (int k = 0; k < rig.placementCount(); ++k)
                stay(rig.place(k, now_s), std::to_string(k + 1));
            break;
        case RigKind::kLevelPlate:
            for (const RigSide side : allRigSides())
                stay(rig.layOn(side, now_s), side.name() + " up");
            break;
        case RigKind::kTurntable:
            for (const RigSide side : allRigSides())
                stay(rig.spin(side, scenario.turntable_rpm, now_s), side.name() + " up");
            rig.spin(allRigSides().back(), 0, now_s);
            break;
        case RigKind::kBag:
            rig.roll(station_s, 0);
            stay(0, "all directions");
            break;
    }
    return stations;
}

std::string digitizerCsv(const RigWorld& jig, const Suit& suit, double sigma_m, uint64_t seed) {
    Random random(seed, "digitizer");
    std::string csv = "placement,kind,id,x_m,y_m,z_m\n";
    const auto add = [&](int placement, const char* kind, const std::string& id, const Vector3d& point_m) {
        const Vector3d found_m = point_m + random.gaussianVector(sigma_m);
        char row[160];
        std::snprintf(row, sizeof row, "%d,%s,%s,%.6f,%.6f,%.6f\n", placement + 1, kind, id.c_str(),
                      found_m.x(), found_m.y(), found_m.z());
        csv += row;
    };
    for (int k = 0; k < jig.placementCount(); ++k) {
        for (int s = 0; s < jig.sourceCount(); ++s)
            add(k, "source", suit.sources[s].id, jig.sourceIn(k, s));
        for (int b = 0; b < jig.boardCount(); ++b)
            add(k, "board", suit.boards[b].id, jig.microphoneIn(k, b));
    }
    return csv;
}

}  // namespace noctule::simulation
