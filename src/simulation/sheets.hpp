#pragma once
// The ice round the field (Fig. 3): sheets of [ice]'s thickness along both walls and across the far end, where these
// are closed, floating where the floes float.

#include <vector>

#include "core/vector.hpp"
#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"
#include "world/world.hpp"

namespace floes {

/// A box with its sides along the world axes, m: fixed, or pressed along its normal (simulation/sheets.hpp).
struct IceSheet {
    Vec3 centre = Vec3::Zero();
    Vec3 half_extents = Vec3::Zero();
    Vec3 inwards = Vec3::Zero();  ///< its normal towards the field
    double faces = 0;             ///< length of the field's edge that it faces at the start, m
};

struct Channel {
    double room = 0;        ///< behind the structure at t = 0, for a floe that passes round it, m
    double begin = 0;       ///< x where the wall sheets begin, m: behind the structure at t = 0
    double end = 0;         ///< x where they end, m: past the far sheet, or past all that the tow can push ahead
    double inner_edge = 0;  ///< |z| of the wall sheets' inner edges at the start, m
    double outer_edge = 0;  ///< |z| of their outer edges, m
    double drift = 0;       ///< how far ice may drift in a run without being lost, m; 0 between fixed sheets
    std::vector<IceSheet> sheets;
};

/// The channel of a scenario with room for these floes.
Channel make_channel(const Scenario& scenario, const FloeSet& floes);

// The ice sheets round the field in the world: fixed, or, with field.confining_N_m, rigid bodies that give way.
//
// A sheet that gives way moves along its normal only. On it act the line load p times the edge of the field that it
// faces, less the part u/u_c of it while it closes at the speed u (u_c: field.closing_speed_m_s, so that a sheet that
// meets nothing comes to that speed), the water's skin drag, and the ice. The load falls with the speed of the step's
// end, which is a mass Δt p l / u_c beside that of the sheet: stable at any load, and at rest all of it is there.

/// How a sheet has moved.
struct SheetMotion {
    double way = 0;    ///< towards the field since the start, m
    double speed = 0;  ///< towards the field, m/s
};

class Sheets {
  public:
    struct Fixed {
        BodyId body;
        IceSheet form;
    };

    Sheets(World& world, const Scenario& scenario, const Channel& channel);

    bool give_way() const { return confining_ > 0; }

    const std::vector<Fixed>& fixed() const { return fixed_; }

    /// Puts them where they came to; as many as there are sheets, or none for the start.
    void place(World& world, const std::vector<SheetMotion>& motions) const;

    /// Before each step, which begins at `time`, s: what acts on them besides the ice, and where those are that push
    /// level ice.
    void press(World& world, double time);

    /// After a step. Throws MemberFailure when a sheet has closed as far as the structure, s `time`: a sheet cannot
    /// touch it.
    void read(const World& world, const StructurePose& structure, double time);

    /// Throws MemberFailure when the structure, which is `offset` (m along x and z) from where its tow or path would
    /// have it, has come to a fixed sheet or a wall.
    void check_fixed(const StructurePose& structure, const Vec2& offset, double time) const;

    const std::vector<SheetMotion>& motions() const { return motions_; }

    /// Mean velocity of a body in the last step; zero for those that are no sheets that give way.
    Vec3 velocity(BodyId body) const;

    void archive(StateArchive& state);  ///< core/state_archive.hpp

  private:
    struct Sheet {
        BodyId body;
        IceSheet form;
        double load = 0;     ///< p times the edge, N
        double skin = 0;     ///< ½ ρ_w C_s A, kg/m
        double closing = 0;  ///< u_c, m/s
    };

    /// Whether the structure reaches as far as a sheet whose middle is there.
    bool touches(const IceSheet& form, const Vec3& centre, const StructurePose& structure) const;

    double confining_;
    double push_;                  ///< m/s along -x, of fixed sheets
    double radius_;                ///< of the structure at the waterline, m
    std::vector<Vec3> waterline_;  ///< its corners in the structure's axes, m; none of a body of revolution
    std::vector<Fixed> fixed_;
    std::vector<IceSheet> walls_;  ///< smooth ones beside a structure that does not fill the field: without bodies
    std::vector<Sheet> sheets_;
    std::vector<SheetMotion> motions_;
    std::vector<double> mean_speed_;  ///< in the last step, m/s
};

}  // namespace floes
