"""What commission.py says of a verdict: sentences, the table, rows of JSON, lines of the header's comment."""

import numpy as np

from engine import suspects
from statics import SURE
import wiring

MENDED = ("axis turned",)  # what a header can mend of all that may be wrong with wires and signs, where each joint has a drive of its own
WORDS = {"zero": "the zero of {1} {0}", "scale": "the torque scale of {1} {0}", "offset": "the torque offset of {1} {0}",
         "coulomb": "the friction of {1} {0}"}


class Report:
    def __init__(self, verdict, limit):
        self.verdict, self.arm, self.limit = verdict, verdict.arm, limit
        self.units = self.arm.units()
        self.shares = self.arm.noun == "drive"
        self.mended = () if self.shares else MENDED
        claims, cost = verdict.hypothesis.claims, verdict.hypothesis.cost  # others that claim more are what poses do not tell
        self.either = [each for each in verdict.alike if 0 < each.claims <= claims and each.cost < cost + wiring.ALIKE]
        self.residuals = verdict.residuals()

    # What is wrong.

    def mistakes(self):
        """Sentences of exchanges, axes and signs; where the poses do not tell which, all that explain them, by "or"."""
        found = self.verdict.mistakes()
        if not self.either:
            return [each.sentence(self.units, self.arm.noun) for each in found]
        ways = [found] + [wiring.named(each, self.verdict.statics) for each in self.either]
        texts = [" and ".join(each.sentence(self.units, self.arm.noun) for each in way) for way in ways]
        remedies = [self._remedy(each) for each in self.either]
        return [", or ".join(dict.fromkeys(texts)) + f" (these poses do not tell which{remedies[0]})"]

    def of_file(self):
        """Sentences of what is wrong with the whole file."""
        return [each.sentence(self.units, self.arm.noun) for each in self.verdict.mistakes() if each.kind in wiring.OF_FILE]

    def of_drive(self, joint):
        """Sentences of one drive's numbers."""
        return [*self._scale(joint), *self._offset(joint), *self._zero(joint)]

    def _scale(self, joint):
        if not self.verdict.is_fault("scale", joint):
            return []
        value, deviation = self.verdict.value("scale", joint)
        return [f"{suspects.Suspect('torque scaled', (joint,), abs(value)).sentence(self.units, self.arm.noun)} +- {deviation:.2g}"]

    def _offset(self, joint):
        if not self.verdict.is_fault("offset", joint):
            return []
        value, deviation = self.verdict.value("offset", joint)
        return [f"tau{joint + 1} is {value:.3g} +- {deviation:.2g} {self.units[joint]} too large in every pose (torque offset)"]

    def _zero(self, joint):
        if not self.verdict.is_fault("zero", joint):
            return []
        value, deviation = self.verdict.value("zero", joint)
        return [f"{suspects.Suspect('zero off', (joint,), value).sentence(self.units, self.arm.noun)} (+- {self.position(joint, deviation)})"]

    def position(self, joint, value):
        return f"{1000 * value:.2g} mm" if self.arm.prismatic[joint] else f"{np.degrees(value):.2g} degrees"

    def tilt(self):
        if not self.verdict.tilt_is_fault():
            return []
        angle, deviation = self.verdict.tilt()
        g = ", ".join(f"{value:.4g}" for value in self.verdict.gravity())
        return [f"the table is tilted by {np.degrees(angle):.3g} +- {np.degrees(deviation):.2g} degrees: gravity is ({g}) m/s^2 in frame 0"]

    def unexplained(self):
        """One sentence, or nothing."""
        worst = int(np.argmax(self.residuals))
        if self.residuals[worst] <= self.limit:
            return ""
        return (f"{100 * self.residuals[worst]:.3g} % of tau{worst + 1} is left unexplained, the limit is {100 * self.limit:g} % (--residual-limit)")

    def drives_to_mend(self):
        """What no header mends."""
        kinds = [each for each in self.verdict.mistakes() if each.kind not in self.mended]
        texts = [each.sentence(self.units, self.arm.noun) for each in kinds] if not self.either else self.mistakes()
        for joint in range(len(self.arm)):
            texts += self._scale(joint) + self._offset(joint) + (self._zero(joint) if self.shares else [])
        return texts

    # What the poses do not tell.

    def untold(self):
        return [self._untold(each, "not told") for each in self.verdict.untold] + self._wiring_untold()

    def poor(self):
        return [self._untold(each, "poorly told") for each in self.verdict.poor]

    def called(self, kind, index):
        if kind == "tilt":
            return f"the tilt about ({', '.join(f'{value:.2g}' for value in self.verdict.statics.tilts[index] + 0.0)})"
        return WORDS[kind].format(index + 1, self.arm.noun)

    def _untold(self, each, how):
        text = f"{self.called(each.kind, each.index)} is {how}"
        if each.partners:
            text += f", mixed up with {' and '.join(self.called(*other) for other in each.partners)}"
        if each.pose is not None:
            return f"{text}: hold ({', '.join(f'{value:.3g}' for value in self.shown(each.pose))}), degrees or mm, too"
        unloaded = each.kind == "scale" and not each.partners
        rest = ": gravity hardly loads it in any pose; push it with a known force, or record a motion for ./axial identify" if unloaded else \
            ": no pose inside the limits tells it" if how == "not told" else ": more holds, or a heavier mass"
        return text + rest

    def shown(self, pose):
        return [1000 * value if slides else np.degrees(value) for value, slides in zip(pose, self.arm.prismatic)]

    def _wiring_untold(self):
        """Of hypotheses that claim a mistake more and explain as much: a sentence for all that one pose, or none, tells."""
        have, groups = [(each.kind, each.joints) for each in self.verdict.mistakes()], {}
        for hypothesis in (each for each in self.verdict.alike if each not in self.either):
            more = [each for each in wiring.named(hypothesis, self.verdict.statics) if (each.kind, each.joints) not in have]
            if more:
                groups.setdefault(self._remedy(hypothesis), []).append(" and ".join(each.sentence(self.units, self.arm.noun) for each in more))
        return [f"these poses cannot tell whether {', or '.join(dict.fromkeys(texts))}{remedy}" for remedy, texts in groups.items()]

    def _remedy(self, hypothesis):
        """What would tell it from what is found."""
        pose = self.verdict.pose_apart_from(hypothesis)
        if pose is None:
            return "; no held pose tells: push each with a known force, or record a motion for ./axial identify"
        return f"; hold ({', '.join(f'{value:.3g}' for value in self.shown(pose))}), degrees or mm, too"

    # Forms.

    def text(self):
        return "\n".join([*self._heading(), "", *self._table(), "", *self._verdicts(), *self._notes()])

    def _heading(self):
        poses = self.verdict.poses
        return [f"{self.arm.name}: {len(self.arm)} drives, {poses.count()} poses, {len(poses)} holds; errors are standard deviations"]

    def _table(self):
        lines = [f"{self.arm.noun:<16} {'torque scale':>18} {'torque offset':>20} {'zero':>22} {'Coulomb':>20} {'left, %':>8}"]
        for j, joint in enumerate(self.arm.joints):
            offset, friction, unit = self.verdict.value("offset", j), self.verdict.friction(j), self.units[j]
            zero = self.verdict.value("zero", j)
            factor, length = (1000.0, "mm") if self.arm.prismatic[j] else (180.0 / np.pi, "deg")
            cells = [_cell(self.verdict.value("scale", j), ""), _cell(offset, unit), _cell(zero and (factor * zero[0], factor * zero[1]), length), _cell(friction, unit)]
            name = f"{j + 1} {joint['name']}"[:16]
            lines.append(f"{name:<16} {cells[0]:>18} {cells[1]:>20} {cells[2]:>22} {cells[3]:>20} {100 * self.residuals[j]:>8.2g}")
        tilt = self.verdict.tilt()
        return lines + [f"tilt of gravity: {_cell(tilt and (np.degrees(tilt[0]), np.degrees(tilt[1])), 'deg')}"]

    def _verdicts(self):
        lines = [*self.mistakes(), *self.tilt()]
        for joint in range(len(self.arm)):
            own = "; ".join(self.of_drive(joint))
            lines.append(f"drive {joint + 1}: {own or 'nothing wrong'}")
        return lines

    def _notes(self):
        notes = [*self.untold(), *self.poor(), *self.verdict.poses.notes]
        return ["", *("note: " + each for each in notes)] if notes else []

    def rows(self):
        """Of JSON."""
        drives = [self._row(j) for j in range(len(self.arm))]
        tilt = self.verdict.tilt()
        gravity = {"kind": "gravity", "robot": self.arm.name, "gravity": self.verdict.gravity().tolist(), "told": tilt is not None,
                   "tilt": tilt and tilt[0], "tilt_deviation": tilt and tilt[1], "fault": self.verdict.tilt_is_fault()}
        wires = [{"kind": "mistake", "robot": self.arm.name, "mistake": each.kind, "joints": [j + 1 for j in each.joints],
                  "mended_by_header": each.kind in self.mended and not self.either, "sentence": each.sentence(self.units, self.arm.noun)} for each in self.verdict.mistakes()]
        untold = [{"kind": "untold", "robot": self.arm.name, "unknown": each.kind, "index": each.index + 1, "poorly": poorly,
                   "pose": None if each.pose is None else [float(value) for value in each.pose],
                   "sentence": self._untold(each, "poorly told" if poorly else "not told")}
                  for group, poorly in ((self.verdict.untold, False), (self.verdict.poor, True)) for each in group]
        fit = {"kind": "fit", "robot": self.arm.name, "poses": self.verdict.poses.count(), "holds": len(self.verdict.poses),
               "residual": float(self.residuals.max()), "explained": not self.unexplained(), "told_apart": not self.either,
               "sentences": self.mistakes(), "not_mended": self.drives_to_mend()}
        return drives + [gravity] + wires + untold + [fit]

    def _row(self, j):
        pair = lambda found, name: {name: None if found is None else found[0], f"{name}_deviation": None if found is None else found[1]}
        values = {}
        for kind in ("scale", "offset", "zero"):
            values.update(pair(self.verdict.value(kind, j), kind))
        return {"kind": "drive", "robot": self.arm.name, "joint": j + 1, "name": self.arm.joints[j]["name"], "unit": self.units[j], **values,
                **pair(self.verdict.friction(j), "coulomb"), "residual": float(self.residuals[j]),
                "faults": [kind for kind in ("scale", "offset", "zero") if self.verdict.is_fault(kind, j)], "sentences": self.of_drive(j)}

    def header(self, name, log):
        """Content of the mended header."""
        turned = set() if self.shares else {each.joints[0] for each in self.verdict.mistakes() if each.kind == "axis turned"}
        joints = [{"zero": self._mended_zero(j), "turned": j in turned, "friction": self._mended_friction(j)} for j in range(len(self.arm))]
        fitted = [*self.mistakes(), *self.tilt(), *(f"drive {j + 1}: {each}" for j in range(len(self.arm)) for each in self.of_drive(j))]
        drives = self.drives_to_mend()
        notes = [] if self.shares else ["position limits moved with the zeros; bodies, speeds and accelerations are as before"]
        notes += ["mend in the drives, which this header cannot: " + "; ".join(drives)] if drives else []
        residuals = ", ".join(f"{100 * each:.2g}" for each in self.residuals)
        return {"name": name, "source": f"; zeros, axes, friction and gravity by ./axial commission from {log}", "notes": notes,
                "fitted": [*(fitted or ["nothing wrong was found"]), f"RMS left of each {self.arm.noun}'s torque, %: {residuals}", *self.untold()],
                "gravity": self.verdict.gravity().tolist() if self.verdict.tilt_is_fault() else list(self.arm.gravity), "joints": joints}

    def _mended_zero(self, j):
        return self.verdict.value("zero", j)[0] if self.verdict.is_fault("zero", j) and not self.shares else 0.0

    def _mended_friction(self, j):
        """Forward and backward; as declared where the poses tell none."""
        level, deviation = self.verdict.friction(j)
        if level < SURE * deviation:
            return None
        return [self.verdict.statics.asymmetry[j] + level, self.verdict.statics.asymmetry[j] - level]


def _cell(found, unit):
    return "not told" if found is None else f"{found[0]:.4g} +- {found[1]:.2g} {unit}".rstrip()
