// SPDX-License-Identifier: Apache-2.0
// The parts of the report, each a complete <section>. One file per part or two.
#pragma once

#include <string>

#include "core/report/report_data.h"
#include "core/report/svg_plot.h"

namespace noctule {

std::string summarySection(const ReportData& data);
std::string runsSection(const ReportData& data);        ///< the paper's table 1, error over time (figure 7)
std::string jointsSection(const ReportData& data);      ///< every joint, angle curves (figure 6)
std::string rootSection(const ReportData& data);        ///< drift of the root
std::string confidenceSection(const ReportData& data);  ///< heat map and curves (figure 5)
std::string rangesSection(const ReportData& data);      ///< used, rejected, gaps
std::string inertiaSection(const ReportData& data);     ///< lost, clipped, present
std::string observabilitySection(const ReportData& data);  ///< what each joint rested on
std::string provenanceSection(const ReportData& data);     ///< settings, calibration, versions, definitions

/// "source 8 (hat)".
std::string sourceLabel(const ReportData& data, int source);
/// "left shin (board 14)", after the segment when it is canonical, else its id.
std::string boardLabel(const ReportData& data, int board);
/// "Source 1 (belly), heard by left foot (board 15)".
std::string pairLabel(const ReportData& data, const ReportPair& pair);
/// "A+G+D" of "AGD".
std::string sensorsLabel(const std::string& sensors);
/// For readers who know neither letters nor names of settings.
std::string sensorsInWords(const std::string& sensors);
/// As the studio's choice of filters names them.
std::string estimatorInWords(const std::string& estimator);
/// What the technical words mean.
std::string definitionsOfWords();
/// First to last second of the take, for all plots of one report.
Interval takeInterval(const ReportData& data);

}  // namespace noctule
