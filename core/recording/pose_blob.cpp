// SPDX-License-Identifier: Apache-2.0
#include "core/recording/pose_blob.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace noctule {

static_assert(std::endian::native == std::endian::little, "blobs of a take are little-endian");

namespace {

constexpr size_t kBytesPerRotation = 4 * sizeof(double);

}  // namespace

std::vector<std::byte> packRotations(const std::vector<Quaterniond>& q_parent_joint) {
    std::vector<std::byte> blob(q_parent_joint.size() * kBytesPerRotation);
    std::byte* out = blob.data();
    for (const Quaterniond& q : q_parent_joint) {
        const double wxyz[4] = {q.w(), q.x(), q.y(), q.z()};
        std::memcpy(out, wxyz, kBytesPerRotation);
        out += kBytesPerRotation;
    }
    return blob;
}

std::optional<std::vector<Quaterniond>> unpackRotations(std::span<const std::byte> blob, size_t joint_count) {
    if (blob.size() != joint_count * kBytesPerRotation)
        return std::nullopt;
    std::vector<Quaterniond> rotations;
    rotations.reserve(joint_count);
    for (size_t joint = 0; joint < joint_count; ++joint) {
        double wxyz[4];
        std::memcpy(wxyz, blob.data() + joint * kBytesPerRotation, kBytesPerRotation);
        const Quaterniond q(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
        const double deviation = std::abs(q.norm() - 1);
        if (!(deviation < 0.01))
            return std::nullopt;
        rotations.push_back(deviation < 1e-12 ? q
                                              : q.normalized());  // what was unit stays the same to the bit
    }
    return rotations;
}

std::vector<std::byte> packSigma(const std::vector<double>& sigma_rad) {
    std::vector<float> narrow(sigma_rad.size());
    std::transform(sigma_rad.begin(), sigma_rad.end(), narrow.begin(),
                   [](double value) { return static_cast<float>(value); });
    const auto bytes = std::as_bytes(std::span(narrow));
    return {bytes.begin(), bytes.end()};
}

std::optional<std::vector<double>> unpackSigma(std::span<const std::byte> blob, size_t joint_count) {
    std::vector<float> narrow(3 * joint_count);
    if (blob.size() != narrow.size() * sizeof(float))
        return std::nullopt;
    if (!blob.empty())
        std::memcpy(narrow.data(), blob.data(), blob.size());
    if (!std::all_of(narrow.begin(), narrow.end(), [](float v) { return std::isfinite(v) && v >= 0; }))
        return std::nullopt;
    return std::vector<double>(narrow.begin(), narrow.end());
}

}  // namespace noctule
