#include "draw/vtk_series.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <zlib.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "replay/view.hpp"
#include "simulation/sheets.hpp"
#include "tables/table.hpp"

namespace floes {

namespace {

constexpr int zlib_level = 1;  // higher ones save a hundredth of the bytes and take up to twice as long
constexpr std::uint8_t vtk_hexahedron = 12;
constexpr std::uint8_t vtk_convex_point_set = 41;

/// The bytes of an array as one compressed block behind VTK's header: number of blocks, size of a block, size of the
/// last one if it is shorter, compressed size.
std::string packed(const std::vector<char>& bytes) {
    if (bytes.empty()) return std::string(3 * sizeof(std::uint64_t), '\0');
    uLongf size = compressBound(bytes.size());
    std::string block(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(block.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                  bytes.size(), zlib_level) != Z_OK)
        throw RunError("zlib could not compress an array of a VTK file; memory may be short.");
    block.resize(size);
    const std::array<std::uint64_t, 4> header{1, bytes.size(), 0, size};
    return std::string(reinterpret_cast<const char*>(header.data()), sizeof header) + block;
}

/// The document is collected in two parts: elements that say where the data stand, and the data.
class XmlDocument {
  public:
    void line(std::string_view text) { text_.append(text).append("\n"); }

    void array(const VtkArray& array) {
        line(fmt::format(R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}"/>)",
                         array.type, array.name, array.components, data_.size()));
        data_ += packed(array.bytes);
    }

    void arrays(std::string_view element, const std::vector<VtkArray>& all) {
        line(fmt::format("<{}>", element));
        for (const VtkArray& one : all) array(one);
        line(fmt::format("</{}>", element));
    }

    const std::string& text() const { return text_; }
    const std::string& data() const { return data_; }

  private:
    std::string text_;
    std::string data_;
};

std::vector<std::uint8_t> cell_types(const VtkMesh& mesh) {
    std::vector<std::uint8_t> types(mesh.offsets.size(), vtk_hexahedron);
    for (std::size_t k = 0; k < types.size() && mesh.kind == VtkCells::solids; ++k)
        if (mesh.offsets[k] - (k > 0 ? mesh.offsets[k - 1] : 0) != 8) types[k] = vtk_convex_point_set;
    return types;
}

}  // namespace

std::string_view VtkMesh::extension() const {
    return kind == VtkCells::hexahedra || kind == VtkCells::solids ? ".vtu" : ".vtp";
}

