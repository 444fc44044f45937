// What most files of floes include from the standard library, fmt and Eigen, read once for all modules: parsing them
// again in every file was half of the build. Files name their own includes all the same (the preset `cluster` is built
// without this), and nothing of floes belongs here, or a change of it would build everything anew.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <ranges>
#include <set>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
