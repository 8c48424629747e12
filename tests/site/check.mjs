// Checks the page of `homogen site` in a browser.
//
// In: the program `homogen`, Chromium, an output folder with the site in `served`. Out: pictures in that folder, sizes and
// times on standard output, or an error for the first check that fails.

import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { gzipSync } from "node:zlib";
import { Browser } from "../show/browser.mjs";
import { serve } from "./server.mjs";

const [homogen, chromium, output] = process.argv.slice(2);
const root = resolve(import.meta.dirname, "../..");
const WIDE = { width: 1440, height: 900 };
const SIZES = [["phone", { width: 375, height: 812, ratio: 2, touch: true }], ["wide", WIDE], ["large", { width: 2560, height: 1440 }]];

// Options of robots with several ends.
const OPTIONS = { "panda_class.urdf": [["tip", "link8"]], "quadruped.urdf": [["floating", ""], ["tip", "fl_foot"]] };

let checks = 0;
function check(holds, what) {
  checks += 1;
  if (!holds) throw new Error(what);
}

const has = (program) => spawnSync("which", [program]).status === 0;
const run = (words, folder = root) => execFileSync(homogen, words, { cwd: folder, encoding: "utf8", maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "ignore"] });

// Drops files, pairs of names and texts or bytes, on the page.
const dropAll = (page, files) => page.ask(`(() => {
  const transfer = new DataTransfer();
  for (const [name, text] of ${JSON.stringify(files)}) transfer.items.add(new File([Array.isArray(text) ? Uint8Array.from(text) : text], name));
  document.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
})()`);

const drop = (page, name, text) => dropAll(page, [[name, text]]);

// Text that differs before and after an answer.
const answered = `document.querySelector("#name").textContent === NAME && (site.error() !== null || site.values()?.mass_matrix)`;
const until = (page, name) => page.until(answered.replace("NAME", JSON.stringify(name)));

// Values of a moving robot equal those of `homogen eval`, to the last bit.
async function values(page, name, file, options) {
  const given = await page.ask(`(() => {
    const sway = (size, step) => homogen.given().qd.map((_, k) => size * Math.sin(step * (k + 1)));
    homogen.move(homogen.q().map((entry, k) => entry + 0.3 * Math.sin(k + 1)));
    homogen.give({ qd: sway(0.7, 2), qdd: sway(1.3, 3) });
    const { q, qd, qdd } = homogen.given();
    return { q, qd, qdd };
  })()`);
  const expected = {};
  for (const own of ["gravity", "inverse_dynamics", "mass_matrix"]) [expected[own]] = evaluated(file, options, own, [given]);
  const text = JSON.stringify(expected);
  // The page may still show the state before.
  const seen = `JSON.stringify({ gravity: site.values().gravity, inverse_dynamics: site.values().inverse_dynamics, mass_matrix: site.values().mass_matrix })`;
  const end = performance.now() + 10_000;
  let last = null;
  while ((last = await page.ask(seen)) !== text && performance.now() < end) await new Promise((done) => setTimeout(done, 30));
  check(last === text, `${name}: ${last} on the page, ${text} by eval`);
}

async function shipped(browser, address) {
  const files = readdirSync(join(root, "robots")).filter((file) => /\.(urdf|dh|xml|sdf|xacro)$/.test(file));
  for (const file of files) {
    const page = await browser.open(address, WIDE);
    await page.ask("site.times()");
    await drop(page, file, readFileSync(join(root, "robots", file), "utf8"));
    await until(page, file);
    check((await page.ask("site.error()")) === null, `${file}: ${await page.ask("site.error()")}`);
    const options = OPTIONS[file] || [];
    if (options.length) {
      await page.ask(`site.take(${JSON.stringify(file)}, ${JSON.stringify(readFileSync(join(root, "robots", file), "utf8"))}, ${JSON.stringify(options)})`);
      await until(page, file);
    }
    await values(page, file, join("robots", file), options);
    check(page.complaints.length === 0, `${file}: ${page.complaints.join("; ")}`);
    await page.send("Page.close");
  }
  console.log(`${files.length} robots of the repository have the values of homogen eval`);
}

