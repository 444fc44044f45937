#pragma once
// Gaussian processes drawn at random points: statistics whose emulator is known to be right.

#include <Eigen/Dense>
#include <cmath>

#include "inference/emulator.hpp"
#include "known_processes.hpp"

namespace floes::toy {

/// Matern's correlation, ν = 5/2, of two points.
inline double correlation(const Eigen::VectorXd& a, const Eigen::VectorXd& b, const Eigen::VectorXd& lengths) {
    const double r = std::sqrt(5.0) * ((a - b).array() / lengths.array()).matrix().norm();
    return (1 + r + r * r / 3) * std::exp(-r);
}

inline Eigen::MatrixXd uniform_points(Eigen::Index count, Eigen::Index axes, RandomStream& random) {
    Eigen::MatrixXd points(count, axes);
    for (Eigen::Index row = 0; row < count; ++row)
        for (Eigen::Index axis = 0; axis < axes; ++axis) points(row, axis) = random.uniform(-1, 1);
    return points;
}

inline Eigen::VectorXd normals(Eigen::Index count, RandomStream& random) {
    Eigen::VectorXd drawn(count);
    for (double& x : drawn) x = known::normal(random);
    return drawn;
}

/// A plane with a process of variance 1 round it.
inline Eigen::VectorXd process(const Eigen::MatrixXd& points, const Eigen::VectorXd& lengths, RandomStream& random) {
    Eigen::MatrixXd covariance(points.rows(), points.rows());
    for (Eigen::Index a = 0; a < points.rows(); ++a)
        for (Eigen::Index b = 0; b < points.rows(); ++b)
            covariance(a, b) = correlation(points.row(a), points.row(b), lengths) + (a == b ? 1e-10 : 0);
    const Eigen::VectorXd slopes = normals(points.cols(), random);
    return 5 + (points * slopes + covariance.llt().matrixL() * normals(points.rows(), random)).array();
}

struct Toy {
    EmulatorData data;
    Eigen::MatrixXd further;  ///< points that are not simulated
    Eigen::VectorXd truth;    ///< there
};

/// Noise of each point between a half and twice `noise`, as variances.
inline Toy draw(Eigen::Index count, Eigen::Index further, const Eigen::VectorXd& lengths, double noise,
                RandomStream& random) {
    const Eigen::MatrixXd points = uniform_points(count + further, lengths.size(), random);
    const Eigen::VectorXd truth = process(points, lengths, random);
    Toy toy{{points.topRows(count), truth.head(count), Eigen::VectorXd(count)},
            points.bottomRows(further),
            truth.tail(further)};
    for (double& variance : toy.data.noise) variance = noise * std::exp2(random.uniform(-1, 1));
    toy.data.values += (toy.data.noise.array().sqrt() * normals(count, random).array()).matrix();
    return toy;
}

/// One that is always the same, with 20 further points.
inline Toy drawn(Eigen::Index count, const Eigen::VectorXd& lengths, double noise) {
    RandomStream random(3, 0, StreamId::bootstrap, 18);
    return draw(count, 20, lengths, noise, random);
}

/// Data of a single axis.
inline EmulatorData on_line(const Eigen::VectorXd& at, const Eigen::VectorXd& values, const Eigen::VectorXd& noise) {
    return {at, values, noise};
}

}  // namespace floes::toy
