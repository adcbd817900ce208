// Asks MuJoCo about a file: node mujoco.mjs PACKAGE QUESTIONS ANSWER. Files that it includes are those beside it; meshes and pictures
// are replaced by a tetrahedron and a dot, for nothing that is asked depends on them.
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, relative, resolve } from "node:path";

const [folder, questions, answer] = process.argv.slice(2);
const { default: load } = await import(resolve(folder, "dist/mujoco_wasm.js"));
const { file, links, movers, held, states } = JSON.parse(readFileSync(questions, "utf8"));
const mujoco = await load({ print: () => {}, printErr: () => {} });
const BODY = 1, JOINT = 3, SITE = 6;

const corners = [[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]], faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
function tetrahedron(name) {
  if (/\.obj$/i.test(name))
    return corners.map((c) => `v ${c.join(" ")}\n`).join("") + faces.map((f) => `f ${f.map((i) => i + 1).join(" ")}\n`).join("");
  if (/\.msh$/i.test(name)) {
    const bytes = Buffer.alloc(16 + 48 + 48);
    [4, 0, 0, 4].forEach((n, i) => bytes.writeInt32LE(n, 4 * i));
    corners.flat().forEach((x, i) => bytes.writeFloatLE(x, 16 + 4 * i));
    faces.flat().forEach((n, i) => bytes.writeInt32LE(n, 64 + 4 * i));
    return bytes;
  }
  const bytes = Buffer.alloc(84 + 50 * faces.length);
  bytes.writeUInt32LE(faces.length, 80);
  faces.forEach((f, i) => f.forEach((corner, j) => corners[corner].forEach((x, k) => bytes.writeFloatLE(x, 84 + 50 * i + 12 + 12 * j + 4 * k))));
  return bytes;
}
const dot = Buffer.from("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4//8/AAX+Av4N70a4AAAAAElFTkSuQmCC", "base64");

// Into MuJoCo's own file system, under the same path.
function put(path, content) {
  const parts = path.split("/").slice(1, -1);
  parts.reduce((above, part) => {
    try { mujoco.FS.mkdir(`${above}/${part}`); } catch { /* there already */ }
    return `${above}/${part}`;
  }, "");
  mujoco.FS.writeFile(path, content);
}
function provide(name) {
  const path = resolve(dirname(file), name);
  if (/\.xml$/i.test(name)) {
    if (relative(dirname(file), path).startsWith("..") || !existsSync(path)) return false;
    put(path, readFileSync(path));
  } else {
    put(path, /\.(png|ktx|bin|hf)$/i.test(name) ? dot : tetrahedron(name));
  }
  return true;
}
// MuJoCo's errors begin with their text, where the module's memory is seen through any buffer.
function message_of(error) {
  if (error.excPtr === undefined) return String(error.message ?? error);
  const view = new mujoco.DoubleBuffer(1), bytes = Buffer.from(view.GetView().buffer, error.excPtr, 500);
  const text = bytes.toString("latin1", 0, Math.max(0, bytes.indexOf(0)));
  view.delete();
  return text;
}
function compiled() {
  put(file, readFileSync(file));
  for (let last = "", tries = 0; tries < 1000; ++tries) {
    try {
      return mujoco.MjModel.loadFromXML(file);
    } catch (error) {
      const message = message_of(error), missing = /Error opening file '([^']+)'/.exec(message)?.[1];
      if (!missing || missing === last || !provide(missing)) throw new Error(message.split("\n").join(" "));
      last = missing;
    }
  }
  throw new Error("it asks for too many files");
}

function ask(model) {
  const data = new mujoco.MjData(model);
  const id = (kind, name, otherwise) => (name === "" ? otherwise : mujoco.mj_name2id(model, kind, name));
  const body = (link) => id(BODY, link.name, link.body);
  const joint = (link) => id(JOINT, link.joint, model.body_jntadr[id(BODY, link.name, link.body)] + link.which);
  const joints = movers.map((i) => joint(links[i])), dofs = joints.map((j) => model.jnt_dofadr[j]);
  const turned = (m, v) => [0, 1, 2].map((r) => m[3 * r] * v[0] + m[3 * r + 1] * v[1] + m[3 * r + 2] * v[2]);
  const transposed = (m) => [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]];
  const product = (a, b) => [0, 1, 2].flatMap((r) => [0, 1, 2].map((c) => a[3 * r] * b[c] + a[3 * r + 1] * b[3 + c] + a[3 * r + 2] * b[6 + c]));
  const at = (array, size, i) => Array.from(array.subarray(size * i, size * (i + 1)));
  const root = () => {
    const b = body(links[0]);
    return { position: at(data.xpos, 3, b), back: transposed(at(data.xmat, 9, b)) };
  };
  const from = (origin, position) => turned(origin.back, position.map((x, k) => x - origin.position[k]));

  function move(q, qd) {
    data.qpos.set(model.qpos0);
    data.qvel.fill(0);
    for (const { link, at: value } of held) data.qpos[model.jnt_qposadr[joint(links[link])]] = value;
    joints.forEach((j, k) => { data.qpos[model.jnt_qposadr[j]] = q[k]; data.qvel[dofs[k]] = qd[k]; });
    mujoco.mj_fwdPosition(model, data);
    mujoco.mj_fwdVelocity(model, data);
  }
  function pose(link) {
    if (link.kind === "") return null;
    const site = link.kind === "site", i = site ? mujoco.mj_name2id(model, SITE, link.name) : body(link), origin = root();
    if (i < 0) return null;
    const [position, rotation] = site ? [data.site_xpos, data.site_xmat] : [data.xpos, data.xmat];
    return [...from(origin, at(position, 3, i)), ...product(origin.back, at(rotation, 9, i))];
  }
  function weight(link) {
    const i = body(link), origin = root(), axes = product(origin.back, at(data.ximat, 9, i)), moments = at(model.body_inertia, 3, i);
    const scaled = axes.map((x, k) => x * moments[k % 3]);
    return [model.body_mass[i], ...from(origin, at(data.xipos, 3, i)), ...product(scaled, transposed(axes))];
  }
  function column(l) {
    const result = new mujoco.DoubleBuffer(model.nv);
    mujoco.mj_mulM(model, data, result, Array.from({ length: model.nv }, (_, d) => (d === dofs[l] ? 1 : 0)));
    const values = dofs.map((d) => result.GetView()[d]);
    result.delete();
    return values;
  }
  const answers = states.map(({ q, qd, qdd }) => {
    move(q, qd);
    const mass_matrix = dofs.map((_, l) => column(l));
    const torque = dofs.map((d, k) => qdd.reduce((sum, a, l) => sum + mass_matrix[l][k] * a, data.qfrc_bias[d]));
    return { poses: links.map(pose), torque, mass_matrix };
  });
  move(states[0].q, states[0].qd);
  return {
    version: `MuJoCo ${mujoco.mj_versionString()}`,
    states: answers,
    bodies: links.map(weight),
    joints: joints.map((j, k) => ({
      limited: Boolean(model.jnt_limited[j]), lower: model.jnt_range[2 * j], upper: model.jnt_range[2 * j + 1],
      damping: model.dof_damping[dofs[k]], friction: model.dof_frictionloss[dofs[k]], rotor: model.dof_armature[dofs[k]],
      stiffness: model.jnt_stiffness[j], rest: model.qpos_spring[model.jnt_qposadr[j]],
    })),
  };
}

let found;
try {
  found = ask(compiled());
} catch (error) {
  found = { refused: message_of(error) };
}
writeFileSync(answer, JSON.stringify(found));
process.exit(0);
