#pragma once
// Strength and stiffness of sea ice from its salinity and temperature, by way of the share of brine in it.

namespace floes {

/// Volume of brine over that of the ice: S (49.185 / |T| + 0.532), S in parts, T in °C from -0.5 to -22.9. Frankenstein
/// and Garner, "Equations for determining the brine volume of sea ice from -0.5° to -22.9°C", J. Glaciology 6(48),
/// 1967.
double brine_volume(double salinity, double temperature);

/// Flexural strength, Pa: 1.76 MPa exp(-5.88 √ν_b). Timco and O'Brien, "Flexural strength equation for sea ice", Cold
/// Regions Science and Technology 22(3), 1994.
double flexural_strength(double brine);

/// Elastic modulus, Pa: 10 GPa - 35.1 GPa ν_b, which is 0 at 0.285. From memory, of Langleben
/// and Pounder (1963): of sound and small quick loads; ice that is loaded for seconds yields more.
double brine_modulus(double brine);

}  // namespace floes
