// SPDX-License-Identifier: Apache-2.0
// The words of the field that a report uses, for readers who meet them there for the first time.
#include <map>

#include "core/report/html.h"
#include "core/report/sections.h"

namespace noctule {

std::string sensorsLabel(const std::string& sensors) {
    std::string label;
    for (const char sensor : sensors)
        label += (label.empty() ? "" : "+") + std::string(1, sensor);
    return label.empty() ? "none" : label;
}

std::string sensorsInWords(const std::string& sensors) {
    static const std::map<std::string, std::string> kWords{
        {"AGD", "accelerometers, gyroscopes and distances"},
        {"AG", "accelerometers and gyroscopes"},
        {"AD", "accelerometers and distances"},
        {"GD", "gyroscopes and distances"},
        {"A", "accelerometers alone"},
        {"G", "gyroscopes alone"},
        {"D", "distances alone"}};
    const auto found = kWords.find(sensors);
    return found == kWords.end() ? sensorsLabel(sensors) : found->second;
}

std::string estimatorInWords(const std::string& estimator) {
    return estimator == "manifold" ? "Noctule" : estimator == "paper" ? "Vlasic 2007" : estimator;
}

std::string definitionsOfWords() {
    return html::definitions(
        {{"Board", "Sensor unit on a limb, with accelerometer, gyroscope and microphone"},
         {"Source", "Small ultrasonic loudspeaker on the body that sends short pulses"},
         {"Range", "Distance from a source to a board, found from the time that a pulse takes"},
         {"Residual", "By how much a measured distance differs from that in the estimated pose"},
         {"Inertial readings", "Acceleration and rate of turning, as the boards measure them"},
         {"Sensors A, G and D", "Accelerometers, gyroscopes and distances; A+G+D means all three"},
         {"Result", "What one processing of the take with its own settings has made"},
         {"Estimator",
          "The method that makes poses of readings and ranges: Noctule (manifold) is this "
          "program's own, Vlasic 2007 (paper) is that of a publication"},
         {"Extended Kalman filter",
          "Method that predicts the pose and corrects it with each "
          "measurement, weighted by how uncertain both are"},
         {"Smoothing",
          "Whether a pose also uses later readings: none, lag (half a second), full (the "
          "whole take) or batch (the whole take, solved anew)"},
         {"Root",
          "The pelvis, which carries the body: free is estimated, given is measured by another "
          "system"},
         {"Reference", "The same motion as another system or a simulation knows it"},
         {"Joint error", "Angle between the estimated and the reference orientation of a joint"},
         {"Drift", "Error that grows with time"},
         {"Confidence", "How far a range is trusted, from 0 to 1"},
         {"Observable", "Determined by measurements and not by the model of the body alone"},
         {"Median", "Half of the values lie below it"},
         {"Standard deviation (SD)", "How far values usually lie from their mean"},
         {"Root mean square (RMS)", "Usual size of an error, large ones counting more"},
         {"NEES", "Squared errors over what the filter expects of them: 1 is honest, more is too sure"},
         {"Cardan angles", "Three turns about axes, one after the other, that make up a rotation"},
         {"ISB", "International Society of Biomechanics, which names the angles of joints"}});
}

}  // namespace noctule
