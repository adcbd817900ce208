#!/usr/bin/python3 -ESB
"""Compiles, and writes down what that cost. usage: compile_cost.py FILE COMPILER ARGUMENT...
FILE gets a line: processor seconds, megabytes at most, object. Launches every compiler of the host's builds (CMAKE_CXX_COMPILER_LAUNCHER).
"""
import os
import sys

log, command = sys.argv[1], sys.argv[2:]
process = os.fork()
if process == 0:
    try:
        os.execvp(command[0], command)
    finally:
        os._exit(127)
status, used = os.wait4(process, 0)[1:]
if "-o" in command:
    line = "%.2f %d %s\n" % (used.ru_utime + used.ru_stime, used.ru_maxrss // 1024, command[command.index("-o") + 1])
    with open(log, "a", encoding="utf-8") as costs:
        costs.write(line)
sys.exit(os.waitstatus_to_exitcode(status) % 256)
