// SPDX-License-Identifier: Apache-2.0
#include "core/math/rotation_fit.h"

#include <Eigen/SVD>

namespace noctule {
namespace {

struct Centred {
    explicit Centred(const Eigen::Matrix3Xd& points)
        : middle(points.rowwise().mean()), about(points.colwise() - middle) {}
    Vector3d middle;
    Eigen::Matrix3Xd about;
};

Eigen::Affine3d placement(const Centred& from, const Centred& to, const Matrix3d& turn) {
    Eigen::Affine3d T = Eigen::Affine3d::Identity();
    T.linear() = turn;
    T.translation() = to.middle - turn * from.middle;
    return T;
}

}  // namespace

Matrix3d nearestRotation(const Matrix3d& M) {
    const Eigen::JacobiSVD<Matrix3d> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Matrix3d U = svd.matrixU();
    if (Matrix3d(U * svd.matrixV().transpose()).determinant() < 0)
        U.col(2) *= -1;
    return U * svd.matrixV().transpose();
}

Eigen::Isometry3d rigidFit(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to) {
    const Centred a(from), b(to);
    return Eigen::Isometry3d(placement(a, b, nearestRotation(b.about * a.about.transpose())).matrix());
}

Eigen::Affine3d similarityFit(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to) {
    const Centred a(from), b(to);
    const Matrix3d product = b.about * a.about.transpose(), R = nearestRotation(product);
    const double scale = R.cwiseProduct(product).sum() / a.about.squaredNorm();
    return placement(a, b, scale * R);
}

}  // namespace noctule
