#pragma once
// The units in which a campaign is shown to people. Values are kept in SI everywhere; a campaign has one Units, and
// every table, axis, sentence and picture of it takes its units from there. Programs get SI.

#include <string>
#include <string_view>

namespace floes {

/// So many significant digits, and all digits before the point: "1230", not "1.23e+03".
std::string significant(double value, int digits);

class Units {
  public:
    /// How values of an SI unit are shown: "kN", 1e-3.
    struct Shown {
        std::string name;   ///< empty: none
        double factor = 1;  ///< shown value / stored value
    };

    /// SI, and shares in percent.
    Units() = default;
    /// Loads, moments, stiffnesses, energies and pressures with the prefix that suits a load of `largest` N: none below
    /// 10 kN, k below 10 MN, M above.
    explicit Units(double largest);

    /// `si`: "N", "N m", "N m-1", "N s-1", "J" and "Pa" get the prefix; "share" is shown in percent, "1" without a
    /// unit, and any other unit as it is.
    Shown of(std::string_view si) const;

    /// A value and its unit in a sentence, with `digits` significant digits: "12.3 kN".
    std::string text(double value, std::string_view si, int digits = 3) const;

    /// The same without its unit.
    std::string number(double value, std::string_view si, int digits = 3) const;

    /// "mean load, kN"; without a unit the words alone.
    std::string heading(std::string_view words, std::string_view si) const;

  private:
    std::string_view prefix_ = "";
    double factor_ = 1;
};

}  // namespace floes
