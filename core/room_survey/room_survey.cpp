// SPDX-License-Identifier: Apache-2.0
#include "core/room_survey/room_survey.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math/linear_solvers.h"
#include "core/math/order_statistics.h"
#include "core/math/rotation_fit.h"
#include "core/room_survey/anchor_start.h"

namespace noctule::room_survey {
namespace {

constexpr double kDoubted_m = 10;           ///< sigma of ranges that are to bend nothing
constexpr size_t kMostWalkRanges = 12'000;  ///< of the walk, in one fit
/// A rest pose that leans, or straps that do, tilt the room with whoever never turns round.
constexpr double kLean_rad = 0.012;
constexpr double kFixed = 0.1;          ///< metres, radians: better known than that is known
constexpr double kNoSpread_m = 0.3;     ///< rough places nearer than that to each other say nothing
constexpr double kPlainlyBetter = 0.5;  ///< of two mirror images, so much less misfit to the file

Error unusable(const std::string& what, const std::string& remedy) {
    return {ErrorKind::kUnusable, what, remedy};
}

Status check(const Evidence& evidence) {
    const size_t count = evidence.anchors.size();
    if (count < kFewestAnchors)
        return unusable("The room has " + std::to_string(count) + " anchors, a survey needs three",
                        "Set up another anchor and record again");
    if (!evidence.walk.empty())
        return Done{};
    if (std::ranges::none_of(evidence.anchors, &Anchor::sounds))
        return unusable(
            "The anchors have no sources, and nobody in a suit walked past them",
            "Record a take in which somebody in a suit stands still and then walks past all anchors");
    if (pairDistances(evidence).size() < kFewestAnchors)
        return unusable("The anchors hardly hear each other, and nobody in a suit walked past them",
                        "Record a take in which somebody in a suit stands still and then walks past all "
                        "anchors, or bring "
                        "the anchors nearer together");
    return Done{};
}

/// Only the anchors of `kept`, counted anew.
Evidence onlyOf(const Evidence& evidence, const std::vector<int>& kept) {
    std::vector<int> index(evidence.anchors.size(), -1);
    Evidence part = evidence;
    part.anchors.clear();
    for (size_t i = 0; i < kept.size(); ++i) {
        index[static_cast<size_t>(kept[i])] = static_cast<int>(i);
        part.anchors.push_back(evidence.anchors[static_cast<size_t>(kept[i])]);
    }
    const auto at = [&](int anchor) { return index[static_cast<size_t>(anchor)]; };
    std::erase_if(part.between, [&](const AnchorRange& one) { return at(one.from) < 0 || at(one.to) < 0; });
    std::erase_if(part.walk, [&](const WalkRange& one) { return at(one.anchor) < 0; });
    std::erase_if(part.heights, [&](const KnownHeight& one) { return at(one.anchor) < 0; });
    for (AnchorRange& one : part.between)
        one.from = at(one.from), one.to = at(one.to);
    for (WalkRange& one : part.walk)
        one.anchor = at(one.anchor);
    for (KnownHeight& one : part.heights)
        one.anchor = at(one.anchor);
    return part;
}

/// Ranges that are half a second apart tell more than those between them.
void thin(std::vector<WalkRange>& walk) {
    const size_t step = (walk.size() + kMostWalkRanges - 1) / kMostWalkRanges;
    for (size_t i = 0; step > 1 && i * step < walk.size(); ++i)
        walk[i] = walk[i * step];
    if (step > 1)
        walk.resize((walk.size() + step - 1) / step);
}

double rmsTo(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to, Eigen::Matrix3Xd& moved) {
    moved = rigidFit(from, to) * from;
    return std::sqrt((moved - to).squaredNorm() / static_cast<double>(to.cols()));
}

/// Takes places in a frame of their own to that of the room's file; of two mirror images the one that fits
/// it.
Status putIntoFileFrame(const Evidence& evidence, AnchorStart& start) {
    std::vector<size_t> placed;
    for (size_t i = 0; i < evidence.anchors.size(); ++i)
        if (start.places_m[i])
            placed.push_back(i);
    const auto n = static_cast<Eigen::Index>(placed.size());
    Eigen::Matrix3Xd found(3, n), rough(3, n), as_is, mirrored;
    for (Eigen::Index i = 0; i < n; ++i) {
        const size_t anchor = placed[static_cast<size_t>(i)];
        found.col(i) = *start.places_m[anchor];
        rough.col(i) = evidence.anchors[anchor].rough_m;
        for (const KnownHeight& known : evidence.heights)
            if (known.anchor == static_cast<int>(anchor))
                rough(1, i) = known.height_m;
    }
    const Eigen::Matrix3Xd spread = rough.colwise() - rough.rowwise().mean();
    if (std::sqrt(spread.topRows<1>().squaredNorm() + spread.bottomRows<1>().squaredNorm()) < kNoSpread_m)
        return unusable(
            "Nobody in a suit walked past the anchors, and the room's file does not say roughly where they "
            "hang: place and heading of the room cannot be known",
            "Record a take with a performer, or put rough places into the room's file");
    const double rms_m = rmsTo(found, rough, as_is);
    const double mirrored_rms_m = rmsTo(Vector3d(1, 1, -1).asDiagonal() * found, rough, mirrored);
    const bool turned = mirrored_rms_m < rms_m;
    // Anchors in one plane are their own mirror image.
    const double worse_m = std::max(rms_m, mirrored_rms_m), better_m = std::min(rms_m, mirrored_rms_m);
    const bool is_told = better_m < kPlainlyBetter * worse_m || (as_is - mirrored).norm() < kNoSpread_m;
    for (Eigen::Index i = 0; i < n; ++i) {
        const size_t anchor = placed[static_cast<size_t>(i)];
        start.places_m[anchor] = turned ? mirrored.col(i) : as_is.col(i);
        start.is_mirrored[anchor] = !is_told;
    }
    return Done{};
}

RoomFrame frameOf(const Evidence& evidence, const RoomFit& fit) {
    RoomFrame frame;
    frame.of_performer = !evidence.walk.empty();
    const Eigen::MatrixXd G = commonMotions(fit.unknowns.places_m);
    const Eigen::MatrixXd back = solveLeastSquares(G, Eigen::MatrixXd::Identity(G.rows(), G.rows()));
    const Eigen::MatrixXd cov = back * fit.cov_places_m2 * back.transpose();
    const auto sigma = [&](Eigen::Index k) { return std::sqrt(std::max(0.0, cov(k, k))); };
    for (Eigen::Index k = 0; k < 6; ++k)
        frame.fixed += sigma(k) < kFixed;
    frame.floor_m = sigma(1) < kFixed ? sigma(1) : 0;
    const double level_rad = std::hypot(sigma(3), sigma(5), frame.of_performer ? kLean_rad : 0);
    frame.level_rad = level_rad < kFixed ? level_rad : 0;
    frame.heading_rad = sigma(4) < kFixed ? sigma(4) : 0;
    return frame;
}

class Survey {
public:
    Survey(const Evidence& evidence, const FitSettings& settings, const JobContext& job)
        : evidence_(evidence), settings_(settings), job_(job) {}