void write_vtk(const std::filesystem::path& path, const VtkMesh& mesh, double time) {
    const bool volume = mesh.kind == VtkCells::hexahedra || mesh.kind == VtkCells::solids;
    const std::string_view type = volume ? "UnstructuredGrid" : "PolyData";
    const std::size_t points = mesh.points.size() / 3;
    const std::string_view cells = volume                          ? "Cells"
                                   : mesh.kind == VtkCells::points ? "Verts"
                                   : mesh.kind == VtkCells::lines  ? "Lines"
                                                                   : "Polys";

    std::vector<VtkArray> topology{vtk_array("connectivity", mesh.connectivity), vtk_array("offsets", mesh.offsets)};
    if (volume) topology.push_back(vtk_array("types", cell_types(mesh)));

    XmlDocument document;
    document.line(R"(<?xml version="1.0"?>)");
    document.line(fmt::format(R"(<VTKFile type="{}" version="1.0" byte_order="{}" header_type="UInt64" )"
                              R"(compressor="vtkZLibDataCompressor">)",
                              type, std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian"));
    document.line(fmt::format("<{}>", type));
    document.line(fmt::format(R"(<FieldData><DataArray type="Float64" Name="TimeValue" NumberOfTuples="1" )"
                              R"(format="ascii">{}</DataArray></FieldData>)",
                              time));
    document.line(fmt::format(R"(<Piece NumberOfPoints="{}" {}="{}">)", points,
                              volume ? "NumberOfCells" : fmt::format("NumberOf{}", cells), mesh.offsets.size()));
    document.arrays("PointData", mesh.point_data);
    document.arrays("CellData", mesh.cell_data);
    document.arrays("Points", {vtk_array("Points", mesh.points, 3)});
    document.arrays(cells, topology);
    document.line("</Piece>");
    document.line(fmt::format("</{}>", type));
    document.line(R"(<AppendedData encoding="raw">)");

    std::ofstream file(path, std::ios::binary);
    file << document.text() << '_' << document.data() << "\n</AppendedData>\n</VTKFile>\n";
    file.close();
    if (!file)
        throw RunError(fmt::format("Cannot write {}; is the disk full, or the folder read-only?", path.string()));
}

namespace {

void append(std::vector<float>& values, const Vec3& vector) {
    for (const double value : vector) values.push_back(static_cast<float>(value));
}

void append_box(VtkMesh& mesh, const Vec3& centre, const Mat3& rotation, const Vec3& half_extents) {
    // In VTK's order: round the lower face, then round the upper one above it.
    for (const double y : {-1.0, 1.0})
        for (const Vec2& corner : {Vec2(-1, -1), Vec2(-1, 1), Vec2(1, 1), Vec2(1, -1)})
            append(mesh.points, centre + rotation * half_extents.cwiseProduct(Vec3(corner.x(), y, corner.y())));
    for (int i = 0; i < 8; ++i) mesh.connectivity.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
    mesh.offsets.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
}

/// Round the lower face, then round the upper one.
void append_prism(VtkMesh& mesh, const BodyState& state, const IceLayout::LaidElement& element) {
    for (const double y : {-1.0, 1.0})
        for (const Corner& corner : element.corners)
            append(mesh.points,
                   state.position + state.rotation * Vec3(corner.x, y * element.half_extents.y(), corner.z));
    for (std::size_t i = 0; i < 2 * element.corners.size(); ++i)
        mesh.connectivity.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
    mesh.offsets.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
}

/// The mesh of these points, a vertex at each.
VtkMesh vertices(std::vector<float> points) {
    VtkMesh mesh{.kind = VtkCells::points, .points = std::move(points)};
    for (std::size_t i = 0; i < mesh.points.size() / 3; ++i) {
        mesh.connectivity.push_back(static_cast<std::int32_t>(i));
        mesh.offsets.push_back(static_cast<std::int32_t>(i + 1));
    }
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

VtkMesh ice_part(const Frame& frame, const IceLayout& layout, std::span<const std::uint8_t> broken) {
    const std::size_t elements = frame.elements.size();
    VtkMesh mesh{.kind = VtkCells::hexahedra};
    mesh.points.reserve(24 * elements);
    std::vector<std::int32_t> floe(elements);
    std::vector<std::uint8_t> is_broken(elements);
    for (std::size_t i = 0; i < elements; ++i) {
        const IceLayout::LaidElement& one = layout.elements[frame.id(i)];
        if (one.square) {
            append_box(mesh, frame.elements[i].position, frame.elements[i].rotation, one.half_extents);
        } else {
            mesh.kind = VtkCells::solids;
            append_prism(mesh, frame.elements[i], one);
        }
        floe[i] = one.floe;
        is_broken[i] = broken[static_cast<std::size_t>(floe[i])];
    }
    mesh.cell_data = {
        vtk_array("floe", floe), vtk_array("piece", frame.pieces), vtk_array("broken", is_broken),
        vtk_array("utilisation", std::vector<float>(frame.utilisation.begin(), frame.utilisation.end())),
        vtk_array("velocity", vectors(frame.elements, [](const BodyState& one) { return one.velocity; }), 3)};
    if (!frame.ids.empty()) mesh.cell_data.push_back(vtk_array("element", frame.ids));
    return mesh;
}

VtkMesh contacts_part(const Frame& frame) {
    const auto read = [&](auto of) { return vectors(frame.contacts, of); };
    std::vector<std::int32_t> element;
    std::vector<std::int32_t> other;
    for (const FrameContact& contact : frame.contacts) {
        element.push_back(contact.element);
        other.push_back(contact.other);
    }
    VtkMesh mesh = vertices(read([](const FrameContact& one) { return one.point; }));
    mesh.point_data = {
        vtk_array("normal", read([](const FrameContact& one) { return one.normal; }), 3),
        vtk_array("friction", read([](const FrameContact& one) { return one.friction; }), 3),
        vtk_array("force", read([](const FrameContact& one) -> Vec3 { return one.normal + one.friction; }), 3),
        vtk_array("element", element), vtk_array("other", other)};
    return mesh;
}

VtkMesh load_part(const Frame& frame) {
    std::vector<float> force;
    for (int i = 0; i < 3; ++i) append(force, frame.load[i] * Vec3::Unit(i));
    append(force, frame.load);
    std::vector<float> points;
    for (int i = 0; i < 4; ++i) append(points, frame.structure.position);
    VtkMesh mesh = vertices(std::move(points));
    mesh.point_data = {vtk_array("force", force, 3), vtk_array("component", std::vector<std::int32_t>{0, 1, 2, 3})};
    return mesh;
}

namespace {

/// Mooring lines that hold, from fairlead to anchor. Cells have tension and which line it is.
VtkMesh moorings_part(const Frame& frame, const Moorings& moorings) {
    VtkMesh mesh{.kind = VtkCells::lines};
    std::vector<float> tension;
    std::vector<std::int32_t> number;
    for (const FrameLine& line : frame.lines) {
        for (const Vec3& point : course(moorings, static_cast<std::size_t>(line.line), line.fairlead, line.anchor)) {
            append(mesh.points, point);
            mesh.connectivity.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
        }
        mesh.offsets.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
        tension.push_back(static_cast<float>(line.tension));
        number.push_back(line.line);
    }
    mesh.cell_data = {vtk_array("tension", tension), vtk_array("line", number)};
    return mesh;
}

}  // namespace

VtkMesh structure_part(const Shape& shape, const StructurePose& pose) {
    const SurfaceMesh surface = shape.mesh(96);
    VtkMesh mesh{.kind = VtkCells::polygons};
    const Mat3 turn = pose.orientation().toRotationMatrix();
    for (const Vec3& point : surface.points) append(mesh.points, pose.position + turn * point);
    for (const std::vector<int>& polygon : surface.polygons) {
        mesh.connectivity.insert(mesh.connectivity.end(), polygon.begin(), polygon.end());
        mesh.offsets.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
    }
    return mesh;
}

namespace {

/// A hexahedron for each sheet of fixed ice.
VtkMesh ice_sheets_part(const Channel& channel) {
    VtkMesh mesh{.kind = VtkCells::hexahedra};
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

/// The text of NAME.py. The camera is that of View::perspective.
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

void write_text(const std::filesystem::path& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file)
        throw RunError(fmt::format("Cannot write {}; is the disk full, or the folder read-only?", path.string()));
}

}  // namespace

void write_vtk_series(const std::filesystem::path& path, const Recording& recording) {
    VtkSeries series(path, recording.subject(), recording.outcome().breaks);
    Frame frame;
    for (int number = 0; number < recording.frames(); ++number) {
        recording.read(number, frame);
        series.add(frame);
    }
    series.finish();
}

VtkSeries::VtkSeries(const std::filesystem::path& path, const RecordingSubject& subject,
                     const std::vector<BreakEvent>& breaks)
    : path_(path),
      folder_(std::filesystem::path(path).replace_extension()),
      subject_(subject),
      layout_(subject.floes),
      breaks_(breaks),
      state_{.collection = path.filename().string()} {
    if (path.extension() != ".pvd")
        throw InputError(
            fmt::format("A series for ParaView is named NAME.pvd; '{}' does not end in .pvd.", path.string()));
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) throw RunError(fmt::format("Cannot make the folder {}: {}.", folder_.string(), error.message()));

    const VtkMesh sheets = ice_sheets_part(subject.channel());
    sheets_ = fmt::format("ice_sheets{}", sheets.extension());
    write_vtk(folder_ / sheets_, sheets, 0);
}

void VtkSeries::add(const Frame& frame) {
    write("ice", 0, ice_part(frame, layout_, broken_floes(breaks_, layout_.floes(), frame.time)), frame.time);
    write("structure", 1, structure_part(subject_.scenario.structure.shape, frame.structure), frame.time);
    write("load", 2, load_part(frame), frame.time);
    write("contacts", 3, contacts_part(frame), frame.time);
    list("ice_sheets", 4, sheets_, frame.time);
    if (subject_.scenario.moorings.line_count() > 0)
        write("moorings", 5, moorings_part(frame, subject_.scenario.moorings), frame.time);

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

void VtkSeries::write(const std::string& part, int number, const VtkMesh& mesh, double time) {
    const std::string file = fmt::format("{}_{:05}{}", part, frames_, mesh.extension());
    write_vtk(folder_ / file, mesh, time);
    list(part, number, file, time);
}

void VtkSeries::list(const std::string& part, int number, const std::string& file, double time) {
    datasets_ += fmt::format(R"(<DataSet timestep="{}" part="{}" name="{}" file="{}/{}"/>)"
                             "\n",
                             time, number, part, html_escaped(folder_.filename().string()), file);
}

void VtkSeries::finish() {
    write_text(std::filesystem::path(path_).replace_extension(".py"), vtk_state(state_, subject_));
    write_text(path_, fmt::format("<?xml version=\"1.0\"?>\n"
                                  "<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n{}"
                                  "</Collection>\n</VTKFile>\n",
                                  datasets_));
}

}  // namespace floes
