/// The probe that measures nothing: what the harness itself costs, to subtract.

extern "C" void axial_kernel(void*) {}