// Files in each language equal those of the command that the page shows.
async function languages(browser, address) {
  const page = await browser.open(`${address}#robot=two_link.urdf`, WIDE);
  await page.until("site.settled()");
  check((await page.ask(`document.querySelectorAll(".lacking").length`)) === 0, "a function of two links is not available");
  for (const [index, title] of ["Rust", "C99", "C++17", "Python", "LLVM IR"].entries()) {
    await page.ask(`document.querySelector("#files .tabs button:nth-child(${index + 1})").click()`);
    const language = ["", "--language c ", "--language cpp", "--language python", "--language llvm"][index];
    await page.until(`!document.querySelector(".files").classList.contains("busy") && document.querySelector("#command")?.textContent.includes(${JSON.stringify(language)})`);
    const command = await page.ask(`document.querySelector("#command").textContent`);
    const words = command.split(" ");
    check(words[0] === "homogen" && !command.includes("'"), `${command} is not simple`);
    const folder = join(output, "generated");
    execFileSync("mkdir", ["-p", folder]);
    execFileSync("cp", [join(root, "robots/two_link.urdf"), folder]);
    run(words.slice(1), folder);
    const files = await page.ask(`[...document.querySelectorAll(".file")].map((file) => [file.querySelector("a").download, file.querySelector("pre").textContent])`);
    check(files.length === (title === "C99" ? 2 : 1), `${title}: ${files.length} files`);
    for (const [name, text] of files) {
      check(readFileSync(join(folder, name), "utf8") === text, `${title}: ${name} differs from that of ${command}`);
    }
    if (title === "C++17") execFileSync("c++", ["-std=c++17", "-fsyntax-only", "-x", "c++", join(folder, files[0][0])]);
  }
}

// Results of a function by eval at states, and the words of options.
const flags = (options) => options.flatMap(([option, value]) => (value === "" ? [`--${option}`] : [`--${option}`, value]));
function evaluated(file, options, own, states, more = []) {
  const path = join(output, "states.json");
  writeFileSync(path, JSON.stringify({ states }));
  return JSON.parse(run(["eval", file, ...flags(options), "--function", own, "--states", path, "--format", "json", ...more])).results;
}

// The volume of the ellipsoid of a Jacobian: √det(J Jᵗ), by elimination.
function volume(rows) {
  const square = rows.map((row) => rows.map((other) => row.reduce((sum, entry, k) => sum + entry * other[k], 0)));
  let product = 1;
  square.forEach((row, k) => {
    product *= row[k];
    for (const below of square.slice(k + 1)) {
      const factor = below[k] / row[k];
      for (let column = k; column < below.length; column += 1) below[column] -= factor * row[column];
    }
  });
  return Math.sqrt(product);
}

const PANDA = "#robot=panda_class.urdf&-tip=link8&q=0.4,-0.5,0.2,-2,0.3,1.8,0.6";
const near = (a, b, error = 1e-9) => Math.abs(a - b) <= error * Math.max(1, Math.abs(a), Math.abs(b));

// The inverse of the mass matrix and the Jacobian of a frame that is chosen by a click, as by eval.
async function matrices(browser, address) {
  const page = await browser.open(address + PANDA, WIDE);
  await page.until("site.values()?.mass_matrix_inverse && site.values()?.geometric_jacobian");
  const [file, options, state] = ["robots/panda_class.urdf", [["tip", "link8"]], await page.ask("homogen.given()")];
  for (const own of ["mass_matrix", "mass_matrix_inverse"]) {
    const [expected] = evaluated(file, options, own, [state]);
    const shown = await page.ask(`[...document.querySelectorAll("#heat-${own} span")].map((cell) => Number(cell.dataset.value))`);
    check(JSON.stringify(shown) === JSON.stringify(expected.flat()), `${own}: ${shown}`);
  }
  const link = await page.ask(`[...document.querySelectorAll("#frame option")].findIndex((option) => option.textContent === "link5")`);
  // A click on the picture, where the frame is drawn.
  const at = await page.ask(`(() => {
    const { x, y } = homogen.place(${link});
    const box = document.querySelector("#picture").getBoundingClientRect();
    return { x: box.x + x, y: box.y + y };
  })()`);
  for (let step = 0; step < 4 && (await page.ask("homogen.chosen()")) !== link; step += 1) {
    for (const type of ["mousePressed", "mouseReleased"]) await page.mouse(type, at, { button: "left", clickCount: 1 });
  }
  check((await page.ask("homogen.chosen()")) === link, "a click does not choose the frame");
  const [rows] = evaluated(file, options, "geometric_jacobian", [state], ["--frame", "link5"]);
  const text = JSON.stringify(rows);
  await page.until(`JSON.stringify(site.values().geometric_jacobian) === ${JSON.stringify(text)}`);
  const shown = await page.ask(`[...document.querySelectorAll("#jacobian [aria-label='The Jacobian'] tbody tr")].map((row) => [...row.querySelectorAll("td span[title]")].map((cell) => Number(cell.title)))`);
  const moving = rows[0].map((_, k) => k).filter((k) => rows.some((row) => row[k] !== 0));
  check(JSON.stringify(shown) === JSON.stringify(moving.map((k) => rows.map((row) => row[k]))), `the table of the Jacobian: ${JSON.stringify(shown)}`);
  const [linear] = await page.ask(`[...document.querySelectorAll("#jacobian [aria-label='Manipulability'] output")].map((one) => Number(one.dataset.value))`);
  check(near(linear, volume(rows.slice(3))), `manipulability ${linear}, not ${volume(rows.slice(3))}`);
  check(page.complaints.length === 0, page.complaints.join("; "));
  // A straight arm in a plane cannot move along itself, nor out of the plane.
  const flat = await browser.open(`${address}#robot=two_link.urdf&q=0.5,0`, WIDE);
  const singular = `[...document.querySelectorAll("#jacobian [aria-label='Singular directions'] b")].length`;
  await flat.until(`site.values()?.geometric_jacobian && ${singular} === 2`);
  await flat.ask("homogen.move([0.5, 1])");
  await flat.until(`${singular} === 1`);
}

