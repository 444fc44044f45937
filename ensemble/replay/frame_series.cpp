#include "replay/frame_series.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "core/units.hpp"

namespace floes {

std::size_t FloeRoll::index_of(int number) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(numbers_, number) - numbers_.begin());
}

void FloeRoll::enter(const Simulation& run, Frame& frame) {
    const IceField& ice = run.ice();
    of_sheet_ = ice.is_sheet();
    std::vector<std::pair<int, int>> there;  // number, place
    for (int place = 0; place < ice.places(); ++place)
        if (ice.is_there(place)) there.emplace_back(ice.number_of(place), place);
    std::ranges::sort(there);

    constexpr int gone = -1;
    std::vector<int> ids(frame.elements.size(), gone);  // by the run's index
    std::vector<std::size_t> shown;                     // those of the run, in the order of the record
    for (const auto& [number, place] : there) {
        // Floes enter in the order of their numbers, so one that no frame has shown is behind all that one has.
        if (numbers_.empty() || number > numbers_.back()) {
            numbers_.push_back(number);
            floes_.push_back(run.laid(place));
            first_element_.push_back(elements_);
            elements_ += ice.elements(place);
        }
        const int first = first_element_[index_of(number)];
        for (int k = 0; k < ice.elements(place); ++k) {
            shown.push_back(static_cast<std::size_t>(ice.first_element(place) + k));
            ids[shown.back()] = first + k;
        }
    }

    const auto id = [&](int element) { return ids[static_cast<std::size_t>(element)]; };
    const Frame whole = frame;
    frame.elements.clear();
    frame.pieces.clear();
    frame.utilisation.clear();
    frame.ids.clear();
    for (const std::size_t k : shown) {
        frame.elements.push_back(whole.elements[k]);
        frame.pieces.push_back(id(whole.pieces[k]));
        frame.utilisation.push_back(whole.utilisation[k]);
        frame.ids.push_back(ids[k]);
    }
    for (FrameContact& contact : frame.contacts) {
        contact.element = id(contact.element);
        if (contact.other >= 0) contact.other = id(contact.other);
    }
}

std::vector<BreakEvent> FloeRoll::breaks(const std::vector<BreakEvent>& of_run) const {
    std::vector<BreakEvent> found;
    if (of_sheet_) return found;
    for (BreakEvent event : of_run) {
        const std::size_t index = index_of(event.floe);
        if (index == numbers_.size() || numbers_[index] != event.floe) continue;
        event.floe = static_cast<int>(index);
        found.push_back(event);
    }
    return found;
}

namespace {

using hdf5::Handle;
using hdf5::Scale;

/// Corners of outlines in their own axes, a row each, NaN behind the last one of each. `whose`: "a floe".
void write_corners(hid_t group, const std::vector<const Outline*>& outlines, const Scale& row, const char* whose) {
    std::size_t most = 0;
    for (const Outline* one : outlines) most = std::max(most, one->size());
    if (most == 0) return;
    std::vector<double> x(most * outlines.size(), undefined);
    std::vector<double> z = x;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        for (std::size_t k = 0; k < outlines[i]->size(); ++k) {
            x[most * i + k] = (*outlines[i])[k].x;
            z[most * i + k] = (*outlines[i])[k].z;
        }
    }
    const Scale corner =
        hdf5::write_index_scale(group, "corner", fmt::format("corner of {}, in order", whose).c_str(), most);
    const std::string text = fmt::format("of {}'s corners, in its own axes", whose);
    hdf5::write_values(group, {"corner_x", "m", text}, {row, corner}, x);
    hdf5::write_values(group, {"corner_z", "m", text}, {row, corner}, z);
}

}  // namespace

Scale element_scale(hid_t file, const IceLayout& layout) {
    return hdf5::write_index_scale(file, "element", "element, floe by floe", layout.elements.size());
}

void write_ice(hid_t file, const FloeShape& usual, const IceLayout& layout, const RecordScales& scales) {
    const Scale& element = scales.element.value();
    std::vector<std::int32_t> floe;
    std::vector<double> sides;
    for (const IceLayout::LaidElement& one : layout.elements) {
        floe.push_back(one.floe);
        for (const double half : one.half_extents) sides.push_back(2 * half);
    }
    const Handle group = hdf5::create_group(file, "ice");
    hdf5::write_attribute(group.id(), "element_side", usual.element);
    hdf5::write_attribute(group.id(), "thickness", usual.thickness);
    hdf5::write_values(group.id(), {"floe", "1", "floe of each element"}, {element}, floe);
    hdf5::write_values(group.id(), {"sides", "m", "length of an element's sides along its own axes"},
                       {element, scales.coordinate}, sides);
    if (std::ranges::all_of(layout.elements, &IceLayout::LaidElement::square)) return;
    std::vector<const Outline*> outlines;
    for (const IceLayout::LaidElement& one : layout.elements) outlines.push_back(&one.corners);
    write_corners(group.id(), outlines, element, "an element");
}

