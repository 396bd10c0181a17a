// SPDX-License-Identifier: Apache-2.0
#include "core/vision/marker_photographs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/calibration/source_offsets/jig_measurements.h"
#include "core/math/order_statistics.h"
#include "core/vision/photograph_set.h"

namespace noctule {
namespace {

/// Focal lengths to begin with, in widths of the picture: telephones, ordinary, wide, long.
constexpr double kFocalWidths[] = {0.8, 1.2, 0.55, 2.0};
constexpr double kGoodFit_px = 1;  ///< of the median sighting: no other beginning is tried
constexpr int kTurnRounds = 3;
// A sighting is wild beyond this, and beyond this many times the usual error.
constexpr double kWild_px = 1.5, kWildTimesUsual = 6, kWorstShare = 0.5;
constexpr int kWildRounds = 10;
// Of a whole photograph, the same.
constexpr double kBadPhotograph_px = 1, kBadTimesUsual = 3;
constexpr double kDoubtful_px = 1.5, kUseless_px = 4;  ///< of all corners' sigma
constexpr double kVague_m = 2e-3;                      ///< of a marker's usual distance, from the fit

std::string fixed(double value, int digits) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

class PhotographMeasurement {
public:
    PhotographMeasurement(const std::vector<PlacedPhotograph>& photographs, PhotographSet set,
                          const PhotographSettings& settings, const JobContext& job)
        : photographs_(photographs), set_(std::move(set)), settings_(settings), job_(job) {}

    Result<PhotographedDistances> measure() {
        if (set_.bundle.sightings.empty()) {
            find(Grade::kNotUsable, "", "no placement has markers that two photographs show",
                 "Photograph every placement at least twice, all markers in sight");
            return finished();
        }
        Bundle start = std::move(set_.bundle);
        if (const Status placed = fitFrom(start); !placed)
            return placed.error();
        if (const Status cleaned = leaveOutWild(); !cleaned)
            return cleaned.error();
        reportSightings();
        reportPhotographs();
        reportFit();
        takeDistances();
        return finished();
    }

private:
    void find(Grade grade, const std::string& part, const std::string& what, const std::string& remedy) {
        set_.findings.push_back({grade, part, asSentence(what), remedy});
    }

    PhotographedDistances finished() {
        result_.known.where = "the photographs";
        result_.known.findings = std::move(set_.findings);
        return std::move(result_);
    }

    static double usualError_px(const Bundle& bundle) {
        std::vector<double> errors_px;
        for (const Sighting& sighting : bundle.sightings)
            errors_px.push_back(sighting.used ? std::min(1e3, sightingError_px(bundle, sighting)) : 1e3);
        return medianOf(std::move(errors_px));
    }

    /// The focal length is the one thing that has to be about right at the beginning.
    Status fitFrom(const Bundle& start) {
        double best_px = INFINITY;
        for (const double widths : kFocalWidths) {
            job_.progress(0.9, "Finding where the cameras stood");
            Bundle bundle = start;
            for (size_t l = 0; l < bundle.lenses.size(); ++l)
                bundle.lenses[l].focal_px = widths * *std::ranges::max_element(set_.lens_size_px[l]);
            for (const PlacementParts& parts : set_.parts)
                setFirstPoses(bundle, parts);
            Result<BundleFit> fit = adjust(bundle, job_);
            for (int round = 0; fit && round < kTurnRounds && turnMistakenMarkers(bundle) > 0; ++round)
                fit = adjust(bundle, job_);
            if (!fit)
                return fit.error();
            if (const double error_px = usualError_px(bundle); error_px < best_px) {
                best_px = error_px;
                fit_ = *fit;
                set_.bundle = std::move(bundle);
            }
            if (best_px < kGoodFit_px)
                break;
        }
        for (const Sighting& sighting : set_.bundle.sightings)
            if (!sighting.used)
                untied_.insert(sighting.camera);
        return Done{};
    }