// Plots have the values of eval, over the range of a joint and over the time of a motion, which plays.
async function plots(browser, address) {
  const page = await browser.open(address + PANDA, WIDE);
  await page.until("site.values()?.mass_matrix && document.querySelector('#command')");
  const [file, options] = ["robots/panda_class.urdf", [["tip", "link8"]]];
  const select = (id, value) => page.ask(`(() => { const own = document.querySelector("#${id}"); own.value = ${JSON.stringify(value)}; own.dispatchEvent(new Event("change")); })()`);
  await page.ask(`document.querySelector(".plot").parentElement.open = true`);
  await page.until("site.plot()?.curves.length === 7");
  await select("plot-function", "kinetic_energy");
  await page.until(`site.plot()?.curves[0].name === "kinetic_energy"`);
  await select("plot-function", "mass_matrix");
  await page.until(`site.plot()?.curves[0].name.includes("joint1, joint1")`);
  await select("plot-row", "1");
  await select("plot-column", "3");
  await page.until(`site.plot()?.curves[0].name === "joint2, joint4"`);
  const { curves: [curve], states } = await page.ask("site.plot()");
  const expected = evaluated(file, options, "mass_matrix", states).map((rows) => rows[1][3]);
  check(JSON.stringify(curve.points.map(([, value]) => value)) === JSON.stringify(expected), "a plot of the mass matrix");
  // A motion from the present configuration to another one.
  const button = (text) => page.ask(`[...document.querySelectorAll("#trajectory button")].find((one) => one.textContent === ${JSON.stringify(text)}).click()`);
  await button("Start here");
  const [from, to] = [await page.ask("homogen.q()"), [0.1, 0.2, -0.3, -1.2, 0.5, 1.2, 0.3]];
  await page.ask(`homogen.move(${JSON.stringify(to)})`);
  await button("End here");
  await select("plot-function", "inverse_dynamics");
  await page.until(`site.plot()?.curves.length === 7 && site.plot().states[0].q.join() === ${JSON.stringify(from.join())}`);
  const motion = await page.ask("site.plot()");
  motion.states.forEach((state, step) => {
    const u = step / (motion.states.length - 1);
    const way = to.map((end, k) => end - from[k]);
    const parts = [10 * u ** 3 - 15 * u ** 4 + 6 * u ** 5, (30 * u ** 2 - 60 * u ** 3 + 30 * u ** 4) / 2, (60 * u - 180 * u ** 2 + 120 * u ** 3) / 4];
    const wanted = { q: way.map((part, k) => from[k] + part * parts[0]), qd: way.map((part) => part * parts[1]), qdd: way.map((part) => part * parts[2]) };
    for (const variable of ["q", "qd", "qdd"]) check(state[variable].every((entry, k) => near(entry, wanted[variable][k], 1e-12)), `${variable} at ${u}`);
  });
  const torques = evaluated(file, options, "inverse_dynamics", motion.states);
  check(motion.curves.every(({ points }, k) => points.every(([, value], step) => near(value, torques[step][k], 1e-12))), "torques of a motion");
  await button("Play");
  await page.until(`Number(document.querySelector(".clock").textContent.split(" ")[0]) > 0.3 && homogen.given().qd.some(Boolean)`);
  await page.until(`document.querySelector("#trajectory button:nth-of-type(3)").textContent === "Play"`);
  check((await page.ask("homogen.q().join()")) === to.join(), "the end of the motion");
  check(page.complaints.length === 0, page.complaints.join("; "));
}

