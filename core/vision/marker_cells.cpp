// SPDX-License-Identifier: Apache-2.0
#include "core/vision/marker_cells.h"

#include <opencv2/aruco.hpp>

#include "core/job/contract.h"

namespace noctule {

MarkerCells markerCells(int number) {
    require(number >= 0 && number < kMarkerNumbers, "markerCells: no such marker");
    cv::Mat picture;  // one pixel a cell
    cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50)->drawMarker(number, kMarkerCells, picture, 1);
    MarkerCells cells;
    for (int row = 0; row < kMarkerCells; ++row)
        for (int column = 0; column < kMarkerCells; ++column)
            cells[size_t(row)][size_t(column)] = picture.at<uchar>(row, column) > 127;
    return cells;
}

}  // namespace noctule
