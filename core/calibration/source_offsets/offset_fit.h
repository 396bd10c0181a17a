// SPDX-License-Identifier: Apache-2.0
// Robust weighted least squares of offsets, the speed of sound's error and the microphones' delays (model in
// source_offsets.h; linear). Weights: Tukey's biweight of the residual, started at medians; the measurements'
// own sigmas and a common spread that the residuals show. What is tolerated but not applied is a parameter
// with its tolerance as prior, so that it neither bends the offsets nor makes their sigmas too small.
#pragma once

#include <vector>

namespace noctule {

struct OffsetSample {
    int source = 0, board = 0, placement = 0;
    double travel_s = 0;  ///< known distance over the speed of sound in force
    double delay_s = 0;   ///< flight minus travel minus the microphone's delay in force
    double sigma_s = 0;
    bool left_out = false;
};

struct OffsetFitSettings {
    int sources = 0, boards = 0, placements = 0;
    double stretch_sigma = 0;  ///< prior of the flight times' relative excess over travel_s
    bool apply_stretch = false;
    double placement_sigma = 0;  ///< prior of each placement's excess over that: its thermometer reading
    double mic_sigma_s = 0;      ///< prior of each microphone's delay beyond the one in force
    bool apply_mics = false;     ///< with mean 0
};

struct OffsetFit {
    std::vector<double> offset_s, offset_sigma_s;  ///< per source
    double stretch = 0, stretch_sigma = 0;
    std::vector<double> mic_s, mic_sigma_s;  ///< per board
    double spread_s = 0;                     ///< robust, of the samples that are not left out
    // Per sample:
    std::vector<double> weight;      ///< 0..1
    std::vector<double> misfit_s;    ///< delay not explained by all parameters
    std::vector<double> residual_s;  ///< delay not explained by what is applied
    std::vector<double> left_out_s;  ///< the same when the sample itself had no part in the fit
};

OffsetFit fitOffsets(const std::vector<OffsetSample>& samples, const OffsetFitSettings& settings);

}  // namespace noctule
