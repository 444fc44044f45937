#pragma once
// Files that other programs read a load from. A format is written as its program's own reader was found to read it, or
// it is not written; docs/coupling.md names what was read.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/units.hpp"
#include "load_files/load_series.hpp"

namespace floes {

/// Where a load comes from, for the legend of a file.
struct LoadOrigin {
    std::string program;  ///< "floes 2.1.0"
    std::string campaign;
    std::string fingerprint;  ///< of the campaign
    std::string case_name;
    int arrangement = 0;
    int member = 0;
    std::string chosen = {};  ///< a sentence on why this member; empty: it was named
    std::string hull_went = "was towed straight on and did not give way";
    int averaged_steps = 1;        ///< time steps of the run in each stored value
    double mean_roll = undefined;  ///< N m, means in the window about the hull's own X, Y and Z
    double mean_pitch = undefined;
    double mean_yaw = undefined;
};

/// A series as it is to be written.
struct LoadToWrite {
    LoadSeries series;
    LoadOrigin origin;
    bool tilts = false;  ///< its axes pitch and roll with the hull: its file has no histories of these
    LoadAxes axes = LoadAxes::earth;
    double tow_towards = 0;  ///< degrees from X towards Y
    double begin = 0;        ///< s of the run, scaled: t = 0 of the series
    double scale = 1;        ///< lengths over those of the campaign
};

struct WrittenLoad {
    std::string path;
    std::string text;
    std::vector<std::string> completed = {};  ///< its reader completes the file: one that has all this is left as it is
};

struct LoadFormat {
    std::string_view word;                      ///< of --for
    std::string_view words;                     ///< what it is
    std::span<const std::string_view> endings;  ///< of a file's name
    bool turns = true;                          ///< it has loads in the hull's axes too
    std::vector<WrittenLoad> (*write)(const LoadToWrite& load, const std::string& path);  ///< throws InputError
};

/// All that are written.
std::span<const LoadFormat> load_formats();

// For this module only.

/// What each file says before its values, in lines. `held`: its reader interpolates between values and holds the ends;
/// `force`, `moment`: units.
std::vector<std::string> legend(const LoadToWrite& load, bool held, std::string_view force, std::string_view moment);

/// Those lines, each behind "# ".
std::string commented(const std::vector<std::string>& lines);

std::vector<WrittenLoad> csv_files(const LoadToWrite& load, const std::string& path);
/// OpenFAST 5.0 and later; 3.1 to 4.2.
std::vector<WrittenLoad> openfast_files(const LoadToWrite& load, const std::string& path);
std::vector<WrittenLoad> openfast_4_files(const LoadToWrite& load, const std::string& path);
std::vector<WrittenLoad> subdyn_files(const LoadToWrite& load, const std::string& path);
std::vector<WrittenLoad> orcaflex_files(const LoadToWrite& load, const std::string& path);

}  // namespace floes
