#pragma once
// Two inputs that vary together, such as thickness and speed of ice: a distribution of the first, and one of the second
// whose parameters are smooth functions of the first. And the states on the contour of a probability (IFORM, inverse
// first-order reliability method): a circle about the origin of two independent standard normal variables, mapped to
// the inputs by Rosenblatt's transform. Outside of any line that touches the circle lies the probability Φ(-radius).

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace floes {

/// a + b x^c.
struct SmoothParameter {
    double a = 0;
    double b = 0;
    double c = 1;

    bool constant() const { return b == 0; }
    double at(double x) const { return constant() ? a : a + b * std::pow(x, c); }
};

enum class InputLaw {
    normal,       ///< mean, standard deviation
    lognormal,    ///< median, standard deviation of the logarithm
    weibull,      ///< P(X > x) = exp(-(x / scale)^shape): scale, shape
    exponential,  ///< mean; the second parameter is not used
};
std::string_view name_of(InputLaw law);

struct InputDistribution {
    InputLaw law = InputLaw::normal;
    SmoothParameter first;   ///< mean, median, scale, mean
    SmoothParameter second;  ///< standard deviation, that of the logarithm, shape

    /// The parameters are in range where the other input is `given`.
    bool valid(double given) const;
    /// The value that is not exceeded with probability Φ(score).
    double value(double score, double given) const;
    /// Φ^-1 of the probability of not exceeding x; infinite where that is 0 or 1.
    double score(double x, double given) const;
    /// Probability of values above `low` and up to `high`.
    double between(double low, double high, double given) const;
};

struct JointInputs {
    InputDistribution one;    ///< parameters are constant
    InputDistribution other;  ///< given `one`

    /// Rosenblatt's transform, back from two standard normal scores.
    std::array<double, 2> at(double one_score, double other_score) const;
};

struct ContourPoint {
    double degrees = 0;             ///< of the angle: scores are radius (cos, sin)
    std::array<double, 2> value{};  ///< of the inputs
};

/// Φ^-1(1 - α), with α the probability of one state such that a year of `states` independent ones has one beyond with
/// probability `per_year`: (1 - α)^states = 1 - per_year. Zero or less where there are so few states that α is 1/2.
double contour_radius(double per_year, double states);

/// `count` points at equal angles from 0, the first with the largest value of `one`.
std::vector<ContourPoint> contour(const JointInputs& inputs, double radius, int count);

/// Hours of a class of both inputs.
struct ClassHours {
    std::array<double, 2> value{};  ///< in the middle of the class, each above 0
    double hours = 0;               ///< above 0
};

/// What the law of the first input makes of a class.
struct ClassCheck {
    double value = 0;
    double hours = 0;   ///< given
    double by_law = 0;  ///< hours
};

struct JointFit {
    JointInputs inputs;         ///< parameters are not finite where nothing could be fitted
    double ahead = 0;           ///< mean log-likelihood of an hour by the law taken for `one`, less that by the other
    bool scatter_fixed = true;  ///< the scatter of `other` has too few classes to depend on `one`
    std::vector<ClassCheck> classes;  ///< of `one`, rising

    bool valid() const;
};

/// Fewest different values of each input.
inline constexpr std::size_t fewest_classes = 3;

/// By maximum likelihood of the hours in classes, whose borders lie halfway between neighbouring values: `one` Weibull
/// or log-normal, which is likelier; `other` log-normal, its median and the standard deviation of its logarithm power
/// laws of `one`.
JointFit fit_joint_inputs(const std::vector<ClassHours>& classes);

}  // namespace floes