    /// The worst first, as it pulls others along. A marker that one photograph is left of goes too.
    Status leaveOutWild() {
        for (int round = 0; round < kWildRounds; ++round) {
            std::vector<double> errors_px;
            double worst_px = 0;
            for (const Sighting& sighting : set_.bundle.sightings)
                if (sighting.used) {
                    errors_px.push_back(sightingError_px(set_.bundle, sighting));
                    worst_px = std::max(worst_px, errors_px.back());
                }
            const double limit_px = std::max(kWild_px, kWildTimesUsual * medianOf(std::move(errors_px)));
            const bool any = worst_px > limit_px;
            for (Sighting& sighting : set_.bundle.sightings)
                if (any && sighting.used) {
                    const double error_px = sightingError_px(set_.bundle, sighting);
                    if (error_px > std::max(limit_px, kWorstShare * worst_px)) {
                        sighting.used = false;
                        wild_px_[sighting.marker].push_back({sighting.camera, error_px});
                    }
                }
            const bool fewer = leaveOutSingles();
            if (!any && !fewer)
                return Done{};
            const auto fit = adjust(set_.bundle, job_);
            if (!fit)
                return fit.error();
            fit_ = *fit;
        }
        return Done{};
    }

    bool leaveOutSingles() {
        bool any = false;
        for (Sighting& sighting : set_.bundle.sightings)
            if (sighting.used && usedSightings(sighting.marker) < 2) {
                sighting.used = false;
                any = true;
            }
        return any;
    }

    std::ptrdiff_t usedSightings(int marker) const {
        return std::ranges::count_if(set_.bundle.sightings, [&](const Sighting& sighting) {
            return sighting.used && sighting.marker == marker;
        });
    }

    const std::string& photographName(int camera) const {
        return photographs_[size_t(set_.photograph_of_camera[size_t(camera)])].photograph.name;
    }

    void reportSightings() {
        for (const auto& [marker, wild] : wild_px_) {
            std::vector<std::string> where;
            for (const auto& [camera, error_px] : wild)
                where.push_back(photographName(camera) + " (" + fixed(error_px, 1) + " px)");
            const PlannedMarker& planned = set_.plan[size_t(set_.marker_in_plan[size_t(marker)])];
            find(Grade::kUsable, planned.id,
                 planned.name + ": its marker " + std::to_string(planned.number) +
                     " does not lie where the others say in " + inWords(where) +
                     (usedSightings(marker) > 0
                          ? ""
                          : ", and is not used in placement " + set_.placementOfMarker(marker)),
                 "See that it is flat, of the same size as the others and does not move between photographs");
        }
    }

    void reportPhotographs() {
        std::vector<double> errors_px;
        for (size_t c = 0; c < set_.bundle.cameras.size(); ++c) {
            PhotographUse use{photographName(int(c)),
                              photographs_[size_t(set_.photograph_of_camera[c])].placement, 0, 0};
            double sum_px2 = 0;
            for (const Sighting& sighting : set_.bundle.sightings)
                if (sighting.used && sighting.camera == int(c)) {
                    sum_px2 += std::pow(sightingError_px(set_.bundle, sighting), 2);
                    ++use.markers;
                }
            use.error_px = use.markers > 0 ? std::sqrt(sum_px2 / use.markers) : 0;
            if (use.markers > 0)
                errors_px.push_back(use.error_px);
            result_.photographs.push_back(use);
        }
        const double usual_px = medianOf(std::move(errors_px));
        for (size_t c = 0; c < result_.photographs.size(); ++c) {
            const PhotographUse& use = result_.photographs[c];
            const size_t seen = photographs_[size_t(set_.photograph_of_camera[c])].photograph.markers.size();
            if (use.markers == 0 && seen > 0)
                find(Grade::kUsable, "",
                     use.name +
                         (untied_.contains(int(c)) ? " shows no marker that ties it to the others"
                                                   : " does not fit the others") +
                         " and is not used",
                     "Take photographs that overlap, with nothing moved in between");
            else if (use.error_px > std::max(kBadPhotograph_px, kBadTimesUsual * usual_px))
                find(Grade::kUsable, "",
                     use.name + " fits badly: " + fixed(use.error_px, 1) + " px, others " +
                         fixed(usual_px, 1) + " px",
                     "Take it again sharp, with the same camera and no zoom");
        }
    }

