#include "vtk/vtk_state.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/units.hpp"
#include "simulation/channel.hpp"
#include "view/camera.hpp"
#include "view/colours.hpp"

namespace floes {
namespace {

constexpr const char* opening = R"PY(# A run of floes as Fig. 5 shows it. Written for ParaView 5.11.
#
#   paraview --state={name}.py                      opens it; in ParaView: File, Load State
#   pvpython {name}.py --screenshot out.png [--time SECONDS]
#                                                   draws it; without a display: xvfb-run -a -s -noreset pvpython ...
#
# White: floes, warm those with a failed joint. Yellow: the structure. From its deck: the ice load along x (red),
# y (green) and z (blue), and their sum (white). At contacts: normal force (magenta) and friction (teal) on the ice. All
# forces to the same scale.

collection = {collection}
first_axis, last_axis = {first_axis}, {last_axis}  # x of the structure in the first frame and the last, m
deck = {deck}  # height of the structure above the water, m
eye, target = {eye}, {target}  # of the camera while the structure is at x = 0, m
angle = {angle}  # of view, degrees
metres_per_newton = {metres_per_newton}
water = {water}  # x and z of its corners, m
time_shown = {time_shown}  # s: the frame with the largest load, {largest_load} N
white, warm, sheet, yellow = {white}, {warm}, {sheet}, {yellow}
red, green, blue, sea, ink = {red}, {green}, {blue}, {sea}, {ink}
magenta, teal = {magenta}, {teal}
)PY";

constexpr const char* body = R"PY(
import argparse
import os

from paraview.simple import *

paraview.simple._DisableFirstRenderCameraReset()
folder = os.path.dirname(os.path.abspath(__file__))
run = PVDReader(registrationName=collection, FileName=os.path.join(folder, collection))
scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
view = GetActiveViewOrCreate('RenderView')
view.UseColorPaletteForBackground = 0
view.Background = [0.75, 0.82, 0.88]
view.KeyLightWarmth = view.FillLightWarmth = view.HeadLightWarmth = view.BackLightWarmth = 0.5  # white light
view.KeyLightIntensity = 0.85
view.OrientationAxesVisibility = 0  # its colours are not those of the load


def part(name):
    return ExtractBlock(registrationName=name, Input=run, Selectors=['/Root/' + name])


def show(source, colour, **properties):
    shown = Show(source, view)
    shown.ColorArrayName = [None, '']
    shown.AmbientColor = shown.DiffuseColor = colour
    for name, value in properties.items():
        setattr(shown, name, value)
    return shown


def by_kind(shown, where, array, kinds):
    ColorBy(shown, (where, array))
    colours = GetColorTransferFunction(array)
    colours.InterpretValuesAsCategories = 1
    colours.Annotations = [word for number, kind in enumerate(kinds) for word in (str(number), kind)]
    colours.IndexedColors = [share for colour in kinds.values() for share in colour]
    return colours


def forces(name, source, array, colour, width):
    lines = Glyph(registrationName=name, Input=source, GlyphType='Line', OrientationArray=['POINTS', array],
                  ScaleArray=['POINTS', array], VectorScaleMode='Scale by Magnitude', ScaleFactor=metres_per_newton,
                  GlyphMode='All Points')
    lines.GlyphTransform.Translate = [0.5, 0, 0]  # lines begin at the point
    return show(lines, colour, LineWidth=width, Ambient=1, Diffuse=0)


ice = show(part('ice'), white, Representation='Surface With Edges', EdgeColor=[0.55, 0.62, 0.68])
by_kind(ice, 'CELLS', 'broken', {'whole': white, 'broken': warm})
show(part('ice_sheets'), sheet)
show(part('structure'), yellow)
x_low, x_high, z_low, z_high = water
show(Plane(registrationName='water', Origin=[x_low, 0, z_low], Point1=[x_high, 0, z_low], Point2=[x_low, 0, z_high]),
     sea, Opacity=0.55)

contacts = part('contacts')
forces('normal forces', contacts, 'normal', magenta, 3)
forces('friction', contacts, 'friction', teal, 3)

load = Transform(registrationName='load, from the deck', Input=part('load'))
load.Transform.Translate = [0, deck + 0.02, 0]
lines = forces('load', load, 'force', white, 7)
colours = by_kind(lines, 'POINTS', 'component', {'surge': red, 'heave': green, 'sway': blue, 'sum': [1, 1, 1]})
legend = GetScalarBar(colours, view)
legend.Title, legend.ComponentTitle = 'ice load', ''
legend.TitleColor = legend.LabelColor = ink
legend.TitleFontSize = legend.LabelFontSize = 10
legend.ScalarBarThickness, legend.ScalarBarLength = 10, 0.16
legend.WindowLocation, legend.Position = 'Any Location', [0.05, 0.74]
legend.TextPosition = 'Ticks left/bottom, annotations right/top'
legend.Visibility = 1

Show(AnnotateTimeFilter(registrationName='time', Input=run, Format='t = {time:.2f} s'), view, Color=ink,
     FontSize=10)

arguments = argparse.ArgumentParser()
arguments.add_argument('--screenshot')
arguments.add_argument('--time', type=float, default=time_shown)
wanted = arguments.parse_known_args()[0]
shown_at = min(max(wanted.time, scene.StartTime), scene.EndTime)


# The camera goes with the structure. Delete its tracks in the Animation View to look from elsewhere while it plays.
for name, seen in (('CameraPosition', eye), ('CameraFocalPoint', target)):
    GetAnimationTrack(name, 0, view).KeyFrames = [CompositeKeyFrame(KeyTime=0, KeyValues=[seen[0] + first_axis]),
                                                  CompositeKeyFrame(KeyTime=1, KeyValues=[seen[0] + last_axis])]
share = (shown_at - scene.StartTime) / max(scene.EndTime - scene.StartTime, 1e-9)
axis = first_axis + (last_axis - first_axis) * share
view.CameraPosition = [eye[0] + axis, eye[1], eye[2]]
view.CameraFocalPoint = [target[0] + axis, target[1], target[2]]
view.CameraViewUp, view.CameraViewAngle = [0, 1, 0], angle
scene.AnimationTime = shown_at
Render()
if wanted.screenshot:
    SaveScreenshot(wanted.screenshot, view, ImageResolution=[1600, 1000])
)PY";