    Result<RoomSurvey> run() {
        if (Status usable = check(evidence_); !usable)
            return usable.error();
        AnchorStart start = evidence_.walk.empty() ? startFromDistances(evidence_) : startFromWalk(evidence_);
        if (evidence_.walk.empty())
            if (Status put = putIntoFileFrame(evidence_, start); !put)
                return put.error();
        describe(start);
        std::vector<int> kept;
        for (size_t i = 0; i < evidence_.anchors.size(); ++i)
            if (start.places_m[i])
                kept.push_back(static_cast<int>(i));
        if (kept.size() < kFewestAnchors)
            return tooFew(kept.size());
        return fit(start, std::move(kept));
    }

private:
    Error tooFew(size_t placed) const {
        std::string silent;
        for (const SurveyedAnchor& anchor : survey_.anchors)
            if (anchor.ranges < kFewestRanges && anchor.hears.size() < kFewestAnchors)
                silent += (silent.empty() ? "" : ", ") + anchor.id;
        return unusable(
            "Only " + std::to_string(placed) +
                " anchors were heard well enough, a survey needs three; hardly heard: " + silent,
            "Walk slowly past all anchors, turn towards each of them, and see that nothing hides them");
    }

    /// Who was heard by whom.
    void describe(const AnchorStart& start) {
        const std::vector<PairDistance> pairs = pairDistances(evidence_);
        for (size_t i = 0; i < evidence_.anchors.size(); ++i) {
            const Anchor& anchor = evidence_.anchors[i];
            SurveyedAnchor found;
            found.id = anchor.id;
            found.sent = anchor.sent, found.heard = anchor.heard;
            found.mirrored = start.is_mirrored[i] && start.places_m[i];
            found.ranges =
                static_cast<int>(std::ranges::count(evidence_.walk, static_cast<int>(i), &WalkRange::anchor));
            for (size_t other = 0; other < evidence_.anchors.size(); ++other) {
                const auto a = static_cast<int>(std::min(i, other)), b = static_cast<int>(std::max(i, other));
                const bool heard = std::ranges::any_of(
                    pairs, [&](const PairDistance& pair) { return pair.a == a && pair.b == b; });
                if (other != i)
                    (heard ? found.hears : found.hears_not).push_back(static_cast<int>(other));
            }
            survey_.anchors.push_back(std::move(found));
        }
    }