    void reportFit() {
        result_.corner_sigma_px = fit_.sigma_px;
        for (size_t l = 0; l < set_.bundle.lenses.size(); ++l) {
            const Lens& lens = set_.bundle.lenses[l];
            result_.lenses.push_back({set_.lens_size_px[l][0], set_.lens_size_px[l][1], lens.focal_px,
                                      lens.k1, lens.k2, lens.edge_px});
        }
        if (fit_.sigma_px > kDoubtful_px)
            find(fit_.sigma_px > kUseless_px ? Grade::kNotUsable : Grade::kUsable, "",
                 "The photographs do not fit together: " + fixed(fit_.sigma_px, 1) +
                     " px per corner, 0.3 px is usual",
                 "Take them sharp, with one camera and without zoom, markers flat and all of one size, "
                 "nothing moved between those of one placement");
    }

    void takeDistances() {
        const BundleCovariance covariance(set_.bundle, fit_.sigma_px);
        std::map<int, std::vector<double>> sigmas_m;  // of each marker
        for (const PlacementParts& parts : set_.parts)
            for (const int source : parts.markers)
                for (const int board : parts.markers)
                    if (isUsed(source, PlannedMarker::Kind::kSource) &&
                        isUsed(board, PlannedMarker::Kind::kBoard)) {
                        const double sigma_m = covariance.distanceSigma_m(source, board);
                        addDistance(source, board, sigma_m);
                        sigmas_m[source].push_back(sigma_m);
                        sigmas_m[board].push_back(sigma_m);
                    }
        for (const auto& [marker, of_marker] : sigmas_m)
            if (const double usual_m = medianOf(of_marker); usual_m > kVague_m)
                find(Grade::kUsable, set_.plan[size_t(set_.marker_in_plan[size_t(marker)])].id,
                     set_.markerName(marker) + ": its distances in placement " +
                         set_.placementOfMarker(marker) + " are known to " + fixed(1e3 * usual_m, 1) +
                         " mm only",
                     "Add photographs of it from other sides and nearer");
        if (result_.known.distances.empty())
            find(Grade::kNotUsable, "", "no source and board can be measured together",
                 "Add photographs that show sources and boards at the same time");
    }

    bool isUsed(int marker, PlannedMarker::Kind kind) const {
        return set_.plan[size_t(set_.marker_in_plan[size_t(marker)])].kind == kind &&
               usedSightings(marker) > 0;
    }

    void addDistance(int source, int board, double fit_sigma_m) {
        const double distance_m = (set_.bundle.markers[size_t(source)].p_jig_marker_m -
                                   set_.bundle.markers[size_t(board)].p_jig_marker_m)
                                      .norm();
        const double sticking_m = std::sqrt(2.0) * settings_.sticking_sigma_m,
                     side_m = settings_.side_sigma * distance_m;
        result_.known.distances.push_back({set_.placementOfMarker(source),
                                           set_.plan[size_t(set_.marker_in_plan[size_t(source)])].id,
                                           set_.plan[size_t(set_.marker_in_plan[size_t(board)])].id,
                                           distance_m, std::hypot(fit_sigma_m, sticking_m, side_m)});
        result_.fit_sigma_m.push_back(fit_sigma_m);
    }

    const std::vector<PlacedPhotograph>& photographs_;
    PhotographSet set_;
    PhotographSettings settings_;
    JobContext job_;
    BundleFit fit_;
    std::set<int> untied_;                                        ///< cameras
    std::map<int, std::vector<std::pair<int, double>>> wild_px_;  ///< of each marker: camera, error
    PhotographedDistances result_;
};

}  // namespace

Result<PhotographedDistances> measurePhotographs(const std::vector<PlacedPhotograph>& photographs,
                                                 const Suit& suit, const PhotographSettings& settings,
                                                 const JobContext& job) {
    auto plan = planMarkers(suit);
    if (!plan)
        return plan.error();
    return PhotographMeasurement(photographs, sortPhotographs(photographs, std::move(*plan), settings.side_m),
                                 settings, job)
        .measure();
}

}  // namespace noctule