void write_floes(hid_t file, const FloeSet& floes, const std::vector<int>& numbers) {
    const Handle group = hdf5::create_group(file, "floes");
    const Scale floe =
        hdf5::write_index_scale(group.id(), "floe", "floe that frames show, in the order of entry", floes.size());
    const auto write = [&](const char* name, const char* text, auto of) {
        std::vector<double> values;
        for (std::size_t i = 0; i < floes.size(); ++i) values.push_back(of(floes.shape(i)));
        hdf5::write_values(group.id(), {name, "m", text}, {floe}, values);
    };
    hdf5::write_values(group.id(), {"number", "1", "place in the order of entry, from 0, as the breaks have it"},
                       {floe}, std::vector<std::int32_t>(numbers.begin(), numbers.end()));
    write("length", "extent along the floe's own x", [](const FloeShape& one) { return one.length; });
    write("breadth", "extent along its own z", [](const FloeShape& one) { return one.breadth; });
    write("thickness", "thickness", [](const FloeShape& one) { return one.thickness; });
    write("element", "side of a square of an element's area", [](const FloeShape& one) { return one.element; });
    std::vector<std::int32_t> patterns;
    for (std::size_t i = 0; i < floes.size(); ++i) patterns.push_back(floes.shape(i).pattern);
    hdf5::write_values(group.id(), {"pattern", "1", "of its cells; -1: squares"}, {floe}, patterns);
    std::vector<const Outline*> outlines;
    for (std::size_t i = 0; i < floes.size(); ++i) outlines.push_back(&floes.shape(i).outline);
    write_corners(group.id(), outlines, floe, "a floe");
}

void write_joints(hid_t file, const IceLayout& layout, const std::vector<BreakEvent>& breaks) {
    const std::vector<IceLayout::LaidJoint>& joints = layout.joints;
    std::vector<std::int32_t> a;
    std::vector<std::int32_t> b;
    for (const IceLayout::LaidJoint& joint : joints) {
        a.push_back(joint.a);
        b.push_back(joint.b);
    }
    std::vector<double> time(joints.size(), undefined);
    std::vector<std::int8_t> mode(joints.size(), -1);
    for (const BreakEvent& event : breaks) {
        const std::size_t joint = layout.joint(event.floe, event.joint);
        time[joint] = event.time;
        mode[joint] = static_cast<std::int8_t>(event.mode);
    }
    const Handle group = hdf5::create_group(file, "joints");
    const Scale joint = hdf5::write_index_scale(file, "joint", "joint, floe by floe", joints.size());
    hdf5::write_values(group.id(), {"a", "1", "element that the joint connects with b"}, {joint}, a);
    hdf5::write_values(group.id(), {"b", "1", "element that the joint connects with a"}, {joint}, b);
    hdf5::write_values(group.id(), {"failure_time", "s", "when it failed; NaN: it did not"}, {joint}, time);
    hdf5::write_values(group.id(), {"failure_mode", "1", "how it failed"}, {joint}, mode,
                       hdf5::flags_of(failure_mode_names, std::int8_t{-1}));
}