// Measured errors of single precision are within the proved bounds, and not zero.
async function errors(browser, address) {
  const page = await browser.open(address + PANDA, WIDE);
  await page.until("site.settled()");
  await page.click('[data-function="inverse_dynamics"] summary');
  const rows = `[...document.querySelectorAll('[data-function="inverse_dynamics"] [aria-label="Error bounds"] tbody tr')].map((row) => [...row.cells].slice(3).map((cell) => Number(cell.textContent.replace("−", "-"))))`;
  await page.until(`${rows}.length === 7`);
  for (const [bound, median] of await page.ask(rows)) check(median > 0 && median < bound, `measured ${median}, proved ${bound}`);
}

// The configuration as text in each language is that of the page.
async function copies(browser, address) {
  const page = await browser.open(address + PANDA, WIDE);
  await page.until("window.homogen?.q().length === 7");
  const q = await page.ask("homogen.q()");
  const own = async (name) => {
    await page.ask(`(() => { const own = document.querySelector("#language-of-q"); own.value = "${name}"; own.dispatchEvent(new Event("change")); })()`);
    return page.ask(`document.querySelector("#q").textContent`);
  };
  const same = (numbers, name) => check(JSON.stringify(numbers) === JSON.stringify(q), `${name}: ${numbers}`);
  same(JSON.parse(await own("JSON")).states[0].q, "JSON");
  same(JSON.parse(execFileSync("python3", ["-c", `${await own("Python")}\nprint(q)`], { encoding: "utf8" })), "Python");
  const program = join(output, "configuration");
  const printed = (compiler, words, source) => {
    execFileSync(compiler, [...words, "-o", program, "-"], { input: source });
    return JSON.parse(execFileSync(program, { encoding: "utf8" }));
  };
  same(printed("cc", ["-x", "c"], `#include <stdio.h>\nint main(void) { ${await own("C")} for (int k = 0; k < 7; k++) printf("%s%.17g", k ? "," : "[", q[k]); puts("]"); return 0; }`), "C");
  same(printed("rustc", [], `fn main() { ${await own("Rust")} println!("{q:?}"); }`), "Rust");
}

// Projects are the folders of the commands that the page shows, and compile.
async function projects(browser, address) {
  const page = await browser.open(`${address}#robot=two_link.urdf`, WIDE);
  await page.until("site.settled()");
  const folder = join(output, "projects");
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  execFileSync("cp", [join(root, "robots/two_link.urdf"), folder]);
  await browser.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: folder });
  for (const kind of ["crate", "cmake", "cmake --language cpp", "python", "firmware"]) {
    await page.ask(`document.querySelector('[data-project="${kind}"]').click()`);
    await page.until(`document.querySelector("#project-command")?.textContent.includes("new ${kind}")`);
    const [command, archive] = await page.ask(`[document.querySelector("#project-command").textContent, document.querySelector("#project a").download]`);
    const end = performance.now() + 10_000;
    while (!existsSync(join(folder, archive)) && performance.now() < end) await new Promise((done) => setTimeout(done, 50));
    const words = command.split(" ").slice(1);
    const name = words[words.length - 1];
    execFileSync("python3", ["-m", "zipfile", "-e", archive, kind], { cwd: folder });
    rmSync(join(folder, archive));
    rmSync(join(folder, name), { recursive: true, force: true });
    run(words, folder);
    execFileSync("diff", ["-r", join(kind, name), name], { cwd: folder });
    const inside = join(folder, name);
    const compile = (program, own) => execFileSync(program, own, { cwd: inside, stdio: ["ignore", "ignore", "pipe"] });
    if (kind === "crate") compile("cargo", ["check", "--offline", "--target-dir", join(folder, "target")]);
    if (kind === "cmake") for (const file of readdirSync(inside).filter((file) => file.endsWith(".c"))) compile("cc", ["-std=c99", "-Wall", "-Werror", "-c", file, "-o", join(folder, `${file}.o`)]);
    if (kind === "cmake --language cpp") compile("c++", ["-std=c++17", "-Wall", "-Werror", "-c", "example.cpp", "-o", join(folder, "example.o")]);
    if (kind.startsWith("cmake") && has("cmake")) {
      const build = join(folder, `build-${name}`);
      rmSync(build, { recursive: true, force: true });
      compile("cmake", ["-S", ".", "-B", build]);
      compile("cmake", ["--build", build]);
    }
    if (kind === "python") compile("python3", ["-B", "-c", `import ${name}`]);
  }
  check(page.complaints.length === 0, page.complaints.join("; "));
}

