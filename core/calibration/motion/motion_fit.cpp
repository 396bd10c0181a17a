// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/motion/motion_fit.h"

#include <algorithm>
#include <cmath>

#include "core/math/order_statistics.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kFirstAccel_m_per_s2 = 0.6, kFirstDistance_m = 0.03;
constexpr double kLeastAccel_m_per_s2 = 0.02, kLeastDistanceNoise_m = 5e-4;
constexpr double kLossScale = 2.5;  // in sigma: residuals beyond it pull less and less
constexpr double kEachPair_s = 0.064;
constexpr size_t kFewestOfPair = 20;                // distances that tell a pair's noise
constexpr double kTurnThatEnds_rad = radians(0.1);  // of the board that turns most
constexpr int kFirstLearning = 1, kFewestIterations = 3;
constexpr double kDamping = 1e-9;

}  // namespace

/// Residuals, all components.
struct MotionFit::Sizes {
    std::vector<std::vector<double>> gyro, accel;  ///< per board
    std::vector<std::vector<double>> distance;     ///< per pair, as MotionFitNoise

    Sizes(size_t boards, size_t sources) : gyro(boards), accel(boards), distance(sources * boards) {}
    static std::vector<double> each(const std::vector<std::vector<double>>& values) {
        std::vector<double> sizes;
        for (const auto& of_board : values)
            sizes.push_back(spreadAbout(0, of_board));
        return sizes;
    }
    MotionResidualSizes ofBoards() const {
        std::vector<std::vector<double>> of_board(gyro.size());
        for (size_t pair = 0; pair < distance.size(); ++pair) {
            auto& all = of_board[pair % of_board.size()];
            all.insert(all.end(), distance[pair].begin(), distance[pair].end());
        }
        return {each(gyro), each(accel), each(of_board)};
    }
};

struct MotionFit::Round {
    ArrowheadSystem system;
    Sizes sizes;
    std::vector<double> board_cost;
    double cost = 0;
};

MotionFit::MotionFit(const MotionBody& body, const MotionModel& model, const MotionLayout& layout,
                     const MotionSettings& settings, const std::vector<MotionEvidence>& takes,
                     const ExpectedConstants& expected)
    : body_(body),
      model_(model),
      layout_(layout),
      settings_(settings),
      takes_(takes),
      expected_(expected),
      priors_(body, layout_, settings_) {
    const auto boards = static_cast<size_t>(layout.boards);
    noise_ = {std::vector<double>(boards, kFirstAccel_m_per_s2),
              std::vector<double>(boards * static_cast<size_t>(layout.sources), kFirstDistance_m)};
    for (const MotionEvidence& take : takes) {
        first_node_.push_back(static_cast<int>(rest_of_node_.size()));
        rest_of_node_.insert(rest_of_node_.end(), static_cast<size_t>(take.nodes),
                             first_node_.back() + take.rests.front().middle());
    }
    for (int b = 0; b < layout.boards; ++b)
        board_segments_.push_back(model.boardSegment(b));
}

/// `copies`: so many neighbours say the same. Returns its cost.
double MotionFit::addData(ResidualBlock& block, double sigma, double copies, std::vector<double>& sizes,
                          Round& round) const {
    const double square = block.residual.head(block.rows).squaredNorm() / (sigma * sigma * block.rows);
    const double scale_square = kLossScale * kLossScale;
    const double cost = block.rows * scale_square * std::log1p(square / scale_square) / copies;
    round.cost += cost;
    block.weight.setConstant(1 / (sigma * sigma * copies * (1 + square / scale_square)));
    round.system.add(block);
    for (int row = 0; row < block.rows; ++row)
        sizes.push_back(block.residual[row]);
    return cost;
}

void MotionFit::addReadings(const MotionUnknowns& unknowns, size_t index, Round& round,
                            const JobContext& job) const {
    const MotionEvidence& take = takes_[index];
    const double copies = std::max(1.0, settings_.correlation_s / settings_.step_s);
    for (int b = 0; b < layout_.boards && !job.cancelled(); ++b) {
        const auto board = static_cast<size_t>(b);
        for (int k = 0; k < take.nodes; ++k) {
            const double since_middle_s = (k - take.nodes / 2.0) * take.step_s;
            if (k + 1 < take.nodes && take.turns[board][static_cast<size_t>(k)].heard) {
                const BoardTurn& turn = take.turns[board][static_cast<size_t>(k)];
                auto block = model_.gyro(unknowns, b, firstNode(index) + k, turn, since_middle_s);
                const double angle_rad = angleBetween(turn.q_begin_end, Quaterniond::Identity());
                round.board_cost[board] +=
                    addData(block, std::hypot(settings_.sigma_turn_rad, settings_.turn_share * angle_rad),
                            copies, round.sizes.gyro[board], round);
            }
            if (const BoardForce& force = take.forces[board][static_cast<size_t>(k)]; force.heard) {
                auto block = model_.accel(unknowns, b, firstNode(index) + k, force);
                round.board_cost[board] +=
                    addData(block, noise_.accel_m_per_s2[board], copies, round.sizes.accel[board], round);
            }
        }
    }
    for (const HeardDistance& heard : take.distances) {
        if (job.cancelled())
            return;
        const auto board = static_cast<size_t>(heard.board);
        auto block = model_.distance(unknowns, heard, firstNode(index));
        round.board_cost[board] += addData(block, noise_.distance_m[pairOf(heard)] / heard.confidence,
                                           std::max(1.0, settings_.correlation_s / kEachPair_s),
                                           round.sizes.distance[pairOf(heard)], round);
    }
}

