// Files as Capytaine's xarray writes them, in both containers and both orders of their dimensions, and what is wrong in
// them.

#include "hydro/radiation.hpp"

#include <gtest/gtest.h>
#include <netcdf.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "support/file_bytes.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace capytaine_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

struct Written {
    int container = NC_64BIT_OFFSET;
    bool influenced_first = false;  // from Capytaine 3.0 on
    std::vector<std::string> motions{"Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw"};
    std::vector<double> omega{nan, 0.5, 1};  // the first row is none
    const char* along = "omega";
    double speed = 0;
    std::size_t speeds = 1;
    double heave_damping = 0.5;
    bool has_added_mass = true;
    bool has_centre = false;
    std::string unit{};                        // of omega
    std::optional<std::size_t> all_rows_as{};  // all rows have the values of this one
};

void expect(int status) {
    ASSERT_EQ(status, NC_NOERR) << nc_strerror(status);
}

/// A matrix element: influenced, then radiating.
double element(std::size_t row, std::size_t i, std::size_t j) {
    return static_cast<double>(1000 * row + 10 * i + j);  // halves that differ by less than programs do
}

class File {
  public:
    explicit File(const Written& what) : what_(what) {
        expect(nc_create(path_.c_str(), what.container | NC_CLOBBER, &id_));
        expect(nc_def_dim(id_, what.along, what.omega.size(), &rows_));
        expect(nc_def_dim(id_, "radiating_dof", what.motions.size(), &radiating_));
        expect(nc_def_dim(id_, "influenced_dof", what.motions.size(), &influenced_));
        expect(nc_def_dim(id_, "string20", 20, &letters_));
        if (what.speeds > 1) expect(nc_def_dim(id_, "forward_speed", what.speeds, &speeds_));
        const bool strings = what.container == NC_NETCDF4;
        const int names = strings ? 1 : 2;
        const std::array<int, 2> radiating{radiating_, letters_};
        const std::array<int, 2> influenced{influenced_, letters_};
        const int type = strings ? NC_STRING : NC_CHAR;
        const int radiating_names = define("radiating_dof", type, {radiating.begin(), radiating.begin() + names});
        const int influenced_names = define("influenced_dof", type, {influenced.begin(), influenced.begin() + names});
        const int omega = define("omega", NC_DOUBLE, {rows_});
        if (!what.unit.empty()) expect(nc_put_att_text(id_, omega, "units", what.unit.size(), what.unit.data()));
        const int added = what.has_added_mass ? define("added_mass", NC_DOUBLE, axes()) : -1;
        const int damping = define("radiation_damping", NC_DOUBLE, axes());
        const int stiffness = define("hydrostatic_stiffness", NC_DOUBLE, {influenced_, radiating_});
        const int density = define("rho", NC_DOUBLE, {});
        const int gravity = define("g", NC_DOUBLE, {});
        const int depth = define("water_depth", NC_DOUBLE, {});
        const int speed =
            define("forward_speed", NC_DOUBLE, what.speeds > 1 ? std::vector<int>{speeds_} : std::vector<int>{});
        int centre = -1;
        if (what.has_centre) {
            int three = 0;
            expect(nc_def_dim(id_, "xyz", 3, &three));
            centre = define("rotation_center", NC_DOUBLE, {three});
        }
        expect(nc_enddef(id_));
        write_names(radiating_names);
        write_names(influenced_names);
        put(omega, what.omega);
        if (what.has_added_mass) put(added, matrices(1));
        put(damping, matrices(what.heave_damping));
        std::vector<double> springs(what.motions.size() * what.motions.size(), 0.0);
        if (what.motions.size() == 6) springs[14] = 1000 * 9.81 * 25;
        put(stiffness, springs);
        put(density, {1000});
        put(gravity, {9.81});
        put(depth, {infinite});
        put(speed, std::vector<double>(what.speeds, what.speed));
        if (what.has_centre) put(centre, {0, 0, -2});
        expect(nc_close(id_));
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    std::string bytes() const { return file_text(path_); }

  private:
    std::vector<int> axes() const {
        return what_.influenced_first ? std::vector<int>{rows_, influenced_, radiating_}
                                      : std::vector<int>{rows_, radiating_, influenced_};
    }

    int define(const char* name, int type, const std::vector<int>& dimensions) const {
        int variable = -1;
        expect(nc_def_var(id_, name, type, static_cast<int>(dimensions.size()), dimensions.data(), &variable));
        return variable;
    }

    void put(int variable, const std::vector<double>& numbers) const {
        expect(nc_put_var_double(id_, variable, numbers.data()));
    }

    void write_names(int variable) const {
        if (what_.container == NC_NETCDF4) {
            std::vector<const char*> texts;
            for (const std::string& motion : what_.motions) texts.push_back(motion.c_str());
            expect(nc_put_var_string(id_, variable, texts.data()));
            return;
        }
        std::string padded;
        for (const std::string& motion : what_.motions) padded += motion + std::string(20 - motion.size(), '\0');
        expect(nc_put_var_text(id_, variable, padded.data()));
    }

    std::vector<double> matrices(double factor) const {
        std::vector<double> found;
        for (std::size_t row = 0; row < what_.omega.size(); ++row) {
            const std::size_t at = what_.all_rows_as.value_or(row);
            for (std::size_t a = 0; a < what_.motions.size(); ++a)
                for (std::size_t b = 0; b < what_.motions.size(); ++b)
                    found.push_back(std::isnan(what_.omega[row])
                                        ? nan
                                        : factor * (what_.influenced_first ? element(at, a, b) : element(at, b, a)));
        }
        return found;
    }

    TemporaryFolder folder_;
    std::string path_ = folder_ / "capytaine.nc";
    Written what_;
    int id_ = 0;
    int rows_ = 0;
    int radiating_ = 0;
    int influenced_ = 0;
    int letters_ = 0;
    int speeds_ = 0;
};

std::string message(const std::string& bytes) {
    return refusal_or("read", [&] { read_radiation(bytes, "hull.nc", {}); });
}

std::string refusal(const Written& what) {
    return message(File(what).bytes());
}

TEST(Capytaine, IsReadByNamesInEitherContainerAndOrder) {
    for (const int container : {NC_64BIT_OFFSET, NC_NETCDF4}) {
        for (const bool influenced_first : {false, true}) {
            const File file({.container = container, .influenced_first = influenced_first});
            const RadiationFile found = read_radiation(file.bytes(), "hull.nc", {});
            ASSERT_EQ(found.points.size(), 2) << "the row without numbers is left out";
            EXPECT_EQ(found.points[0].frequency, 0.5);
            EXPECT_EQ(found.points[0].added(4, 0), element(1, 4, 0)) << "force in pitch by a motion in surge";
            EXPECT_EQ(found.points[1].damping(2, 3), 0.5 * element(2, 2, 3));
            ASSERT_TRUE(found.water);
            EXPECT_EQ(found.water->density, 1000);
            EXPECT_EQ(found.water->depth, infinite);
            EXPECT_NEAR(found.water->waterplane, 25, 1e-12);
            EXPECT_FALSE(found.reference);
            ASSERT_EQ(found.remarks.size(), 1);
            EXPECT_NE(found.remarks[0].find("1 of its 3 frequencies have numbers that are none"), std::string::npos);
        }
    }
}

TEST(Capytaine, KnowsItsLimitsItsBodyAndItsReference) {
    const RadiationFile limits = read_radiation(
        File({.motions = {"buoy__Surge", "buoy__Heave"}, .omega = {0, 0.5, infinite}, .has_centre = true}).bytes(),
        "hull.nc", {});
    ASSERT_EQ(limits.points.size(), 1);
    EXPECT_EQ(limits.points[0].added(2, 0), element(1, 1, 0));
    ASSERT_TRUE(limits.at_zero && limits.at_infinity);
    EXPECT_EQ((*limits.at_infinity)(2, 2), element(2, 1, 1));
    EXPECT_EQ(limits.reference, Vec3(0, 0, -2));
    ASSERT_EQ(limits.remarks.size(), 1);
    EXPECT_EQ(limits.remarks[0], "hull.nc: has nothing about sway, roll, pitch, yaw, which is taken as 0");
}

TEST(Capytaine, SaysWhatIsWrong) {
    const std::string form =
        "; Capytaine's files have added_mass and radiation_damping over radiating_dof, influenced_dof and a frequency";
    EXPECT_EQ(refusal({.motions = {"a__Heave", "b__Surge"}}),
              "hull.nc: is of the bodies a, b, and a file of one body is read" + form);
    EXPECT_EQ(refusal({.motions = {"Heave", "bulge"}}),
              "hull.nc: has a motion \"bulge\", and surge, sway, heave, roll, pitch and yaw are read" + form);
    EXPECT_EQ(refusal({.motions = {"Heave", "heave"}}), "hull.nc: has heave twice" + form);
    EXPECT_EQ(refusal({.speed = 2}),
              "hull.nc: is of a hull at a forward speed of 2 m/s, and one at rest is read" + form);
    EXPECT_EQ(refusal({.speeds = 3}), "hull.nc: has 3 values of forward_speed, and a file of one is read" + form);
    EXPECT_EQ(refusal({.has_added_mass = false}), "hull.nc: has no variable added_mass" + form);
    EXPECT_EQ(refusal({.along = "station"}),
              "hull.nc: has 3 along station of added_mass, and a file of one is read" + form);
    EXPECT_EQ(refusal({.omega = {-1, 1}}), "hull.nc: has a frequency of -1 rad/s" + form);
    EXPECT_NE(refusal({.omega = {nan}}).find("has no periods"), std::string::npos);
}

// Rows of two runs in one file: neither is the one that counts. The same row again is no harm.
TEST(Capytaine, AFrequencyTwiceIsRefusedUnlessItIsTheSame) {
    EXPECT_EQ(refusal({.omega = {0.5, 1, 0.5}}).substr(0, 101),
              "hull.nc: has a frequency of 0.5 rad/s, a period of 12.5664 s, twice with other values, rows 1 and 3; ");
    const RadiationFile found = read_radiation(File({.omega = {0.5, 1, 0.5}, .all_rows_as = 1}).bytes(), "hull.nc", {});
    EXPECT_EQ(found.points.size(), 2);
}

TEST(Capytaine, TakesFrequenciesInTheUnitThatTheyHave) {
    EXPECT_EQ(read_radiation(File({.unit = "rad/s"}).bytes(), "hull.nc", {}).points[0].frequency, 0.5);
    EXPECT_EQ(refusal({.unit = "Hz"}).substr(0, 58), "hull.nc: has omega in Hz, and Capytaine's is in rad/s; Cap");
}

// A file that was cut off is refused, where what is missing was to be read: NetCDF takes it for zeros. Never a crash.
TEST(Capytaine, CutOffAnywhereIsRefusedOrTheSame) {
    for (const int container : {NC_64BIT_OFFSET, NC_NETCDF4}) {
        const std::string whole = File({.container = container}).bytes();
        const RadiationFile wanted = read_radiation(whole, "hull.nc", {});
        int refused = 0;
        for (std::size_t length = 8; length < whole.size(); length += 197) {
            try {
                EXPECT_EQ(read_radiation(whole.substr(0, length), "hull.nc", {}), wanted) << length;
            } catch (const InputError&) {
                ++refused;
            }
        }
        EXPECT_GT(refused, 10);
        for (std::size_t at = 0; at < whole.size(); at += 401) {
            std::string changed = whole;
            changed[at] = static_cast<char>(changed[at] ^ 0x55);
            message(changed);
        }
    }
}

}  // namespace capytaine_test
}  // namespace floes