// Messages are under the words that caused them, and go when the text is corrected.
async function mistakes(browser, address) {
  const page = await browser.open(address, WIDE);
  const text = readFileSync(join(root, "robots/two_link.urdf"), "utf8");
  const wrong = text.replace('<axis xyz="', '<axis xyz="0 0 0" was="');
  await drop(page, "wrong.urdf", wrong);
  await until(page, "wrong.urdf");
  const word = await page.ask(`document.querySelector(".message.error .word")?.textContent`);
  check(/axis|xyz|0 0 0/.test(word || ""), `the message is under ${word}`);
  await page.ask(`(() => { const text = document.querySelector("#text-of-robot"); text.value = ${JSON.stringify(text)}; text.dispatchEvent(new Event("input", { bubbles: true })); })()`);
  await page.until("site.error() === null && site.values()?.mass_matrix");
  // Options that contradict the file.
  await page.ask(`(() => { const own = document.querySelector("#option-lock"); own.value = "nowhere"; own.dispatchEvent(new Event("change")); })()`);
  await page.until("site.error() !== null");
  check(/nowhere/.test(await page.ask("site.error()")), "the error does not name the joint");
  check(page.complaints.length === 0, page.complaints.join("; "));
}

// Several files: the page finds the first one and puts what it includes in its place.
async function together(browser, address) {
  const part = (name) => [name, readFileSync(join(root, "robots", name), "utf8")];
  for (const [name, text, other] of [
    ["whole.xml", `<mujoco model="whole"><include file="parts/two_link.xml"/></mujoco>`, "two_link.xml"],
    ["whole.urdf.xacro", `<robot name="whole" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="$(find arm)/two_link.urdf.xacro"/></robot>`, "two_link.urdf.xacro"],
  ]) {
    const page = await browser.open(address, WIDE);
    await dropAll(page, [part(other), [name, text]]);
    await until(page, name);
    check((await page.ask("site.error()")) === null, `${name}: ${await page.ask("site.error()")}`);
    check((await page.ask(`document.querySelector("#robot").textContent`)) === "whole", "the first file");
    await values(page, name, join("robots", other), []);
    check(page.complaints.length === 0, page.complaints.join("; "));
    await page.send("Page.close");
  }
  // Files that include each other end in a message.
  const page = await browser.open(address, WIDE);
  await dropAll(page, [["a.xml", `<mujoco><include file="b.xml"/></mujoco>`], ["b.xml", `<mujoco><include file="a.xml"/></mujoco>`]]);
  await page.until("site.error() !== null");
}

// The picture of the robot, once it is painted.
const PICTURE = `new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(document.querySelector("#picture").toDataURL()))))`;