    struct Fitted {
        Evidence part;
        RoomFit fit;
        std::vector<AnchorMove> moves;  ///< the plainest first
    };
    /// `doubted`: the anchor, of those kept, by whose ranges nothing but its own place is to be found.
    Result<Fitted> fitted(const AnchorStart& start, const std::vector<int>& kept, int doubted = -1) const {
        Fitted result{onlyOf(evidence_, kept), {}, {}};
        thin(result.part.walk);
        for (WalkRange& range : result.part.walk)
            if (range.anchor == doubted)
                range.sigma_m = kDoubted_m;
        std::vector<Vector3d> places_m;
        for (const int anchor : kept)
            places_m.push_back(*start.places_m[static_cast<size_t>(anchor)]);
        auto fit = fitRoom(result.part, places_m, start.clock_m, settings_, job_);
        if (!fit)
            return fit.error();
        if (fit->cov_places_m2.size() == 0)
            return unusable("The distances do not hold the anchors together",
                            "Record again, slowly past all anchors");
        result.fit = std::move(*fit);
        result.moves = shiftsOf(result.part, result.fit);
        return result;
    }

    Result<RoomSurvey> fit(const AnchorStart& start, std::vector<int> kept) {
        auto all = fitted(start, kept);
        while (all && std::ranges::any_of(all->moves, &AnchorMove::isSuspicious)) {
            const auto move = culprit(start, kept, *all);
            if (!move)
                return move.error();
            if (!*move)
                break;
            survey_.anchors[static_cast<size_t>(kept[static_cast<size_t>((*move)->anchor)])].moved = *move;
            if (kept.size() <= kFewestAnchors)
                break;
            kept.erase(kept.begin() + (*move)->anchor);
            all = fitted(start, kept);
        }
        if (!all)
            return all.error();
        keep(all->part, all->fit, kept);
        survey_.findings = findingsOf(survey_, evidence_);
        return std::move(survey_);
    }

    /// A moved anchor bends the performer's way, so that others seem moved too: the culprit is the one
    /// without which the others agree best. Nothing: all stand still.
    Result<std::optional<AnchorMove>> culprit(const AnchorStart& start, const std::vector<int>& kept,
                                              const Fitted& all) const {
        const auto plain = [](const AnchorMove& move) {
            return move.isPlain() ? std::optional(move) : std::nullopt;
        };
        if (kept.size() <= kFewestAnchors)
            return plain(all.moves.front());
        std::optional<AnchorMove> best;
        double least = 0;
        for (int anchor = 0; anchor < std::ssize(kept); ++anchor) {
            const auto without = fitted(start, kept, anchor);
            if (!without)
                return without.error();
            const auto own = std::ranges::find(without->moves, anchor, &AnchorMove::anchor);
            if (own != without->moves.end() && (!best || without->fit.flesh_m < least))
                best = *own, least = without->fit.flesh_m;
        }
        return best ? plain(*best) : std::nullopt;
    }

