"""Fixed point computes the host's bits on every board, at the same count of instructions or cycles for every input."""

import json
import pathlib

import emulator
import harness

# Cycles at most, where the board counts them: 9 200 are 73.6 us at 125 MHz.
PROMISED_CYCLES = {"inverse_dynamics,puma560,32_nearest": 9200}
IMAGES = [f"{app}-{robot}" for app in ("fixed", "fixed-derivatives", "fixed-motions") for robot in ("scara", "puma560")]
# Images that some boards run; a Puma's looped derivatives of forward dynamics take more than the 8 kB of an stm32f100.
SOME = {"fixed-drives-wrist_arm": ("stm32f405", "stm32f100", "nrf51", "rv32_virt"),
        "fixed-looped-scara": ("stm32f405", "stm32f100", "nrf51", "rv32_virt"),
        "fixed-looped-puma560": ("stm32f405", "nrf51", "rv32_virt")}
GOLDEN = pathlib.Path(__file__).resolve().parents[1] / "property" / "fixed" / "golden_bits.json"


class FixedBits(harness.BoardTest):
    def test_bits_and_constant_time(self):
        images = IMAGES + [image for image, boards in SOME.items() if self.board in boards]
        robots = {image.rpartition("-")[2] for image in images}
        golden = json.loads(GOLDEN.read_text())
        looped = {image.rpartition("-")[2] for image in images if image.startswith("fixed-looped-")}
        wanted = {name: bits for name, bits in golden.items()
                  if name.split(",")[1] in (looped if name.endswith(",32_looped") else robots)}
        found = {}
        for image in images:
            code, text = emulator.run(self.board, image)
            self.assertEqual(code, 0, text[-500:])
            self.assertTrue(text.endswith("end\n"), text[-500:])
            for row in (line.split(",") for line in text.splitlines() if line.startswith("fixed,")):
                name, bits, least, most = ",".join(row[1:4]), row[4], int(row[5]), int(row[6])
                found[name] = bits
                self.assertGreater(least, 20, f"{name}: it cannot be that few")
                self.assertEqual(least, most, f"{name}: one count for all inputs")
                print(f"{name}: {most}")
                if emulator.board(self.board).get("runner", {}).get("counts") == "cycles":
                    self.assertLessEqual(most, PROMISED_CYCLES.get(name, most), name)
        self.assertEqual(found, wanted)


if __name__ == "__main__":
    harness.main()
