// SPDX-License-Identifier: Apache-2.0
// Batch least squares over trajectories and constants: Gauss-Newton with robust weights, the noise of every
// board's readings learnt from what the fit leaves over.
#pragma once

#include "core/calibration/motion/motion_evidence.h"
#include "core/calibration/motion/motion_model.h"
#include "core/calibration/motion/motion_priors.h"
#include "core/job/job.h"

namespace noctule {

/// Root mean squares, robust; per board.
struct MotionResidualSizes {
    std::vector<double> gyro_rad{}, accel_m_per_s2{}, distance_m{};  ///< a step's turn; a force; a distance
};

/// Standard deviations that a fit learns. Distances of one pair are heard directly, those of another one by
/// way of the floor: each pair has its own.
struct MotionFitNoise {
    std::vector<double> accel_m_per_s2{};  ///< per board
    std::vector<double> distance_m{};      ///< per pair, source by source
};

struct MotionFitResult {
    MotionUnknowns unknowns{};
    Eigen::MatrixXd cov_border{};
    MotionResidualSizes before{},
        after{};  ///< what the first trajectory left over with the constants expected
    int iterations = 0;
    bool converged = false;
    std::vector<double> board_cost{};     ///< of each board's readings, robust, in squared sigma
    double cost = 0;                      ///< of all terms
    std::vector<double> last_turn_rad{};  ///< by which each board's mounting moved in the last step
};

class MotionFit {
public:
    /// Keeps references to all.
    MotionFit(const MotionBody& body, const MotionModel& model, const MotionLayout& layout,
              const MotionSettings& settings, const std::vector<MotionEvidence>& takes,
              const ExpectedConstants& expected);

    /// From first nodes and constants, or from where an earlier run ended: the noise it learnt stays.
    Result<MotionFitResult> run(MotionUnknowns start, const JobContext& job);
    /// As learnt.
    const MotionFitNoise& noise() const { return noise_; }
    /// Takes another fit's and learns none: costs of two fits with the same noise can be compared.
    void keepNoise(const MotionFitNoise& noise) {
        noise_ = noise;
        learns_noise_ = false;
    }

private:
    struct Round;
    struct Sizes;
    void assemble(const MotionUnknowns& unknowns, Round& round, const JobContext& job) const;
    std::vector<double> turnsOf(const ArrowheadSystem& solved) const;
    void addReadings(const MotionUnknowns& unknowns, size_t take, Round& round, const JobContext& job) const;
    void addTies(const MotionUnknowns& unknowns, size_t take, const ResidualSink& sink) const;
    double addData(ResidualBlock& block, double sigma, double copies, std::vector<double>& sizes,
                   Round& round) const;
    void learnNoise(const Sizes& sizes, const MotionResidualSizes& of_boards);
    size_t pairOf(const HeardDistance& heard) const {
        return static_cast<size_t>(heard.source * layout_.boards + heard.board);
    }
    int firstNode(size_t take) const { return first_node_[take]; }

    const MotionBody& body_;
    MotionModel model_;
    MotionLayout layout_;
    MotionSettings settings_;
    const std::vector<MotionEvidence>& takes_;
    const ExpectedConstants& expected_;
    MotionPriors priors_;
    MotionFitNoise noise_;
    bool learns_noise_ = true;
    std::vector<int> first_node_, rest_of_node_, board_segments_;
};

}  // namespace noctule
