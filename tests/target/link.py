"""The link protocol, written from hal/link/README.md and nothing else, so that it checks the C++ side."""

import struct
import zlib

HELLO, SET_POINT, TORQUE, ERROR, STATS_REQUEST, STATS, SHUTDOWN, START, MEASUREMENT, INJECTION = range(1, 11)
ENCODERS, ARM_COMMAND, ARM_LOAD = 12, 13, 14
PLACE, PUSH, BLIND, STOP, GO = range(5)
LOCK_STEP, FREE_RUNNING = 0, 1
OK, NOT_FINITE, OUTSIDE_LIMITS, EFFORT_LIMITED, WATCHDOG, DISABLED, NOT_MEASURED = range(7)
IDLE, RUNNING, FADING, HOLDING, PHASE_DISABLED = range(5)
(BAD_COBS, TRUNCATED, OVERSIZED, BAD_LENGTH, BAD_CRC, OUT_OF_ORDER, BAD_PAYLOAD, UNKNOWN_TYPE, OVERRUN, WITHOUT_SESSION,
 FAR_AHEAD) = range(11)
SEQUENCE_WINDOW = 20
POWER_ON, BY_WATCHDOG, BY_FAULT, BY_STACK_OVERFLOW, BY_SOFTWARE, UNKNOWN_CAUSE = range(6)
OVERFLOW_STACK, JUMP, HANG, WRITE = range(4)
NO_SESSION = 0
CLOCKS = ("crystal", "internal", "emulator", "crystal alone")
COUNTERS = ("instructions", "cycles", "none")


def stuff(data):
    """COBS: blocks of up to 254 bytes without a zero, each after its length plus one."""
    out = bytearray()
    blocks = bytes(data).split(b"\0")
    for index, block in enumerate(blocks):
        while len(block) >= 254:
            out += b"\xff" + block[:254]
            block = block[254:]
            if not block and index == len(blocks) - 1:
                return bytes(out)
        out += bytes([len(block) + 1]) + block
    return bytes(out)


def unstuff(coded):
    out = bytearray()
    at = 0
    while at < len(coded):
        code = coded[at]
        block = coded[at + 1 : at + code]
        if len(block) != code - 1:
            raise ValueError("a block is cut short")
        out += block
        at += code
        if code < 255 and at < len(coded):
            out.append(0)
    return bytes(out)


def body(kind, sequence, payload=b"", session=NO_SESSION):
    head = struct.pack("<BIH", kind, sequence & 0xFFFFFFFF, len(payload)) + payload
    return head + struct.pack("<I", zlib.crc32(head) ^ session)


def frame(kind, sequence, payload=b"", session=NO_SESSION):
    return b"\0" + stuff(body(kind, sequence, payload, session)) + b"\0"


def parse(piece, session=NO_SESSION):
    """(type, sequence, payload) of what lay between two delimiters: of the session, or of none; of any where it is None."""
    data = unstuff(piece)
    kind, sequence, length = struct.unpack_from("<BIH", data)
    told = struct.unpack_from("<I", data, 7 + length)[0] ^ zlib.crc32(data[: 7 + length]) if len(data) == 11 + length else None
    if told is None or (session is not None and told not in (session, NO_SESSION)):
        raise ValueError("the firmware sent a broken frame: " + piece.hex())
    return kind, sequence, data[7:-4]


def start(mode, session, nonce):
    return struct.pack("<BII", mode, session, nonce)


def injection(fault, address=0):
    return struct.pack("<BI", fault, address)


def measurement(counts, feeds_forward=1):
    return struct.pack(f"<{len(counts)}iB", *counts, feeds_forward)


def hello(payload):
    names = ("version joints clock_source counter_kind mode clock_Hz baud tick_Hz counter_numerator "
             "counter_denominator empty_bracket robot board session nonce reset_cause fault_address library").split()
    values = dict(zip(names, struct.unpack("<5B6I16s16sIIBII", payload)))
    for name in ("robot", "board"):
        values[name] = values[name].rstrip(b"\0").decode()
    return values


def set_point(q, qd, qdd):
    values = [*q, *qd, *qdd]
    return struct.pack(f"<{len(values)}f", *values)


def torque(payload):
    joints = (len(payload) - 9) // 4
    *tau, count, overruns, status, joint, phase = struct.unpack(f"<{joints}fIHBBB", payload)
    return {"tau": tau, "count": count, "overruns": overruns, "status": status, "joint": joint, "phase": phase}


def torque_of(tau, phase=RUNNING):
    """What a controller sends to its drives."""
    return struct.pack(f"<{len(tau)}fIHBBB", *tau, 0, 0, OK, 255, phase)


def encoders(payload):
    joints = (len(payload) - 9) // 8
    values = struct.unpack(f"<{joints}i{joints}fIHBBB", payload)
    return {"position": values[:joints], "speed": values[joints : 2 * joints],
            **dict(zip(("count", "overruns", "status", "joint", "phase"), values[2 * joints :]))}


def arm_command(action, values):
    return struct.pack(f"<{len(values)}fB", *values, action)


def arm_load(mass, com=(0, 0, 0), inertia=(0,) * 6):
    """kg, m in the last link's frame, kg m^2 about com: xx, yy, zz, xy, xz, yz."""
    return struct.pack("<10f", mass, *com, *inertia)


def error(payload):
    fault, *counters = struct.unpack("<B11I", payload)
    return {"fault": fault, "counters": counters}


def stats(payload):
    names = "frames set_points refused gaps ticks watchdog_holds count_min count_max stack_bytes deadline_overruns".split()
    values = struct.unpack("<21I", payload)
    return {**dict(zip(names, values)), "counters": list(values[10:])}