std::string python(const Vec3& v) {
    return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", v.x(), v.y(), v.z());
}

std::string python(const Colour& colour) {
    return python(Vec3(colour.red, colour.green, colour.blue));
}

std::string quoted(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + "'";
}

}  // namespace

std::string vtk_state(const VtkStateOf& series, const RecordingSubject& subject) {
    const Camera seen = camera(View::perspective, subject, 0);
    const Channel channel = subject.channel();
    const Shape& shape = subject.scenario.structure.shape;
    const double scale = 1.5 * shape.largest_radius() / (series.largest_force > 0 ? series.largest_force : 1);
    const std::string name = series.collection.substr(0, series.collection.rfind('.'));
    return fmt::format(fmt::runtime(opening), fmt::arg("name", name), fmt::arg("collection", quoted(series.collection)),
                       fmt::arg("first_axis", series.first_axis), fmt::arg("last_axis", series.last_axis),
                       fmt::arg("deck", shape.top()), fmt::arg("eye", python(seen.eye)),
                       fmt::arg("target", python(seen.target)),
                       fmt::arg("angle", fmt::format("{:.4g}", seen.angle / unit::degree)),
                       fmt::arg("metres_per_newton", fmt::format("{:.4g}", scale)),
                       fmt::arg("time_shown", series.time_of_largest_load),
                       fmt::arg("largest_load", fmt::format("{:.4g}", series.largest_load)),
                       fmt::arg("white", python(white_ice)), fmt::arg("warm", python(broken_ice)),
                       fmt::arg("sheet", python(sheet_ice)), fmt::arg("yellow", python(structure_yellow)),
                       fmt::arg("sea", python(sea)), fmt::arg("red", python(surge_red)),
                       fmt::arg("green", python(heave_green)), fmt::arg("magenta", python(normal_magenta)),
                       fmt::arg("teal", python(friction_teal)), fmt::arg("blue", python(sway_blue)),
                       fmt::arg("ink", python(ink)),
                       fmt::arg("water", fmt::format("[{:.6g}, {:.6g}, {:.6g}, {:.6g}]", channel.begin, channel.end,
                                                     -channel.outer_edge, channel.outer_edge))) +
           body;
}

}  // namespace floes
