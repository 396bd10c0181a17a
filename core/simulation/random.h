// SPDX-License-Identifier: Apache-2.0
// The simulation's random numbers: xoshiro256++ (Blackman, Vigna 2019) seeded by splitmix64. The same numbers
// on every machine; only the logarithms behind gaussian() and exponential() may differ in the last bit. Every
// effect draws from its own stream, named by text and index, so that switching one effect on or off never
// changes what another draws:   Random random(seed, "gyro noise", board);
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/math/conventions.h"

namespace noctule::simulation {

/// Layers of the normal density for Marsaglia and Tsang's ziggurat (2000), in Doornik's form (2005).
struct ZigguratTable {
    static constexpr int kLayers = 256;
    std::array<double, kLayers + 1> edge;  ///< outer edge of each layer, falling to 0
    std::array<double, kLayers> inner;     ///< edge[i + 1] / edge[i]: below it a draw is accepted at once
    static const ZigguratTable& instance();
};

class Random {
public:
    /// The stream of that name and index under a take's seed; equal arguments give equal streams.
    explicit Random(uint64_t seed, std::string_view name = {}, uint64_t index = 0);

    /// 64 equally likely bits.
    uint64_t bits() {
        const uint64_t result = rotateLeft(state_[0] + state_[3], 23) + state_[0];
        const uint64_t shifted = state_[1] << 17;
        state_[2] ^= state_[0];
        state_[3] ^= state_[1];
        state_[1] ^= state_[2];
        state_[0] ^= state_[3];
        state_[2] ^= shifted;
        state_[3] = rotateLeft(state_[3], 45);
        return result;
    }

    /// Uniform in [0, 1), in steps of 2^-53.
    double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    /// Uniform in [low, high).
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    /// Uniform in 0 .. count - 1; count > 0 and far below 2^53.
    int64_t below(int64_t count) { return static_cast<int64_t>(uniform() * static_cast<double>(count)); }

    /// Normal with mean 0 and standard deviation 1.
    double gaussian() {
        const uint64_t word = bits();
        const size_t layer = word & 255;
        const double u = static_cast<double>(static_cast<int64_t>(word) >> 11) * 0x1p-52;  // in [-1, 1)
        if (u < ziggurat_->inner[layer] && -u < ziggurat_->inner[layer]) [[likely]]
            return u * ziggurat_->edge[layer];
        return gaussianNearEdge(layer, u);
    }
    double gaussian(double sigma) { return sigma * gaussian(); }
    /// Three independent components of that standard deviation.
    Vector3d gaussianVector(double sigma);
    /// Uniform on the unit sphere.
    Vector3d direction();
    /// Waiting time of a Poisson process of rate 1.
    double exponential();

private:
    static uint64_t rotateLeft(uint64_t x, int by) { return (x << by) | (x >> (64 - by)); }
    double gaussianNearEdge(size_t layer, double u);

    std::array<uint64_t, 4> state_;
    const ZigguratTable* ziggurat_;
};

}  // namespace noctule::simulation
