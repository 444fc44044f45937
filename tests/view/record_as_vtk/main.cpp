// record_as_vtk RECORD.h5 SERIES.pvd: for the test that opens the series in ParaView.

#include "view/vtk_series.hpp"

int main(int count, char** arguments) {
    if (count != 3) return 2;
    floes::write_vtk_series(arguments[2], floes::Record(arguments[1]));
}
