// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/random.h"

#include <cmath>

namespace noctule::simulation {
namespace {

// For 256 layers: where the tail begins, and the area of every layer (Doornik 2005, table 1).
constexpr double kTailStart = 3.6541528853610088;
constexpr double kLayerArea = 0.00492867323399;

double density(double x) {
    return std::exp(-0.5 * x * x);
}

ZigguratTable makeTable() {
    ZigguratTable table{};
    table.edge[0] = kLayerArea / density(kTailStart);
    table.edge[1] = kTailStart;
    for (size_t i = 2; i < ZigguratTable::kLayers; ++i)
        table.edge[i] = std::sqrt(-2 * std::log(kLayerArea / table.edge[i - 1] + density(table.edge[i - 1])));
    table.edge[ZigguratTable::kLayers] = 0;
    for (size_t i = 0; i < ZigguratTable::kLayers; ++i)
        table.inner[i] = table.edge[i + 1] / table.edge[i];
    return table;
}

/// One step of splitmix64 (Steele, Lea, Flood 2014): advances the counter and scrambles it.
uint64_t splitMix(uint64_t& counter) {
    counter += 0x9E3779B97F4A7C15u;
    uint64_t z = counter;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

/// FNV-1a, 64 bits.
uint64_t hashText(std::string_view text) {
    uint64_t hash = 0xCBF29CE484222325u;
    for (const char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
    return hash;
}

}  // namespace

const ZigguratTable& ZigguratTable::instance() {
    static const ZigguratTable table = makeTable();
    return table;
}

Random::Random(uint64_t seed, std::string_view name, uint64_t index) : ziggurat_(&ZigguratTable::instance()) {
    // Each part is scrambled before the next joins, so that (seed 1, index 2) is not (seed 2, index 1).
    uint64_t counter = seed;
    counter = splitMix(counter) ^ hashText(name);
    counter = splitMix(counter) ^ index;
    for (uint64_t& word : state_)
        word = splitMix(counter);
}

double Random::gaussianNearEdge(size_t layer, double u) {
    while (true) {
        const double x = u * ziggurat_->edge[layer];
        if (std::abs(u) < ziggurat_->inner[layer])
            return x;
        if (layer == 0) {  // beyond the last edge: Marsaglia's exact tail
            while (true) {
                const double beyond = exponential() / kTailStart;
                if (2 * exponential() > beyond * beyond)
                    return std::copysign(kTailStart + beyond, u);
            }
        }
        const double outer_density = density(ziggurat_->edge[layer]);
        const double inner_density = density(ziggurat_->edge[layer + 1]);
        if (outer_density + uniform() * (inner_density - outer_density) < density(x))
            return x;
        const uint64_t word = bits();
        layer = word & 255;
        u = static_cast<double>(static_cast<int64_t>(word) >> 11) * 0x1p-52;
    }
}

Vector3d Random::gaussianVector(double sigma) {
    const double x = gaussian(sigma), y = gaussian(sigma), z = gaussian(sigma);
    return {x, y, z};
}

Vector3d Random::direction() {
    while (true) {
        const Vector3d v = gaussianVector(1);
        if (v.squaredNorm() > 1e-12)
            return v.normalized();
    }
}

double Random::exponential() {
    return -std::log(1 - uniform());
}

}  // namespace noctule::simulation