    void keep(const Evidence& part, const RoomFit& fit, const std::vector<int>& kept) {
        survey_.performer = evidence_.walk.empty() ? "" : evidence_.performer;
        survey_.cov_m2 = constellationCovariance(fit.unknowns.places_m, fit.cov_places_m2);
        for (size_t i = 0; i < kept.size(); ++i) {
            SurveyedAnchor& anchor = survey_.anchors[static_cast<size_t>(kept[i])];
            const auto at = 3 * static_cast<Eigen::Index>(i);
            anchor.placed = true;
            anchor.place_m = fit.unknowns.places_m[i];
            anchor.microphone_m = fit.unknowns.microphone_m(i);
            anchor.source_m = fit.unknowns.source_m(i);
            anchor.cov_m2 = survey_.cov_m2.block<3, 3>(at, at);
            anchor.sigma_m = std::sqrt(eigenvaluesOf(anchor.cov_m2).maxCoeff());
        }
        keepDistances(part, fit, kept);
        survey_.frame = frameOf(part, fit);
        survey_.flesh_m = fit.flesh_m;
        survey_.iterations = fit.iterations;
        survey_.converged = fit.converged;
        keepResiduals(fit);
        double next_s = -1;
        for (size_t i = 0; i < part.walk.size(); ++i)
            if (part.walk[i].time_s >= next_s) {
                survey_.walked_m.push_back(fit.devices_at_m[i]);
                next_s = part.walk[i].time_s + settings_.node_s;
            }
    }

    void keepDistances(const Evidence& part, const RoomFit& fit, const std::vector<int>& kept) {
        const std::vector<PairDistance> pairs = pairDistances(part);
        for (int a = 0; a < std::ssize(kept); ++a)
            for (int b = a + 1; b < std::ssize(kept); ++b) {
                const Vector3d between = fit.unknowns.places_m[static_cast<size_t>(a)] -
                                         fit.unknowns.places_m[static_cast<size_t>(b)];
                const Vector3d n = between.normalized();
                const Matrix3d cov =
                    survey_.cov_m2.block<3, 3>(3 * a, 3 * a) + survey_.cov_m2.block<3, 3>(3 * b, 3 * b) -
                    survey_.cov_m2.block<3, 3>(3 * a, 3 * b) - survey_.cov_m2.block<3, 3>(3 * b, 3 * a);
                SurveyedDistance distance{kept[static_cast<size_t>(a)], kept[static_cast<size_t>(b)],
                                          between.norm(), std::sqrt(std::max(0.0, n.dot(cov * n)))};
                for (const PairDistance& pair : pairs)
                    if (pair.a == a && pair.b == b)
                        distance.measured_m = pair.distance_m;
                survey_.distances.push_back(distance);
            }
    }

    void keepResiduals(const RoomFit& fit) {
        std::vector<double> sizes;
        for (const auto* residuals : {&fit.between_m, &fit.walk_m})
            for (const double residual : *residuals)
                sizes.push_back(std::abs(residual));
        survey_.ranges = static_cast<int>(sizes.size());
        survey_.median_m = medianOf(sizes);
        // Echoes and astray detections are no residuals of the places.
        const double limit_m = 5 * 1.4826 * survey_.median_m;
        std::erase_if(sizes, [limit_m](double size) { return size > limit_m; });
        double squares = 0;
        for (const double size : sizes)
            squares += size * size;
        survey_.rms_m = sizes.empty() ? 0 : std::sqrt(squares / static_cast<double>(sizes.size()));
    }

    const Evidence& evidence_;
    const FitSettings& settings_;
    const JobContext& job_;
    RoomSurvey survey_;
};

}  // namespace

double RoomSurvey::worstSigma_m() const {
    double worst_m = 0;
    for (const SurveyedAnchor& anchor : anchors)
        worst_m = std::max(worst_m, anchor.left_out ? 0 : anchor.sigma_m);
    return worst_m;
}

bool canLeaveOut(const RoomSurvey& survey, size_t anchor) {
    const auto used = std::ranges::count_if(survey.anchors, &SurveyedAnchor::isUsed);
    return used - survey.anchors[anchor].isUsed() >= std::ptrdiff_t{kFewestAnchors};
}

Status leaveOut(RoomSurvey& survey, const std::vector<size_t>& anchors) {
    for (const size_t index : anchors) {
        SurveyedAnchor& anchor = survey.anchors[index];
        if (!canLeaveOut(survey, index))
            return Error{ErrorKind::kUsage,
                         "Without anchor " + anchor.id + " fewer than three anchors would have a place",
                         "Use it, or walk once more past the others"};
        anchor.left_out = true;
        std::erase_if(survey.findings, [&](const Finding& finding) { return finding.part == anchor.id; });
        std::erase_if(survey.distances, [index](const SurveyedDistance& one) {
            return one.a == static_cast<int>(index) || one.b == static_cast<int>(index);
        });
    }
    return Done{};
}

Result<RoomSurvey> surveyRoom(const Evidence& evidence, const FitSettings& settings, const JobContext& job) {
    return Survey(evidence, settings, job).run();
}

}  // namespace noctule::room_survey