void MotionFit::addTies(const MotionUnknowns& unknowns, size_t index, const ResidualSink& sink) const {
    const MotionEvidence& take = takes_[index];
    const int first = firstNode(index);
    for (size_t rest = 0; rest < take.rests.size(); ++rest)
        priors_.addRest(unknowns, first + take.rests[rest].middle(), rest == 0, sink);
    for (int k = 0; k < take.nodes; ++k) {
        priors_.addJoints(unknowns, first + k, sink);
        if (k + 1 == take.nodes)
            break;
        priors_.addRootStep(unknowns, first + k, take.isStillStep(k), sink);
        for (int s = 0; s < body_.size(); ++s) {
            bool heard = false;
            for (size_t b = 0; b < board_segments_.size() && !heard; ++b)
                heard = board_segments_[b] == s && take.turns[b][static_cast<size_t>(k)].heard;
            if (!heard)
                priors_.addFollowing(unknowns, first + k, s, sink);
        }
    }
}

void MotionFit::assemble(const MotionUnknowns& unknowns, Round& round, const JobContext& job) const {
    const ResidualSink sink = [&round](const ResidualBlock& block) {
        round.cost += block.weight.head(block.rows).dot(block.residual.head(block.rows).cwiseAbs2());
        round.system.add(block);
    };
    priors_.addConstants(unknowns, expected_, board_segments_, sink);
    for (size_t take = 0; take < takes_.size() && !job.cancelled(); ++take) {
        addReadings(unknowns, take, round, job);
        addTies(unknowns, take, sink);
    }
}

/// A pair that is seldom heard counts as its board's others.
void MotionFit::learnNoise(const Sizes& sizes, const MotionResidualSizes& of_boards) {
    for (size_t b = 0; b < noise_.accel_m_per_s2.size(); ++b)
        noise_.accel_m_per_s2[b] = std::max(kLeastAccel_m_per_s2, of_boards.accel_m_per_s2[b]);
    for (size_t pair = 0; pair < noise_.distance_m.size(); ++pair)
        noise_.distance_m[pair] =
            std::max(kLeastDistanceNoise_m, sizes.distance[pair].size() < kFewestOfPair
                                                ? of_boards.distance_m[pair % noise_.accel_m_per_s2.size()]
                                                : spreadAbout(0, sizes.distance[pair]));
}

std::vector<double> MotionFit::turnsOf(const ArrowheadSystem& solved) const {
    std::vector<double> turns_rad;
    for (int b = 0; b < layout_.boards; ++b)
        turns_rad.push_back(solved.borderStep().segment<3>(layout_.mounting(b)).norm());
    return turns_rad;
}

Result<MotionFitResult> MotionFit::run(MotionUnknowns start, const JobContext& job) {
    MotionFitResult result;
    result.unknowns = std::move(start);
    for (result.iterations = 0;; ++result.iterations) {
        job.progress(static_cast<double>(result.iterations) / (settings_.most_iterations + 1.0),
                     "Fitting the movement");
        if (job.cancelled())
            return JobContext::cancelledError();
        model_.freezeFlesh(result.unknowns, rest_of_node_);
        Round round{ArrowheadSystem(static_cast<int>(result.unknowns.nodes.size()), layout_.nodeSize(),
                                    layout_.borderSize()),
                    Sizes(noise_.accel_m_per_s2.size(), static_cast<size_t>(layout_.sources)),
                    std::vector<double>(noise_.accel_m_per_s2.size(), 0.0)};
        assemble(result.unknowns, round, job);
        result.after = round.sizes.ofBoards();
        result.board_cost = round.board_cost;
        result.cost = round.cost;
        if (result.iterations == 0)
            result.before = result.after;
        const bool solved = std::isfinite(round.cost) && round.system.solve(kDamping, job);
        if (job.cancelled())
            return JobContext::cancelledError();
        if (!solved) {
            result.converged = false;
            return result;
        }
        if (result.converged || result.iterations == settings_.most_iterations) {
            result.cov_border = round.system.borderCovariance();
            return result;
        }
        move(result.unknowns, layout_, round.system.nodeSteps(), round.system.borderStep());
        result.last_turn_rad = turnsOf(round.system);
        result.converged =
            result.iterations >= kFewestIterations &&
            *std::max_element(result.last_turn_rad.begin(), result.last_turn_rad.end()) < kTurnThatEnds_rad;
        if (learns_noise_ && result.iterations >= kFirstLearning)
            learnNoise(round.sizes, result.after);
    }
}

}  // namespace noctule
