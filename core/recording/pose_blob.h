// SPDX-License-Identifier: Apache-2.0
// Rotations and their deviations as a take stores them: little-endian float64 w,x,y,z per joint and float32
// radians, three per joint.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/math/conventions.h"

namespace noctule {

std::vector<std::byte> packRotations(const std::vector<Quaterniond>& q_parent_joint);

/// Nothing when the length is not `joint_count` quaternions or one is not finite or not of norm 1 within 1 %.
std::optional<std::vector<Quaterniond>> unpackRotations(std::span<const std::byte> blob, size_t joint_count);

std::vector<std::byte> packSigma(const std::vector<double>& sigma_rad);

/// Nothing when the length is not three numbers per joint or one is not finite or negative.
std::optional<std::vector<double>> unpackSigma(std::span<const std::byte> blob, size_t joint_count);

}  // namespace noctule