namespace {

constexpr hsize_t numbers_a_chunk = 1024;   // of frames
constexpr hsize_t contacts_a_chunk = 4096;  // of a few frames
constexpr hsize_t states_a_chunk = 1024;    // of elements that come and go, of a frame or two

/// Bits of a float's mantissa that are kept. What follows in simulated numbers is noise, which would take most of the
/// time and the room that compression costs.
constexpr int bits_of_places = 20;  // 25 m to 8 µm
constexpr int bits_of_turns = 15;   // 0.03 mrad
constexpr int bits_of_motion = 12;  // speeds, forces and utilisations to 0.01 %

void put(std::vector<float>& values, double value, int bits) {
    const std::uint32_t dropped = (1u << (23 - bits)) - 1;
    const auto whole = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    values.push_back(std::bit_cast<float>((whole + (dropped >> 1)) & ~dropped));
}

/// What one row is along: all elements of a frame or, where they come and go, one element.
hdf5::Dimensions of_element(const RecordScales& scales, const hdf5::Scale* part = nullptr) {
    hdf5::Dimensions row;
    if (scales.element) row.push_back(*scales.element);
    if (part != nullptr) row.push_back(*part);
    return row;
}

void put(std::vector<float>& values, const Vec3& v, int bits) {
    for (const double part : {v.x(), v.y(), v.z()}) put(values, part, bits);
}

ElementColumns<hdf5::Series> element_columns(hid_t group, const RecordScales& scales) {
    const hsize_t chunk = scales.element ? 1 : states_a_chunk;
    const hdf5::Dimensions vector = of_element(scales, &scales.coordinate);
    return {{group, {"position", "m", "centre of each element"}, vector, chunk},
            {group,
             {"orientation", "1", "unit quaternion from the element's axes to world axes"},
             of_element(scales, &scales.quaternion),
             chunk},
            {group, {"velocity", "m s-1", "velocity of the centre"}, vector, chunk},
            {group,
             {"piece", "1", "first element of the connected piece that the element belongs to"},
             of_element(scales),
             chunk},
            {group,
             {"utilisation", "1",
              "largest utilisation of the element's joints, 0 to 1; a crack has 1 and the share of its stiffness that "
              "is gone"},
             of_element(scales),
             chunk}};
}

ContactColumns<hdf5::Series> contact_columns(hid_t group, const hdf5::Scale& coordinate) {
    constexpr hsize_t chunk = contacts_a_chunk;
    return {{group, {"element", "1", "element that the forces act on"}, {}, chunk},
            {group,
             {"other", "1", "what touches it: an element, -1 the structure, -2 an ice sheet or wall, -3 the bed"},
             {},
             chunk},
            {group, {"point", "m", "point of contact"}, {coordinate}, chunk},
            {group, {"normal_force", "N", "normal force on the element"}, {coordinate}, chunk},
            {group, {"friction_force", "N", "friction force on the element"}, {coordinate}, chunk}};
}

}  // namespace

FrameSeries::Numbers::Numbers(hid_t group)
    : step(group, {"step", "1", "steps completed"}, {}, numbers_a_chunk),
      each([group] {
          std::deque<hdf5::Series<double>> all;
          for (const FrameNumber& one : frame_numbers)
              all.emplace_back(group, hdf5::Label{one.name, one.unit, one.text}, hdf5::Dimensions{}, numbers_a_chunk);
          return all;
      }()),
      first_contact(group, {"first_contact", "1", "row of /contacts with the frame's first contact"}, {},
                    numbers_a_chunk),
      contacts(group, {"contacts", "1", "number of contacts"}, {}, numbers_a_chunk) {}

FrameSeries::FrameSeries(hid_t file, const RecordScales& scales)
    : time_(file, {"time", "s", "time of each frame"}, {}, numbers_a_chunk),
      contact_(file, {"contact", "1", "contact, frame by frame"}, {}, contacts_a_chunk),
      frames_group_(hdf5::create_group(file, "frames")),
      contacts_group_(hdf5::create_group(file, "contacts")),
      states_group_(scales.element ? std::optional<hdf5::Handle>() : hdf5::create_group(file, "states")),
      elements_(element_columns(states_group_ ? states_group_->id() : frames_group_.id(), scales)),
      numbers_(frames_group_.id()),
      contacts_(contact_columns(contacts_group_.id(), scales.coordinate)) {
    const hid_t frames = frames_group_.id();
    if (!scales.element) {
        state_.emplace(file, hdf5::Label{"state", "1", "element that is there, frame by frame"}, hdf5::Dimensions{},
                       states_a_chunk);
        states_.emplace(
            States{{frames, {"first_state", "1", "row of /states with the frame's first element"}, {}, numbers_a_chunk},
                   {frames, {"states", "1", "number of elements that are there"}, {}, numbers_a_chunk},
                   {states_group_->id(), {"element", "1", "which element it is"}, {}, states_a_chunk}});
        state_->become_scale();
        state_->scales(states_->element.id());
        std::apply([this](auto&... series) { (state_->scales(series.id()), ...); }, elements_.all());
    }
    if (scales.line) {
        line_count_ = static_cast<std::size_t>(scales.line->size());
        const hdf5::Dimensions vector{*scales.line, scales.coordinate};
        lines_.emplace(LineColumns<hdf5::Series>{
            {frames,
             {"line_fairlead", "m", "fairlead of each mooring line; NaN: it has broken"},
             vector,
             numbers_a_chunk},
            {frames, {"line_anchor", "m", "anchor of each mooring line"}, vector, numbers_a_chunk},
            {frames, {"line_tension", "N", "tension of each mooring line"}, {*scales.line}, numbers_a_chunk}});
    }
    time_.become_scale();
    for_each_of_frames([this](auto& series) { time_.scales(series.id()); });
    contact_.become_scale();
    std::apply([this](auto&... series) { (contact_.scales(series.id()), ...); }, contacts_.all());
}

