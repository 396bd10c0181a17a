// SPDX-License-Identifier: Apache-2.0
#include "core/vision/photograph_set.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/calibration/source_offsets/jig_measurements.h"

namespace noctule {
namespace {

// Of a camera that nothing is known of: its middle within a hundredth of the picture's width, little
// distortion, as cameras of today correct it themselves.
constexpr double kFocalLogSigma = 1, kMiddleSigmaWidths = 0.01, kDistortionSigma = 0.2, kEdgeSigma_px = 0.3;

LensBelief usualLens(int width_px, int height_px) {
    LensBelief belief;
    belief.lens.focal_px = width_px;
    belief.lens.center_px = {(width_px - 1) / 2.0, (height_px - 1) / 2.0};
    const double middle_px = kMiddleSigmaWidths * std::max(width_px, height_px);
    belief.sigma << kFocalLogSigma, middle_px, middle_px, kDistortionSigma, kDistortionSigma, kEdgeSigma_px;
    return belief;
}

/// A marker of the plan in a placement: where it is seen, and how often in each photograph.
struct Appearance {
    std::map<int, std::vector<const SeenMarker*>> in_photograph;

    /// The photograph that shows it twice; -1: none.
    int twiceIn() const {
        for (const auto& [photograph, seen] : in_photograph)
            if (seen.size() > 1)
                return photograph;
        return -1;
    }
};

class PhotographSorter {
public:
    PhotographSorter(const std::vector<PlacedPhotograph>& photographs, std::vector<PlannedMarker> plan,
                     double side_m)
        : photographs_(photographs) {
        set_.plan = std::move(plan);
        set_.bundle.side_m = side_m;
    }

    PhotographSet sort() {
        sortIntoPlacements();
        for (size_t p = 0; p < set_.placements.size(); ++p)
            addPlacement(p);
        reportMarkers();
        return std::move(set_);
    }

private:
    void find(Grade grade, const std::string& part, const std::string& what, const std::string& remedy) {
        set_.findings.push_back({grade, part, asSentence(what), remedy});
    }

    void sortIntoPlacements() {
        std::map<std::string, std::vector<int>> of_label;
        std::vector<std::string> labels;
        for (size_t i = 0; i < photographs_.size(); ++i) {
            auto& of_this = of_label[photographs_[i].placement];
            if (of_this.empty())
                labels.push_back(photographs_[i].placement);
            of_this.push_back(static_cast<int>(i));
            if (photographs_[i].photograph.markers.empty())
                find(Grade::kUsable, "", "no marker is found in " + photographs_[i].photograph.name,
                     "Take it again nearer, in better light and sharp");
        }
        for (const std::string& label : labels)
            if (of_label[label].size() >= 2) {
                set_.placements.push_back(label);
                of_placement_.push_back(of_label[label]);
            } else {
                find(Grade::kUsable, "",
                     "placement " + label + " has only one photograph, " +
                         photographs_[size_t(of_label[label].front())].photograph.name,
                     "Take another one from another side while nothing has moved");
            }
    }

    void addPlacement(size_t placement) {
        std::map<int, Appearance> of_number;
        set_.parts.emplace_back();
        for (const int photograph : of_placement_[placement]) {
            for (const SeenMarker& seen : photographs_[size_t(photograph)].photograph.markers)
                of_number[seen.number].in_photograph[photograph].push_back(&seen);
            addCamera(photograph);
        }
        for (size_t m = 0; m < set_.plan.size(); ++m)
            addMarker(placement, static_cast<int>(m), of_number[set_.plan[m].number]);
        for (const auto& [number, appearance] : of_number)
            if (appearance.in_photograph.size() >= 2 &&
                std::ranges::count(set_.plan, number, &PlannedMarker::number) == 0)
                strangers_.insert(number);
    }

    void addCamera(int photograph) {
        const Photograph& picture = photographs_[size_t(photograph)].photograph;
        CameraPose camera;
        const std::array size{picture.width_px, picture.height_px};
        const auto known = std::ranges::find(set_.lens_size_px, size);
        camera.lens = static_cast<int>(known - set_.lens_size_px.begin());
        if (known == set_.lens_size_px.end()) {
            set_.lens_size_px.push_back(size);
            set_.bundle.beliefs.push_back(usualLens(size[0], size[1]));
            set_.bundle.lenses.push_back(set_.bundle.beliefs.back().lens);
        }
        camera_of_photograph_[photograph] = static_cast<int>(set_.bundle.cameras.size());
        set_.parts.back().cameras.push_back(camera_of_photograph_[photograph]);
        set_.photograph_of_camera.push_back(photograph);
        set_.bundle.cameras.push_back(camera);
    }

    void addMarker(size_t placement, int in_plan, const Appearance& appearance) {
        const PlannedMarker& planned = set_.plan[size_t(in_plan)];
        const std::string& label = set_.placements[placement];
        if (const int twice = appearance.twiceIn(); twice >= 0)
            return find(Grade::kUsable, planned.id,
                        planned.name + ": its marker " + std::to_string(planned.number) +
                            " is seen twice in " + photographs_[size_t(twice)].photograph.name +
                            " and is not used in placement " + label,
                        "Take the wrong one off the jig and photograph the placement again");
        if (appearance.in_photograph.empty()) {
            never_in_[in_plan].push_back(label);
            return;
        }
        if (appearance.in_photograph.size() == 1) {
            once_in_[in_plan].push_back(label);
            return;
        }
        const int marker = static_cast<int>(set_.bundle.markers.size());
        set_.bundle.markers.emplace_back();
        set_.marker_placement.push_back(static_cast<int>(placement));
        set_.marker_in_plan.push_back(in_plan);
        set_.parts[placement].markers.push_back(marker);
        for (const auto& [photograph, seen] : appearance.in_photograph)
            set_.bundle.sightings.push_back(
                {camera_of_photograph_[photograph], marker, seen.front()->corners_px, true});
    }

    void reportMarkers() {
        for (const auto& [in_plan, labels] : never_in_)
            reportMissing(in_plan, labels, "in no photograph");
        for (const auto& [in_plan, labels] : once_in_)
            reportMissing(in_plan, labels, "in one photograph only");
        for (const int number : strangers_)
            find(Grade::kUsable, "",
                 "marker " + std::to_string(number) +
                     " stands in the photographs and belongs to no part of the suit",
                 "Take it off the jig, or stick the sheet of this suit on");
    }

    void reportMissing(int in_plan, const std::vector<std::string>& labels, const std::string& how) {
        const PlannedMarker& planned = set_.plan[size_t(in_plan)];
        if (planned.kind == PlannedMarker::Kind::kOrigin)
            return;  // helps, but need not be there
        find(Grade::kUsable, planned.id,
             planned.name + ": its marker " + std::to_string(planned.number) + " is " + how +
                 " of placement" + (labels.size() > 1 ? "s " : " ") + inWords(labels),
             "Photograph it whole and sharp, from at least two sides");
    }

    const std::vector<PlacedPhotograph>& photographs_;
    PhotographSet set_;
    std::vector<std::vector<int>> of_placement_;
    std::map<int, int> camera_of_photograph_;
    std::map<int, std::vector<std::string>> never_in_, once_in_;  ///< placements, by index in the plan
    std::set<int> strangers_;
};

}  // namespace

PhotographSet sortPhotographs(const std::vector<PlacedPhotograph>& photographs,
                              std::vector<PlannedMarker> plan, double side_m) {
    return PhotographSorter(photographs, std::move(plan), side_m).sort();
}

std::string inWords(const std::vector<std::string>& words) {
    std::string text;
    for (size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
    return text;
}

}  // namespace noctule
