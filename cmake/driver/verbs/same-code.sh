# shellcheck shell=bash
# summary: whether a change of the headers changed any kernel's machine code, against a revision
# group: maintain, rare

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial same-code BEFORE [options]
Installs what is missing. Compiles each kernel with the headers and robots of BEFORE, a revision of git or a folder that holds
firmware/include and robots, and with those of this tree, and compares the machine code: instructions, constants, what is called.
Names, comments and files may differ. Prints what is not the same, with its instructions, and ends with 1 where a kernel of a robot with
one drive for each joint differs, or one of joints that share drives has more. All of them: half an hour of two processors.
  --scene NAME            only these, a name or a list: puma560, scara, panda-looped, wrist_arm, gripper and others
  --number float|fixed32  only these
  --build NAME            only these: stm32f405, nrf51, rv32_virt (with the flags of their own), cortex_m4f-O2, host-gcc-O2, host-clang-O2
  --kernel NAME           only these: inverse_dynamics and others
  --json FILE             the rows, as an array of objects
END_OF_USAGE
}

run() {
  ensure_packages clang
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/boards/size/same_code.py" "$@"
}