void FrameSeries::for_each_of_frames(const auto& use) {
    const auto each = [&use](auto&... series) { (use(series), ...); };
    if (lines_) std::apply(each, lines_->all());
    if (states_)
        each(states_->first, states_->count);
    else
        std::apply(each, elements_.all());
    use(numbers_.step);
    for (hdf5::Series<double>& one : numbers_.each) use(one);
    each(numbers_.first_contact, numbers_.contacts);
}

void FrameSeries::add(const Frame& frame) {
    time_.append(frame.time);
    numbers_.step.append(frame.step);
    StructurePose structure = frame.structure;
    Vec3 load = frame.load;
    for (std::size_t k = 0; k < frame_numbers.size(); ++k)
        numbers_.each[k].append(frame_numbers[k].sign * frame_numbers[k].of(structure, load));
    numbers_.first_contact.append(static_cast<std::int32_t>(contacts_.element.rows()));
    numbers_.contacts.append(static_cast<std::int32_t>(frame.contacts.size()));
    if (states_) add_states(frame);
    add_elements(frame);
    add_contacts(frame.contacts);
    if (lines_) add_lines(frame.lines);
}

void FrameSeries::finish() {
    const auto finish = [](auto&... series) { (series.finish(), ...); };
    finish(time_, contact_);
    if (states_) {
        finish(*state_, states_->element);
        std::apply(finish, elements_.all());
    }
    for_each_of_frames(finish);
    std::apply(finish, contacts_.all());
}

void FrameSeries::add_states(const Frame& frame) {
    const auto first = static_cast<std::int32_t>(state_->rows());
    std::vector<std::int32_t> numbers(frame.elements.size());
    std::iota(numbers.begin(), numbers.end(), first);
    states_->first.append(first);
    states_->count.append(static_cast<std::int32_t>(numbers.size()));
    states_->element.append(std::vector<std::int32_t>(frame.ids.begin(), frame.ids.end()));
    state_->append(numbers);
}

void FrameSeries::add_elements(const Frame& frame) {
    std::vector<float> position;
    std::vector<float> orientation;
    std::vector<float> velocity;
    for (const BodyState& element : frame.elements) {
        const Quat q(element.rotation);
        put(position, element.position, bits_of_places);
        for (const double part : {q.w(), q.x(), q.y(), q.z()}) put(orientation, part, bits_of_turns);
        put(velocity, element.velocity, bits_of_motion);
    }
    elements_.position.append(position);
    elements_.orientation.append(orientation);
    elements_.velocity.append(velocity);
    elements_.piece.append(std::vector<std::int32_t>(frame.pieces.begin(), frame.pieces.end()));
    std::vector<float> utilisation;
    for (const double used : frame.utilisation) put(utilisation, used, bits_of_motion);
    elements_.utilisation.append(utilisation);
}

void FrameSeries::add_lines(const std::vector<FrameLine>& lines) {
    constexpr float broken = std::numeric_limits<float>::quiet_NaN();
    std::vector<float> fairlead(3 * line_count_, broken);
    std::vector<float> anchor(3 * line_count_, broken);
    std::vector<float> tension(line_count_, broken);
    for (const FrameLine& one : lines) {
        const auto at = static_cast<std::size_t>(one.line);
        for (std::size_t k = 0; k < 3; ++k) {
            fairlead[3 * at + k] = static_cast<float>(one.fairlead[static_cast<Eigen::Index>(k)]);
            anchor[3 * at + k] = static_cast<float>(one.anchor[static_cast<Eigen::Index>(k)]);
        }
        tension[at] = static_cast<float>(one.tension);
    }
    lines_->fairlead.append(fairlead);
    lines_->anchor.append(anchor);
    lines_->tension.append(tension);
}

void FrameSeries::add_contacts(const std::vector<FrameContact>& contacts) {
    std::vector<std::int32_t> numbers;
    std::vector<std::int32_t> element;
    std::vector<std::int32_t> other;
    std::vector<float> point;
    std::vector<float> normal;
    std::vector<float> friction;
    for (const FrameContact& contact : contacts) {
        numbers.push_back(static_cast<std::int32_t>(contact_.rows() + numbers.size()));
        element.push_back(contact.element);
        other.push_back(contact.other);
        put(point, contact.point, bits_of_places);
        put(normal, contact.normal, bits_of_motion);
        put(friction, contact.friction, bits_of_motion);
    }
    contact_.append(numbers);
    contacts_.element.append(element);
    contacts_.other.append(other);
    contacts_.point.append(point);
    contacts_.normal.append(normal);
    contacts_.friction.append(friction);
}

}  // namespace floes
