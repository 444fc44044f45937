#include "draw/xdmf_series.hpp"

#include <algorithm>
#include <array>
#include <fstream>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "hdf5/columns.hpp"
#include "replay/view.hpp"
#include "tables/table.hpp"

namespace floes {

namespace {

// Kinds of cells as XDMF 2 counts them.
constexpr std::int32_t vertices_of = 1;
constexpr std::int32_t line_along = 2;
constexpr std::int32_t polygon_of = 3;
constexpr std::int32_t wedge = 8;
constexpr std::int32_t hexahedron = 9;

void add_cell(XdmfMesh& mesh, std::int32_t kind, std::span<const std::int32_t> points) {
    mesh.cells.push_back(kind);
    if (kind <= polygon_of) mesh.cells.push_back(static_cast<std::int32_t>(points.size()));
    mesh.cells.insert(mesh.cells.end(), points.begin(), points.end());
    ++mesh.count;
}

void append(std::vector<float>& values, const Vec3& vector) {
    for (const double value : vector) values.push_back(static_cast<float>(value));
}

std::int32_t next_point(const XdmfMesh& mesh) {
    return static_cast<std::int32_t>(mesh.points.size() / 3);
}

void append_box(XdmfMesh& mesh, const Vec3& centre, const Mat3& rotation, const Vec3& half_extents) {
    // In VTK's order: round the lower face, then round the upper one above it.
    std::array<std::int32_t, 8> corners{};
    for (std::int32_t& corner : corners)
        corner = next_point(mesh) + static_cast<std::int32_t>(&corner - corners.data());
    for (const double y : {-1.0, 1.0})
        for (const Vec2& corner : {Vec2(-1, -1), Vec2(-1, 1), Vec2(1, 1), Vec2(1, -1)})
            append(mesh.points, centre + rotation * half_extents.cwiseProduct(Vec3(corner.x(), y, corner.y())));
    add_cell(mesh, hexahedron, corners);
}

/// The points round the lower face, then round the upper one; a fan of cells from the first corner.
void append_prism(XdmfMesh& mesh, const BodyState& state, const IceLayout::LaidElement& element) {
    const std::int32_t low = next_point(mesh);
    const auto corners = static_cast<std::int32_t>(element.corners.size());
    const std::int32_t high = low + corners;
    for (const double y : {-1.0, 1.0})
        for (const Corner& corner : element.corners)
            append(mesh.points,
                   state.position + state.rotation * Vec3(corner.x, y * element.half_extents.y(), corner.z));
    // The corners go round so that the lower face is seen from below: VTK's order of a wedge, not of a hexahedron.
    std::int32_t k = 1;
    for (; k + 2 < corners; k += 2)
        add_cell(mesh, hexahedron,
                 std::array{low, low + k + 2, low + k + 1, low + k, high, high + k + 2, high + k + 1, high + k});
    if (k + 1 < corners) add_cell(mesh, wedge, std::array{low, low + k, low + k + 1, high, high + k, high + k + 1});
}

/// The mesh of these points, a vertex at each.
XdmfMesh vertices(std::vector<float> points) {
    XdmfMesh mesh{.points = std::move(points)};
    for (std::int32_t i = 0; i < next_point(mesh); ++i) add_cell(mesh, vertices_of, std::array{i});
    return mesh;
}

template <class Items, class Read>
std::vector<float> vectors(const Items& items, Read read) {
    std::vector<float> values;
    values.reserve(3 * items.size());
    for (const auto& item : items) append(values, read(item));
    return values;
}

}  // namespace

XdmfMesh ice_part(const Frame& frame, const IceLayout& layout, std::span<const std::uint8_t> broken, int sheet) {
    XdmfMesh mesh;
    std::vector<std::int32_t> element;
    std::vector<std::int32_t> floe;
    std::vector<std::int32_t> piece;
    std::vector<std::int8_t> is_broken;
    std::vector<float> utilisation;
    std::vector<float> velocity;
    for (std::size_t i = 0; i < frame.elements.size(); ++i) {
        const IceLayout::LaidElement& one = layout.elements[frame.id(i)];
        if (one.square) {
            append_box(mesh, frame.elements[i].position, frame.elements[i].rotation, one.half_extents);
        } else {
            append_prism(mesh, frame.elements[i], one);
        }
        while (std::ssize(element) < mesh.count) {
            element.push_back(static_cast<std::int32_t>(frame.id(i)));
            floe.push_back(one.floe);
            piece.push_back(frame.pieces[i]);
            is_broken.push_back(sheet < 0 ? static_cast<std::int8_t>(broken[static_cast<std::size_t>(one.floe)])
                                          : frame.pieces[i] != sheet);
            utilisation.push_back(static_cast<float>(frame.utilisation[i]));
            append(velocity, frame.elements[i].velocity);
        }
    }
    mesh.cell_data = {{"element", element},         {"floe", floe},           {"piece", piece}, {"broken", is_broken},
                      {"utilisation", utilisation}, {"velocity", velocity, 3}};
    return mesh;
}

XdmfMesh contacts_part(const Frame& frame) {
    const auto read = [&](auto of) { return vectors(frame.contacts, of); };
    std::vector<std::int32_t> element;
    std::vector<std::int32_t> other;
    for (const FrameContact& contact : frame.contacts) {
        element.push_back(contact.element);
        other.push_back(contact.other);
    }
    XdmfMesh mesh = vertices(read([](const FrameContact& one) { return one.point; }));
    mesh.point_data = {
        XdmfArray{"normal", read([](const FrameContact& one) { return one.normal; }), 3},
        XdmfArray{"friction", read([](const FrameContact& one) { return one.friction; }), 3},
        XdmfArray{"force", read([](const FrameContact& one) -> Vec3 { return one.normal + one.friction; }), 3},
        XdmfArray{"element", element}, XdmfArray{"other", other}};
    return mesh;
}

XdmfMesh load_part(const Frame& frame) {
    std::vector<float> force;
    for (int i = 0; i < 3; ++i) append(force, frame.load[i] * Vec3::Unit(i));
    append(force, frame.load);
    std::vector<float> points;
    for (int i = 0; i < 4; ++i) append(points, frame.structure.position);
    XdmfMesh mesh = vertices(std::move(points));
    mesh.point_data = {XdmfArray{"force", force, 3}, XdmfArray{"component", std::vector<std::int32_t>{0, 1, 2, 3}}};
    return mesh;
}

namespace {

/// Mooring lines that hold, from fairlead to anchor. Cells have tension and which line it is.
XdmfMesh moorings_part(const Frame& frame, const Moorings& moorings) {
    XdmfMesh mesh;
    std::vector<float> tension;
    std::vector<std::int32_t> number;
    for (const FrameLine& line : frame.lines) {
        std::vector<std::int32_t> along;
        for (const Vec3& point : course(moorings, static_cast<std::size_t>(line.line), line.fairlead, line.anchor)) {
            along.push_back(next_point(mesh));
            append(mesh.points, point);
        }
        add_cell(mesh, line_along, along);
        tension.push_back(static_cast<float>(line.tension));
        number.push_back(line.line);
    }
    mesh.cell_data = {{"tension", tension}, {"line", number}};
    return mesh;
}

}  // namespace

XdmfMesh structure_part(const SurfaceMesh& surface, const StructurePose& pose) {
    XdmfMesh mesh;
    const Mat3 turn = pose.orientation().toRotationMatrix();
    for (const Vec3& point : surface.points) append(mesh.points, pose.position + turn * point);
    for (const std::vector<int>& polygon : surface.polygons)
        add_cell(mesh, polygon_of, std::vector<std::int32_t>(polygon.begin(), polygon.end()));
    return mesh;
}

namespace {

/// A hexahedron for each sheet of fixed ice.
XdmfMesh ice_sheets_part(const Channel& channel) {
    XdmfMesh mesh;
    for (const IceSheet& sheet : channel.sheets) append_box(mesh, sheet.centre, Mat3::Identity(), sheet.half_extents);
    return mesh;
}

constexpr const char* opening = R"PY(# A run of floes as Fig. 5 shows it. Written for ParaView 5.11.
#
#   paraview --state={name}.py                      opens it; in ParaView: File, Load State
#   pvpython {name}.py --screenshot out.png [--time SECONDS]
#                                                   draws it; without a display: xvfb-run -a -s -noreset pvpython ...
#
# White: floes, warm those with a failed joint. Yellow: the structure. From its deck: the ice load along x (red),
# y (green) and z (blue), and their sum (white). At contacts: normal force (magenta) and friction (teal) on the ice. All
# forces to the same scale.

file = {file}
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
run = XDMFReader(registrationName=file, FileNames=[os.path.join(folder, file)])
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

ice = part('ice')
by_kind(show(ice, white), 'CELLS', 'broken', {'whole': white, 'broken': warm})
surface = ExtractSurface(registrationName='surface of the ice', Input=ice)
show(FeatureEdges(registrationName='edges of elements', Input=surface), [0.55, 0.62, 0.68])
offsets = GetSettingsProxy('RenderViewSettings')  # lines where they are: ParaView draws them before what is near
offsets.LineOffsetParameters, offsets.PolygonOffsetParameters = [0, 0], [1, 1]
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

/// The text of NAME.py. The camera is that of View::perspective.
std::string paraview_state(const SeriesState& series, const RecordingSubject& subject) {
    const Camera seen = camera(View::perspective, subject, 0);
    const Channel channel = subject.channel();
    const Shape& shape = subject.scenario.structure.shape;
    const double scale = 1.5 * shape.largest_radius() / (series.largest_force > 0 ? series.largest_force : 1);
    const std::string name = series.file.substr(0, series.file.rfind('.'));
    return fmt::format(fmt::runtime(opening), fmt::arg("name", name), fmt::arg("file", quoted(series.file)),
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

void write_text(const std::filesystem::path& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file)
        throw RunError(fmt::format("Cannot write {}; is the disk full, or the folder read-only?", path.string()));
}

}  // namespace

void write_xdmf_series(const std::filesystem::path& path, const Recording& recording) {
    XdmfSeries series(path, recording.subject(), recording.outcome().breaks);
    Frame frame;
    for (int number = 0; number < recording.frames(); ++number) {
        recording.read(number, frame);
        series.add(frame);
    }
    series.finish();
}

namespace {

/// Where the state for ParaView lies. Throws InputError for a file there that is none.
std::filesystem::path state_beside(std::filesystem::path path) {
    path.replace_extension(".py");
    const std::string_view known(opening, std::string_view(opening).find('\n'));
    std::string first;
    std::ifstream there(path);
    if (there.is_open() && std::getline(there, first) && first != known)
        throw InputError(fmt::format(
            "{} is there and is no state for ParaView, which would be written in its place; give another name.",
            path.string()));
    return path;
}

std::filesystem::path numbers_beside(const std::filesystem::path& path) {
    if (path.extension() != ".xdmf2")
        throw InputError(
            fmt::format("A series for ParaView is named NAME.xdmf2; '{}' does not end in .xdmf2.", path.string()));
    state_beside(path);  // before anything is written
    return path.string() + ".h5";
}

/// The whole of an array as a dataset, compressed.
template <class Value>
void write_numbers(hid_t file, const std::string& name, const std::vector<Value>& values) {
    hdf5::Series<Value> series(file, {name, "", name}, {}, values.size());
    series.append(values);
    series.finish();
}

/// The type as XDMF names it.
std::string_view type_words(const XdmfValues& values) {
    constexpr std::array<std::string_view, 3> words{R"(NumberType="Float" Precision="4")",
                                                    R"(NumberType="Int" Precision="4")",
                                                    R"(NumberType="Char" Precision="1")"};
    return words.at(values.index());
}

/// x, y or z of all points.
XdmfArray coordinate(const XdmfMesh& mesh, std::size_t axis) {
    std::vector<float> values;
    for (std::size_t i = axis; i < mesh.points.size(); i += 3) values.push_back(mesh.points[i]);
    return {std::string(1, "xyz"[axis]), values};
}

}  // namespace

XdmfSeries::XdmfSeries(const std::filesystem::path& path, const RecordingSubject& subject,
                       const std::vector<BreakEvent>& breaks)
    : path_(path),
      numbers_(hdf5::create_file(numbers_beside(path))),
      subject_(subject),
      layout_(subject.floes),
      breaks_(breaks),
      sheets_(ice_sheets_part(subject.channel())),
      hull_(subject.scenario.structure.shape.mesh(96)),
      state_{.file = path.filename().string()} {}

void XdmfSeries::add(const Frame& frame) {
    // First what every frame has: ParaView takes its times from the first part.
    const int sheet = subject_.scenario.arrangement.level() ? largest_piece(frame) : -1;
    write("ice", ice_part(frame, layout_, broken_floes(breaks_, layout_.floes(), frame.time), sheet), frame.time);
    write("structure", structure_part(hull_, frame.structure), frame.time);
    write("load", load_part(frame), frame.time);
    write("contacts", contacts_part(frame), frame.time);
    write("ice_sheets", sheets_, frame.time);
    if (subject_.scenario.moorings.line_count() > 0)
        write("moorings", moorings_part(frame, subject_.scenario.moorings), frame.time);

    if (frames_ == 0) state_.first_axis = frame.structure.position.x();
    state_.last_axis = frame.structure.position.x();
    if (frames_ == 0 || frame.load.norm() > state_.largest_load) {
        state_.largest_load = frame.load.norm();
        state_.time_of_largest_load = frame.time;
    }
    state_.largest_force = std::max(state_.largest_force, frame.load.norm());
    for (const FrameContact& contact : frame.contacts)
        state_.largest_force = std::max(state_.largest_force, (contact.normal + contact.friction).norm());
    ++frames_;
}

void XdmfSeries::write(const std::string& part, const XdmfMesh& mesh, double time) {
    auto at = std::ranges::find(grids_, part, &std::pair<std::string, std::string>::first);
    if (at == grids_.end()) at = grids_.insert(at, {part, ""});
    if (mesh.count == 0) return;  // ParaView's reader falls over a part of nothing
    std::string& grids = at->second;
    grids += fmt::format(R"(<Grid Name="{}"><Time Value="{}"/>)"
                         R"(<Topology TopologyType="Mixed" NumberOfElements="{}">{}</Topology>)"
                         R"(<Geometry GeometryType="X_Y_Z">)",
                         part, time, mesh.count, item(part, {"cells", mesh.cells}));
    for (std::size_t axis = 0; axis < 3; ++axis) grids += item(part, coordinate(mesh, axis));
    grids += "</Geometry>" + attributes(part, mesh.point_data, "Node") + attributes(part, mesh.cell_data, "Cell") +
             "</Grid>\n";
}

std::string XdmfSeries::attributes(const std::string& part, const std::vector<XdmfArray>& arrays,
                                   std::string_view centre) {
    std::string text;
    for (const XdmfArray& array : arrays)
        text += fmt::format(R"(<Attribute Name="{}" AttributeType="{}" Center="{}">{}</Attribute>)", array.name,
                            array.components == 3 ? "Vector" : "Scalar", centre, item(part, array));
    return text;
}

std::string XdmfSeries::item(const std::string& part, const XdmfArray& array) {
    const std::string key = part + '_' + array.name;
    Written& last = written_[key];
    if (last.values == array.values && !last.item.empty()) return last.item;
    const std::string name = fmt::format("{}_{:05}", key, frames_);
    const std::size_t values = std::visit(
        [&](const auto& all) {
            write_numbers(numbers_.id(), name, all);
            return all.size();
        },
        array.values);
    const std::string sizes =
        array.components == 1 ? fmt::to_string(values) : fmt::format("{} {}", values / 3, array.components);
    last = {array.values, fmt::format(R"(<DataItem Format="HDF" {} Dimensions="{}">{}:/{}</DataItem>)",
                                      type_words(array.values), sizes, markup_escaped(state_.file) + ".h5", name)};
    return last.item;
}

void XdmfSeries::finish() {
    numbers_.close("H5Fclose", numbers_beside(path_).string());
    std::string text =
        "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n"
        "<Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Spatial\">\n";
    for (const auto& [part, grids] : grids_)
        if (!grids.empty())
            text += fmt::format("<Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n{}</Grid>\n",
                                part, grids);
    write_text(state_beside(path_), paraview_state(state_, subject_));
    write_text(path_, text + "</Grid>\n</Domain>\n</Xdmf>\n");
}

}  // namespace floes