// A tetrahedron in each format: a mesh in metres with z upwards, one in millimetres with y upwards, and one that is mirrored.
function tetrahedron() {
  const points = [[0, 0, 0], [0.25, 0, 0], [0, 0.25, 0], [0, 0, 0.5]];
  const faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
  const vertices = (list) => list.map((point) => `vertex ${point.join(" ")}`).join(" ");
  const binary = new DataView(new ArrayBuffer(84 + 50 * faces.length));
  binary.setUint32(80, faces.length, true);
  faces.forEach((face, k) => face.forEach((point, corner) => points[point].forEach((entry, axis) => binary.setFloat32(96 + 50 * k + 12 * corner + 4 * axis, entry, true))));
  const mirrored = points.map(([x, y, z]) => [x, -y, z]);
  const upright = points.map(([x, y, z]) => [1000 * x, 1000 * z, -1000 * y]);
  return [
    ["upper.stl", `solid t ${faces.map((face) => `facet normal 0 0 0 outer loop ${vertices(face.map((k) => points[k]))} endloop endfacet`).join(" ")} endsolid t`, "1 1 1"],
    ["binary.STL", [...new Uint8Array(binary.buffer)], "1 1 1"],
    ["mirrored.obj", [...mirrored.map((point) => `v ${point.join(" ")}`), ...faces.map((face) => `f ${[...face].reverse().map((k) => `${k - 4}//1`).join(" ")}`)].join("\n"), "1 -1 1"],
    ["upright.dae", `<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><unit meter="0.001"/><up_axis>Y_UP</up_axis></asset>
      <library_geometries><geometry id="g"><mesh><source id="s"><float_array id="a" count="12">${upright.flat().join(" ")}</float_array></source>
      <vertices id="v"><input semantic="POSITION" source="#s"/></vertices><polylist count="4"><input semantic="NORMAL" source="#s" offset="1"/><input semantic="VERTEX" source="#v" offset="0"/>
      <vcount>3 3 3 3</vcount><p>${faces.flat().map((k) => `${k} 0`).join(" ")}</p></polylist></mesh></geometry></library_geometries>
      <library_visual_scenes><visual_scene id="w"><node><translate>0 0 1000</translate><node><translate>0 0 -1000</translate><instance_geometry url="#g"/></node></node></visual_scene></library_visual_scenes></COLLADA>`, "1 1 1"],
  ];
}

// The same mesh has the same picture in each format, and one that is missing or cut short none.
async function meshes(browser, address) {
  const text = readFileSync(join(root, "robots/two_link.urdf"), "utf8");
  const withMesh = (name, scale) => text.replace(/<link name="upper">/, (tag) => `${tag}<visual><geometry><mesh filename="package://arm/meshes/${name}" scale="${scale}"/></geometry></visual>`);
  const seen = async (robot, files) => {
    const page = await browser.open(address, WIDE);
    await dropAll(page, [["robot.urdf", robot], ...files]);
    await until(page, "robot.urdf");
    // The ellipsoid comes last.
    await page.until("site.settled()");
    check(page.complaints.length === 0, page.complaints.join("; "));
    const picture = await page.ask(PICTURE);
    await page.send("Page.close");
    return picture;
  };
  const all = tetrahedron();
  const pictures = [];
  for (const [name, data, scale] of all) pictures.push(await seen(withMesh(name, scale), [[name, data]]));
  all.forEach(([name], k) => check(pictures[k] === pictures[0], `${name} is drawn differently`));
  const without = await seen(withMesh("upper.stl", "1 1 1"), []);
  check(without !== pictures[0], "a mesh makes no difference");
  check(without === await seen(withMesh("binary.STL", "1 1 1"), [["binary.STL", all[1][1].slice(0, 100)]]), "a mesh that is cut short is drawn");
  // Meshes that are dropped later belong to the robot that is shown.
  const page = await browser.open(address, WIDE);
  await drop(page, "robot.urdf", withMesh("upper.stl", "1 1 1"));
  await until(page, "robot.urdf");
  await dropAll(page, [all[0].slice(0, 2)]);
  await page.until(`${PICTURE}.then((picture) => picture === ${JSON.stringify(pictures[0])})`);
  await page.send("Page.close");
}

// Shapes of links are drawn, and a link that is pointed at has its name.
async function drawn(browser, address) {
  const page = await browser.open(address, WIDE);
  const text = readFileSync(join(root, "robots/two_link.urdf"), "utf8");
  const shapes = ["<box size='0.1 0.1 0.2'/>", "<cylinder radius='0.05' length='0.3'/>", "<sphere radius='0.1'/>"];
  const visuals = shapes.map((shape) => `<visual><origin xyz="0.1 0 0" rpy="0 1.57 0"/><geometry>${shape}</geometry></visual>`).join("");
  await drop(page, "shapes.urdf", text.replace(/<link name="upper">/, (tag) => tag + visuals));
  await until(page, "shapes.urdf");
  const picture = () => page.ask(PICTURE);
  const layer = (name) => `[...document.querySelectorAll("#layers label")].find((label) => label.textContent.trim() === "${name}").querySelector("input")`;
  check(await page.ask(`${layer("bodies")}.checked`), "shapes are not shown at first");
  const first = await picture();
  await page.ask(`${layer("bodies")}.click()`);
  check((await picture()) !== first, "bodies make no difference");
  // The tip and the frame of the fore arm are apart; with all in one place only one name is left.
  const hovered = await page.ask(`(() => {
    const { x, y } = homogen.place(1);
    const box = document.querySelector("#picture").getBoundingClientRect();
    return { x: box.x + x, y: box.y + y };
  })()`);
  await page.mouse("mouseMoved", hovered);
  await page.until(`!document.querySelector("#tag").hidden && /upper|shoulder/.test(document.querySelector("#tag").textContent)`);
  check(page.complaints.length === 0, page.complaints.join("; "));
}

// Hostile files end in a message; nothing of them runs, and the page takes the next file.
async function hostile(browser, address) {
  const page = await browser.open(address, WIDE);
  const good = readFileSync(join(root, "robots/scara.urdf"), "utf8");
  const evil = "</script><script>window.lost = 1</script><img src=x onerror='window.lost = 2'>";
  const escaped = evil.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll("'", "&apos;");
  await drop(page, "names.urdf", good.replace(/(name|link|joint)="/g, `$1="${escaped}`));
  await until(page, "names.urdf");
  check((await page.ask(`document.querySelector("#robot").textContent`)).startsWith(evil), "the name is not shown");
  check((await page.ask(`document.querySelectorAll("img, #view-of-robot script").length`)) === 0, "a name was parsed as HTML");
  const nested = (count) => `"<robot>" + "<link name='a'>".repeat(${count})`;
  const bomb = `'<!DOCTYPE r [<!ENTITY a "' + "b".repeat(100) + '">' + Array.from({ length: 20 }, (_, k) => '<!ENTITY a' + k + ' "' + ("&a" + (k || "") + ";").repeat(10) + '">').join("") + ']><robot name="&a19;"/>'`;
  const macros = `'<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="m" params=""><xacro:m/></xacro:macro><xacro:m/></robot>'`;
  for (const [name, made] of [["nested.urdf", nested(300_000)], ["closed.urdf", `"<robot name='r'>" + "<link name='a'>".repeat(100_000) + "</link>".repeat(100_000) + "</robot>"`], ["entities.urdf", bomb], ["macros.xacro", macros], ["zeros.urdf", `"\\0".repeat(1000)`], ["empty.urdf", `""`]]) {
    await page.ask(`site.take(${JSON.stringify(name)}, ${made})`);
    await page.until(`document.querySelector("#name").textContent === ${JSON.stringify(name)} && site.error() !== null`);
    console.log(`${name}: ${(await page.ask("site.error()")).replace(/.*Error/s, "").slice(0, 140)}`);
  }
  await page.ask(`(() => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([new Uint8Array(65 << 20)], "large.urdf"));
    document.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
  })()`);
  await page.until(`/64 MB/.test(site.error())`);
  await drop(page, "good.urdf", good);
  await until(page, "good.urdf");
  check((await page.ask("site.error()")) === null, "the page does not recover");
  check((await page.ask("window.lost")) === undefined, "a script was run");
  check(page.complaints.length === 0, page.complaints.join("; "));
}

// A link has the robot, its options and the configuration; a typed number is one of it.
async function links(browser, address) {
  const page = await browser.open(`${address}#robot=panda_class.urdf&-tip=link8&q=0.1,-0.2,0.3,-0.4,0.5,0.6,-0.7`, WIDE);
  await page.until("site.values()?.mass_matrix");
  check((await page.ask("homogen.q().join()")) === "0.1,-0.2,0.3,-0.4,0.5,0.6,-0.7", "the configuration of the link");
  await page.ask(`(() => { const typed = document.querySelector(".sliders .typed"); typed.value = "1.5 rad"; typed.dispatchEvent(new Event("change")); })()`);
  check((await page.ask("homogen.q()[0]")) === 1.5, "a typed number");
  await page.until(`location.hash.includes("q=1.5,")`);
  // Links of the documentation.
  const pages = ["robots/README.md", "runtime/src/front.md"].flatMap((path) => readFileSync(join(root, path), "utf8").match(/localhost:8000\/#robot=[^)]+/g));
  check(pages.length > 20, `${pages.length} links`);
  for (const hash of new Set(pages.map((link) => link.split("/")[1]))) {
    const linked = await browser.open(address + hash, WIDE);
    await linked.until("site.error() !== null || site.values()?.mass_matrix");
    check((await linked.ask("site.error()")) === null && linked.complaints.length === 0, `${hash}: ${await linked.ask("site.error()")}`);
    await linked.send("Page.close");
  }
  const unknown = await browser.open(`${address}#robot=nobody.urdf`, WIDE);
  await unknown.until("site.error() !== null");
  check(/no robot nobody.urdf/.test(await unknown.ask("site.error()")), "a robot that does not exist");
}

async function times(browser, address) {
  const module = readFileSync(join(output, "served/homogen.wasm"));
  const packed = gzipSync(module, { level: 9 }).length;
  console.log(`module: ${(module.length / 1e6).toFixed(2)} MB, ${(packed / 1e6).toFixed(2)} MB compressed`);
  check(packed < 2e6, "the module is larger than 2 MB compressed");
  // At once, and after the engines have had some seconds, as while a person looks for a file.
  for (const [sample, wait] of [["panda_class.urdf", 0], ["panda_class.urdf", 8], ["quadruped.urdf", 8], ["humanoid.urdf", 8]]) {
    const page = await browser.open(address, WIDE);
    await new Promise((done) => setTimeout(done, 1000 * wait));
    await page.ask(`document.querySelector('[data-sample="${sample}"]').click()`);
    // A busy machine takes its time.
    await page.until("site.settled()", 300_000);
    const { robot, first, values: all, all: every } = await page.ask("site.times()");
    const said = (time) => (time === undefined ? "—" : `${(time / 1000).toFixed(2)} s`);
    console.log(`${sample}, dropped after ${wait} s: shown after ${said(robot)}, first function ${said(first)}, torques and mass matrix ${said(all)}, all functions ${said(every)}; opened in ${page.took.toFixed(0)} ms; ${((await page.ask("site.memory()")) / 1e6).toFixed(0)} MB`);
    await page.send("Page.close");
  }
}

// What a person wants to do takes at most five clicks, each with a picture.
async function tasks(browser, address) {
  const page = await browser.open(address, WIDE);
  let clicks = 0;
  const click = async (selector) => {
    clicks += 1;
    await page.click(selector);
  };
  const done = async (name, most) => {
    await new Promise((later) => setTimeout(later, 300));
    await page.picture(join(output, `task_${name}.png`));
    check(clicks <= most, `${name} takes ${clicks} clicks`);
    console.log(`${name}: ${clicks} clicks`);
    clicks = 0;
  };
  // Torques of gravity at a configuration.
  await click('[data-sample="panda_class.urdf"]');
  await page.until("site.values()?.gravity");
  const rest = await page.ask("site.values().gravity.join()");
  await click("#slider-3");
  await page.until(`site.values().gravity.join() !== ${JSON.stringify(rest)}`);
  await done("gravity", 2);
  // How one torque comes about.
  await page.until("site.settled() && site.values().mass_matrix_inverse && site.values().geometric_jacobian");
  await click('[data-function="inverse_dynamics"] summary');
  await page.until(`document.querySelector('[data-function="inverse_dynamics"] .code .d')`);
  await click('[data-function="inverse_dynamics"] .code .d[data-n*="_in_"]');
  await page.until(`document.querySelector("#explain").classList.contains("pinned")`);
  await done("explanation", 2);
  // The cost of an option.
  await click("#show-options");
  await click("#option-formulation");
  await page.send("Input.insertText", { text: "frame-0" });
  await page.key("Enter");
  await page.ask(`document.activeElement.blur()`);
  await page.until(`site.settled() && /before: /.test(document.querySelector('[data-function="inverse_dynamics"] .before').textContent)`);
  await page.ask(`document.querySelector("#functions").scrollIntoView({ behavior: "instant" })`);
  await done("cost", 2);
  // C for a microcontroller.
  await browser.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: output });
  await click("#files .tabs button:nth-child(2)");
  await click("#files select");
  await page.ask(`(() => { const own = document.querySelector("#files select"); own.value = "f32"; own.dispatchEvent(new Event("change")); })()`);
  await page.until(`/--scalar f32.*--language c /.test(document.querySelector("#command").textContent) && !document.querySelector(".files").classList.contains("busy")`);
  await click(".file .download");
  await done("c", 4);
  // What she sees, as a link.
  await click("#link");
  await page.until(`/Copied|address bar/.test(document.querySelector("#link").textContent)`);
  check(/robot=panda_class.urdf.*-formulation=frame-0.*q=/.test(await page.ask("location.hash")), "the link");
  await done("link", 1);
  check(page.complaints.length === 0, page.complaints.join("; "));
}

// Pictures at three widths, light and dark; nothing is wider than the page.
async function pictures(browser, address) {
  for (const [name, size] of SIZES) {
    for (const dark of [false, true]) {
      const look = `${name}${dark ? "_dark" : ""}`;
      const start = await browser.open(address, { ...size, dark });
      await start.picture(join(output, `start_${look}.png`));
      const page = await browser.open(`${address}#robot=panda_class.urdf&-tip=link8&q=0.4,-0.5,0.2,-2.0,0.3,1.8,0.6`, { ...size, dark });
      await page.until("site.values()?.mass_matrix && document.querySelector('#command')");
      await page.picture(join(output, `panda_${look}.png`));
      for (const part of ["values", "files"]) {
        await page.ask(`document.querySelector("#${part}").scrollIntoView({ behavior: "instant" })`);
        await new Promise((done) => setTimeout(done, 300));
        await page.picture(join(output, `panda_${part}_${look}.png`));
      }
      for (const one of [start, page]) {
        const width = await one.ask("document.documentElement.scrollWidth");
        check(width <= size.width, `${look}: ${width} px wide`);
        check(one.complaints.length === 0, `${look}: ${one.complaints.join("; ")}`);
        await one.send("Page.close");
      }
    }
  }
}

const server = await serve(join(output, "served"));
const browser = new Browser(chromium);
try {
  await times(browser, server.address);
  await shipped(browser, server.address);
  await languages(browser, server.address);
  await mistakes(browser, server.address);
  await links(browser, server.address);
  await matrices(browser, server.address);
  await plots(browser, server.address);
  await errors(browser, server.address);
  await copies(browser, server.address);
  await projects(browser, server.address);
  await together(browser, server.address);
  await drawn(browser, server.address);
  await meshes(browser, server.address);
  await hostile(browser, server.address);
  await tasks(browser, server.address);
  await pictures(browser, server.address);
  const known = /^\/(|site\.css|site\.js|worker\.js|homogen\.wasm|robots\/[\w.]+)$/;
  const other = server.requested.filter((path) => !known.test(path));
  check(other.length === 0, `requests: ${other.join(", ")}`);
  console.log(`${checks} checks passed`);
} finally {
  await browser.close();
  server.close();
}
