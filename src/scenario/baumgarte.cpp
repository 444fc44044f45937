#include "scenario/baumgarte.hpp"

#include "core/contract.hpp"

namespace floes {

Stabilization paper_stabilization(const SpringDamper& row, double time_step) {
    FLOES_EXPECTS(time_step > 0);
    const double sum = time_step * row.stiffness + row.damping;
    return {1.0 / sum, time_step * row.stiffness / sum};
}

SpringDamper paper_spring(const Stabilization& numbers, double time_step) {
    return {numbers.erp / (time_step * numbers.cfm), (1.0 - numbers.erp) / numbers.cfm};
}

Stabilization bullet_stabilization(const SpringDamper& row, double time_step, double inverse_mass) {
    FLOES_EXPECTS(time_step > 0 && inverse_mass > 0);
    const Stabilization paper = paper_stabilization(row, time_step);
    return {paper.cfm / (time_step * inverse_mass), paper.erp};
}

SpringDamper bullet_spring(const Stabilization& numbers, double time_step, double inverse_mass) {
    return paper_spring({numbers.cfm * time_step * inverse_mass, numbers.erp}, time_step);
}

JointRows joint_rows(double side, double thickness, double density) {
    FLOES_EXPECTS(side > 0 && thickness > 0 && density > 0);
    const double mass = density * side * side * thickness;
    const double horizontal_inertia = mass * (side * side + thickness * thickness) / 12.0;
    const double vertical_inertia = mass * side * side / 6.0;
    const double lever = side / 2.0;  // from an element's centre to the joint
    JointRows rows;
    rows.axial = 2.0 / mass;
    rows.vertical_shear = rows.axial + 2.0 * lever * lever / horizontal_inertia;
    rows.in_plane_shear = rows.axial + 2.0 * lever * lever / vertical_inertia;
    rows.torsion = 2.0 / horizontal_inertia;
    rows.in_plane_bending = 2.0 / vertical_inertia;
    rows.bending = rows.torsion;
    return rows;
}

}  // namespace floes
